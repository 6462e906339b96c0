"""Spiraling Edge (Crossno and Angel, IEEE Visualization 1999): surfaces from points, decision by decision.

    mesh = se.reconstruct(points)             # (n, 3) array, path or "scene:torus"; -> Mesh with verdict
    state = se.Run("scene:torus").at("137.sphere.3")    # one decision, with rings and numbers

Lengths are in the unit of the points, angles in degrees; points are named by their row, from 0. Options (`**options`)
are those of the command line as keywords: neighbors=16, crop=(x0, y0, z0, x1, y1, z1), rule={"maxgap": 100}. Wrong
arguments raise ValueError; files and points that cannot be used InputError. See docs/python.md.
"""
from __future__ import annotations

import numbers
import os
import weakref
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._core import Cancelled, Event, InputError, __version__

__all__ = ["Answer", "Candidate", "Cancelled", "Event", "Failure", "Found", "InputError", "Line", "Mesh", "Points",
           "Prepared", "Reading", "Ring", "RingPoints", "Run", "State", "Stepper", "Trial", "Verdict", "best",
           "check", "look", "prepare", "read", "reconstruct", "scenes", "why", "__version__"]

MOST_BYTES = 1 << 31  # that a packed file may hold
_VIEWER = "spiraling-edge-viewer"
Progress = Optional[Callable[[float], Any]]


@dataclass(frozen=True, eq=False)
class Points:
    """Points as they are in a file: position and normals (n, 3) float64, types (n,) uint8 (section 4), triangles
    (t, 3) uint32, neighbors as (offset (n + 1,), ids), attributes by name; read-only, of length 0 where the file has
    none. notes: sentences on what was read in a way of its own."""
    position: np.ndarray
    normals: np.ndarray
    types: np.ndarray
    triangles: np.ndarray
    neighbors: Tuple[np.ndarray, np.ndarray]
    attributes: Dict[str, np.ndarray]
    notes: Tuple[str, ...]
    _core: Any = field(repr=False)


@dataclass(frozen=True, eq=False)
class Prepared:
    """Points that are ready for a run (sections 3 and 4): unit normals (n, 3), types (n,), for each point p the list
    ids[offset[p]:offset[p + 1]] of neighbors = (offset, ids), nearest first. report: the numbers of points that were
    set aside, by reason, and what was derived; options: in words. Every function takes it in place of points."""
    position: np.ndarray
    normals: np.ndarray
    types: np.ndarray
    neighbors: Tuple[np.ndarray, np.ndarray]
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

    @property
    def address(self) -> str:
        return self.event.address


@dataclass(frozen=True)
class Found:
    """The first decisions that a query found, and the number of all."""
    lines: List[Line] = field(repr=False)
    total: int


@dataclass(frozen=True)
class Answer:
    """Why a subject is in the mesh or not. cause: address of the deciding line; proved_by: "inversion", "step",
    "preparation" or "nothing"; what_if: the line under which the answer is another; rule: "unblocked=on", with which an
    absent subject is there; None where there is none."""
    subject: str
    present: bool
    sentence: str
    cause: str
    proved_by: str
    what_if: Optional[str]
    rule: Optional[str]
    lines: List[Line] = field(repr=False)


@dataclass(frozen=True, eq=False)
class State:
    """A run just after one decision (`event`; None at the start). Points are None where there are none: pivot, first,
    last, start and end (6.1), under_test. status (n,) int32: UNUSED 0, USED the number of ring entries, DONE -1 (4).
    rings: the active one first, then the stack from the top. fan: the points of the triangles as they would be made
    now (6.4); new_triangles (t, 3): those of this pivot. before: the state just before the decision."""
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
    before: Optional["State"] = field(repr=False, default=None)

    @property
    def address(self) -> Optional[str]:
        return self.event.address if self.event else None

    def in_plane(self, points: Any) -> np.ndarray:
        """(m, 2): points by number, or positions (m, 3), in the tangent plane of the pivot, seen from the tip of its
        normal; first to the right (6.1). Requires a pivot."""
        position, normal = self.prepared.position, self.prepared.normals[self.pivot]
        right = position[self.first] - position[self.pivot]
        right = right - normal * (right @ normal)
        right = right / (np.linalg.norm(right) or 1.0)
        places = np.asarray(points)
        offset = (places if places.ndim == 2 else position[places.astype(np.intp)]) - position[self.pivot]
        return np.stack([offset @ right, offset @ np.cross(normal, right)], axis=1)

    def circle(self) -> np.ndarray:
        """(65, 3): the closed circle through the pivot, s and t of a decision of stage "sphere" (6.3); (0, 3) where
        there is none."""
        numbers = self.event.evidence if self.event and self.event.stage == "sphere" else {"radius": 0.0}
        if not numbers["radius"] > 0.0:
            return np.empty((0, 3))
        p, s, t = (self.prepared.position[i] for i in (self.pivot, numbers["s"], numbers["t"]))
        center = np.array(numbers["center"])
        normal = np.cross(t - p, s - p)
        across = np.cross(normal / np.linalg.norm(normal), p - center)
        turn = np.linspace(0.0, 2.0 * np.pi, 65)[:, None]
        return center + np.cos(turn) * (p - center) + np.sin(turn) * across

    def svg(self, size: int = 480) -> str:
        """The tangent plane of the pivot as a drawing, `size` pixels wide."""
        from .pictures import state_svg
        return state_svg(self, size)

    def _repr_svg_(self) -> str:
        return self.svg()


