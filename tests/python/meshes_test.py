"""Meshes, their verdicts, and what arrays may be."""
import concurrent.futures
import gc
import gzip
import multiprocessing
import os
import pickle
import re
import struct
import subprocess
import sys
import threading
import time
import zlib

import numpy as np
import pytest

import spiraling_edge as se


@pytest.mark.parametrize("words, options", [
    ([], {}),
    (["-k", "16", "--rule", "flip=off"], {"neighbors": 16, "rule": {"flip": False}}),
    (["--crop", "0,-2,-2,2,2,2", "--thin", "0.08"], {"crop": (0, -2, -2, 2, 2, 2), "thin": 0.08}),
    (["--derive-normals", "--symmetric"], {"derive_normals": True, "symmetric": True}),
    (["--rule", "holewidth=0.5", "--derive-rim"], {"rule": {"holewidth": 0.5}, "derive_rim": True}),
    (["--scale-by", "2,2,1", "--orient"], {"scale_by": (2, 2, 1), "orient": True}),
])
@pytest.mark.parametrize("rules", ["robust", "paper"])
def test_a_written_mesh_has_the_bytes_of_the_command_line(tmp_path, program, scan, words, options, rules):
    program("run", scan, "-q", "--rules", rules, *words, "-o", tmp_path / "theirs.ply")
    se.reconstruct(scan, rules=rules, **options).write(tmp_path / "ours.ply")
    assert (tmp_path / "ours.ply").read_bytes() == (tmp_path / "theirs.ply").read_bytes()


@pytest.mark.parametrize("extension", ["ply", "obj", "off", "stl", "glb"])
def test_every_format_has_the_bytes_of_the_command_line(tmp_path, program, extension):
    program("run", "scene:torus", "-q", "--rules", "robust", "--used-points", "-o", tmp_path / f"theirs.{extension}")
    se.reconstruct("scene:torus").write(tmp_path / f"ours.{extension}", used_points=True)
    assert (tmp_path / f"ours.{extension}").read_bytes() == (tmp_path / f"theirs.{extension}").read_bytes()


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_positions_alone_give_the_mesh_of_a_file_with_them(tmp_path, program, torus, dtype):
    xyz = torus.position.astype(dtype)
    kind = "float" if dtype is np.float32 else "double"
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(xyz)}\n"
    header += "".join(f"property {kind} {axis}\n" for axis in "xyz") + "end_header\n"
    (tmp_path / "xyz.ply").write_bytes(header.encode() + xyz.tobytes())
    program("run", tmp_path / "xyz.ply", "-q", "--rules", "robust", "-o", tmp_path / "theirs.ply")
    se.reconstruct(xyz, normals=None).write(tmp_path / "ours.ply")
    assert (tmp_path / "ours.ply").read_bytes() == (tmp_path / "theirs.ply").read_bytes()


@pytest.mark.parametrize("scene", ["scene:stranded-point", "scene:flipped-patch", "scene:noise"])
def test_best_has_the_bytes_of_the_command_line(tmp_path, program, scene):
    program("run", scene, "-q", "--best", "-o", tmp_path / "theirs.ply")
    mesh = se.best(scene, rules="paper")
    mesh.write(tmp_path / "ours.ply")
    assert (tmp_path / "ours.ply").read_bytes() == (tmp_path / "theirs.ply").read_bytes()
    assert mesh.trials[0].change == "no change"
    assert mesh.verdict.headline in [trial.headline for trial in mesh.trials[1:]]


def test_a_verdict_is_that_of_check(tmp_path, answer, scan):
    mesh = se.reconstruct(scan, rules="paper", rule={"convex": False})
    mesh.write(tmp_path / "mesh.ply")
    theirs = answer("check", tmp_path / "mesh.ply", "--points", scan, "--rules", "paper", "--rule", "convex=off")
    assert not mesh.verdict.sound and mesh.verdict.headline == theirs["verdict"]["headline"]
    assert len(mesh.verdict.failures) == len(theirs["failures"])
    assert mesh.verdict.counts["holes"] == theirs["counts"]["holes"]
    again = se.check(tmp_path / "mesh.ply", points=scan, rules="paper", rule={"convex": False})
    assert again.headline == mesh.verdict.headline


