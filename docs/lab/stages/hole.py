"""Section 6.2, Figure 7: a hole of three."""
from geometry import HALF_TURN, add, cross, dot, sub


def hole(at, start, end, candidates):
    """Returns the candidates on the side of p, if p, start and end form a hole of three; else all.

    They form one if end + 1 == start, the step from ring[end] to ring[start] is not open, and the
    angle of end less that of start is below HALF_TURN. The plane goes through
    ring[start] and ring[end], along the sum of the normals of p, ring[start] and ring[end]: its own
    normal is (end - start) x sum. A candidate stays if it lies strictly on the side of p.
    """
    raise NotImplementedError
