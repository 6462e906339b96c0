#!/usr/bin/env python3
"""Makes the tables and pictures of docs/failures.md: every class of failure of every set, with its
three moments and a picture; which decisions all failures lead to; what turning them does; and the
scenes of the failure gallery.

  docs/make-failures.py [--cli CLI] [--viewer VIEWER] [--sets FOLDER] [--prove] [--no-pictures]

FOLDER holds the sets (*.ply). --prove turns the decisions anew, which takes a quarter of an hour. Pictures need
convert. Text between the marks is written anew, the rest of the page is left alone.
"""
import argparse
import collections
import json
import pathlib
import re
import struct
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE / "failures.md"
LETTERS = "ABCDEFGHIJKLM"
PROOFS = ["gone", "gone, asked again", "gone with the earlier", "another in its place", "stays", "cannot be turned"]
# Large classes are sampled: so many of each class are turned.
SAMPLE = 100
FEWER = {"bunny": 10, "armadillo": 10, "mannequin_devil": 20, "table1_lobster": 4, "sphere_noisy": 4}
# What a picture shows: of the first of these classes that the set has the first failure; or these.
TELLING = ["intersecting_triangles", "holes", "flipped_triangles", "folded_edges", "unused_points", "slivers"]
CHOSEN = {"three_peaks": "holes:1", "fin90": "holes:1", "fandisk": "unused_points:1",
          "sphere_noisy": "unused_points:300"}
LOST = ("leftover_rings", "holes", "unused_points", "isolated_points", "triangle_cap")


def options():
    parser = argparse.ArgumentParser()
    build = HERE.parent / "build/bin"
    parser.add_argument("--cli", default=str(build / "spiraling-edge"))
    parser.add_argument("--viewer", default=str(build / "spiraling-edge-viewer"))
    parser.add_argument("--sets", type=pathlib.Path, default=HERE.parent.parent / "shared/data/points")
    parser.add_argument("--prove", action="store_true")
    parser.add_argument("--no-pictures", dest="pictures", action="store_false")
    return parser.parse_args()


def asked(*words):
    answer = subprocess.run([ARGS.cli, *words], check=True, capture_output=True, text=True)
    return json.loads(answer.stdout)


def rank(line):
    pivot, stage, n = (line["address"].split(".") + ["", "0"])[:3]
    return int(pivot), stage, int(n)


def positions(path):
    """Position and normal of every point of a binary PLY; nothing without normals."""
    head, _, body = path.read_bytes().partition(b"end_header\n")
    lines = [line.split() for line in head.decode().splitlines()]
    first = next(i for i, words in enumerate(lines) if words[:2] == ["element", "vertex"])
    columns = []
    for words in lines[first + 1:]:
        if words[0] != "property":
            break
        columns.append((words[2], {"float": "f", "double": "d", "uchar": "B", "int": "i"}[words[1]]))
    if "nx" not in dict(columns):
        return []
    form = "<" + "".join(kind for _, kind in columns)
    at = [[name for name, _ in columns].index(name) for name in ("x", "y", "z", "nx", "ny", "nz")]
    rows = struct.iter_unpack(form, body[:int(lines[first][2]) * struct.calcsize(form)])
    return [[row[i] for i in at] for row in rows]


def scene_points(scene):
    with tempfile.NamedTemporaryFile(suffix=".ply") as mesh:
        subprocess.run([ARGS.cli, "run", "scene:" + scene, "-o", mesh.name, "-q"], check=True)
        return positions(pathlib.Path(mesh.name))


def is_wide(points, failure):
    """Does its triangle span more than 180 degrees at the pivot?"""
    made = re.search(r"= \((\d+), (\d+), (\d+)\)", failure["created"]["text"])
    if not points or not made:
        return False
    p, x, y = (points[int(i)] for i in made.groups())
    u, v = ([q[i] - p[i] for i in range(3)] for q in (x, y))
    n = p[3:]
    return sum((u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2]) * n[i] for i in range(3)) < 0


def reason(failure, points=()):
    """The letter of the paragraph that says why this decision is the cause."""
    line = failure["unavoidable"]
    pivot, stage = line["address"].split(".")[:2]
    if failure["class"] in LOST:
        if stage == "sort":
            return "G" if "same angle" in line["text"] else "L"
        return {"twopoint": "F", "limits": "B", "insert": "K"}.get(
            stage, "H" if line["role"] == "fact" else "G")
    if stage != "emit" and failure["created"]["address"].split(".")[0] != pivot:
        return "E"
    if stage == "sphere":
        if "no circle" in line["text"]:
            return "D"
        if line["role"] == "refused":
            return "C"
        return "M" if is_wide(points, failure) else "A"
    return {"limits": "B", "insert": "K", "sort": "I", "reciprocal": "I", "hole": "I"}.get(stage, "J")


def first_of(failures, kind):
    return min((f for f in failures if f["class"] == kind), key=lambda f: rank(f["created"]))


def short(text):
    """Without the numbers of the sphere: a click shows them."""
    return re.sub(r" \((d|turn) = ?[^)]*\)| \(turn [^)]*\)", "", text).replace("|", "\\|")


def row(name, failure, count, points=()):
    moments = [f"`{failure[m]['address']}`" for m in ("created", "unavoidable", "first_touched")]
    at = ", ".join(str(p) for p in failure["points"][:6])
    if len(failure["points"]) > 6:
        at += f", ... ({len(failure['points'])})"
    said = short(failure["unavoidable"]["text"])
    return f"| {name} | {count} | {at} | {' | '.join(moments)} | {said} | {reason(failure, points)} |"


