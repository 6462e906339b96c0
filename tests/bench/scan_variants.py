#!/usr/bin/env python3
"""Writes what a scan of the same surface might look like: scan_variants.py BASE.off SPACING FOLDER

BASE.off is NOFF without faces, as `run --max-pivots 0 --normals -o BASE.off` writes it; SPACING is
the mean distance to the nearest point. Writes FOLDER/NAME.off for each variant, normals unchanged:
  half, quarter   points kept at random
  moved           map coordinates: about (500000, 5400000, 300), the longest side 10
  rough 0.1 ...   each point moved by that many spacings, in a random direction
  doubled         a second layer: a copy moved along the normals by half a spacing
The same input gives the same bytes.
"""
import pathlib
import random
import sys


def read(path):
    """Rows x y z nx ny nz."""
    with open(path) as file:
        if file.readline().strip() != "NOFF":
            sys.exit(f"{path}: expected NOFF")
        count = int(file.readline().split()[0])
        rows = [[float(word) for word in file.readline().split()] for _ in range(count)]
    return [row[:6] for row in rows]


def write(path, rows):
    with open(path, "w") as file:
        file.write(f"NOFF\n{len(rows)} 0 0\n")
        file.writelines(" ".join(map(repr, row)) + "\n" for row in rows)


def thinned(rows, share):
    chance = random.Random(1)
    return [row for row in rows if chance.random() < share]


def moved(rows):
    low = [min(row[i] for row in rows) for i in range(3)]
    scale = 10 / max(max(row[i] for row in rows) - low[i] for i in range(3))
    corner = (500000, 5400000, 300)
    return [[corner[i] + scale * (row[i] - low[i]) for i in range(3)] + row[3:] for row in rows]


def roughened(rows, distance):
    chance = random.Random(2)
    result = []
    for row in rows:
        direction = [chance.gauss(0, 1) for _ in range(3)]
        length = sum(x * x for x in direction) ** 0.5
        result.append([row[i] + distance * direction[i] / length for i in range(3)] + row[3:])
    return result


def doubled(rows, distance):
    return rows + [[row[i] + distance * row[i + 3] for i in range(3)] + row[3:] for row in rows]


def main():
    rows, spacing, folder = read(sys.argv[1]), float(sys.argv[2]), pathlib.Path(sys.argv[3])
    write(folder / "half.off", thinned(rows, 0.5))
    write(folder / "quarter.off", thinned(rows, 0.25))
    write(folder / "moved.off", moved(rows))
    for share in (0.1, 0.2, 0.4):
        write(folder / f"rough {share}.off", roughened(rows, share * spacing))
    write(folder / "doubled.off", doubled(rows, 0.5 * spacing))


if __name__ == "__main__":
    main()
