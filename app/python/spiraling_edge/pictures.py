"""Pictures for notebooks: the tangent plane of a pivot as SVG, a mesh as PNG."""
from __future__ import annotations

import struct
import textwrap
import zlib
from html import escape
from typing import Sequence

import numpy as np

# Colors on white, each with a shape of its own, as in the viewer.
COLORS = {"pivot": "#000000", "used": "#2A7FC0", "first": "#00694D", "last": "#8E2C8A", "test": "#B07800",
          "rejected": "#A83A00", "unused": "#6B7280", "done": "#8E949C"}
OF_FANS = ("sort", "limits", "convex", "reciprocal", "hole", "sphere", "twopoint", "guard", "emit")
HALO = 'text-anchor="middle" paint-order="stroke" stroke="#fff" stroke-width="3"'
LEGEND = [("first", "first"), ("last", "last"), ("used", "candidate, ring"), ("rejected", "rejected"),
          ("unused", "UNUSED"), ("done", "DONE")]


SHAPES = {"first": "M-7 -7L7 0L-7 7Z", "last": "M7 -7L-7 0L7 7Z", "rejected": "M-5 -5L5 5M5 -5L-5 5",
          "unused": "M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0Z", "done": "M-3 0a3 3 0 1 0 6 0a3 3 0 1 0 -6 0Z",
          "used": "M-6 0a6 6 0 1 0 12 0a6 6 0 1 0 -12 0Z"}


def _mark(kind: str, x: float, y: float) -> str:
    look = {"rejected": ("none", 2.5), "unused": ("#fff", 1.5)}.get(kind, (COLORS[kind], 0))
    return (f'<path transform="translate({x:.1f} {y:.1f})" d="{SHAPES[kind]}" fill="{look[0]}" '
            f'stroke="{COLORS[kind]}" stroke-width="{look[1]}"/>')


def _kinds(state) -> dict:
    """The look of each point that is drawn, the most important last."""
    offset, ids = state.prepared.neighbors
    near = ids[offset[state.pivot]:offset[state.pivot + 1]].tolist()
    status = state.status
    kinds = {p: "done" if status[p] < 0 else "used" if status[p] > 0 else "unused" for p in near}
    kinds.update((p, "used") for p in state.fan.points.tolist())
    kinds.update((each.point, "used" if each.kept else "rejected") for each in state.candidates)
    kinds.update((p, look) for p, look in ((state.start, "first"), (state.end, "last"), (state.first, "first"),
                                           (state.last, "last")) if p is not None)
    kinds.pop(state.pivot, None)
    return kinds


def _drawing(state, size: int) -> list:
    kinds = _kinds(state)
    plane = dict(zip(kinds, state.in_plane(list(kinds))))
    plane[state.pivot] = np.zeros(2)
    reach = max([float(np.abs(place).max()) for place in plane.values()] + [1e-300])
    middle, scale = size / 2, 0.40 * size / reach
    pixel = {p: (middle + scale * x, middle - scale * y) for p, (x, y) in plane.items()}

    def path(points: Sequence[int]) -> str:
        return "L".join("%.1f %.1f" % pixel[p] for p in points)

    parts = []
    for corners in state.new_triangles.tolist():
        if all(p in pixel for p in corners):
            parts.append(f'<path d="M{path(corners)}Z" fill="#F6DFA8" stroke="{COLORS["test"]}"/>')
    fan = state.fan.points.tolist() if state.event.stage in OF_FANS else []
    spokes = "".join(f"M{path([state.pivot, p])}" for p in fan)
    parts.append(f'<path d="{spokes}M{path(fan)}" fill="none" stroke="{COLORS["used"]}" stroke-dasharray="4 4"/>'
                 if fan else "")
    for ring in state.rings[:1]:
        points = ring.points.tolist()
        steps = "".join(f"M{path(step)}" for step in zip(points, points[1:] + points[:1])
                        if step[0] in pixel and step[1] in pixel)
        parts.append(f'<path d="{steps}" stroke="{COLORS["used"]}" stroke-width="3.5"/>')
    rim = "L".join("%.1f %.1f" % (middle + scale * x, middle - scale * y) for x, y in state.in_plane(state.circle()))
    parts.append(f'<path d="M{rim}" fill="none" stroke="{COLORS["test"]}" stroke-width="1.5"/>' if rim else "")
    for p, kind in kinds.items():
        x, y = pixel[p]
        if p == state.under_test:
            parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="12" fill="none" stroke="{COLORS["test"]}" '
                         'stroke-width="3"/>')
        parts.append(_mark(kind, x, y))
        if kind not in ("unused", "done") or p == state.under_test:
            away = np.array([x - middle, y - middle]) / (np.hypot(x - middle, y - middle) or 1.0)
            parts.append(f'<text x="{x + 22 * away[0]:.1f}" y="{y + 18 * away[1] + 4:.1f}" {HALO}>{p}</text>')
    parts.append(f'<circle cx="{middle}" cy="{middle}" r="8" fill="{COLORS["pivot"]}"/>'
                 f'<circle cx="{middle}" cy="{middle}" r="4" fill="#fff"/>'
                 f'<text x="{middle}" y="{middle + 24}" {HALO} font-weight="bold">p = {state.pivot}</text>')
    return parts