def test_arrays_of_a_mesh_are_views_that_keep_its_memory(torus):
    mesh = se.reconstruct(torus)
    position, triangles = mesh.position, mesh.triangles
    assert np.shares_memory(position, mesh.prepared.position)
    assert not position.flags.writeable and not triangles.flags.writeable
    expected = triangles.copy()
    del mesh
    gc.collect()
    assert np.array_equal(triangles, expected) and np.array_equal(position, torus.position)
    assert triangles.dtype == np.uint32 and triangles.shape == (len(triangles), 3)


@pytest.mark.parametrize("convert", [
    lambda xyz: xyz.astype(np.float32), np.asfortranarray, lambda xyz: np.repeat(xyz, 2, axis=0)[::2],
    lambda xyz: np.hstack([xyz, xyz])[:, :3], lambda xyz: xyz.astype(">f8"), lambda xyz: xyz.tolist()])
def test_numbers_in_any_layout_give_the_same_mesh(torus, convert):
    xyz = torus.position.astype(np.float32).astype(np.float64)
    assert np.array_equal(se.reconstruct(convert(xyz)).triangles, se.reconstruct(xyz).triangles)


def test_whole_numbers_are_points():
    x, y = np.meshgrid(np.arange(6), np.arange(6))
    grid = np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1)
    mesh = se.reconstruct(grid, normals=np.tile([0, 0, 1], (36, 1)))
    assert len(mesh.triangles) == 50


@pytest.mark.parametrize("points, sentence", [
    (np.zeros((4, 2)), r"points: expected an array of shape (n, 3), not (4, 2)"),
    (np.zeros(3), r"points: expected an array of shape (n, 3), not (3,)"),
    (np.zeros((4, 3), complex), "points: expected numbers, not complex128"),
    (np.zeros((4, 3), bool), "points: expected numbers, not bool"),
    ([["a", "b", "c"]], "points: expected numbers, not <U1"),
    (np.zeros((0, 3)), "There are no points to triangulate."),
])
def test_other_arrays_are_refused_with_a_sentence(points, sentence):
    with pytest.raises(ValueError, match=re.escape(sentence)):
        se.reconstruct(points)


@pytest.mark.parametrize("options, sentence", [
    ({"normals": np.zeros((3, 3))}, "normals: expected shape (1000, 3), not (3, 3)"),
    ({"normals": "derived"}, "normals: expected numbers, not <U7"),
    ({"rules": "best"}, "--rules best: no such set"),
    ({"radius": -1}, "--radius -1: expected a number > 0"),
    ({"radius": 1.0, "neighbors": 8}, "--radius: not together with --neighbors"),
    ({"derive_normals": True, "orient": True}, "--derive-normals: not together with --orient"),
    ({"rule": {"maxgap": "wide"}}, "--rule maxgap=wide: write maxgap=VALUE with a number"),
    ({"rule": {"maxgap": None}}, "--rule maxgap=None: write maxgap=VALUE with a number"),
    ({"neighbors": {}}, "--neighbors {}: expected a whole number"),
    ({"symmetric": 3}, "--symmetric 3: expected true or false"),
    ({"scale": (1, 1, 1)}, "--scale=1,1,1: no such option of a run"),
    ({"colour": 1}, "--colour=1: no such option of a run"),
    ({"what_if": "137.sphere keep 100000"}, "Point 100000 does not exist."),
    ({"rule": ["maxgap=100", "tie=no"]}, "--rule tie=no: write tie="),
    ({"max_pivots": 3}, "--max-pivots=3: no such option of a run's points and rules; docs/command-line.md lists them"),
    ({"most_bytes": -3}, "most_bytes: expected a whole number from 1 to 18446744073709551615, not -3"),
])
def test_wrong_options_are_refused_with_a_sentence(torus, options, sentence):
    points = torus.position if "normals" in options else "scene:torus"
    with pytest.raises(ValueError, match=re.escape(sentence)):
        se.reconstruct(points, **options)


