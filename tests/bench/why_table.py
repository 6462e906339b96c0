#!/usr/bin/env python3
"""Random questions to `why`, each answer's inversion run again: why_table.py PROGRAM COUNT FILE... [SEED]

For each FILE and for the rules paper, corrected and robust, COUNT questions of each kind are drawn by chance (SEED: 1):
unused points, missing edges (of near points that share no triangle), missing triangles, wrong triangles (at a fault),
triangles of the mesh, and faults (holes first). A proved answer names a what-if; the run is repeated with it by
`run --what-if`, and its mesh must hold the subject where the first did not, and the other way around; a fault must be
gone. Prints a Markdown table. PROGRAM: build/bin/spiraling-edge.
Exit code 1 if a proof is false, or if under 90 % of the unused points, missing edges, wrong triangles and faults are
proved.
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile

RULES = ("paper", "corrected", "robust")
NOT_ASKED = ("openings", "slivers", "leftover_rings", "lost_points")  # No faults, or asked about as points.
COUNTED = ("unused point", "missing edge", "wrong triangle", "fault")
work = pathlib.Path(tempfile.mkdtemp())


def mesh_of(program, file, options):
    """Triangles by the numbers of the prepared points, and the report of a run."""
    out, report = work / "mesh.obj", work / "report.json"
    for path in (out, report):
        path.unlink(missing_ok=True)
    done = subprocess.run([program, "run", file, *options, "-q", "-o", out, "--report", report], capture_output=True, text=True)
    if not out.exists():
        sys.exit(f"{file} {options}: {done.stderr}")
    lines = [line.split() for line in out.read_text().splitlines()]
    points = [tuple(map(float, w[1:4])) for w in lines if w and w[0] == "v"]
    faces = [tuple(int(x.split("/")[0]) - 1 for x in w[1:4]) for w in lines if w and w[0] == "f"]
    return points, faces, json.loads(report.read_text())


def holds(faces, subject):
    return any(set(subject) <= set(face) for face in faces)


def near(points, p, count):
    order = sorted(range(len(points)), key=lambda q: sum((a - b) ** 2 for a, b in zip(points[p], points[q])))
    return [q for q in order if q != p][:count]


def questions(points, faces, report, count, chance):
    """Kind and subject of each question."""
    used = {p for face in faces for p in face}
    edges = {frozenset(e) for f in faces for e in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0]))}
    whole = {frozenset(f) for f in faces}
    lost = [p for p in range(len(points)) if p not in used]
    asked = [("unused point", [p]) for p in chance.sample(lost, min(count, len(lost)))]
    for _ in range(count):
        p = chance.randrange(len(points))
        others = [q for q in near(points, p, 6) if frozenset((p, q)) not in edges]
        if others:
            asked.append(("missing edge", [p, others[0]]))
        three = [p] + near(points, p, 2)
        if frozenset(three) not in whole:
            asked.append(("missing triangle", three))
        if faces:
            asked.append(("triangle", list(faces[chance.randrange(len(faces))])))
    wrong = [list(faces[fault[key]]) for fault in report.get("fault_list", []) for key in ("triangle", "other") if fault.get(key) is not None]
    asked += [("wrong triangle", t) for t in chance.sample(wrong, min(count, len(wrong)))]
    return asked


def failures(program, file, options):
    """The failures of a run, with their names CLASS:N."""
    done = subprocess.run([program, "why", file, *options, "--failures", "--json", "-q"], capture_output=True, text=True)
    count, named = {}, []
    for failure in json.loads(done.stdout)["failures"]:
        kind = failure["class"]
        count[kind] = count.get(kind, 0) + 1
        named.append((f"{kind}:{count[kind]}", kind, failure["points"]))
    return named


def add(tally, key, answer):
    """Counts an answer; True if it has an inversion."""
    row = tally.setdefault(key, [0, 0, 0])
    row[0] += 1
    row[1] += answer["proved_by"] == "inversion"
    row[2] += answer["proved_by"] in ("step", "preparation")
    return answer["proved_by"] == "inversion"


def why(program, file, rules, *subject):
    """The answer to a question; None if it has none."""
    done = subprocess.run([program, "why", file, "--rules", rules, *subject, "--json", "-q"], capture_output=True, text=True)
    if done.returncode:
        print(f"{file} {rules} {subject}: {done.stderr.strip()}", file=sys.stderr)
        return None
    answer = json.loads(done.stdout)
    if answer["proved_by"] == "nothing":
        print(f"{file} {rules} {subject}: {answer['answer']}", file=sys.stderr)
    return answer


def what_ifs(answer):
    """The options of the run that proves an answer."""
    without = ["--rule", answer["without"]] if "without" in answer else []
    return [word for line in answer["what_if"] for word in ("--what-if", line)] + without


def main():
    program, count, *files = sys.argv[1:]
    seed = int(files.pop()) if files[-1].isdigit() else 1
    tally, false = {}, 0
    for file in files:
        for rules in RULES:
            points, faces, report = mesh_of(program, file, ["--rules", rules])
            for kind, subject in questions(points, faces, report, int(count), random.Random(seed)):
                option = {1: "--point", 2: "--edge", 3: "--triangle"}[len(subject)]
                answer = why(program, file, rules, option, ",".join(map(str, subject)))
                if answer is None or not add(tally, (rules, kind), answer):
                    continue
                _, other, _ = mesh_of(program, file, ["--rules", rules, *what_ifs(answer)])
                if holds(other, subject) == answer["present"] or holds(faces, subject) != answer["present"]:
                    print(f"FALSE: {file} {rules} {option} {subject}: {answer['what_if']}", file=sys.stderr)
                    false += 1
            faults = [f for f in failures(program, file, ["--rules", rules]) if f[1] not in NOT_ASKED]
            random.Random(seed).shuffle(faults)
            for name, kind, members in sorted(faults, key=lambda fault: fault[1] != "holes")[: int(count)]:
                answer = why(program, file, rules, "--failure", name)
                if answer is None or not add(tally, (rules, "fault"), answer):
                    continue
                left = failures(program, file, ["--rules", rules, *what_ifs(answer)])
                if (kind, members) in [(k, p) for _, k, p in left]:
                    print(f"FALSE: {file} {rules} {name}: {answer['what_if']}", file=sys.stderr)
                    false += 1
    print("| rules | question | asked | by inversion | by a step or preparation |\n|---|---|--:|--:|--:|")
    for (rules, kind), (asked, inverted, other) in sorted(tally.items()):
        print(f"| {rules} | {kind} | {asked} | {inverted} | {other} |")
    counted = [row for (_, kind), row in tally.items() if kind in COUNTED]
    asked, proved = sum(row[0] for row in counted), sum(row[1] + row[2] for row in counted)
    print(f"\nproved: {proved} of {asked}, falsely: {false}")
    sys.exit(bool(false or proved < 0.9 * asked))


if __name__ == "__main__":
    main()
