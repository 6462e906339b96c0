/// Shape of a triangle against its corners' normals and its neighbors: shared by the rules beyond
/// the paper and the checks of a finished mesh, so that both have the same definition of a fault.
#pragma once

#include <algorithm>
#include <cmath>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Two triangles at an edge count as folded if the angle between them is below this: the cosine of
/// the angle between their normals is below -cos(10 degrees).
inline constexpr double kFoldCosine = -0.984807753012208;

/// Twice the area along the normal, counterclockwise.
inline Vec3 areaVector(const Vec3& a, const Vec3& b, const Vec3& c) {
    return glm::cross(b - a, c - a);
}
inline Vec3 areaVector(const PointSet& points, const Triangle& t) {
    return areaVector(points.position[t.a], points.position[t.b], points.position[t.c]);
}

/// A triangle whose height is at most this share of its longest edge is a needle.
inline constexpr double kNeedle = 1e-6;

/// FaultKind::Degenerate: a corner twice, no area, or a needle.
inline bool isDegenerate(const PointSet& points, const Triangle& t) {
    if (t.a == t.b || t.b == t.c || t.c == t.a) return true;
    const Vec3 u = points.position[t.b] - points.position[t.a];
    const Vec3 v = points.position[t.c] - points.position[t.a];
    const double longest =
        std::max(glm::dot(u - v, u - v), std::max(glm::dot(u, u), glm::dot(v, v)));
    return !(glm::length(glm::cross(u, v)) > kNeedle * longest);
}

/// Above zero if the triangle faces the sum of the normals of its corners.
inline double facing(const PointSet& points, const Triangle& t) {
    const Vec3 sum = points.normal[t.a] + points.normal[t.b] + points.normal[t.c];
    return glm::dot(areaVector(points, t), sum);
}

/// The point of a triangle that is nearest to `x`, by the region that `x` lies over: a corner, a
/// side or the inside (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
inline Vec3 nearestPoint(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double d1 = glm::dot(ab, x - a);
    const double d2 = glm::dot(ac, x - a);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const double d3 = glm::dot(ab, x - b);
    const double d4 = glm::dot(ac, x - b);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
    const double d5 = glm::dot(ab, x - c);
    const double d6 = glm::dot(ac, x - c);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    return a + (vb * ab + vc * ac) / (va + vb + vc);
}

/// FaultKind::Flipped, for a triangle that is not degenerate.
inline bool isFlipped(const PointSet& points, const Triangle& t) { return facing(points, t) < 0.0; }

/// True if the triangle faces the normal of each of its corners.
inline bool facesNormals(const PointSet& points, Index a, Index b, Index c) {
    const Vec3 area = areaVector(points, {a, b, c});
    return glm::dot(area, points.normal[a]) > 0.0 && glm::dot(area, points.normal[b]) > 0.0 &&
           glm::dot(area, points.normal[c]) > 0.0;
}

/// Weight of a flipped triangle (FaultKind::Flipped) against smaller faults.
inline constexpr int kFlippedFault = 4;

/// The same triangle, from its least corner on: rounding depends on the order of the corners.
inline Triangle fromLeastCorner(const Triangle& t) {
    if (t.b < t.a && t.b < t.c) return {t.b, t.c, t.a};
    return t.c < t.a && t.c < t.b ? Triangle{t.c, t.a, t.b} : t;
}

/// kFlippedFault for a flipped triangle, 1 for one against a single corner's normal, else 0. The
/// same whichever corner comes first, also where an edge runs along a normal: the flips of edges
/// end only if no triangle gets better by being made again.
inline int shapeFaults(const PointSet& points, const Triangle& t) {
    const Triangle s = fromLeastCorner(t);
    if (!(facing(points, s) > 0.0)) return kFlippedFault;
    return facesNormals(points, s.a, s.b, s.c) ? 0 : 1;
}

/// True if the triangle is farther off the normal of a corner than the angle of this cosine.
inline bool isSteep(const PointSet& points, const Triangle& t, double cosine) {
    const Vec3 area = areaVector(points, t);
    const double limit = cosine * std::sqrt(glm::dot(area, area));
    return glm::dot(area, points.normal[t.a]) < limit ||
           glm::dot(area, points.normal[t.b]) < limit || glm::dot(area, points.normal[t.c]) < limit;
}

/// True only if the triangle is far from a needle and within the angle of this cosine of each
/// normal of its corners, by margins far above the rounding: neither flipped nor isSteep().
inline bool clearlyFaces(const PointSet& points, const Triangle& t, double cosine) {
    constexpr double kMargin = 1e-6;
    const Vec3 ab = points.position[t.b] - points.position[t.a];
    const Vec3 ac = points.position[t.c] - points.position[t.a];
    const Vec3 area = glm::cross(ab, ac);
    const double areaSq = glm::dot(area, area);
    const double edges = glm::dot(ab, ab) + glm::dot(ac, ac);
    if (!(areaSq > 1e-8 * edges * edges)) return false;
    const double least = (cosine + kMargin) * std::sqrt(areaSq);
    return glm::dot(area, points.normal[t.a]) > least &&
           glm::dot(area, points.normal[t.b]) > least && glm::dot(area, points.normal[t.c]) > least;
}

/// Cosine of the angle between the normals of two triangles; 1 if one has no area.
inline double normalsCosine(const PointSet& points, const Triangle& a, const Triangle& b) {
    const Vec3 m = areaVector(points, a);
    const Vec3 n = areaVector(points, b);
    const double size = std::sqrt(glm::dot(m, m) * glm::dot(n, n));
    return size > 0.0 ? glm::dot(m, n) / size : 1.0;
}

/// True if the angle between two normals of any length is larger than the one with this cosine. The
/// roots are taken separately: the product of the squares would overflow much earlier.
inline bool encloseMore(const Vec3& m, const Vec3& n, double cosine) {
    const double along = glm::dot(m, n);
    if (cosine <= 0.0 && along >= 0.0) return false;  // Most, and without a root.
    return along < cosine * (std::sqrt(glm::dot(m, m)) * std::sqrt(glm::dot(n, n)));
}

/// FaultKind::Folded, for triangles at a common edge. The same whichever corner comes first.
inline bool folded(const PointSet& points, const Triangle& a, const Triangle& b) {
    return encloseMore(areaVector(points, fromLeastCorner(a)),
                       areaVector(points, fromLeastCorner(b)), kFoldCosine);
}

/// Cosine of the least angle: the smaller, the better. 1 for a triangle without area.
inline double leastAngleCosine(const PointSet& points, const Triangle& t) {
    const Vec3 ab = points.position[t.b] - points.position[t.a];
    const Vec3 bc = points.position[t.c] - points.position[t.b];
    const Vec3 ca = points.position[t.a] - points.position[t.c];
    const double abSq = glm::dot(ab, ab);
    const double bcSq = glm::dot(bc, bc);
    const double caSq = glm::dot(ca, ca);
    // Between a side that arrives at a corner and the one that leaves it.
    const auto cosine = [](const Vec3& in, double inSq, const Vec3& out, double outSq) {
        const double size = std::sqrt(inSq * outSq);
        return size > 0.0 ? -glm::dot(in, out) / size : 1.0;
    };
    return std::max(cosine(ca, caSq, ab, abSq),
                    std::max(cosine(ab, abSq, bc, bcSq), cosine(bc, bcSq, ca, caSq)));
}

}  // namespace se
