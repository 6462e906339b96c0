from geometry import SAME_ANGLE


def sort(at):
    end = at.end_angle(1)
    found = []
    for x in at.lists[at.p]:
        if x in at.done or x in (at.first, at.last):
            continue
        if SAME_ANGLE < at.angle(x) < end - SAME_ANGLE:
            found.append(x)
    found.sort(key=at.angle)
    kept = []
    for x in found:
        if kept and at.angle(x) - at.angle(kept[-1]) <= SAME_ANGLE:
            nearest = min(kept[-1], x, key=at.lists[at.p].index)
            kept[-1] = nearest
        else:
            kept.append(x)
    return kept