def test_every_shared_option_of_the_command_line_is_a_keyword(program):
    own = ("most-bytes", "start", "help", "output", "normals", "used-points", "fault-fields", "with-lists", "best",
           "max-pivots", "report", "trace", "trace-stages", "check", "force", "quiet", "json")
    options = set(re.findall(r"--([a-z][a-z-]+)", "\n".join(
        line for line in program("run", "--help").splitlines() if line.lstrip().startswith("-")))) - set(own)
    assert options >= {"neighbors", "scale-by", "derive-rim", "what-if"} and len(options) > 14
    for option in options:
        for value in ("x", True):
            try:
                se.prepare("scene:torus", **{option.replace("-", "_"): value})
            except ValueError as error:
                assert "no such option" not in str(error)


def test_the_bytes_of_an_input_are_limited(scan):
    with pytest.raises(se.InputError, match="holds more than 100 bytes, read or unpacked; most_bytes=N raises"):
        se.read(scan, most_bytes=100)
    with pytest.raises(se.InputError, match="holds more than 100 bytes"):
        se.reconstruct(scan, most_bytes=100)


def test_a_switch_that_is_off_changes_nothing(torus):
    off = {key: False for key in ("symmetric", "derive_rim", "derive_normals", "orient", "keep_opposing",
                               "keep_noise", "keep_strays")}
    assert np.array_equal(se.reconstruct(torus, **off).triangles, se.reconstruct(torus).triangles)


def test_rules_may_be_a_list(torus):
    assert se.prepare(torus, rule=["maxgap=100", "flip=off"]).options == \
        se.prepare(torus, rule={"maxgap": 100, "flip": False}).options


@pytest.mark.parametrize("scene", ["scene:figure-8", "scene:sheet"])
def test_other_normals_of_points_leave_types_and_lists(scene):
    points = se.read(scene)
    usual = se.prepare(points, rules="paper")
    same = se.prepare(points, normals=points.normals, rules="paper")
    assert np.array_equal(same.types, usual.types) and np.array_equal(same.neighbors[1], usual.neighbors[1])
    turned = se.prepare(points, normals=-2.0 * points.normals, rules="paper")
    assert np.allclose(turned.normals, -usual.normals)
    assert np.array_equal(turned.types, usual.types) and np.array_equal(turned.neighbors[1], usual.neighbors[1])
    assert np.array_equal(se.reconstruct(same).triangles, se.reconstruct(usual).triangles)


def test_prepared_points_are_prepared_again_by_other_options(torus):
    prepared = se.prepare(torus, rules="paper", neighbors=10)
    assert se.prepare(prepared) is prepared
    for options in ({"rules": "robust"}, {"neighbors": 8}, {"derive_normals": True}):
        theirs = se.reconstruct(torus, **{"rules": "paper", "neighbors": 10, **options})
        ours = se.reconstruct(prepared, **options)
        assert np.array_equal(ours.triangles, theirs.triangles) and ours.options == theirs.options
    with pytest.raises(ValueError, match="--crop: these points are taken already"):
        se.reconstruct(prepared, crop=(0, 0, 0, 1, 1, 1))


def test_points_that_are_not_finite_are_set_aside_and_keep_their_row(torus):
    xyz = torus.position.copy()
    xyz[3], xyz[7] = np.nan, np.inf
    mesh = se.reconstruct(xyz, normals=torus.normals)
    assert mesh.prepared.report["non_finite"] == 2 and len(mesh.position) == len(xyz)
    assert not np.isin([3, 7], mesh.triangles).any() and np.isnan(mesh.position[3]).all()


def test_errors_of_files_are_input_errors(tmp_path, scan):
    for name in ("missing.ply", "broken.ply"):
        (tmp_path / "broken.ply").write_text("ply\nformat ascii 1.0\nend_header\n")
        with pytest.raises(se.InputError, match=name):
            se.read(tmp_path / name)
    with pytest.raises(se.InputError, match="no such scene"):
        se.reconstruct("scene:none")
    with pytest.raises(ValueError, match="only .ply"):
        se.reconstruct(scan).write(tmp_path / "mesh.doc")
    with pytest.raises(ValueError, match=".stl has no place for normals"):
        se.reconstruct(scan).write(tmp_path / "mesh.stl", normals=True)
    with pytest.raises(OSError):
        se.reconstruct(scan).write(tmp_path / "no" / "mesh.ply")
    with pytest.raises(ValueError, match="most_bytes: expected a whole number"):
        se.read(scan, -3)


