#!/usr/bin/env python3
"""The lab: makes the data of a student, tests the six stages one by one, and runs them together.

    ./lab.py data --seed 4711                 figures, their traces, and points of your own
    ./lab.py check [STAGE...]                 tests stages, by default until one is wrong
    ./lab.py run data/mine.ply                runs all stages, writes mine.setrace
    ./lab.py hand-in                          tests all stages, writes hand-in.json

Exit code: 0 all right, 1 a stage is wrong or not written, 2 wrong usage.
"""
import argparse
import contextlib
import hashlib
import importlib
import json
import pathlib
import shutil
import signal
import subprocess
import sys
import traceback

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = shutil.which("spiraling-edge")
SHARES = [HERE, HERE / "../../app/teach/share"]
if PROGRAM:
    SHARES.append(pathlib.Path(PROGRAM).resolve().parent / "../share/spiraling-edge")
sys.path[:0] = [str(HERE), str(HERE / "stages")]
sys.path += [str(folder) for folder in SHARES]
try:
    import setrace
except ModuleNotFoundError:
    sys.exit("lab.py: setrace.py is missing; copy it to this folder, from share/spiraling-edge/ of "
             "the installed program or app/teach/share/ of a checkout")
from geometry import Pivot  # noqa: E402

DATA = pathlib.Path("data")
STAGES = ["sort", "limits", "reciprocal", "hole", "sphere", "emit"]
MINE = {"shape": "torus", "points": 120, "neighbors": 10}


SECONDS = 5  # The most that one call of a stage may take.
# The parts of a pivot in the addresses of its decisions, in their order.
PARTS = ["pivot", "skip", "insert", "sort", "limits", "convex", "reciprocal", "hole", "sphere",
         "twopoint", "emit", "ring", "split", "join", "advance"]


class Fault(Exception):
    """What is wrong with a stage beside its result, as a sentence."""


@contextlib.contextmanager
def time_limit():
    """Raises TimeoutError after SECONDS, where the system can."""
    def stop(*_):
        raise TimeoutError(f"no end after {SECONDS} seconds")
    if not hasattr(signal, "setitimer"):
        yield
        return
    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def where_in_stage(problem):
    """"stages/limits.py, line 31: ", or nothing if no stage was running."""
    places = [(frame.filename, frame.lineno) for frame in traceback.extract_tb(problem.__traceback__)]
    if isinstance(problem, SyntaxError):
        places.append((problem.filename or "", problem.lineno))
    places = [(file, line) for file, line in places if pathlib.Path(file).parent.name == "stages"]
    return "stages/{}, line {}: ".format(pathlib.Path(places[-1][0]).name, places[-1][1]) \
        if places else ""


def call(stage, function, *arguments):
    """The result of a stage. Raises Fault if there is none, NotImplementedError if it is a stub."""
    try:
        with time_limit():
            result = getattr(importlib.import_module(stage), function)(*arguments)
    except NotImplementedError:
        raise NotImplementedError(f"stages/{stage}.py is not written yet") from None
    except Exception as problem:  # Whatever the student's code does.
        raise Fault(f"{where_in_stage(problem)}{type(problem).__name__}: {problem}") from problem
    if result is None:
        raise Fault(f"stages/{stage}.py: {function} returns nothing")
    if stage != "limits" and not isinstance(result, list):
        raise Fault(f"stages/{stage}.py: {function} returns no list: {result}")
    return result


def call_limits(at, candidates):
    result = call("limits", "limits", at, candidates)
    if not isinstance(result, tuple) or len(result) != 3 or \
            not all(place in range(1, len(at.ring)) for place in result[:2]):
        raise Fault("stages/limits.py: expected (start, end, candidates), start and end places from "
                    f"1 to {len(at.ring) - 1}, got {result}")
    return result


def labeled(result):
    """"start 129, end 76, left [4, 8]", or a list as it is."""
    if not isinstance(result, dict):
        return str(result)
    return ", ".join(f"{label} {value}" for label, value in result.items())


# ---- the stages, each with the results of our run before it --------------------------------------

def place(at, point, begin, step):
    """The place of a limit on the ring, from where it began."""
    while at.ring[begin] != point:
        begin += step
    return begin


def limits_of(at, line):
    return place(at, line["start"], len(at.ring) - 1, -1), place(at, line["end"], 1, 1)


def try_sort(at, line):
    return call("sort", "sort", at), line["sort"]


def try_limits(at, line):
    start, end, candidates = call_limits(at, list(line["sort"]))
    return ({"start": at.ring[start], "end": at.ring[end], "left": candidates},
            {"start": line["start"], "end": line["end"], "left": line["limits"]})


def try_reciprocal(at, line):
    return call("reciprocal", "reciprocal", at, list(line["limits"])), line["reciprocal"]


def try_hole(at, line):
    return call("hole", "hole", at, *limits_of(at, line), list(line["reciprocal"])), line["hole"]


def try_sphere(at, line):
    return call("sphere", "sphere", at, *limits_of(at, line), list(line["hole"])), line["sphere"]


