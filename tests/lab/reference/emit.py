from geometry import HALF_TURN


def fan(at, start, end, candidates):
    passed = at.ring[start:][::-1]
    points = passed + candidates + at.ring[1:end + 1][::-1]
    return [] if len(points) == 2 and at.end_angle(1) > HALF_TURN else points


def ring(at, start, end, candidates, points):
    if not points:
        return at.ring[1:] + at.ring[:1]
    return at.ring[end:start + 1] + candidates
