#!/usr/bin/env python3
"""Makes meshes of many scans: by the rules "robust", and where a fault is left by the best settings.

    repair_scans.py FOLDER SCAN...

Writes FOLDER/NAME.ply for each scan, but over no scan and over no other mesh, and a line of tab-separated values. Ends
with 1 if a mesh is not sound or was not made.
"""
import pathlib
import sys

import spiraling_edge as se

folder, scans = pathlib.Path(sys.argv[1]), sys.argv[2:]
folder.mkdir(parents=True, exist_ok=True)
failed = 0
written = set()
print("scan", "triangles", "verdict", "settings", sep="\t")
for scan in scans:
    target = folder / (pathlib.Path(scan.replace("scene:", "")).stem + ".ply")
    try:
        if target in written:
            raise ValueError(f"{target}: is the mesh of another scan")
        points = se.read(scan)
        mesh = se.reconstruct(points)
        if not mesh.verdict.sound:
            mesh = se.best(points)
        mesh.write(target)
    except ValueError as error:
        print(scan, 0, error, "", sep="\t")
        failed += 1
        continue
    written.add(target)
    print(scan, len(mesh.triangles), mesh.verdict.headline, mesh.options, sep="\t")
    failed += not mesh.verdict.sound
sys.exit(1 if failed else 0)