HEAD = ["| class | failures | points of the first | created | unavoidable | first touched | what was decided there | cause |",
        "|---|---|---|---|---|---|---|---|"]


def sources():
    """Name and argument of every set."""
    return [(path.stem, str(path)) for path in sorted(ARGS.sets.glob("*.ply"))]


def gallery_scenes():
    return [scene for scene in asked("scenes", "--json") if "failure" in scene]


def number_of(failures, chosen):
    return [f for f in failures if f["class"] == chosen["class"]].index(chosen) + 1


def sets(reports):
    lines = []
    for name, source in sources():
        report = reports[name]
        lines += [f"### {name}", ""]
        counts = {k: v for k, v in report["counts"].items() if v}
        if not counts:
            lines += ["No failures found.", ""]
            continue
        kind = next((k for k in TELLING if k in counts), next(iter(counts)))
        alert = CHOSEN.get(name)
        if alert is None:
            alert = f"{kind}:{number_of(report['failures'], first_of(report['failures'], kind))}"
        picture(source, name, alert)
        lines += [f'<img src="images/failure-{name}.png" width="480" alt="{alert} of {name}">', "",
                  f"`--alert {alert}`", ""]
        lines += HEAD
        points = positions(pathlib.Path(source))
        lines += [row(f"`{kind}`", first_of(report["failures"], kind), n, points) for kind, n in counts.items()]
        lines.append("")
    return lines


def letters(reports):
    lines = ["| set | alerts | " + " | ".join(LETTERS) + " |", "|---|---|" + "---|" * len(LETTERS)]
    total = collections.Counter()
    for name, source in sources():
        points = positions(pathlib.Path(source))
        count = collections.Counter(reason(f, points) for f in reports[name]["failures"])
        total += count
        lines.append(letter_row(name, count))
    return lines + [letter_row("all", total), ""]


def letter_row(name, count):
    return f"| {name} | {sum(count.values())} | " + " | ".join(str(count[c] or "") for c in LETTERS) + " |"


def proofs():
    lines = ["| set | turned | " + " | ".join(PROOFS) + " |", "|---|---|" + "---|" * len(PROOFS)]
    total = collections.Counter()
    for name, source in [("scene:" + s["id"], "scene:" + s["id"]) for s in gallery_scenes()] + sources():
        most = FEWER.get(name, SAMPLE)
        found = asked("why", source, "--failures", "--prove", "--most", str(most), "--json", "-q")
        count = collections.Counter(each["proof"] for each in found["proofs"])
        total += count
        lines.append(proof_row(name, count))
    able = sum(total.values()) - total["cannot be turned"]
    gone = able - total["stays"]
    alone = gone - total["another in its place"]
    return [f"Of {able} decisions that can be turned, {gone} take their failure with them ({100 * gone / able:.0f} %), "
            f"{alone} without a new one of its class in its place.", ""] + lines + [proof_row("all", total), ""]


def proof_row(name, count):
    return f"| {name} | {sum(count.values())} | " + " | ".join(str(count[p] or "") for p in PROOFS) + " |"


def gallery():
    lines = ["| scene | class | points | created | unavoidable | first touched | what was decided there | cause |",
             "|---|---|---|---|---|---|---|---|"]
    for scene in gallery_scenes():
        kind, address = scene["failure"], scene["address"]
        failures = asked("why", "scene:" + scene["id"], "--failures", "--json", "-q")["failures"]
        same = [f for f in failures if f["class"] == kind]
        exact = [f for f in same if f["unavoidable"]["address"] == address]
        near = [f for f in same if f["created"]["address"].split(".")[0] == address.split(".")[0]]
        chosen = (exact or near or same)[0]
        lines.append(row(f"`{scene['id']}`", chosen, f"`{kind}`", scene_points(scene["id"])))
        picture("scene:" + scene["id"], scene["id"], f"{kind}:{number_of(failures, chosen)}", "900x560", 144)
    lines.append("")
    return lines


def picture(source, name, alert, size="640x400", colors=48):
    """With as many colors as fit into 30 kB."""
    if not ARGS.pictures:
        return
    path = HERE / "images" / f"failure-{name}.png"
    with tempfile.NamedTemporaryFile(suffix=".png") as full:
        subprocess.run([ARGS.viewer, source, "--no-config", "--layout", "present", "--ui-scale",
                        "0.9" if size == "900x560" else "0.75", "--size", size, "--alert", alert,
                        "--screenshot", full.name], check=True)
        while True:
            subprocess.run(["convert", full.name, "+dither", "-colors", str(colors), "-strip", "-define",
                            "png:compression-level=9", "PNG8:" + str(path)], check=True)
            if size == "900x560" or colors < 12 or path.stat().st_size <= 30000:
                return
            colors = colors * 3 // 4


def put(text, mark, lines):
    begin, end = f"<!-- begin {mark} -->", f"<!-- end {mark} -->"
    before, rest = text.split(begin)
    return before + begin + "\n" + "\n".join(lines) + end + rest.split(end)[1]


def main():
    reports = {name: asked("why", source, "--failures", "--json", "-q") for name, source in sources()}
    page = PAGE.read_text()
    page = put(page, "gallery", gallery())
    page = put(page, "causes", letters(reports))
    if ARGS.prove:
        page = put(page, "proofs", proofs())
    page = put(page, "sets", sets(reports))
    PAGE.write_text(page)


if __name__ == "__main__":
    ARGS = options()
    main()
