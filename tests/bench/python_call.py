#!/usr/bin/env python3
"""Processor time of `import spiraling_edge` beyond that of NumPy, and of a call against the command line: docs/python.md.

    python_call.py PROGRAM SCAN [TIMES]

PYTHONPATH names the package. Each is the least of TIMES (20); both read the scan, run `robust` and write the mesh.
"""
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

program, scan = sys.argv[1:3]
times = int(sys.argv[3]) if len(sys.argv) > 3 else 20
IMPORT = "import numpy, time; t = time.process_time(); import spiraling_edge; print(time.process_time() - t)"
CALL = """import sys, time, spiraling_edge as se
se.reconstruct("scene:torus")
t = time.process_time(); se.reconstruct(sys.argv[1]).write(sys.argv[2]); print(time.process_time() - t)"""


def python(code, *words):
    return float(subprocess.run([sys.executable, "-c", code, *words], check=True, capture_output=True).stdout)


def command(target):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "run", scan, "--rules", "robust", "-q", "-o", target], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


with tempfile.TemporaryDirectory() as folder:
    ours, theirs = (os.path.join(folder, name) for name in ("ours.ply", "theirs.ply"))
    for name, best in (("import", min(python(IMPORT) for _ in range(times))),
                       ("se.reconstruct().write()", min(python(CALL, scan, ours) for _ in range(times))),
                       ("spiraling-edge run", min(command(theirs) for _ in range(times)))):
        print(f"{name:<26} {1000 * best:6.1f} ms")
    assert pathlib.Path(ours).read_bytes() == pathlib.Path(theirs).read_bytes()
