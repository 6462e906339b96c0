from geometry import HALF_TURN, add, cross, dot, sub


def hole(at, start, end, candidates):
    a, b = at.ring[start], at.ring[end]
    if end + 1 != start or (b, a) in at.open or \
            not at.end_angle(end) - at.start_angle(start) < HALF_TURN:
        return candidates
    total = add(add(at.normal[at.p], at.normal[a]), at.normal[b])
    plane = cross(sub(at.position[b], at.position[a]), total)

    def side(x):
        return dot(plane, sub(at.position[x], at.position[a]))
    return [x for x in candidates if side(x) * side(at.p) > 0.0]
