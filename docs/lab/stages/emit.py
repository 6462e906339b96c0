"""Sections 6.4 and 6.5: the fan, and the edge ring after it."""
from geometry import HALF_TURN


def fan(at, start, end, candidates):
    """Returns the points of the fan from first to last; [] for no triangle.

    First, the ring points that start has passed, start, the candidates, end, the ring points that
    end has passed, last; each once, but in a full turn first is last, too, and stands at both ends.
    A fan of first and last alone has no triangle if the angle of last, at.end_angle(1), exceeds
    HALF_TURN (Figure 9).
    """
    raise NotImplementedError


def ring(at, start, end, candidates, points):
    """Returns the edge ring after the pivot, from the next pivot on; `points` is the fan.

    With triangles, p and the points that start and end have passed leave the ring, the candidates
    enter it between start and end, and the point at end is the next pivot. Without a triangle the
    ring stays, and the point after p is next. Only pivots without split and join are tested.
    """
    raise NotImplementedError
