#!/usr/bin/env python3
"""Draws one pivot with matplotlib: angles are those of section 6.1, counterclockwise from first.

    draw_pivot.py [SCAN or scene:NAME] [ADDRESS] [PICTURE]
"""
import sys
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import spiraling_edge as se

source, address, picture = (sys.argv[1:] + ["scene:torus", "137.sphere.3", "pivot.png"][len(sys.argv) - 1:])[:3]
state = se.Run(source).at(address)
if state.pivot is None:
    sys.exit(f"{address}: no decision of a pivot; try {address.split('.')[0]}.sort.1")
position = state.prepared.position
figure, axes = plt.subplots(figsize=(7, 7), layout="constrained", subplot_kw={"projection": "polar"})


def plot(points, degrees, style, **look):
    distance = np.linalg.norm(position[list(points)] - position[state.pivot], axis=1)
    axes.plot(np.radians(degrees), distance, style, **look)
    for point, angle, far in zip(points, degrees, distance):
        axes.annotate(str(point), (np.radians(angle), far), xytext=(7, 7), textcoords="offset points")


ring = state.neighbor_ring
rejected = [each for each in state.candidates if not each.kept]
plot(ring.points, ring.degrees, "s-", color="#2A7FC0", label="neighbor ring")
plot([each.point for each in rejected], [each.degrees for each in rejected], "x", color="#A83A00", label="rejected")
plot([state.first], [0.0], ">", color="#00694D", ms=10, label="first")
plot([state.last], [state.sector_degrees], "<", color="#8E2C8A", ms=10, label="last")
tested = [each for each in state.candidates if each.point == state.under_test]
plot([each.point for each in tested], [each.degrees for each in tested], "o", color="#B07800", mfc="none", ms=18,
     label="under test")
axes.bar(0.0, axes.get_ylim()[1], np.radians(state.sector_degrees), align="edge", alpha=0.15, label="free sector")
axes.set_title(f"{address}: {textwrap.fill(state.event.sentence, 80)}", fontsize=10)
axes.set_xlabel(f"angle at the pivot {state.pivot} (6.1), distance from it in the unit of the points")
axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncol=3)
figure.savefig(picture, dpi=120)
print(f"{picture}: {state.event.sentence}")
