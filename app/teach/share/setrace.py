"""Traces of Spiraling Edge runs (.setrace) for `spiraling-edge diff TRACE INPUT`, and the points
that `spiraling-edge run INPUT --with-lists -o points.ply` writes. Standard library only.

    points = setrace.read_points("points.ply")
    with setrace.Writer("mine.setrace", points.position) as trace:
        trace.pivot(p=15, first=20, last=39, fan=[20, 9, 31, 35, 39])
"""
import collections
import json
import struct

Points = collections.namedtuple("Points", "position normal type lists")
Points.__doc__ = """Positions and normals as triples, type bits (0: interior), and for each point
the list of its neighbors, nearest first."""

SCALARS = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h",
           "ushort": "H", "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I",
           "float": "f", "float32": "f", "double": "d", "float64": "d"}


def points_hash(positions):
    """The `hash` of a header: 64-bit FNV-1a of the positions as doubles in little endian."""
    value = 0xCBF29CE484222325
    for byte in b"".join(struct.pack("<3d", *position) for position in positions):
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"fnv1a64:{value:016x}"


class Writer:
    """A trace that is being written; the file is complete after close()."""

    def __init__(self, path, positions):
        self.file = open(path, "w", encoding="ascii")
        self._line({"setrace": 1, "points": len(positions), "hash": points_hash(positions)})

    def pivot(self, p, first, last, fan=None, **fields):
        """Adds a pivot. `fan`: the points from first to last, [] for no triangle. `fields`: `sort`,
        `limits`, `reciprocal`, `hole`, `sphere` (the candidates after that stage), `start`, `end`,
        `ring` (the active edge ring after the pivot, from the next pivot on), `next`; `ends=True`
        in the last line of a trace that is meant to end before the run does."""
        line = {"p": p, "first": first, "last": last}
        if fan is not None:
            line["fan"] = fan
        self._line({**line, **fields})

    def close(self):
        self.file.close()

    def _line(self, values):
        self.file.write(json.dumps(values, separators=(",", ":")) + "\n")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def read(path):
    """The header and the pivots of a trace, as dictionaries."""
    with open(path, encoding="utf-8") as file:
        header, *pivots = [json.loads(line) for line in file if line.strip()]
    return header, pivots


def _header(file):
    """The elements of a PLY file as (name, count, [(name, type, type of the length or None)])."""
    elements = []
    if file.readline().strip() != b"ply" or file.readline().split()[1] != b"binary_little_endian":
        raise ValueError("expected a PLY file as spiraling-edge writes it")
    for line in iter(file.readline, b""):
        words = line.decode("ascii").split()
        if words[0] == "end_header":
            break
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and words[1] == "list":
            elements[-1][2].append((words[4], SCALARS[words[3]], SCALARS[words[2]]))
        elif words[0] == "property":
            elements[-1][2].append((words[2], SCALARS[words[1]], None))
    return elements


def _values(file, code, count):
    layout = f"<{count}{code}"
    return struct.unpack(layout, file.read(struct.calcsize(layout)))


def _row(file, properties):
    row = {}
    for name, code, length in properties:
        row[name] = _values(file, code, 1)[0] if length is None else \
            list(_values(file, code, _values(file, length, 1)[0]))
    return row


def read_points(path):
    """The points of a PLY file that `spiraling-edge run --with-lists` or `figures --conformance`
    has written. Neighbors whose normals oppose are left out, as by the rule `opposing`."""
    with open(path, "rb") as file:
        rows = {name: [_row(file, properties) for _ in range(count)]
                for name, count, properties in _header(file)}
    vertices = rows["vertex"]
    normals = [(v["nx"], v["ny"], v["nz"]) for v in vertices]
    agree = lambda a, b: sum(x * y for x, y in zip(normals[a], normals[b])) > 0.0
    return Points([(v["x"], v["y"], v["z"]) for v in vertices], normals,
                  [v.get("scalar_se_type", 0) for v in vertices],
                  [[q for q in each["id"] if agree(p, q)]
                   for p, each in enumerate(rows["se_neighbors"])])
