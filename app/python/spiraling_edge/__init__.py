"""Spiraling Edge (Crossno and Angel, IEEE Visualization 1999): surfaces from points, decision by decision.

    mesh = se.reconstruct(points)             # (n, 3) array, path or "scene:torus"; -> Mesh with verdict
    state = se.Run("scene:torus").at("137.sphere.3")    # one decision, with rings and numbers

Lengths are in the unit of the points, angles in degrees; points are named by their row, from 0. Options (`**options`)
are those of the command line as keywords: neighbors=16, crop=(x0, y0, z0, x1, y1, z1), rule={"maxgap": 100}. Wrong
arguments raise ValueError; files and points that cannot be used InputError. Records can be pickled, for other processes
of the same version. See docs/python.md.
"""
from __future__ import annotations

import functools
import operator
import os
import struct
import weakref
import zlib
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._core import Cancelled, InputError, __version__

__all__ = ["Answer", "Candidate", "Cancelled", "Event", "Failure", "Found", "InputError", "Line", "Mesh", "Points",
           "Prepared", "Reading", "Ring", "RingPoints", "Run", "State", "Stepper", "Trial", "Verdict", "best",
           "check", "look", "prepare", "read", "reconstruct", "scenes", "why", "__version__"]

MOST_BYTES = 1 << 31  # of an input, read or unpacked
MOST_PIXELS = 8192  # of a side of a picture
Progress = Optional[Callable[[float], Any]]


@dataclass(frozen=True, eq=False)
class _Cloud:
    position: np.ndarray
    normals: np.ndarray
    types: np.ndarray
    neighbors: Tuple[np.ndarray, np.ndarray]

    def __reduce__(self) -> Any:
        return operator.methodcaller("record"), (self._core,)  # of the library


@dataclass(frozen=True, eq=False)
class Points(_Cloud):
    """Points as they are in a file: position and normals (n, 3) float64, types (n,) uint8 (section 4), triangles
    (t, 3) uint32, neighbors as (offset (n + 1,), ids), attributes by name; read-only, of length 0 where the file has
    none. notes: sentences on what was read in a way of its own."""
    triangles: np.ndarray
    attributes: Dict[str, np.ndarray]
    notes: Tuple[str, ...]
    _core: Any = field(repr=False)


@dataclass(frozen=True, eq=False)
class Prepared(_Cloud):
    """Points that are ready for a run (sections 3 and 4): unit normals (n, 3), types (n,), for each point p the list
    ids[offset[p]:offset[p + 1]] of neighbors = (offset, ids), nearest first. report: the numbers of points that were
    set aside, by reason, and what was derived; options: in words. Every function takes it in place of points."""
    report: Dict[str, Any]
    options: str
    _core: Any = field(repr=False)


Source = Union[np.ndarray, str, "os.PathLike[str]", Points, Prepared]


@dataclass(frozen=True, eq=False)
class Failure:
    """One failure of a mesh: its class, a sentence, the points (ascending) and triangles, the center."""
    kind: str
    is_fault: bool
    sentence: str
    points: np.ndarray
    triangles: np.ndarray
    place: Tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class Verdict:
    """The verdict on a mesh, judged by the points as given. sound: triangles, and no fault after a complete search
    (exact); places: with faults; covered: share of the points; distances of points from the mesh; counts by class."""
    sound: bool
    headline: str
    exact: bool
    places: int
    pieces: int
    openings: int
    covered: float
    greatest_distance: float
    mean_distance: float
    counts: Dict[str, int]
    failures: List[Failure] = field(repr=False)


@dataclass(frozen=True)
class Trial:
    """A run that best() has made: its change of the settings, and the headline of its verdict."""
    change: str
    headline: str


@dataclass(frozen=True)
class Reading:
    """The numbers of a decision. margin: > 0 taken, < 0 refused; 0 where it would change."""
    quantity: str
    unit: str
    value: float
    threshold: float
    margin: float


