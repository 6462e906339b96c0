"""Section 6.1, Figure 3: the candidates, by angle."""
from geometry import SAME_ANGLE


def sort(at):
    """Returns the neighbors of at.p that may become points of its fan, by increasing at.angle().

    Those of at.lists[at.p] that are not DONE, not first and not last, and whose angle is more than
    SAME_ANGLE above 0 and more than SAME_ANGLE below that of last, at.end_angle(1). Of neighbors
    whose angles are within SAME_ANGLE, the one nearest to p stays: it comes first in the list.
    """
    raise NotImplementedError