def test_files_packed_by_gzip_are_read(tmp_path, scan):
    packed = tmp_path / "scan.ply.gz"
    packed.write_bytes(gzip.compress(scan.read_bytes()))
    assert np.array_equal(se.read(packed).position, se.read(scan).position)


def test_a_mesh_of_arrays_is_checked():
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
    closed = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    assert se.check(corners, closed).sound
    twice = se.check(corners, closed + [[0, 1, 3]])
    assert not twice.sound and twice.counts["non_manifold_edges"] == 3
    with pytest.raises(ValueError, match="a corner is no row of the points"):
        se.check(corners, [[0, 1, 4]])
    for ignored in ({"neighbors": 9}, {"colour": 1}, {"rules": "paper"}, {"normals": corners}):
        with pytest.raises(ValueError, match="only with points="):
            se.check(corners, closed, **ignored)


def test_progress_is_a_share_and_false_cancels(torus):
    shares = []
    se.reconstruct(torus, progress=shares.append)
    assert shares and all(0.0 <= share <= 1.0 for share in shares)
    with pytest.raises(se.Cancelled):
        se.reconstruct(torus, progress=lambda share: False)
    with pytest.raises(ZeroDivisionError):
        se.best(torus, progress=lambda share: 1 / 0)


def test_an_interrupt_ends_a_call(torus):
    import _thread
    with pytest.raises(KeyboardInterrupt):
        se.reconstruct(torus, progress=lambda share: _thread.interrupt_main())


