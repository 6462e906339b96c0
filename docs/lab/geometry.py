"""Vectors, angles, and the pivot that every stage gets. Given; nothing to do here."""
import math

SAME_ANGLE = 1e-12  # Angles nearer than this, in the unit of angle(), are the same.
HALF_TURN = 2.0
FULL_TURN = 4.0


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a, factor):
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0], a[0] * b[1] - b[0] * a[1])


def angle(center, normal, reference, x):
    """The angle at `center` from `reference` counterclockwise to `x` (section 6.1), as a number that
    grows with it: 1 - cos up to 180 degrees, 3 + cos beyond; so 0 to 4, with HALF_TURN at 2."""
    z = sub(reference, center)
    z = scale(z, 1.0 / math.sqrt(dot(z, z)))
    v = sub(x, center)
    cosine = max(-1.0, min(1.0, dot(z, v) / math.sqrt(dot(v, v))))
    return 3.0 + cosine if dot(cross(normal, z), v) < 0.0 else 1.0 - cosine


def degrees(key):
    """The result of angle() in degrees."""
    if key <= HALF_TURN:
        return math.degrees(math.acos(max(-1.0, 1.0 - key)))
    return 360.0 - math.degrees(math.acos(min(1.0, key - 3.0)))


class Pivot:
    """A pivot and what the run knows before it. Points are numbers from 0.

    position[x], normal[x]   of point x
    lists[x]                 its neighbors, nearest first
    p                        the pivot
    ring                     the active edge ring from p on: ring[0] is p, ring[1] is last, ring[-1]
                             is first; the mesh is on its left
    open                     the set of steps (from, to) of the rings that are no edges of the mesh
    done                     the set of DONE points
    entries[x]               for each place of x on a ring, its neighbors there, (before, after);
                             a point that is on no ring has no entries: it is UNUSED or DONE

    Start and end of the neighbor ring are places of `ring`: start begins at len(ring) - 1, first,
    and goes down; end begins at 1, last, and goes up.
    """

    def __init__(self, points, p, ring, stack, open_steps, done):
        self.position, self.normal, self.lists = points.position, points.normal, points.lists
        self.p, self.ring, self.open, self.done = p, ring, open_steps, done
        self.entries = {}
        for each in [ring] + stack:
            for i, x in enumerate(each):
                pair = (each[i - 1], each[(i + 1) % len(each)])
                self.entries.setdefault(x, []).append(pair)

    @property
    def first(self):
        return self.ring[-1]

    @property
    def last(self):
        return self.ring[1]

    def is_full_turn(self):
        """First and last are the same point: the sector is a full turn."""
        return self.first == self.last

    def angle(self, x):
        """The angle of point x at p, from first."""
        return angle(self.position[self.p], self.normal[self.p], self.position[self.first],
                     self.position[x])

    def start_angle(self, start):
        return 0.0 if start == len(self.ring) - 1 else self.angle(self.ring[start])

    def end_angle(self, end):
        if end == 1 and self.is_full_turn():
            return FULL_TURN
        return self.angle(self.ring[end])
