"""The snippets of docs/python.md and the examples, as they are printed."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "app" / "python" / "examples"


def snippets(page):
    """The blocks of Python of a page, without those marked as not run."""
    blocks = re.findall(r"(<!-- not run: [^\n]* -->\n)?```python\n(.*?)```", page.read_text(), re.S)
    return [code for mark, code in blocks if not mark]


def test_the_page_runs_as_printed(tmp_path, scan, monkeypatch):
    pytest.importorskip("meshio", reason="skipped: python3-meshio is not installed")
    monkeypatch.chdir(tmp_path)
    shutil.copy(scan, "scan.ply")
    code = snippets(ROOT / "docs" / "python.md")
    assert len(code) >= 7
    exec(compile("\n".join(code), "docs/python.md", "exec"), {})
    assert pathlib.Path("mesh.ply").stat().st_size > 0


def run(*words, **more):
    return subprocess.run([sys.executable, *map(str, words)], capture_output=True, text=True, check=False, **more)


def test_a_pivot_is_drawn_with_matplotlib(tmp_path):
    pytest.importorskip("matplotlib", reason="skipped: python3-matplotlib is not installed")
    made = run(EXAMPLES / "draw_pivot.py", "scene:torus", "137.sphere.3", "pivot.png", cwd=tmp_path,
               env={**os.environ, "MPLCONFIGDIR": str(tmp_path)})
    assert made.returncode == 0, made.stderr
    assert (tmp_path / "pivot.png").stat().st_size > 10000


def test_scans_are_repaired_in_a_batch(tmp_path, scan):
    made = run(EXAMPLES / "repair_scans.py", tmp_path / "out", scan, tmp_path / "missing.ply", "scene:sphere")
    lines = made.stdout.splitlines()
    assert made.returncode == 1 and len(lines) == 4, made.stderr
    assert "\tsound\t" in lines[1] and "missing.ply" in lines[2] and "\tsound\t" in lines[3]
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == ["scan.ply", "sphere.ply"]


def test_stages_are_compared_and_a_wrong_one_is_named(tmp_path):
    made = run(EXAMPLES / "compare_stages.py", "scene:torus", 60)
    assert made.returncode == 0, made.stdout + made.stderr
    for stage in ("sort", "sphere", "emit"):
        count = re.search(rf"^{stage} +(\d+) of (\d+) decisions equal", made.stdout, re.M)
        assert count and count[1] == count[2] and int(count[1]) > 10
    wrong = (EXAMPLES / "compare_stages.py").read_text().replace("< np.linalg.norm(center)", "> np.linalg.norm(center)")
    (tmp_path / "wrong.py").write_text(wrong)
    made = run(tmp_path / "wrong.py", "scene:torus", 60)
    assert made.returncode == 1 and re.search(r"^\d+\.sphere\.\d+: yours ", made.stdout, re.M)


def test_the_lab_says_our_decisions_where_a_stage_is_wrong(tmp_path):
    shutil.copytree(ROOT / "docs" / "lab", tmp_path / "lab")
    shutil.copy(ROOT / "app" / "teach" / "share" / "setrace.py", tmp_path / "lab")
    for stage in (ROOT / "tests" / "lab" / "reference").glob("*.py"):
        shutil.copy(stage, tmp_path / "lab" / "stages")
    sphere = tmp_path / "lab" / "stages" / "sphere.py"
    sphere.write_text(sphere.read_text().replace(" or gap > 120.0", ""))
    program = pathlib.Path(os.environ["SPIRALING_EDGE_PROGRAM"])
    environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}
    run("lab.py", "data", "--seed", 1, cwd=tmp_path / "lab", env=environment)
    made = run("lab.py", "check", "sphere", cwd=tmp_path / "lab", env=environment)
    assert made.returncode == 1, made.stdout + made.stderr
    pivot = re.search(r"pivot (\d+) ", made.stdout)[1]
    assert re.search(rf"^  {pivot}\.sphere\.1: Point \d+ ", made.stdout, re.M), made.stdout