class Mesh:
    """A mesh and how it was made: triangles (t, 3) uint32, counterclockwise seen from the tip of the normals (6.4);
    position and normals (n, 3) of all points. counters: of the run; stopped: it made too many triangles; options: the
    settings in words; trials: those of best(). Arrays are read-only views, without a copy."""
    triangles: np.ndarray
    counters: Dict[str, int]
    stopped: bool

    def __init__(self, made: Any, trials: Sequence[Trial] = ()) -> None:
        self._made = made
        self._verdict: Optional[Verdict] = None
        self.__dict__.update(made.parts())
        self.prepared = _prepared_record(made.run)
        self.position, self.normals = self.prepared.position, self.prepared.normals
        self.options, self.trials = self.prepared.options, list(trials)

    @property
    def verdict(self) -> Verdict:
        """Searched for at the first access, on all cores. Crossing triangles are found exactly."""
        if self._verdict is None:
            self._verdict = _verdict(self._made.judge())
        return self._verdict

    def write(self, path: Union[str, "os.PathLike[str]"], used_points: bool = False, normals: bool = False,
              force: bool = False) -> None:
        """Writes PLY, OBJ, OFF, STL or GLB by the extension, as `spiraling-edge run -o` does; no partial file is left.
        used_points: only those in a triangle; normals: also in OFF; force: also in place of the file that the points
        are of. Raises OSError, ValueError."""
        name, source = os.fsencode(path), self._made.run.source()
        if not force and os.path.exists(name) and os.path.exists(source) and os.path.samefile(name, source):
            raise ValueError(f"{os.fsdecode(name)}: the points are from this file; force=True replaces it")
        self._made.write(name, used_points, normals)

    def png(self, size: int = 480, view: Sequence[float] = (0.5, -0.8, 0.45)) -> bytes:
        """A picture of the mesh, seen from the direction `view`, z up; the inner side is orange."""
        from .pictures import mesh_png
        return mesh_png(self.position, self.triangles, size, view)

    def _repr_png_(self) -> bytes:
        return self.png()

    def __repr__(self) -> str:
        return f"<Mesh of {len(self.triangles)} triangles and {len(self.position)} points, {self.options}>"


def _verdict(parts: Dict[str, Any]) -> Verdict:
    return Verdict(**{**parts, "failures": [Failure(**each) for each in parts["failures"]]})


def _prepared_record(run: Any) -> Prepared:
    return Prepared(**run.parts(), _core=run)


def _reading(parts: Dict[str, Any]) -> Optional[Reading]:
    return Reading(**parts) if parts else None


def _lines(parts: List[Dict[str, Any]]) -> List[Line]:
    return [Line(**{**each, "reading": _reading(each["reading"])}) for each in parts]


def _state(parts: Dict[str, Any], prepared: Prepared, before: Optional[State] = None) -> State:
    parts["reading"] = _reading(parts["reading"])
    for name in ("neighbor_ring", "fan"):
        parts[name] = RingPoints(*parts[name])
    parts["candidates"] = [Candidate(*each) for each in parts["candidates"]]
    parts["rings"] = [Ring(*each) for each in parts["rings"]]
    return State(**parts, prepared=prepared, before=before)


