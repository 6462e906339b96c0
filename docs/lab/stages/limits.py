"""Section 6.1, Figures 4 and 5: start and end move, and candidates beyond them go."""
from geometry import HALF_TURN, SAME_ANGLE, cross, dot, sub


def limits(at, candidates):
    """Returns (start, end, candidates): places on at.ring, and the candidates that are left.

    start = len(at.ring) - 1 and end = 1 at first. If at.is_full_turn(), nothing changes.

    Figure 4. First start moves on, from s = ring[start] to the point x = ring[start - 1], while
      - the step from x to s is not open,
      - x is in the list of p,
      - the angle of x lies between those of start and end, by more than SAME_ANGLE,
      - the ring is concave at s: ((x - s) x (p - s)) . normal of s > 0,
      - the angle of x less that of start is below HALF_TURN - SAME_ANGLE.
    Then end moves on, from s = ring[end] to the point x = ring[end + 1], while
      - the step from s to x is not open,
      - x is in the list of p,
      - the angle of x lies between those of start and end, by more than SAME_ANGLE,
      - the ring is concave at s: ((p - s) x (x - s)) . normal of s > 0,
      - the angle of end less that of x is below HALF_TURN - SAME_ANGLE.
    If either moved, candidates go whose angle is not more than SAME_ANGLE above that of start, or
    not more than SAME_ANGLE below that of end.

    Angles are those of at.angle(), at.start_angle(start) and at.end_angle(end). A difference of two
    may be compared with HALF_TURN only; for other angles take degrees() of each first.

    Figure 5, the convexity test. The candidates go that are next on the ring beyond start,
    ring[start - 1], or beyond end, ring[end + 1] (of a ring that ends there, ring[0]), if that is
    their only entry, len(at.entries[x]) == 1.
    """
    raise NotImplementedError
