#!/usr/bin/env python3
"""The verdicts of meshes by `paper`, `robust` and `--best`: verdicts.py [--before OLD] PROGRAM FILE...

Prints a Markdown table, a row for each file, and what it comes to. PROGRAM: build/bin/spiraling-edge. OLD: an
earlier program; its meshes are judged by `check` of PROGRAM too, so that both are counted alike. A cell is the
number of places with faults, then each count of docs/robust.md, "Better", that is not 0. A run that takes longer
than LIMIT seconds (environment, 300) is a cell as well. ONLY (environment) names the settings to run, such as
`robust`. Exit code 1 if settings that `--best` takes are worse than
`robust` for any file, or if its work is more than 25 times that of its dearest run. Where it takes none,
or `robust` makes no triangle, there is nothing to compare; such files are named.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

COUNTS = {
    "points_lost": "lost",
    "extra_pieces": "pieces",
    "hole_edges": "hole edges",
    "openings_closed": "closed",
    "triangles_against_normals": "turned",
    "pieces_facing_in": "inward",
    "points_not_covered": "uncovered",
}
SETTINGS = {"paper": ["--rules", "paper"], "robust": ["--rules", "robust"], "best": ["--best"]}
LIMIT = int(os.environ.get("LIMIT", "300"))
ONLY = os.environ.get("ONLY", " ".join(SETTINGS)).split()
work = pathlib.Path(tempfile.mkdtemp())


def run(program, file, options):
    """The mesh's path and the report, or what went wrong."""
    mesh, report = work / "mesh.ply", work / "report.json"
    for path in (mesh, report):
        path.unlink(missing_ok=True)
    command = [program, "run", file, *options, "-q", "-o", mesh, "--report", report]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return None, f"no end in {LIMIT} s"
    if done.returncode not in (0, 1) or not mesh.exists() or not report.exists():
        return None, f"code {done.returncode}"
    return mesh, json.loads(report.read_text())


def verdict(program, mesh, file):
    """What `check` says of a saved mesh beside the points it was made from."""
    done = subprocess.run([program, "check", mesh, "--points", file, "--json"], capture_output=True, text=True)
    try:
        return json.loads(done.stdout)["verdict"]
    except (ValueError, KeyError):
        return None


def cell(judged):
    if judged is None:
        return "no mesh"
    if judged["sound"]:
        return "sound"
    counts = [f"{judged[key]} {word}" for key, word in COUNTS.items() if judged[key]]
    return f"{judged['places']}" + (f" ({', '.join(counts)})" if counts else "")


def worse(judged, than):
    """True if a verdict comes after another in the order of `--best` (docs/robust.md)."""
    if judged is None or than is None:
        return False
    def rank(verdict):
        return (not verdict["sound"], verdict["points_amiss"], verdict["extra_pieces"])
    return rank(judged) > rank(than)


def median(numbers):
    return sorted(numbers)[len(numbers) // 2] if numbers else 0


def main():
    words = sys.argv[1:]
    before = words[1] if words[:1] == ["--before"] else None
    program, *files = words[2:] if before else words
    sides = ([("before", before)] if before else []) + [("now", program)]
    columns = [(name, side, by) for name in SETTINGS if name in ONLY for side, by in sides]
    print("| file |" + "".join(f" {name}{', ' + side if before else ''} |" for name, side, _ in columns))
    print("|---" * (len(columns) + 1) + "|")
    costs, sound, sums, judged_worse = [], {}, {}, {}
    for file in files:
        judged, reports = {}, {}
        for name, side, by in columns:
            mesh, report = run(by, file, SETTINGS[name])
            judged[name, side] = verdict(program, mesh, file) if mesh else report
            reports[name, side] = report if mesh else {}
        cells = [v if isinstance(v, str) else cell(v) for v in judged.values()]
        print(f"| {pathlib.Path(file).stem} | " + " | ".join(cells) + " |", flush=True)
        whole = {key: None if isinstance(v, str) else v for key, v in judged.items()}
        for key, v in whole.items():
            sound[key] = sound.get(key, 0) + bool(v and v["sound"])
        # Only where each side has a mesh, so that they count the same files.
        for key, v in whole.items() if all(v and v["triangles"] for v in whole.values()) else ():
            for count in ("places", "faults", *COUNTS):
                sums.setdefault(key, {}).setdefault(count, 0)
                sums[key][count] += v[count]
        for side, _ in sides:
            if not worse(whole.get(("best", side)), whole.get(("robust", side))):
                continue
            empty = whole["robust", side]["triangles"] == 0
            none_taken = reports["best", side].get("best", {}).get("chosen") == 0
            kind = "not comparable" if empty or none_taken else "worse"
            judged_worse.setdefault((side, kind), []).append(pathlib.Path(file).stem)
        spent = [trial["work"] for trial in reports.get(("best", "now"), {}).get("best", {}).get("tried", [])]
        if spent and max(spent):
            costs.append(sum(spent) / max(spent))
    print()
    for key, count in sound.items():
        print(f"sound by {key[0]}, {key[1]}: {count} of {len(files)}; in sum", ", ".join(f"{n} {c}" for c, n in sums.get(key, {}).items()))
    for side, _ in sides:
        for kind in ("worse", "not comparable"):
            names = judged_worse.get((side, kind), [])
            print(f"--best {kind} {'than' if kind == 'worse' else 'with'} robust, {side}: {len(names)} of {len(files)} {' '.join(names)}")
    print(f"work of all runs over that of the dearest: median {median(costs):.1f}, at most {max(costs, default=0):.1f}")
    sys.exit(bool(judged_worse.get(("now", "worse"))) or max(costs, default=0) > 25)


if __name__ == "__main__":
    main()
