"""Section 6.1, Figure 6: a point of a ring stays only if p could be its neighbor."""
from geometry import FULL_TURN, SAME_ANGLE, angle


def reciprocal(at, candidates):
    """Returns the candidates that are on no ring, and those with an entry whose free sector holds p.

    The entries of e are at.entries.get(e, []), as (before, after). The sector goes from `before`
    counterclockwise to `after`, seen from e with the normal of e; it is a FULL_TURN if both are the
    same point. p lies in it if its angle is more than SAME_ANGLE inside.
    """
    raise NotImplementedError