def _rows(values: Any, name: str) -> Tuple[np.ndarray, bool]:
    """An (n, 3) array of doubles, and whether the values were single."""
    array = np.asarray(values)
    if np.ma.isMaskedArray(values):
        raise ValueError(f"{name}: has a mask; leave out or fill what it hides")
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{name}: expected numbers, not {array.dtype}")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: expected an array of shape (n, 3), not {array.shape}")
    return np.ascontiguousarray(array, np.float64), array.dtype.kind == "f" and array.dtype.itemsize <= 4


def _input(points: Any, normals: Any = None, triangles: Any = None) -> Any:
    if isinstance(points, Points) and normals is None and triangles is None:
        return points._core
    if isinstance(points, (str, bytes, os.PathLike)):
        if normals is not None or triangles is not None:
            raise ValueError("normals, triangles: a file has its own")
        return read(points)._core
    position, single = _rows(points.position if isinstance(points, Points) else points, "points")
    directions, single_normals = _rows(np.empty((0, 3)) if normals is None else normals, "normals")
    if normals is not None and directions.shape != position.shape:
        raise ValueError(f"normals: expected shape {position.shape}, not {directions.shape}")
    corners = np.empty((0, 3), np.int64) if triangles is None else np.asarray(triangles)
    if corners.dtype.kind not in "iu" or corners.ndim != 2 or corners.shape[1] != 3:
        raise ValueError(f"triangles: expected whole numbers of shape (t, 3), not {corners.dtype} {corners.shape}")
    if corners.size and not 0 <= corners.min() <= corners.max() < len(position):
        raise ValueError("triangles: a corner is no row of the points")
    return _core.from_arrays(position, single, directions, single_normals, corners.astype(np.uint32))


def _text(value: Any) -> str:
    """The text that an option of the command line takes."""
    if isinstance(value, (bool, np.bool_)):
        return "on" if value else "off"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, str):
        return value
    if isinstance(value, (list, tuple, np.ndarray)):
        return ",".join(map(_text, np.ravel(value).tolist()))
    raise ValueError(f"expected a number, a word or several, not {value!r}")


def _texts(rules: Optional[str], normals: Any, options: Dict[str, Any]) -> Tuple[List[Tuple[str, str]], Any]:
    """Options as keys and texts, and the normals unless they are a word."""
    texts = [] if rules is None else [("rules", _text(rules))]
    if isinstance(normals, str):
        texts, normals = texts + [("normals", normals)], None
    for name, value in options.items():
        if value is None:
            continue
        if name == "rule":
            if not isinstance(value, dict):
                raise ValueError(f'rule: expected settings such as {{"maxgap": 100}}, not {value!r}')
            texts += [("switches", f"{rule}={_text(setting)}") for rule, setting in value.items()]
        elif name == "what_if":
            texts += [("what_if", line) for line in ([value] if isinstance(value, str) else value)]
        else:
            texts.append((name, _text(value)))
    return texts, normals


def _prepare(points: Any, normals: Any, rules: Optional[str], options: Dict[str, Any], usual: str,
             progress: Progress = None) -> Any:
    """Prepared points for rules; None: those of prepared points, `usual` for others."""
    if rules is None and not isinstance(points, Prepared):
        rules = usual
    texts, normals = _texts(rules, normals, options)
    if not isinstance(points, Prepared):
        return _core.prepare(_input(points, normals), texts, progress)
    if normals is not None:
        raise ValueError("normals: these points are prepared already")
    return points._core.with_rules(texts)


def read(source: Union[str, bytes, "os.PathLike[str]"]) -> Points:
    """Reads a file of any format of docs/file-formats.md, also packed by gzip, or "scene:NAME". Raises InputError."""
    name = os.fsencode(source)
    packed = b""
    if os.path.isfile(name):
        with open(name, "rb") as file:
            packed = file.read(2)
    if packed == b"\x1f\x8b":
        import gzip
        import zlib
        try:
            with gzip.open(name, "rb") as stream:
                content = stream.read(MOST_BYTES + 1)
        except (EOFError, gzip.BadGzipFile, zlib.error) as error:
            raise InputError(f"{os.fsdecode(name)}: is packed by gzip, and damaged or cut short: {error}") from None
        if len(content) > MOST_BYTES:
            raise InputError(f"{os.fsdecode(name)}: holds more than {MOST_BYTES} bytes, unpacked")
        core = _core.from_bytes(content, name)
    else:
        core = _core.from_source(name)
    return Points(**core.parts(), _core=core)


def scenes() -> Dict[str, str]:
    """Name and title of the built-in inputs, for "scene:NAME"."""
    return _core.scenes()


