#!/usr/bin/env python3
"""Writes even points of a unit sphere, with normals, as a binary PLY: sphere_ply.py COUNT FILE"""
import math
import struct
import sys

count = int(sys.argv[1])
golden = math.pi * (3 - math.sqrt(5))
with open(sys.argv[2], "wb") as file:
    properties = "".join(f"property float {name}\n" for name in "x y z nx ny nz".split())
    file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {count}\n{properties}end_header\n".encode())
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        radius = math.sqrt(max(0.0, 1 - z * z))
        x, y = radius * math.cos(golden * i), radius * math.sin(golden * i)
        file.write(struct.pack("<6f", x, y, z, x, y, z))