@dataclass(eq=False)
class Event:
    """One decision: its address "pivot.stage.n" with the section of the paper (empty beyond it), a sentence, the verdict
    of a test in words, whether the tested point was taken (None: no test), the point. evidence: the numbers by which it
    was made (docs/python.md)."""
    address: str
    pivot: int
    stage: str
    n: int
    section: str
    sentence: str
    verdict: str
    taken: Optional[bool]
    point: Optional[int]
    evidence: Dict[str, Any] = field(repr=False)


@dataclass(frozen=True, eq=False)
class RingPoints:
    """Points of a neighbor ring, counterclockwise from start to end, and their angles at the pivot (6.1)."""
    points: np.ndarray
    degrees: np.ndarray


@dataclass(frozen=True, eq=False)
class Ring:
    """An edge ring: its points in order; open[i]: the step from points[i] to the next is no edge of the mesh."""
    points: np.ndarray
    open: np.ndarray
    active: bool
    name: str


@dataclass(frozen=True)
class Candidate:
    """A neighbor of the pivot that was tested, with its last test."""
    point: int
    degrees: float
    kept: bool
    verdict: str
    stage: str


@dataclass(frozen=True)
class Line:
    """A decision in an answer. role: fact, taken, refused, indirect, made or undone; pivot: its point."""
    event: Event
    role: str
    pivot: Optional[int]
    reading: Optional[Reading]
    address = property(operator.attrgetter("event.address"))


@dataclass(frozen=True)
class Found:
    """The first decisions that a query found, and the number of all."""
    lines: List[Line] = field(repr=False)
    total: int


@dataclass(frozen=True)
class Answer:
    """Why a subject is in the mesh or not. cause: address of the deciding line; proved_by: "inversion", "step",
    "preparation" or "nothing"; what_if: the lines under which the answer is another; without: "flip=off", a rule that
    is off then as well; change: "--neighbors 16", an option that brings an absent subject in; None: there is none."""
    subject: str
    present: bool
    sentence: str
    cause: str
    proved_by: str
    what_if: List[str]
    without: Optional[str]
    change: Optional[str]
    lines: List[Line] = field(repr=False)


@dataclass(frozen=True, eq=False)
class State:
    """A run just after one decision (`event`; None at the start). Points are None where there are none: pivot, first,
    last, start and end (6.1), under_test. status (n,) int32: UNUSED 0, USED the number of ring entries, DONE -1 (4).
    rings: the active one first, then the stack from the top. fan: the points of the triangles as they would be made
    now (6.4); new_triangles (t, 3): those of this pivot. before: the state just before the decision; of the first one
    of a pivot it has no event."""
    event: Optional[Event]
    reading: Optional[Reading]
    pivot: Optional[int]
    first: Optional[int]
    last: Optional[int]
    start: Optional[int]
    end: Optional[int]
    under_test: Optional[int]
    sector_degrees: float
    complete: bool
    neighbor_ring: RingPoints
    fan: RingPoints
    candidates: List[Candidate]
    rings: List[Ring]
    new_triangles: np.ndarray
    finished_triangles: int
    status: np.ndarray
    prepared: Prepared = field(repr=False)
    before: Optional["State"] = field(repr=False)
    _next: Optional[str] = field(repr=False)  # of a `before`: the address of the decision
    _core: Any = field(repr=False)

    def __reduce__(self) -> Any:
        return _state_at, (self.prepared, self.address, self._next)

    @property
    def address(self) -> Optional[str]:
        return self.event.address if self.event else None

    def svg(self, size: int = 480) -> str:
        """The tangent plane of the pivot as a drawing, `size` pixels wide, with the sentence."""
        return self._core.svg(_whole(size, "size", 1, MOST_PIXELS))

    _repr_svg_ = svg