def prepare(points: Source, normals: Any = None, rules: Optional[str] = None, progress: Progress = None,
            **options: Any) -> Prepared:
    """Derives what is missing: normals, neighbor lists (12 nearest), and sets unusable points aside (3, 4). normals:
    (n, 3), "derived" or "oriented". Raises ValueError, InputError, Cancelled."""
    return _prepared_record(_prepare(points, normals, rules, options, "robust", progress))


def reconstruct(points: Source, normals: Any = None, rules: Optional[str] = None, progress: Progress = None,
                **options: Any) -> Mesh:
    """The mesh of a run to its end, with the bytes of `spiraling-edge run` (3 to 7). points: (n, 3), a path, a scene,
    Points or Prepared, of which the rules alone may change; normals: (n, 3), of any length, "derived" or "oriented";
    None: those of the file, or derived; rules: "paper", "printed", "corrected" or "robust"; None: those of prepared
    points, else "robust". Raises ValueError, InputError, Cancelled."""
    return Mesh(_core.reconstruct(_prepare(points, normals, rules, options, "robust", progress), progress))


def best(points: Source, normals: Any = None, rules: str = "robust", progress: Progress = None,
         **options: Any) -> Mesh:
    """The best mesh of up to 20 runs with other settings, as `run --best` (docs/robust.md): faults at the fewest
    places, in no count worse than that of the rules "robust". Raises as reconstruct()."""
    if isinstance(points, Prepared):
        raise ValueError("points: best() prepares them in several ways, give the points themselves")
    texts, normals = _texts(rules, normals, options)
    made, tried = _core.best(_input(points, normals), texts, progress)
    return Mesh(made, [Trial(*each) for each in tried])


def check(vertices: Source, triangles: Any = None, points: Optional[Source] = None, normals: Any = None,
          rules: Optional[str] = None, **options: Any) -> Verdict:
    """The verdict on any mesh: a file, or vertices (n, 3) and triangles (t, 3). points, normals and options: those
    that it was made of, by which it is judged; None: by itself alone. Raises ValueError, InputError."""
    mesh = _input(vertices, None, triangles)
    return _verdict(_core.check(mesh, None if points is None else _prepare(points, normals, rules, options, "robust")))


def why(points: Source, point: Optional[int] = None, edge: Optional[Sequence[int]] = None,
        triangle: Optional[Sequence[int]] = None, normals: Any = None, rules: Optional[str] = None, more: bool = False,
        progress: Progress = None, **options: Any) -> Answer:
    """Why a point, an edge or a triangle is in the mesh of a run or not, with the proof (docs/why.md). more: up to 200
    inverted decisions instead of 20. Raises as reconstruct()."""
    return Run(points, normals, rules, **options).why(point, edge, triangle, more, progress)


class Run:
    """A run of which every decision can be gone to, forward and back. At first it is at its start. rules: None: those
    of prepared points, else "paper"."""

    def __init__(self, points: Source, normals: Any = None, rules: Optional[str] = None, progress: Progress = None,
                 **options: Any) -> None:
        self._run = _prepare(points, normals, rules, options, "paper", progress)
        self._cursor = _core.Cursor(self._run)
        self.prepared = _prepared_record(self._run)

    @property
    def state(self) -> State:
        """The state at the place of the run."""
        return _state(self._cursor.state(False), self.prepared, _state(self._cursor.state(True), self.prepared))

    @property
    def events(self) -> List[Event]:
        """All decisions of the pivot at the place of the run, in order."""
        return self._cursor.events()

    def at(self, address: Union[str, int]) -> State:
        """Goes to a decision, "137.sphere.3", the first of a stage, "137.sphere", or the begin of a pivot, 137. Raises
        ValueError for what is no address, LookupError, unmoved, where the run has no such decision."""
        if not self._cursor.go_to(str(address)):
            raise LookupError(f"{address}: the run has no such decision")
        return self.state

    def forward(self, unit: str = "decision") -> Optional[State]:
        """One "decision", "phase" or "pivot" on; None, unmoved, at the end."""
        return self.state if self._cursor.step(unit, False) else None

    def back(self, unit: str = "decision") -> Optional[State]:
        """One step back, at last to the start; None there."""
        return self.state if self._cursor.step(unit, True) else None

    def next(self, line: str) -> Optional[State]:
        """On to the next decision that a line matches, "stage=sphere refused margin<0.01" (spiraling-edge why --help);
        None, at the end of the run, if there is none. Raises ValueError."""
        return self.state if self._cursor.run_until(line) else None

    def find(self, line: str, most: int = 100, progress: Progress = None) -> Found:
        """The first `most` decisions of the whole run that a line matches. The place stays."""
        lines, total = self._cursor.find(line, most, progress)
        return Found(_lines(lines), total)

    def why(self, point: Optional[int] = None, edge: Optional[Sequence[int]] = None,
            triangle: Optional[Sequence[int]] = None, more: bool = False, progress: Progress = None) -> Answer:
        """As se.why(), of this run."""
        given = [(1, None if point is None else [point]), (2, edge), (3, triangle)]
        subject = [each for each in given if each[1] is not None]
        most = np.iinfo(np.uint32).max
        if len(subject) != 1 or np.size(subject[0][1]) != subject[0][0] or not all(
                isinstance(p, numbers.Integral) and 0 <= p <= most for p in subject[0][1]):
            raise ValueError("expected one of point=P, edge=(P, Q), triangle=(P, Q, R), numbered from 0")
        parts = _core.why(self._run, list(map(int, subject[0][1])), more, progress)
        return Answer(**{**parts, "lines": _lines(parts["lines"])})

    def mesh(self, progress: Progress = None) -> Mesh:
        """The mesh at the end of this run."""
        return Mesh(_core.reconstruct(self._run, progress))

    def _repr_svg_(self) -> str:
        return self.state.svg()


