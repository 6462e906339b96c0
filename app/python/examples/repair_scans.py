#!/usr/bin/env python3
"""Makes meshes of many scans: by the rules "robust", and where a fault is left by the best settings.

    repair_scans.py FOLDER SCAN...

Writes FOLDER/NAME.ply for each scan, and a line of tab-separated values. Ends with 1 if a mesh is not sound.
"""
import pathlib
import sys

import spiraling_edge as se

folder, scans = pathlib.Path(sys.argv[1]), sys.argv[2:]
folder.mkdir(parents=True, exist_ok=True)
failed = 0
print("scan", "triangles", "verdict", "settings", sep="\t")
for scan in scans:
    try:
        points = se.read(scan)
        mesh = se.reconstruct(points)
        if not mesh.verdict.sound:
            mesh = se.best(points)
    except se.InputError as error:
        print(scan, 0, error, "", sep="\t")
        failed += 1
        continue
    name = scan.replace("scene:", "")
    mesh.write(folder / (pathlib.Path(name).stem + ".ply"))
    print(scan, len(mesh.triangles), mesh.verdict.headline, mesh.options, sep="\t")
    failed += not mesh.verdict.sound
sys.exit(1 if failed else 0)