@dataclass(eq=False)
class Mesh:
    """A mesh and how it was made: triangles (t, 3) uint32, counterclockwise seen from the tip of the normals (6.4);
    position and normals (n, 3) of all points. stopped: it made too many triangles; options: the settings in words;
    trials: those of best(). Arrays are read-only views, without a copy."""
    prepared: Prepared = field(repr=False)
    triangles: np.ndarray = field(repr=False)
    stopped: bool
    trials: List[Trial] = field(repr=False)

    position = property(operator.attrgetter("prepared.position"))
    normals = property(operator.attrgetter("prepared.normals"))
    options = property(operator.attrgetter("prepared.options"))

    @functools.cached_property
    def verdict(self) -> Verdict:
        """Searched for at the first access, on all cores. Crossing triangles are found exactly."""
        return self.prepared._core.judge(self.triangles, self.stopped)

    def write(self, path: Union[str, "os.PathLike[str]"], used_points: bool = False, normals: bool = False,
              force: bool = False) -> None:
        """Writes PLY, OBJ, OFF, STL or GLB by the extension, as `spiraling-edge run -o` does; no partial file is left.
        used_points: only those in a triangle; normals: also in OFF; force: also in place of the file that the points
        are of. Raises OSError, ValueError."""
        self.prepared._core.write(self.triangles, path, used_points, normals, force)

    def png(self, size: int = 480, view: Sequence[float] = (0.5, -0.8, 0.45)) -> bytes:
        """A picture of the mesh, seen from the direction `view`, z up; the inner side is red."""
        size = _whole(size, "size", 1, MOST_PIXELS)
        if np.shape(view) != (3,):
            raise ValueError(f"view: expected three numbers, not {view!r}")
        rows = self.prepared._core.picture(self.triangles, size, view)[::-1, :, :3].reshape(size, 3 * size)
        header = struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)
        data = zlib.compress(np.pad(rows, ((0, 0), (1, 0))).tobytes())  # filter 0 before each row
        return b"\x89PNG\r\n\x1a\n" + b"".join(
            struct.pack(">I", len(part)) + kind + part + struct.pack(">I", zlib.crc32(kind + part))
            for kind, part in ((b"IHDR", header), (b"IDAT", data), (b"IEND", b"")))

    _repr_png_ = png

    def __repr__(self) -> str:
        return f"<Mesh of {len(self.triangles)} triangles and {len(self.position)} points, {self.options}>"


def _state_at(prepared: Prepared, address: Optional[str], following: Optional[str]) -> State:
    run = Run(prepared)
    if following:
        return run.at(following).before
    return run.at(address) if address else run.state


def _whole(value: Any, name: str, least: int, most: int) -> int:
    try:
        if least <= operator.index(value) <= most:
            return operator.index(value)
    except TypeError:
        pass
    raise ValueError(f"{name}: expected a whole number from {least} to {most}, not {value!r}")


def _rows(values: Any, name: str, kinds: str = "fiu") -> np.ndarray:
    array = np.empty((0, 3), np.int64) if values is None else np.asarray(values)
    if np.ma.isMaskedArray(values):
        raise ValueError(f"{name}: has a mask; leave out or fill what it hides")
    if array.dtype.kind not in kinds:
        raise ValueError(f"{name}: expected {'numbers' if 'f' in kinds else 'whole numbers'}, not {array.dtype}")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: expected an array of shape (n, 3), not {array.shape}")
    return array


def _input(points: Any, normals: Any = None, triangles: Any = None, most_bytes: Optional[int] = None) -> Any:
    if isinstance(points, Points) and normals is None and triangles is None:
        return points._core
    if isinstance(points, (str, bytes, os.PathLike)):
        if normals is not None or triangles is not None:
            raise ValueError("normals, triangles: a file has its own")
        return read(points, MOST_BYTES if most_bytes is None else most_bytes)._core
    is_file = isinstance(points, Points)
    position = _rows(points.position if is_file else points, "points")
    directions, corners = _rows(normals, "normals"), _rows(triangles, "triangles", "iu")
    if normals is not None and directions.shape != position.shape:
        raise ValueError(f"normals: expected shape {position.shape}, not {directions.shape}")
    if is_file and triangles is None:
        return points._core.with_normals(directions)
    if corners.size and not 0 <= corners.min() <= corners.max() < len(position):
        raise ValueError("triangles: a corner is no row of the points")
    return _core.from_arrays(position, directions, corners)