def is_plain(at, line, candidates):
    """No point is met again, and no finished edge is closed: neither split nor join."""
    return not any(x in at.entries for x in candidates) and \
        len(line["ring"]) > 3 and len(at.entries) == len(at.ring)


def try_emit(at, line):
    arguments = (*limits_of(at, line), list(line["sphere"]))
    fan = call("emit", "fan", at, *arguments)
    if fan != line["fan"] or not is_plain(at, line, line["sphere"]):
        return {"fan": fan}, {"fan": line["fan"]}
    ring = call("emit", "ring", at, *arguments, list(line["fan"]))
    return {"fan": fan, "ring": ring}, {"fan": line["fan"], "ring": line["ring"]}


# ---- the data ------------------------------------------------------------------------------------

def inputs():
    """The inputs of the data folder, the figures first: name, points, start, pivots."""
    def order(path):
        word, _, number = path.stem.partition("-")
        return word == "cloud", word != "figure", int(number) if word == "figure" else 0, path.stem
    if not (DATA / "mine.json").exists():
        sys.exit("lab.py: there is no data; make it with: ./lab.py data --seed N")
    for path in sorted(DATA.glob("*.setrace"), key=order):
        start = path.with_suffix(".start.json")
        yield (path.stem, setrace.read_points(path.with_suffix(".ply")),
               json.loads(start.read_text()) if start.exists() else {}, setrace.read(path)[1])


def cases(points, start, pivots):
    """(number, pivot, line of the trace) of each pivot that needs none of section 7."""
    *stack, ring = start.get("rings", [[]])
    open_steps = {tuple(step) for step in start.get("open", [])}
    done = set(start.get("done", []))
    for number, line in enumerate(pivots, 1):
        if not ring:  # A new ring of two.
            ring, open_steps = [line["p"], line["first"]], open_steps | {
                (line["p"], line["first"]), (line["first"], line["p"])}
        known = ring[0] == line["p"] and ring[1] == line["last"] and ring[-1] == line["first"]
        if known and "sort" in line:
            yield number, Pivot(points, line["p"], ring, stack, open_steps, done), line
        done = done | set(line.get("done", []))
        ring, stack = line["ring"], line.get("stack", [])
        open_steps = {tuple(step) for step in line.get("open", [])}


def ask(*words):
    """The lines that the program prints; none without the program."""
    if not PROGRAM:
        return []
    return subprocess.run([PROGRAM, *words], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          universal_newlines=True).stdout.splitlines()


def nearest_address(source, number, stage):
    """The decisions of a stage, or those of the last part before it that the pivot has."""
    parts = {line.split(".")[1] for line in ask("run", *source, "-q", "--trace", "-")
             if line.startswith(f"{number}.")}
    parts = [part for part in PARTS[:PARTS.index(stage) + 1] if part in parts]
    return f"{number}.{parts[-1]}" if parts else str(number)


def source_of(name):
    """The words that name an input to the program."""
    if any(line.split()[0] == f"scene:{name}" for line in ask("scenes") if line.strip()):
        return [f"scene:{name}"]
    start = DATA / f"{name}.start.json"
    return [str(DATA / f"{name}.ply")] + (["--start", str(start)] if start.exists() else [])


def our_decisions(source, number, stage):
    """Our decisions of a stage in sentences, where Python has the package spiraling_edge and the input no start."""
    try:
        import spiraling_edge
    except ImportError:
        return ""
    if len(source) > 1:
        return ""
    run = spiraling_edge.Run(source[0])
    run.at(number)
    return "".join(f"\n  {each.address}: {each.sentence}" for each in run.events if each.stage == stage)


def see(source, number, stage):
    """The command that shows the decision."""
    return " ".join(["spiraling-edge-viewer", *source, "--goto",
                     nearest_address(source, number, stage)])


def test(stage):
    """Tests one stage on all inputs. Returns the number of pivots, and the first fault or None."""
    count = 0
    for name, points, start, pivots in inputs():
        for number, at, line in cases(points, start, pivots):
            where = f"{name}, pivot {number} (point {at.p} between {at.first} and {at.last})"
            try:
                yours, ours = globals()["try_" + stage](at, line)
            except NotImplementedError:
                return count, "not written yet"
            except Fault as fault:
                return count, f"{where}: {fault}"
            if yours != ours:
                source = source_of(name)
                return count, (f"wrong at {where}\n  yours: {labeled(yours)}\n"
                               f"  ours:  {labeled(ours)}{our_decisions(source, number, stage)}\n"
                               f"  see: {see(source, number, stage)}")
            count += 1
    return count, None


# ---- commands ------------------------------------------------------------------------------------

