from geometry import HALF_TURN, SAME_ANGLE, cross, dot, sub


def is_concave(at, s, before, after):
    a, b = sub(at.position[before], at.position[s]), sub(at.position[after], at.position[s])
    return dot(cross(a, b), at.normal[s]) > 0.0


def moves(at, start, end, side):
    low, high = at.start_angle(start), at.end_angle(end)
    limit, to = (start, start - 1) if side < 0 else (end, (end + 1) % len(at.ring))
    s, x = at.ring[limit], at.ring[to]
    if ((x, s) if side < 0 else (s, x)) in at.open or x not in at.lists[at.p]:
        return False
    angle = at.angle(x)
    if not max(low, 0.0) + SAME_ANGLE < angle < high - SAME_ANGLE:
        return False
    if not (is_concave(at, s, x, at.p) if side < 0 else is_concave(at, s, at.p, x)):
        return False
    return (angle - low if side < 0 else high - angle) < HALF_TURN - SAME_ANGLE


def limits(at, candidates):
    start, end = len(at.ring) - 1, 1
    if at.is_full_turn():
        return start, end, candidates
    while moves(at, start, end, -1):
        start -= 1
    while moves(at, start, end, 1):
        end += 1
    if start < len(at.ring) - 1 or end > 1:
        low, high = at.start_angle(start) + SAME_ANGLE, at.end_angle(end) - SAME_ANGLE
        candidates = [x for x in candidates if low < at.angle(x) < high]
    beyond = (at.ring[start - 1], at.ring[(end + 1) % len(at.ring)])
    return start, end, [x for x in candidates
                        if x not in beyond or len(at.entries.get(x, [])) != 1]