def _text(value: Any) -> str:
    """The text that an option of the command line takes."""
    if isinstance(value, (list, tuple, np.ndarray)):
        return ",".join(map(_text, np.ravel(value).tolist()))
    return ("off", "on")[bool(value)] if isinstance(value, (bool, np.bool_)) else str(value)


def _words(options: Dict[str, Any]) -> List[str]:
    """Options as words of the command line; rule=, a dict or a list, and what_if=, a list, may be several."""
    words = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if name == "rule" and isinstance(value, dict):
            words += [f"{option}={rule}={_text(setting)}" for rule, setting in value.items()]
        elif name in ("rule", "what_if") and isinstance(value, (list, tuple)):
            words += [f"{option}={_text(line)}" for line in value]
        elif isinstance(value, (bool, np.bool_)):
            words += [option] if value else []
        elif value is not None:
            words.append(f"{option}={_text(value)}")
    return words


def _prepare(points: Any, normals: Any, usual: str, progress: Progress, **options: Any) -> Prepared:
    """Prepared points for options; without rules= by the rules of prepared points, or the usual ones."""
    if isinstance(points, Prepared):
        if normals is not None:
            raise ValueError("normals: these points are prepared already")
        words = _words(options)
        return points._core.again(words, progress) if words else points
    options["rules"] = options["rules"] or usual
    return _core.prepare(_input(points, normals, None, options.get("most_bytes")), _words(options), progress)


def read(source: Union[str, bytes, "os.PathLike[str]"], most_bytes: int = MOST_BYTES) -> Points:
    """Reads a file of any format of docs/file-formats.md, also packed by gzip, or "scene:NAME". Raises InputError."""
    return _core.read(source, _whole(most_bytes, "most_bytes", 1, 2**64 - 1))


def scenes() -> Dict[str, str]:
    """Name and title of the built-in inputs, for "scene:NAME"."""
    return _core.scenes()


def prepare(points: Source, normals: Any = None, rules: Optional[str] = None, progress: Progress = None,
            **options: Any) -> Prepared:
    """Derives what is missing: normals, neighbor lists (12 nearest), and sets unusable points aside (3, 4). normals:
    (n, 3). Raises ValueError, InputError, Cancelled."""
    return _prepare(points, normals, "robust", progress, rules=rules, **options)


def reconstruct(points: Source, normals: Any = None, rules: Optional[str] = None, progress: Progress = None,
                **options: Any) -> Mesh:
    """The mesh of a run to its end, with the bytes of `spiraling-edge run` (3 to 7). points: (n, 3), a path, a scene,
    Points or Prepared, which other options prepare again; normals: (n, 3), of any length; None: those of the file, or
    derived; rules: "paper", "printed", "corrected" or "robust"; None: those of prepared points, else "robust". Raises
    ValueError, InputError, Cancelled."""
    prepared = _prepare(points, normals, "robust", progress, rules=rules, **options)
    return prepared._core.mesh(progress, [])


def best(points: Source, normals: Any = None, rules: str = "robust", progress: Progress = None,
         **options: Any) -> Mesh:
    """The best mesh of up to 20 runs with other settings, as `run --best` (docs/robust.md): a sound one, or
    else the one with the fewest points amiss. Raises as reconstruct()."""
    if isinstance(points, Prepared):
        raise ValueError("points: best() prepares them in several ways, give the points themselves")
    return _core.best(_input(points, normals, None, options.get("most_bytes")), _words({"rules": rules, **options}), progress)


def check(vertices: Source, triangles: Any = None, points: Optional[Source] = None, normals: Any = None,
          rules: Optional[str] = None, **options: Any) -> Verdict:
    """The verdict on any mesh: a file, or vertices (n, 3) and triangles (t, 3). points, normals and options: those
    that it was made of, by which it is judged; None: by itself alone. Raises ValueError, InputError."""
    if points is None and (normals is not None or rules is not None or options):
        raise ValueError("normals, rules and options: only with points=, which they prepare")
    judge = None if points is None else _prepare(points, normals, "robust", None, rules=rules, **options)._core
    return _core.check(_input(vertices, None, triangles), judge)