def test_threads_make_equal_meshes_at_once(torus):
    meshes = []
    threads = [threading.Thread(target=lambda: meshes.append(se.reconstruct(torus))) for _ in range(3)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert len(meshes) == 3 and all(np.array_equal(m.triangles, meshes[0].triangles) for m in meshes)


def pixels(png):
    """Rows of colors of a picture without filters."""
    width, height = struct.unpack(">II", png[16:24])
    data = zlib.decompress(png[png.index(b"IDAT") + 4:png.index(b"IEND") - 8])
    return np.frombuffer(data, np.uint8).reshape(height, 1 + 3 * width)[:, 1:].reshape(height, width, 3).astype(int)


def test_a_mesh_shows_itself_as_a_picture(torus):
    mesh = se.reconstruct(torus)
    assert mesh._repr_png_().startswith(b"\x89PNG")
    picture = pixels(mesh.png(size=100, view=(0, 0, 1)))
    assert picture.shape == (100, 100, 3)
    # A torus from above: nothing in the middle and in the corners, and no inner side.
    assert (picture[0, 0] == picture[50, 50]).all() and (picture[50, 15] != picture[0, 0]).any()
    red = (picture[..., 0] > picture[..., 2] + 40).sum()
    assert red == 0
    inside = se.reconstruct(torus.position, normals=-torus.normals)
    assert (pixels(inside.png(size=100, view=(0, 0, 1)))[50, 15:20, 0] > 100).any()
    huge, usual = (se.reconstruct(torus.position * size, normals=torus.normals, rules="paper") for size in (2.0**200, 1))
    assert np.array_equal(huge.triangles, usual.triangles) and huge.png() == usual.png()
    with pytest.raises(ValueError, match="view: expected a direction"):
        mesh.png(view=(0, 0, 0))
    with pytest.raises(ValueError, match="view: expected three numbers"):
        mesh.png(view=(0, 0))
    for size in (0, -1, 8193, 1.5, "large"):
        with pytest.raises(ValueError, match="size: expected a whole number from 1 to 8192"):
            mesh.png(size=size)


def test_a_picture_of_a_large_mesh_takes_no_second():
    mesh = se.reconstruct(np.random.default_rng(1).normal(size=(20000, 3)) * [1, 1, 0.01])
    started = time.process_time()
    mesh.png()
    assert time.process_time() - started < 1.0


def test_records_come_back_from_other_processes(tmp_path, scan, torus):
    mesh = se.best(scan, rules="paper")
    verdict = mesh.verdict
    again = pickle.loads(pickle.dumps(mesh))
    mesh.write(tmp_path / "mesh.ply")
    again.write(tmp_path / "again.ply")
    assert (tmp_path / "again.ply").read_bytes() == (tmp_path / "mesh.ply").read_bytes()
    assert again.__dict__["verdict"].headline == verdict.headline and again.options == mesh.options
    assert [trial.headline for trial in again.trials] == [trial.headline for trial in mesh.trials]
    points = pickle.loads(pickle.dumps(torus))
    assert np.array_equal(points.position, torus.position) and np.array_equal(points.neighbors[1], torus.neighbors[1])
    prepared = pickle.loads(pickle.dumps(se.prepare(torus, rules="corrected", neighbors=9, keep_noise=True)))
    assert prepared.options == "corrected rules, noise off, 9 neighbors"
    assert np.array_equal(se.reconstruct(prepared).triangles,
                          se.reconstruct(torus, rules="corrected", neighbors=9, keep_noise=True).triangles)
    with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        theirs = pool.submit(se.reconstruct, torus).result()
    assert np.array_equal(theirs.triangles, se.reconstruct(torus).triangles)


def test_paths_may_be_any_bytes_but_a_nul(tmp_path, scan):
    odd = os.path.join(os.fsencode(tmp_path), b"sc\xffn.ply")
    se.reconstruct(scan).write(odd)
    assert len(se.read(odd).position) == len(se.read(os.fsdecode(odd)).position) > 0
    with pytest.raises(ValueError, match=r"sc\\xffn.ply: the points are from this file"):
        se.reconstruct(odd).write(odd)
    with pytest.raises(se.InputError, match=r"m\\xffn.ply"):
        se.read(b"m\xffn.ply")
    with pytest.raises(OSError, match=r"m\\xffn.ply"):
        se.reconstruct(scan).write(os.path.join(os.fsencode(tmp_path), b"no", b"m\xffn.ply"))
    for work in (se.read, se.reconstruct(scan).write):
        with pytest.raises(ValueError, match="null byte"):
            work(f"{tmp_path}/mesh.ply\0.txt")
    assert not (tmp_path / "mesh.ply").exists()


def test_the_file_of_the_points_is_replaced_only_by_force(tmp_path):
    scan = tmp_path / "scan.ply"
    se.reconstruct("scene:torus").write(scan)
    before = scan.read_bytes()
    mesh = se.reconstruct(str(scan), rule={"flip": False})
    with pytest.raises(ValueError, match="force=True"):
        mesh.write(scan)
    assert scan.read_bytes() == before
    mesh.write(scan, force=True)


def test_prepared_points_keep_their_rules():
    prepared = se.prepare("scene:noise", rules="corrected", rule={"maxgap": 100})
    assert "maxgap" in se.Run(prepared).prepared.options
    assert se.reconstruct(prepared).options == prepared.options
    assert "maxgap" in se.reconstruct(prepared, rule="flip=off").options


def test_damaged_gzip_names_the_file(tmp_path):
    whole = gzip.compress(b"0 0 0\n1 0 0\n0 1 0\n0 0 1\n" * 50)
    for damage in (whole[:-9], whole[:-6] + b"\0" + whole[-5:]):
        packed = tmp_path / "points.xyz.gz"
        packed.write_bytes(damage)
        with pytest.raises(se.InputError, match="points.xyz.gz"):
            se.read(packed)


def test_any_false_answer_of_progress_cancels():
    for answer in (False, np.False_, 0):
        with pytest.raises(se.Cancelled):
            se.best("scene:torus", progress=lambda share: answer)


def test_a_thread_at_work_does_not_abort_python_that_ends():
    script = ("import threading, time, spiraling_edge as se\n"
              "threading.Thread(target=se.best, args=('scene:noise',), daemon=True).start()\n"
              "time.sleep(0.3)\n")
    assert subprocess.run([sys.executable, "-c", script], check=False).returncode == 0