def make_data(arguments):
    if not PROGRAM:
        sys.exit("lab.py: there is no spiraling-edge in the PATH")
    mine = str(DATA / "mine.ply")
    subprocess.run([PROGRAM, "figures", "--conformance", str(DATA)], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run([PROGRAM, "sample", MINE["shape"], "-n", str(MINE["points"]), "--seed",
                    str(arguments.seed), "-k", str(MINE["neighbors"]), "-q", "-o", mine], check=True)
    subprocess.run([PROGRAM, "run", mine, "-q", "--with-lists", "--force", "-o", mine, "--trace",
                    str(DATA / "mine.setrace"), "--trace-stages"], check=True)
    (DATA / "mine.json").write_text(json.dumps({"seed": arguments.seed, **MINE}) + "\n")
    print(f"{len(list(DATA.glob('*.setrace')))} inputs with traces are in {DATA}/")
    return 0


def check(arguments):
    for stage in arguments.stages or STAGES:
        count, fault = test(stage)
        print(f"{stage}: {fault}" if fault else f"{stage}: right at {count} pivots")
        if fault:
            return 1
    return 0


def hand_in(_):
    results = {stage: test(stage) for stage in STAGES}
    for stage, (count, fault) in results.items():
        print(f"{stage}: {fault}" if fault else f"{stage}: right at {count} pivots")
    files = {stage: hashlib.sha256((HERE / "stages" / f"{stage}.py").read_bytes()).hexdigest()
             for stage in STAGES}
    report = {"data": json.loads((DATA / "mine.json").read_text()),
              "stages": {stage: {"right": fault is None, "pivots": count, "sha256": files[stage]}
                         for stage, (count, fault) in results.items()}}
    pathlib.Path("hand-in.json").write_text(json.dumps(report, indent=2) + "\n")
    return 0 if all(fault is None for _, fault in results.values()) else 1


def run_pivot(at, line):
    """The ring after a pivot, or None if it meets a point again or closes, which is not part of the
    lab. `line` takes the results of the stages, as far as they come."""
    line["sort"] = call("sort", "sort", at)
    start, end, line["limits"] = call_limits(at, list(line["sort"]))
    line.update(start=at.ring[start], end=at.ring[end])
    line["reciprocal"] = call("reciprocal", "reciprocal", at, list(line["limits"]))
    line["hole"] = call("hole", "hole", at, start, end, list(line["reciprocal"]))
    line["sphere"] = candidates = call("sphere", "sphere", at, start, end, list(line["hole"]))
    fan = call("emit", "fan", at, start, end, list(candidates))
    line["fan"] = fan
    if fan and (any(x in at.entries for x in candidates) or start - end + 1 + len(candidates) <= 3):
        line["ends"] = True
        return None
    ring = call("emit", "ring", at, start, end, list(candidates), list(fan))
    if len(ring) < 2:
        raise Fault(f"stages/emit.py: ring returns fewer than 2 points: {ring}")
    line.update(ring=ring, next=ring[0])
    return ring


def run(arguments):
    points = setrace.read_points(arguments.points)
    if any(points.type) or pathlib.Path(arguments.points).with_suffix(".start.json").exists():
        sys.exit(f"lab.py: {arguments.points} has points on walls or begins with a mesh, which is "
                 "not part of the lab; run data/mine.ply")
    limit = 10 * len(points.position)
    p = 0
    ring = [p, points.lists[p][0]]
    open_steps, done = {(ring[0], ring[1]), (ring[1], ring[0])}, set()
    with setrace.Writer(arguments.output, points.position) as trace:
        for number in range(1, limit + 1):
            at = Pivot(points, ring[0], ring, [], open_steps, done)
            line = {}
            try:
                ring = run_pivot(at, line)
            except (Fault, NotImplementedError) as fault:
                print(f"pivot {number} (point {at.p} between {at.first} and {at.last}): "
                      f"{fault}")
                return 1
            finally:
                trace.pivot(at.p, at.first, at.last, **line)
            if ring is None:
                print(f"pivot {number} meets a point of the ring again, or closes it: the lab ends "
                      f"before split and join; {number} pivots are in {arguments.output}")
                return 0
            done = done | (set(at.ring) - set(ring))
            if line["fan"]:
                open_steps = {step for step in open_steps
                              if at.p not in step and set(step) <= set(ring)}
    print(f"stopped after {limit} pivots, 10 for each point: the ring does not end; the first fault "
          f"is found by: spiraling-edge diff {arguments.output} {arguments.points}")
    return 1


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    command = commands.add_parser("data", help="make the data of a student")
    command.add_argument("--seed", type=int, required=True, help="your number")
    command.set_defaults(work=make_data)
    command = commands.add_parser("check", help="test stages")
    command.add_argument("stages", nargs="*", metavar="STAGE", help=", ".join(STAGES))
    command.set_defaults(work=check)
    command = commands.add_parser("run", help="run all stages together")
    command.add_argument("points", help="a PLY file of the data")
    command.add_argument("-o", "--output", default="mine.setrace", help="the trace (mine.setrace)")
    command.set_defaults(work=run)
    commands.add_parser("hand-in", help="write hand-in.json").set_defaults(work=hand_in)
    arguments = parser.parse_args()
    unknown = [each for each in getattr(arguments, "stages", []) if each not in STAGES]
    if unknown:
        parser.error(f"{unknown[0]}: no such stage; the stages are {', '.join(STAGES)}")
    return arguments.work(arguments)


if __name__ == "__main__":
    sys.exit(main())