def why(points: Source, point: Optional[int] = None, edge: Optional[Sequence[int]] = None,
        triangle: Optional[Sequence[int]] = None, normals: Any = None, rules: Optional[str] = None, more: bool = False,
        progress: Progress = None, **options: Any) -> Answer:
    """Why a point, an edge or a triangle is in the mesh of a run or not, with the proof (docs/why.md). more: up to 200
    inverted decisions instead of 20. Raises as reconstruct()."""
    return Run(points, normals, rules, **options).why(point, edge, triangle, more, progress)


class Run(_core.Cursor):
    """A run of which every decision can be gone to, forward and back. At first it is at its start. rules: None: those
    of prepared points, else "paper"."""

    def __init__(self, points: Source, normals: Any = None, rules: Optional[str] = None, progress: Progress = None,
                 **options: Any) -> None:
        self.prepared = _prepare(points, normals, "paper", progress, rules=rules, **options)
        super().__init__(self.prepared)

    def at(self, address: Union[str, int]) -> State:
        """Goes to a decision, "137.sphere.3", the first of a stage, "137.sphere", or the begin of a pivot, 137. Raises
        ValueError for what is no address, LookupError, unmoved, where the run has no such decision."""
        if not self._go_to(str(address)):
            raise LookupError(f"{address}: the run has no such decision")
        return self.state

    def find(self, line: str, most: int = 100, progress: Progress = None) -> Found:
        """The first decisions of the whole run that a line matches, at most `most`. The place stays."""
        return self._find(line, _whole(most, "most", 0, 2**64 - 1), progress)

    def why(self, point: Optional[int] = None, edge: Optional[Sequence[int]] = None,
            triangle: Optional[Sequence[int]] = None, more: bool = False, progress: Progress = None) -> Answer:
        """As se.why(), of this run."""
        given = [(size, np.ravel(each)) for size, each in ((1, point), (2, edge), (3, triangle)) if each is not None]
        size, points = given[0] if len(given) == 1 else (0, np.empty(0))
        if len(points) != size or points.dtype.kind not in "iu" or points.min() < 0:
            raise ValueError("expected one of point=P, edge=(P, Q), triangle=(P, Q, R), numbered from 0")
        return _core.why(self.prepared._core, points.clip(max=0xffffffff).tolist(), more, progress)

    def _repr_svg_(self) -> str:
        return self.state.svg()


class Stepper(_core.Stepper):
    """The algorithm, phase by phase. observer(event): called for each decision after its phase; a true value stops
    the run there, and the next call goes on. Arrays are copies."""

    def __init__(self, points: Source, normals: Any = None, rules: Optional[str] = None,
                 observer: Optional[Callable[[Event], Any]] = None, **options: Any) -> None:
        self.prepared = _prepare(points, normals, "paper", None, rules=rules, **options)
        me = weakref.ref(self)  # an observer may refer to its stepper
        self._observer = observer
        super().__init__(self.prepared._core, observer and (lambda event: me()._observer(event)))


def look(run: Union[Run, Stepper], viewer: str = "spiraling-edge-viewer") -> None:
    """Opens the viewer at the place of a run, and returns when its window is closed. viewer: the program, by its name
    on PATH or its path. What the user does there has no effect here. Raises OSError."""
    import subprocess
    import tempfile
    place = str(run.pivots) if isinstance(run, Stepper) else run.state.address or "0"
    with tempfile.TemporaryDirectory(prefix="spiraling-edge-") as folder:
        session = run.prepared._core.write_session(folder, place)
        ended = subprocess.run([viewer, session], check=False).returncode
    if ended != 0:
        raise OSError(f"{viewer} ended with an error")
