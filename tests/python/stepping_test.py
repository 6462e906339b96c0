"""Runs decision by decision, and the reasons."""
import _thread
import copy
import functools
import gc
import os
import pathlib
import pickle
import re
import signal
import stat
import threading
import weakref
import xml.etree.ElementTree

import numpy as np
import pytest

import spiraling_edge as se


@pytest.mark.parametrize("scene, rules", [("scene:sheet", "paper"), ("scene:torus", "robust"),
                                          ("scene:stranded-point", "robust")])
def test_an_observer_sees_the_decisions_of_the_trace(program, scene, rules):
    lines = []
    stepper = se.Stepper(scene, rules=rules, observer=lambda event: lines.append(f"{event.address}\t{event.sentence}"))
    assert stepper.run_until() == "finished" and stepper.phase == "finished"
    assert lines == program("run", scene, "--rules", rules, "--trace", "-", "-q").splitlines()
    assert np.array_equal(stepper.triangles, se.reconstruct(scene, rules=rules).triangles)


def test_evidence_has_a_name_for_each_number():
    kinds = {}

    def keep(event):
        kinds.setdefault((event.stage, tuple(event.evidence)), event)
    for scene in se.scenes():
        for rules in ("paper", "robust"):
            se.Stepper(f"scene:{scene}", rules=rules, observer=keep).run_until()
    page = (pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md").read_text()
    rows = re.findall(r"^\| [a-z ]+ \| (`.*?`) \|", page.partition("<!-- begin evidence -->")[2], re.M)
    documented = {tuple(re.findall(r"\w+", row)) for row in rows}
    assert len(documented) > 25 and {names for _, names in kinds} <= documented
    assert len(kinds) > 25
    sphere = next(event for (stage, _), event in kinds.items() if stage == "sphere")
    numbers = sphere.evidence
    assert sphere.section == "6.3" and sphere.taken == (sphere.verdict != "removed")
    assert numbers["q"] == sphere.point and numbers["radius"] > 0.0 and len(numbers["center"]) == 3


def test_a_stepper_runs_phase_by_phase_to_the_state_of_a_pivot():
    by_phase, by_pivot = se.Stepper("scene:torus"), se.Stepper("scene:torus")
    phases = []
    while by_phase.pivots < 3 or by_phase.phase != "pivot":
        phases.append(by_phase.phase)
        assert by_phase.advance()
    while by_pivot.pivots < 3:
        assert by_pivot.step_pivot()
    assert phases[:9] == ["seed", "pivot", "sort", "limits", "convex", "reciprocal", "hole", "sphere", "twopoint"]
    assert np.array_equal(by_phase.triangles, by_pivot.triangles) and len(by_pivot.triangles)
    assert np.array_equal(by_phase.status, by_pivot.status)
    ring = by_pivot.rings[0]
    assert ring.active and len(ring.points) == len(ring.open) > 2
    assert by_pivot.status[ring.points].min() > 0  # USED, section 4


def test_the_neighbor_ring_is_sorted_by_angle_between_start_and_end():
    stepper = se.Stepper("scene:torus")
    stepper.run_until(lambda s: s.pivots == 20)
    assert len(stepper.neighbor_ring.points) == 0
    while stepper.phase != "sphere":
        stepper.advance()
    ring = stepper.neighbor_ring
    assert len(ring.points) > 2 and (np.diff(ring.degrees) > 0).all()


def test_observers_and_conditions_stop_and_resume_a_run():
    stops = []
    stepper = se.Stepper("scene:torus", observer=lambda event: event.address == "5.sphere.1")
    assert stepper.run_until() == "observer"
    stops.append(stepper.phase)
    assert stepper.run_until(lambda s: s.pivots == 10) == "condition" and stepper.pivots == 10
    assert stops == ["twopoint"]


def test_an_exception_of_an_observer_ends_the_call_and_the_run_goes_on():
    def observer(event):
        if event.address == "5.sphere.1":
            raise LookupError("here")
    stepper = se.Stepper("scene:torus", observer=observer)
    with pytest.raises(LookupError, match="here"):
        stepper.run_until()
    assert stepper.run_until() == "finished"
    assert np.array_equal(stepper.triangles, se.reconstruct("scene:torus", rules="paper").triangles)


def test_an_interrupt_ends_a_run_between_two_pivots():
    # No code of Python runs that would see the interrupt before the library does.
    interrupt = functools.partial(next, map(_thread.interrupt_main, [signal.SIGINT]))
    stepper = se.Stepper("scene:torus")
    with pytest.raises(KeyboardInterrupt):
        stepper.run_until(progress=interrupt)
    assert stepper.phase != "finished"
    assert stepper.run_until() == "finished"


def test_a_stepper_is_freed_although_its_observer_refers_to_it():
    class Counting:
        def __init__(self):
            self.stepper = se.Stepper("scene:sheet", observer=self.count)

        def count(self, event):
            self.events = event.n
    counting = Counting()
    counting.stepper.step_pivot()
    kept = weakref.ref(counting.stepper)
    del counting
    gc.collect()
    assert kept() is None


def test_a_run_at_work_is_not_moved():
    stepper = se.Stepper("scene:torus")
    with pytest.raises(RuntimeError, match="cannot move its own run"):
        stepper.run_until(lambda s: s.advance())
    began, go_on = threading.Event(), threading.Event()

    def waits(_):
        began.set()
        return go_on.wait(60)
    thread = threading.Thread(target=stepper.run_until, args=[waits])
    thread.start()
    began.wait(60)
    with pytest.raises(RuntimeError, match="Another thread"):
        stepper.pivots
    go_on.set()
    thread.join()
    assert stepper.run_until() == "finished"


def test_a_run_goes_to_addresses_and_back():
    run = se.Run("scene:torus")
    assert run.state.event is None and run.back() is None
    state = run.at("134.sphere.3")  # the numbers of docs/library.md
    assert state.before.neighbor_ring.points.tolist() == [74, 497, 429, 575]
    assert state.neighbor_ring.points.tolist() == [74, 497, 575]
    assert np.round(state.neighbor_ring.degrees, 1).tolist() == [0.0, 70.8, 119.7]
    assert round(state.event.evidence["distance"], 4) == 0.1785 and state.reading.margin < 0
    assert run.back("pivot").event.pivot == 133 and len(run.state.rings[0].points) == 50
    run.at("134.sphere.3")
    assert run.next("stage=sphere refused margin<0.01").address == "269.sphere.2"
    assert run.at(137).address == "137.pivot.1" and run.forward().address == run.events[1].address
    with pytest.raises(LookupError, match="99999"):
        run.at(99999)
    with pytest.raises(ValueError, match="expected an address"):
        run.at("first")
    with pytest.raises(ValueError, match="nonsense"):
        run.next("nonsense")


def test_found_decisions_and_reasons_are_those_of_the_command_line(answer):
    run = se.Run("scene:stranded-point")
    found = run.find("stage=sphere refused", most=5)
    theirs = answer("why", "scene:stranded-point", "--find", "stage=sphere refused", "--most", 5)
    assert found.total == theirs["total"]
    assert [line.address for line in found.lines] == [line["address"] for line in theirs["lines"]]
    ours = run.why(point=32)
    theirs = answer("why", "scene:stranded-point", "--point", 32)
    assert ours.sentence == theirs["answer"] and ours.cause == theirs["cause"]
    assert ours.what_if == theirs["what_if"] and ours.proved_by == theirs["proved_by"]
    assert ours.change == theirs["change"] == "--rule unblocked=on"
    assert se.Run("scene:figure-3").why(point=3).change == "--neighbors 10"
    with pytest.raises(ValueError, match="expected one of"):
        run.why(point=1, edge=(1, 2))
    with pytest.raises(ValueError):
        run.why(point=10**6)
    for most in (-1, 1.5, "all"):
        with pytest.raises(ValueError, match="most: expected a whole number from 0"):
            run.find("kept", most=most)
    for size in (0, -1, 8193):
        with pytest.raises(ValueError, match="size: expected a whole number from 1 to 8192"):
            run.state.svg(size)


@pytest.mark.parametrize("scene", ["torus", "stranded-point", "figure-8", "figure-13"])
def test_every_place_is_drawn(scene):
    run = se.Run(f"scene:{scene}")
    assert ">The start of the run<" in run._repr_svg_()
    for _ in range(300):
        state = run.forward()
        if state is None:
            break
        xml.etree.ElementTree.fromstring(state.svg())
        assert f">{state.address}" in state.svg()
        assert (f">Tangent plane at {state.pivot}<" in state.svg()) == (state.pivot is not None)


def test_a_drawing_has_a_style_of_its_own():
    run = se.Run("scene:torus")
    one, other = run.at("9.sort").svg(), run.at("9.emit").svg()
    for drawing in (one, other):
        name = re.search(r'<g id="([\w-]+)"', drawing)[1]
        assert all(rule.startswith(f"#{name} .") for rule in re.search("<style>(.*)</style>", drawing)[1].split("}")[:-1])
    assert re.search('id="[^"]*"', one)[0] != re.search('id="[^"]*"', other)[0] and one == run.at("9.sort").svg()


def test_a_state_comes_back_from_a_pickle():
    run = se.Run("scene:torus", neighbors=10)
    for state in (run.state, run.at("137.sphere.1")):
        again = pickle.loads(pickle.dumps(state))
        assert again.address == state.address and again.svg() == state.svg()
        assert np.array_equal(again.status, state.status)
    for address in ("137.pivot.1", "137.sphere.1", "1.seed.1"):
        before = run.at(address).before
        for again in (pickle.loads(pickle.dumps(before)), copy.deepcopy(before)):
            assert again.address == before.address and again.svg() == before.svg()
            assert again.finished_triangles == before.finished_triangles
            assert [ring.points.tolist() for ring in again.rings] == [ring.points.tolist() for ring in before.rings]
    answer = run.why(point=5)
    again = pickle.loads(pickle.dumps(answer))
    assert again.sentence == answer.sentence and str(again.lines) == str(answer.lines)


def test_the_viewer_gets_the_place(tmp_path):
    viewer = tmp_path / "viewer.sh"
    viewer.write_text(f'#!/bin/sh\ncp "$1" "$(dirname "$1")/points.ply" "{tmp_path}"\n')
    viewer.chmod(viewer.stat().st_mode | stat.S_IXUSR)
    run = se.Run("scene:torus", rule={"maxgap": 100})
    run.at("137.sphere.3")
    se.look(run, os.fspath(viewer))
    session = (tmp_path / "run.sesession").read_text()
    assert '"address": "137.sphere.3"' in session and '"maxgap": 100' in session
    again = se.Run(tmp_path / "points.ply", rule={"maxgap": 100, "opposing": False})
    assert again.at("137.sphere.3").event.sentence == run.state.event.sentence
    stepper = se.Stepper("scene:torus")
    stepper.run_until(lambda s: s.pivots == 20)
    se.look(stepper, os.fspath(viewer))
    assert '"address": "20"' in (tmp_path / "run.sesession").read_text()
    with pytest.raises(OSError):
        se.look(run, "no-such-viewer")
