#!/usr/bin/env python3
"""What the doctor says of planted causes, and whether its commands do what it says:
doctor_grid.py [--held-out] PROGRAM [CAUSE...]

Each cause is planted at three strengths into points of five shapes that none of the thresholds was chosen on (those
were chosen on the shapes of tests/core/doctor/named_causes_test.cpp). A file is judged right if the doctor accuses it
of the cause, and of nothing but what follows from it. Then each command that the doctor prints, with its effect, is
run as printed, and the mesh is judged again. Prints a Markdown table. PROGRAM: build/bin/spiraling-edge. With
--held-out on two more shapes, of random points by this script, that nothing was chosen or corrected on.
Exit code 1 if under 95 % of the files are judged right, if a clean shape is accused, or if an effect is not as said.
"""
import json
import math
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile

SHAPES = ["genus-2", "two-tori", "hyperboloid-one-sheet", "monkey-saddle", "metaballs"]
POINTS = 1500
work = pathlib.Path(tempfile.mkdtemp())


def sampled(program, shape):
    """Rows x y z nx ny nz of even points of a shape."""
    path = work / "shape.obj"
    subprocess.run([program, "sample", shape, "-n", str(POINTS), "-o", path, "-q"], check=True)
    rows = {"v": [], "vn": []}
    for line in path.read_text().splitlines():
        kind, *words = line.split()
        if kind in rows:
            rows[kind].append([float(word) for word in words[:3]])
    return [point + normal for point, normal in zip(rows["v"], rows["vn"])]


def peanut(u, v):
    a, b = math.pi * (0.02 + 0.96 * u), 2 * math.pi * v
    r = (0.55 + 0.35 * math.cos(2 * a) ** 2) * math.sin(a)
    return r * math.cos(b), 0.8 * r * math.sin(b), 1.4 * math.cos(a)


def coil(u, v):
    """A tube along a helix of one turn and a half, open at both ends."""
    a, b = 3 * math.pi * u, 2 * math.pi * v
    r = 1 + 0.3 * math.cos(b)
    return r * math.cos(a), r * math.sin(a), 1.2 * u * math.pi + 0.3 * math.sin(b)


HELD_OUT = {"peanut": peanut, "coil": coil}


def scattered(surface):
    """Rows of points of a surface, by chance, none nearer to another than their number permits."""
    chance, step = random.Random(11), 1e-4
    dense = []
    while len(dense) < 20 * POINTS:
        u, v = chance.random(), chance.random()
        x, along, across = surface(u, v), surface(u + step, v), surface(u, v + step)
        normal = cross([p - q for p, q in zip(along, x)], [p - q for p, q in zip(across, x)])
        if math.hypot(*normal) > 40 * step * step * chance.random():
            dense.append(list(x) + unit(normal))
    low, high = 0.0, 1.0
    for _ in range(12):
        apart, cells, kept = (low + high) / 2, {}, []
        for row in dense:
            cell = [math.floor(c / apart) for c in row[:3]]
            near = (cells.get((cell[0] + i, cell[1] + j, cell[2] + k), ()) for i in (-1, 0, 1) for j in (-1, 0, 1)
                    for k in (-1, 0, 1))
            if all(math.dist(row[:3], other[:3]) >= apart for some in near for other in some):
                cells.setdefault(tuple(cell), []).append(row)
                kept.append(row)
        low, high = (apart, high) if len(kept) > POINTS else (low, apart)
    return kept


def direction(chance):
    return unit([chance.gauss(0, 1) for _ in range(3)])


