#!/usr/bin/env python3
"""Draws one pivot with matplotlib: its neighbor ring, the edge ring, and the circumsphere test of section 6.3.

    draw_pivot.py [SCAN or scene:NAME] [ADDRESS] [PICTURE]
"""
import sys
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import spiraling_edge as se

source, address, picture = (sys.argv[1:] + ["scene:torus", "137.sphere.3", "pivot.png"][len(sys.argv) - 1:])[:3]
state = se.Run(source).at(address)
if state.pivot is None:
    sys.exit(f"{address}: no decision of a pivot; try {address.split('.')[0]}.sort.1")


def plot(points, *style, **look):
    plane = state.in_plane(points)
    axes.plot(plane[:, 0], plane[:, 1], *style, **look)


figure, axes = plt.subplots(figsize=(7, 7), layout="constrained")
for corners in state.new_triangles:
    plane = state.in_plane(corners)
    axes.fill(plane[:, 0], plane[:, 1], color="#F6DFA8", ec="#B07800")
offset, ids = state.prepared.neighbors
near = [int(p) for p in ids[offset[state.pivot]:offset[state.pivot + 1]]]
shown = {*near, *map(int, state.neighbor_ring.points), state.first, state.last, state.pivot}
plot(near, "o", mfc="white", mec="#6B7280", label="neighbors")
ring = state.rings[0].points.tolist()
for i, p in enumerate(ring):
    step = [p, ring[(i + 1) % len(ring)]]
    if shown.issuperset(step):
        plot(step, "-", color="#2A7FC0", lw=3, label="edge ring" if p == state.pivot else None)
plot(state.neighbor_ring.points, "s--", color="#2A7FC0", mfc="#2A7FC0", label="neighbor ring")
rejected = [each.point for each in state.candidates if not each.kept]
plot(rejected, "x", color="#A83A00", ms=9, mew=2.5, label="rejected")
plot([state.first], ">", color="#00694D", ms=11, label="first")
plot([state.last], "<", color="#8E2C8A", ms=11, label="last")
plot([state.pivot], "o", color="black", ms=11, mfc="white", mew=4, label="pivot")
for p in shown:
    axes.annotate(str(p), state.in_plane([p])[0], xytext=(6, 6), textcoords="offset points",
                  bbox={"fc": "white", "ec": "none", "pad": 1})
if state.under_test is not None:
    plot([state.under_test], "o", mfc="none", mec="#B07800", ms=20, mew=2, label="under test")
if len(state.circle()):
    circle = state.in_plane(state.circle())
    axes.plot(circle[:, 0], circle[:, 1], "-", color="#B07800", label="through p, s and t")
axes.set_aspect("equal")
axes.margins(0.12)
sentence = textwrap.fill(state.event.sentence, 80)
axes.set_title(f"{state.address}, section {state.event.section}\n{sentence}", fontsize=10)
axes.set_xlabel("tangent plane of the pivot, first to the right; in the unit of the points")
axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncol=4, markerscale=0.7)
figure.savefig(picture, dpi=120)
print(f"{picture}: {state.event.sentence}")
