#!/usr/bin/env python3
"""Compares a student's stages of a pivot with ours, pivot by pivot: each gets our result of the stages before it.

    compare_stages.py [SCAN or scene:NAME] [PIVOTS]

Write your own in place of sort_angle(), inside_sphere() and fan_triangles(). Ends with 1 at a difference.
"""
import collections
import sys

import numpy as np

import spiraling_edge as se

points, pivots = (sys.argv[1:] + ["scene:torus", "200"][len(sys.argv) - 1:])[:2]
run = se.Run(points)
position, normals = run.prepared.position, run.prepared.normals


def sort_angle(p, first, q):
    """6.1: the angle of q at p, in degrees from first, counterclockwise about the normal of p."""
    z, v = (position[x] - position[p] for x in (first, q))
    cosine = (z @ v) / np.sqrt((z @ z) * (v @ v))
    degrees = np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))
    return degrees if np.cross(normals[p], z) @ v >= 0.0 else 360.0 - degrees


def inside_sphere(p, t, q, s):
    """6.3: whether q is inside the sphere whose equator is the circle through p, s and t."""
    a, b = position[t] - position[p], position[s] - position[p]
    across = np.cross(a, b)
    center = np.cross((a @ a) * b - (b @ b) * a, across) / (2.0 * (across @ across))
    return np.linalg.norm(position[q] - position[p] - center) < np.linalg.norm(center)


def fan_triangles(p, fan):
    """6.4: the triangles of the pivot with each two points of the fan that follow each other."""
    return [(p, fan[i], fan[i + 1]) for i in range(len(fan) - 1)]


def answers(state, event, numbers):
    """Your result and ours for a decision; None where the stage is not compared."""
    if event.stage == "sort" and numbers["verdict"] == "kept":
        return round(sort_angle(state.pivot, state.first, numbers["point"]), 6), round(numbers["degrees"], 6)
    if event.stage == "sphere" and numbers["verdict"] != "no circle":
        ours = numbers["distance"] < numbers["radius"]
        return inside_sphere(state.pivot, numbers["t"], numbers["q"], numbers["s"]), ours
    if event.stage == "emit":
        fan = state.fan.points.tolist()
        return fan_triangles(state.pivot, fan)[len(state.new_triangles) - 1], numbers["corners"]
    return None


seen, wrong = collections.Counter(), collections.Counter()
state = run.at(1)
while state and state.event.pivot <= int(pivots):
    pair = answers(state, state.event, state.event.evidence) if state.pivot is not None else None
    if pair:
        seen[state.event.stage] += 1
        wrong[state.event.stage] += pair[0] != pair[1]
        if pair[0] != pair[1] and wrong[state.event.stage] == 1:
            print(f"{state.address}: yours {pair[0]}, ours {pair[1]}. {state.event.sentence}")
    state = run.forward()
for stage, count in seen.items():
    print(f"{stage:<8} {count - wrong[stage]} of {count} decisions equal")
sys.exit(1 if any(wrong.values()) else 0)