def unit(v):
    length = math.sqrt(sum(x * x for x in v)) or 1.0
    return [x / length for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def spacing(rows):
    """The median distance of the nearest point."""
    some = rows[:: max(1, len(rows) // 200)]
    nearest = sorted(min(math.dist(a[:3], b[:3]) for b in rows if b is not a) for a in some)
    return nearest[len(nearest) // 2]


def with_normals(rows, made):
    return [row[:3] + list(made(row)) for row in rows]


def tilted(rows, degrees, chance):
    def turn(row):
        across = unit(cross(row[3:], direction(chance)))
        angle = math.radians(degrees)
        return [math.cos(angle) * n + math.sin(angle) * a for n, a in zip(row[3:], across)]

    return with_normals(rows, turn)


def pairs(rows, apart, chance):
    by = apart * spacing(rows)
    return rows + [[x + by * d for x, d in zip(row, direction(chance))] + row[3:] for row in rows]


def lines(rows, ratio, _):
    """Points of an ellipsoid in lines about its axis, without normals: their number is that of the shape's points."""
    along = math.sqrt(4 * math.pi * math.pi / (len(rows) * ratio)) * spacing(rows) / spacing(rows)
    made = []
    for line in range(int(0.8 * math.pi / (ratio * along))):
        a = 0.1 * math.pi + ratio * along * line
        count = max(3, int(2 * math.pi * math.sin(a) / along))
        for i in range(count):
            b = 2 * math.pi * (i + 0.37 * line) / count
            made.append([1.3 * math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), 0.9 * math.cos(a)])
    return made


def flipped(rows, share, _):
    """The normals of a round patch turned."""
    center = rows[7][:3]
    near = sorted(range(len(rows)), key=lambda p: math.dist(rows[p][:3], center))[: int(share * len(rows))]
    made = [list(row) for row in rows]
    for p in near:
        made[p][3:] = [-n for n in made[p][3:]]
    return made


def every(rows, strength, made):
    step = (len(rows) // 3, 50, 4)[strength]
    return [made(row) if p % step == 0 else row for p, row in enumerate(rows)]


def on_map(rows, distance):
    scale = distance / spacing(rows)
    return [[691000 + scale * r[0], 5335000 + scale * r[1], 520 + scale * r[2]] for r in rows]


def as_float(x):
    step = 2.0 ** (math.floor(math.log2(abs(x))) - 23)
    return round(x / step) * step


def as_six_digits(x):
    return float(f"{x:.6g}")


def strays(rows, count, chance):
    low, high = ([f(row[i] for row in rows) for i in range(3)] for f in (min, max))
    middle, size = [(a + b) / 2 for a, b in zip(low, high)], math.dist(low, high)
    return rows + [[m + (0.8 + 0.4 * i) * size * d for m, d in zip(middle, direction(chance))] + direction(chance)
                   for i in range(count)]


NAN = float("nan")
# Cause: the check, checks that may follow from it, and how it is planted at strength 0, 1 or 2.
CAUSES = {
    "tilted normals": ("unfit_normals", (), lambda r, s, c: tilted(r, (25, 35, 50)[s], c)),
    "random normals": ("unfit_normals", (), lambda r, s, c: with_normals(r, lambda _: direction(c))),
    "one direction": ("unfit_normals", (), lambda r, s, c: with_normals(r, lambda _: ((0, 0, 1), (0, 1, 0), (0.6, 0, 0.8))[s])),
    "lines of sight": ("unfit_normals", (), lambda r, s, c: with_normals(
        r, lambda row: unit([o - x for o, x in zip(((0, 0, 20), (20, 0, 5), (0, 9, 9))[s], row)]))),
    "axes swapped": ("unfit_normals", (), lambda r, s, c: with_normals(
        r, lambda row: ([row[4], row[3], row[5]], [row[3], row[5], row[4]], [row[4], row[5], row[3]])[s])),
    "flipped patch": ("flipped_normals", ("inside_out",), lambda r, s, c: flipped(r, (0.1, 0.2, 0.4)[s], c)),
    "zero normals": ("zero_normals", (), lambda r, s, c: every(r, s, lambda row: row[:3] + [0, 0, 0])),
    "long normals": ("unscaled_normals", (), lambda r, s, c: with_normals(r, lambda row: [(0.5, 2, 100)[s] * n for n in row[3:]])),
    "twins": ("twins", (), lambda r, s, c: pairs(r, (0.01, 0.05, 0.15)[s], c)),
    "lines": ("lines", ("no_normals",), lambda r, s, c: lines(r, (6, 10, 20)[s], c)),
    "degrees": ("mixed_units", ("no_normals",), lambda r, s, c: [
        [11.57 + (9e-6, 1e-4, 1e-3)[s] * x[0], 48.13 + 0.67 * (9e-6, 1e-4, 1e-3)[s] * x[1], 520 + x[2]] for x in r]),
    "float on a map": ("lost_digits", ("no_normals", "duplicates", "in_line", "twins", "lines", "ties"), lambda r, s, c: [
        [as_float(x) for x in row] for row in on_map(r, (0.3, 0.6, 1.0)[s])]),
    "six digits": ("lost_digits", ("no_normals", "duplicates", "in_line", "twins", "lines", "ties"), lambda r, s, c: [
        [as_six_digits(x) for x in row] for row in on_map(r, (3.0, 10.0, 20.0)[s])]),
    "zeros of a camera": ("sentinels", ("duplicates", "zero_normals"), lambda r, s, c: every(
        [[x[0], x[1], x[2] + 5] + x[3:] for x in r], s, lambda row: [0, 0, 0] + row[3:])),
    "heights -9999": ("sentinels", (), lambda r, s, c: every(
        [[4e5 + 300 * x[0], 5e6 + 300 * x[1], 500 + 300 * x[2]] + x[3:] for x in r], s, lambda row: row[:2] + [-9999] + row[3:])),
    "depths of a camera": ("sentinels", (), lambda r, s, c: every(
        [[x[0], x[1], x[2] + 5] + x[3:] for x in r], s, lambda row: row[:2] + [(0, -1, -999)[s]] + row[3:])),
    "kilometers": ("mixed_units", ("no_normals",), lambda r, s, c: [
        [(0, 5, 690)[s] + 1e-3 * x[0], (0, 8, 5300)[s] + 1e-3 * x[1], 520 + x[2]] for x in r]),
    "not finite": ("non_finite", (), lambda r, s, c: every(r, s, lambda row: [NAN] + row[1:])),
    "copies": ("duplicates", (), lambda r, s, c: r + r[:: (500, 20, 2)[s]]),
    "strays": ("isolated_points", (), lambda r, s, c: strays(r, (1, 3, 8)[s], c)),
}


def told(program, path):
    """The checks that accuse a file, and (command, effect) of each remedy that is printed."""
    text = subprocess.run([program, "doctor", path], capture_output=True, text=True).stdout
    accused = re.findall(r"^  (?:error|warning) +([a-z_]+):", text, re.M)
    effects = re.findall(r"^ +try: (.*)\n +tried: (.*)$", text, re.M)
    effects += re.findall(r"^ +without gain: (.*? OUT\.ply(?: --drop [a-z_]+)?(?: --force)?): (.*)$", text, re.M)
    return accused, sorted(set(effects))


def outcome(report):
    """The outcome of a run, in the doctor's words."""
    judged = json.loads(report.read_text())["verdict"]
    if judged["stopped"]:
        return "stopped"
    if judged["triangles"] == 0:
        return "no triangle"
    amiss = judged["points_amiss"]
    return "sound" if judged["sound"] else f"{amiss} point{'' if amiss == 1 else 's'} amiss"


def end(program, arguments):
    """The outcome of a run with these arguments."""
    report = work / "report.json"
    report.unlink(missing_ok=True)
    subprocess.run([program, "run", *arguments, "-q", "--report", report], capture_output=True)
    return outcome(report) if report.exists() else "no report"


def effect(program, path, command):
    """The effect of a command that was printed, as another run of it has it."""
    words = shlex.split(command)[1:]
    out = work / "out.ply"
    words = [str(out) if word == "OUT.ply" else word for word in words]
    if "--best" in words:
        report = work / "best.json"
        subprocess.run([program, *words, "-q", "--report", report], capture_output=True)
        return outcome(report)
    if words[0] == "doctor":
        out.unlink(missing_ok=True)
        done = subprocess.run([program, *words, "--force"], capture_output=True, text=True)
        if not out.exists():
            return done.stderr.strip()
        if "--drop" not in words:
            report = json.loads(subprocess.run([program, "info", out, "--json"], capture_output=True, text=True).stdout)
            return f"writes {report['points']} points, without those that every run sets aside"
        after = [str(out)]
    else:
        at = words.index("-o")
        after = words[1:at] + words[at + 2 :]
    sides = [f"by {rules} {end(program, after + ['--rules', rules])} (before {end(program, [str(path), '--rules', rules])})"
             for rules in ("paper", "robust")]
    return ", ".join(sides)


def write(path, rows):
    path.write_text("".join(" ".join(map(repr, map(float, row))) + "\n" for row in rows))


def main():
    words = sys.argv[1:]
    held_out = words[:1] == ["--held-out"]
    program, *chosen = words[1:] if held_out else words
    chosen = chosen or list(CAUSES)
    if held_out:
        shapes = {name: scattered(surface) for name, surface in HELD_OUT.items()}
    else:
        shapes = {shape: sampled(program, shape) for shape in SHAPES}
    bad = 0
    for shape, rows in shapes.items():
        path = work / f"{shape}.xyz"
        write(path, rows)
        accused, _ = told(program, path)
        if accused:
            print(f"clean {shape} is accused: {' '.join(accused)}")
            bad = 1
    print("| cause | check | judged right | effects as said |")
    print("|---|---|--:|--:|")
    all_right = all_files = 0
    for cause in chosen:
        check, also, plant = CAUSES[cause]
        right = files = as_said = effects = 0
        for strength in range(3):
            for shape, rows in shapes.items():
                path = work / f"{shape}-{strength}.xyz"
                write(path, plant(rows, strength, random.Random(5 + strength)))
                accused, commands = told(program, path)
                files += 1
                good = check in accused and not set(accused) - {check, *also}
                right += good
                if not good:
                    print(f"{cause} {strength} in {shape}: {' '.join(accused) or 'nothing'}", file=sys.stderr)
                for command, said in commands:
                    effects += 1
                    now = effect(program, path, command)
                    same = said.startswith(now)
                    as_said += same
                    if not same:
                        print(f"{command}\n  said {said}\n  now  {now}", file=sys.stderr)
        print(f"| {cause} | `{check}` | {right} of {files} | {as_said} of {effects} |", flush=True)
        all_right, all_files, bad = all_right + right, all_files + files, bad or as_said < effects
    print(f"\njudged right: {all_right} of {all_files}")
    sys.exit(bool(bad or all_right < 0.95 * all_files))


if __name__ == "__main__":
    main()
