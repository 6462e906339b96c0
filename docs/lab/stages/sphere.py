"""Section 6.3, Figure 8: the circumsphere."""
from geometry import cross, degrees, dot, scale, sub


def sphere(at, start, end, candidates):
    """Returns the candidates that the test of section 6.3 leaves.

    One pass, in order. For a candidate q let t be the one before it that stayed, or start, and s the
    one after it, or end. q stays if it is inside the sphere whose equator is the circle through p, t
    and s, or if the angle from t to s exceeds 120 degrees, or if p, t and s lie in line. Take the
    degrees() of each angle, then the difference; of end use at.end_angle(end), since at.angle(last)
    is 0 in a full turn.

    With T, S and Q relative to p and N = T x S, the center, relative to p, is
    (|T|^2 S - |S|^2 T) x N / (2 |N|^2), and the radius is its length. So Q is inside if
    |Q|^2 |N|^2 - Q . ((|T|^2 S - |S|^2 T) x N) < 0. Up to 1e-12 |Q|^2 |N|^2 it counts as on the
    sphere, which is not inside. In line: |N|^2 <= 1e-20 |T|^2 |S|^2.
    """
    raise NotImplementedError
