from geometry import cross, degrees, dot, scale, sub


def is_kept(at, t, q, s):
    tv, qv, sv = (sub(at.position[x], at.position[at.p]) for x in (t, q, s))
    tt, qq, ss = dot(tv, tv), dot(qv, qv), dot(sv, sv)
    n = cross(tv, sv)
    nn = dot(n, n)
    if not nn > 1e-20 * tt * ss:
        return True
    center = cross(sub(scale(sv, tt), scale(tv, ss)), n)
    return qq * nn - dot(qv, center) < -1e-12 * qq * nn


def sphere(at, start, end, candidates):
    kept = [(at.ring[start], at.start_angle(start))]
    for i, q in enumerate(candidates):
        is_last = i + 1 == len(candidates)
        s = at.ring[end] if is_last else candidates[i + 1]
        s_angle = at.end_angle(end) if is_last else at.angle(s)
        t, t_angle = kept[-1]
        gap = degrees(s_angle) - degrees(t_angle)
        if is_kept(at, t, q, s) or gap > 120.0:
            kept.append((q, at.angle(q)))
    return [x for x, _ in kept[1:]]
