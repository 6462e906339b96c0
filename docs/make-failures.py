#!/usr/bin/env python3
"""Makes the tables and pictures of docs/failures.md: every class of failure of every set, with its
three moments, and the scenes of the failure gallery.

  docs/make-failures.py [CLI] [VIEWER] [FOLDER]   FOLDER holds the sets (*.ply); needs convert

Text between the marks is written anew, the rest of the page is left alone.
"""
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
CLI = sys.argv[1] if len(sys.argv) > 1 else str(HERE.parent / "build/bin/spiraling-edge")
VIEWER = sys.argv[2] if len(sys.argv) > 2 else str(HERE.parent / "build/bin/spiraling-edge-viewer")
SETS = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else HERE.parent.parent / "shared/data/points")
PAGE = HERE / "failures.md"


def asked(*words):
    return json.loads(subprocess.run([CLI, *words], check=True, capture_output=True, text=True).stdout)


def rank(line):
    pivot, stage, n = (line["address"].split(".") + ["", "0"])[:3]
    return int(pivot), stage, int(n)


def reason(failure):
    """The letter of the paragraph that says why this decision is the cause."""
    line = failure["unavoidable"]
    stage = line["address"].split(".")[1]
    text = line["text"]
    if failure["class"] in ("leftover_rings", "holes", "unused_points", "isolated_points"):
        if stage == "twopoint":
            return "F"
        return "H" if line["role"] == "fact" else "G"
    if stage == "limits":
        return "B"
    if stage == "twopoint":
        return "E"
    if stage == "sphere":
        if "no circle" in text:
            return "D"
        return "C" if line["role"] == "refused" else "A"
    if stage == "insert":
        return "K"
    if stage in ("sort", "reciprocal", "hole"):
        return "I"
    return "J"


def first_of(failures, kind):
    return min((f for f in failures if f["class"] == kind), key=lambda f: rank(f["created"]))


def row(name, failure, count):
    moments = [f"`{failure[m]['address']}`" for m in ("created", "unavoidable", "first_touched")]
    points = ", ".join(str(p) for p in failure["points"][:6])
    if len(failure["points"]) > 6:
        points += f", ... ({len(failure['points'])})"
    said = failure["unavoidable"]["text"].replace("|", "\\|")
    return f"| {name} | {count} | {points} | {' | '.join(moments)} | {said} | {reason(failure)} |"


HEAD = ["| class | failures | points of the first | created | unavoidable | first touched | what was decided there | cause |",
        "|---|---|---|---|---|---|---|---|"]


def sets():
    lines = []
    for path in sorted(SETS.glob("*.ply")):
        report = asked("why", str(path), "--failures", "--json", "-q")
        lines += [f"### {path.stem}", ""]
        counts = {k: v for k, v in report["counts"].items() if v}
        if not counts:
            lines += ["No failures found.", ""]
            continue
        lines += HEAD
        lines += [row(f"`{kind}`", first_of(report["failures"], kind), n) for kind, n in counts.items()]
        lines.append("")
    return lines


def gallery():
    lines = ["| scene | class | points | created | unavoidable | first touched | what was decided there | cause |",
             "|---|---|---|---|---|---|---|---|"]
    for scene in asked("scenes", "--json"):
        if "failure" not in scene:
            continue
        kind, address = scene["failure"], scene["address"]
        failures = asked("why", "scene:" + scene["id"], "--failures", "--json", "-q")["failures"]
        same = [f for f in failures if f["class"] == kind]
        exact = [f for f in same if f["unavoidable"]["address"] == address]
        near = [f for f in same if f["created"]["address"].split(".")[0] == address.split(".")[0]]
        chosen = (exact or near or same)[0]
        number = same.index(chosen) + 1
        text = row(f"`{scene['id']}`", chosen, f"`{kind}`")
        lines.append(text)
        picture(scene["id"], f"{kind}:{number}")
    lines.append("")
    return lines


def picture(scene, alert):
    path = HERE / "images" / f"failure-{scene}.png"
    subprocess.run([VIEWER, "scene:" + scene, "--no-config", "--layout", "present", "--ui-scale", "0.9",
                    "--size", "900x560", "--alert", alert, "--screenshot", str(path)], check=True)
    subprocess.run(["convert", str(path), "+dither", "-colors", "144", "-strip", "-define",
                    "png:compression-level=9", "PNG8:" + str(path)], check=True)


def put(text, mark, lines):
    begin, end = f"<!-- begin {mark} -->", f"<!-- end {mark} -->"
    before, rest = text.split(begin)
    return before + begin + "\n" + "\n".join(lines) + end + rest.split(end)[1]


page = PAGE.read_text()
page = put(page, "gallery", gallery())
page = put(page, "sets", sets())
PAGE.write_text(page)
