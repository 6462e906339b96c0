from geometry import FULL_TURN, SAME_ANGLE, angle


def holds(at, e, before, after):
    def seen(x):
        return angle(at.position[e], at.normal[e], at.position[before], at.position[x])
    limit = FULL_TURN if before == after else seen(after)
    return SAME_ANGLE < seen(at.p) < limit - SAME_ANGLE


def reciprocal(at, candidates):
    return [e for e in candidates if e not in at.entries or
            any(holds(at, e, *pair) for pair in at.entries[e])]