def state_svg(state, size: int) -> str:
    """The pivot's tangent plane, seen from the tip of its normal, first to the right (6.1), with the sentence."""
    parts, top = [], 0
    if state.pivot is not None and state.first is not None and state.event:
        parts = _drawing(state, size)
        for i, (kind, name) in enumerate(LEGEND):
            x, y = 20 + (i % 3) * size / 3, size + 16 + 22 * (i // 3)
            parts.append(_mark(kind, x, y) + f'<text x="{x + 14}" y="{y + 5}">{name}</text>')
        top = size + 44
    section = f", section {state.event.section}" if state.event and state.event.section else ""
    title = f"{state.address}{section}" if state.event else "The start of the run"
    words = textwrap.wrap(state.event.sentence if state.event else f"{len(state.status)} points", size // 7)
    parts.append(f'<text x="12" y="{top + 24}" font-weight="bold">{escape(title)}</text>')
    parts += [f'<text x="12" y="{top + 46 + 19 * i}">{escape(line)}</text>' for i, line in enumerate(words)]
    height = top + 46 + 19 * len(words)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{size}" height="{height}" '
            f'viewBox="0 0 {size} {height}" font-family="Inter, DejaVu Sans, sans-serif" font-size="13" '
            f'stroke-linejoin="round"><rect width="{size}" height="{height}" fill="#fff"/>' + "".join(parts) + "</svg>")


def _samples(xyz: np.ndarray):
    """Places (m, 3) all over triangles (t, 3, 3), about four for each unit of area seen along z, with the triangle of
    each and the distance from its nearest side."""
    a, u, v = xyz[:, 0], xyz[:, 1] - xyz[:, 0], xyz[:, 2] - xyz[:, 0]
    area = np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    count = np.ceil(2.0 * area).astype(int) + 1
    row = np.repeat(np.arange(len(xyz)), count)
    turn = (np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count))[:, None]
    share = (0.5 + turn * [0.7548776662466927, 0.5698402909980532]) % 1.0  # evenly spread in a square, then folded
    share = np.where(share.sum(1, keepdims=True) > 1.0, 1.0 - share, share)
    sides = np.linalg.norm(np.stack([u - v, v, u], 1)[:, :, :2], axis=2)
    heights = area[:, None] / np.maximum(sides, 1e-9)
    near = np.column_stack([1.0 - share.sum(1), share]) * heights[row]
    return a[row] + share[:, :1] * u[row] + share[:, 1:] * v[row], row, near.min(1)


def mesh_png(position: np.ndarray, triangles: np.ndarray, size: int, view: Sequence[float]) -> bytes:
    """A picture of a mesh without perspective, seen from the direction `view`, z up: shaded, back sides orange."""
    wide, to_eye = 2 * size, np.asarray(view, float) / np.linalg.norm(view)
    right = np.cross([0.0, 0.0, 1.0] if abs(to_eye[2]) < 0.999 else [0.0, 1.0, 0.0], to_eye)
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(right, to_eye), to_eye])
    picture = np.full((wide * wide, 3), 255.0)
    if len(triangles):
        xyz = position[triangles] @ axes.T
        low, high = xyz.reshape(-1, 3).min(0), xyz.reshape(-1, 3).max(0)
        xyz = (xyz - (low + high) / 2) * 0.94 * wide / max(float((high - low)[:2].max()), 1e-300)
        xyz[..., :2] += wide / 2
        normal = np.cross(xyz[:, 1] - xyz[:, 0], xyz[:, 2] - xyz[:, 0])
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
        front = normal[:, 2] < 0  # since y is down
        normal[front] *= -1.0
        light = 0.3 + 0.7 * np.maximum(0.0, normal @ [-0.36, -0.48, 0.8])
        color = np.where(front[:, None], [178.0, 205.0, 232.0], [230.0, 140.0, 60.0]) * light[:, None]
        place, row, near = _samples(xyz)
        order = np.argsort(place[:, 2], kind="stable")  # the nearest is written last
        shade = np.where((near < 1.0) & (len(triangles) < 6000), 0.55, 1.0)
        picture[(place[:, :2].astype(int) @ [1, wide])[order]] = (color[row] * shade[:, None])[order]
    small = picture.reshape(size, 2, size, 2, 3).mean(axis=(1, 3)).astype(np.uint8)
    rows = np.concatenate([np.zeros((size, 1), np.uint8), small.reshape(size, -1)], axis=1).tobytes()

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