class Stepper:
    """The algorithm, phase by phase. observer(event): called for each decision after its phase; a true value stops
    the run there, and the next call goes on. Arrays are copies."""

    def __init__(self, points: Source, normals: Any = None, rules: Optional[str] = None,
                 observer: Optional[Callable[[Event], Any]] = None, **options: Any) -> None:
        self._run = _prepare(points, normals, rules, options, "paper")
        me = weakref.ref(self)  # an observer may refer to its stepper
        self._observer = observer
        self._core = _core.Stepper(self._run, observer and (lambda event: me()._observer(event)))
        self.prepared = _prepared_record(self._run)

    def advance(self) -> bool:
        """Runs one phase of a pivot. False, doing nothing, if the run is finished."""
        return self._core.step(False)

    def step_pivot(self) -> bool:
        """Runs to the end of the pivot, or of the next one if between two. False if none was left, or if the observer
        stopped it."""
        return self._core.step(True)

    def run_until(self, condition: Optional[Callable[["Stepper"], Any]] = None, progress: Progress = None) -> str:
        """Runs whole pivots until condition(self) is true between two of them, or to the end: "condition", "observer",
        "finished", or "capped" after too many triangles."""
        return self._core.run_until(self, condition, progress)

    @property
    def phase(self) -> str:
        """The next phase: "seed", "pivot", "sort", "limits", "convex", "reciprocal", "hole", "sphere", "twopoint",
        "guard", "emit", "ring", "link", "fill", "advance", one after the last pivot, or "finished"."""
        return self._core.phase()

    @property
    def pivots(self) -> int:
        """Number of pivots begun; between two pivots all of them are complete."""
        return self._core.pivots()

    @property
    def counters(self) -> Dict[str, int]:
        return self._core.counters()

    @property
    def status(self) -> np.ndarray:
        """(n,) int32: UNUSED 0, USED the number of ring entries, DONE -1 (4)."""
        return self._core.status()

    @property
    def triangles(self) -> np.ndarray:
        """(t, 3) uint32: the mesh so far (6.4)."""
        return self._core.triangles()

    @property
    def rings(self) -> List[Ring]:
        """The active edge ring, then the stack from the top (6.5)."""
        return [Ring(*each) for each in self._core.rings()]

    @property
    def neighbor_ring(self) -> RingPoints:
        """Start, the candidates left and end (6.1), from the sort on until the triangles are made; empty otherwise."""
        return RingPoints(*self._core.neighbor_ring())


def look(run: Union[Run, Stepper], viewer: str = _VIEWER) -> None:
    """Opens the viewer at the place of a run, and returns when its window is closed. viewer: the program, by its name
    on PATH or its path. What the user does there has no effect here. Raises OSError."""
    import subprocess
    import tempfile
    place = str(run.pivots) if isinstance(run, Stepper) else run.state.address or "0"
    with tempfile.TemporaryDirectory(prefix="spiraling-edge-") as folder:
        run._run.write_session(os.fsencode(folder), place)
        ended = subprocess.run([viewer, os.path.join(folder, "run.sesession")], check=False).returncode
    if ended != 0:
        raise OSError(f"{viewer} ended with an error")
