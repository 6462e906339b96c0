/// Plain geometry in long double, by other formulas than those of the stepper.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se::test::sentences {

using Real = long double;
using V = glm::vec<3, Real, glm::defaultp>;
inline constexpr Real kDegree = std::numbers::pi_v<Real> / 180;

/// The angle between two directions, in degrees: 0 to 180.
inline Real between(const V& a, const V& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) / kDegree;
}

/// §6.1: the angle of `x` at p counterclockwise about `normal` from `first`, in degrees: 0 to 360.
/// `flat`: in projection on the tangent plane, where a direction along the normal counts as 90.
inline Real angleAt(const V& p, const V& normal, const V& first, const V& x, bool flat) {
    const V z = first - p;
    const V v = x - p;
    const V ahead = glm::cross(normal, z);
    const Real across = glm::dot(ahead, v) / glm::length(ahead);
    if (!flat) return across < 0 ? 360 - between(z, v) : between(z, v);
    const auto isAlongNormal = [&](const V& d) {
        return glm::length(glm::cross(normal, d)) <= 1e-12L * glm::length(d);
    };
    if (isAlongNormal(z) || isAlongNormal(v)) return 90;
    const V along = glm::cross(ahead, normal);
    const Real angle = std::atan2(across, glm::dot(along, v) / glm::length(along)) / kDegree;
    return angle < 0 ? angle + 360 : angle;
}

/// The center, relative to the origin, of the circle through it, t and s; nothing if they are
/// collinear. By the weights of the three corners.
inline std::optional<V> circleCenter(const V& t, const V& s) {
    const Real tt = glm::dot(t, t);
    const Real ss = glm::dot(s, s);
    const Real ts = glm::dot(t - s, t - s);
    const Real atT = ss * (tt + ts - ss);
    const Real atS = tt * (ss + ts - tt);
    const Real sum = ts * (tt + ss - ts) + atT + atS;
    if (!(std::abs(sum) > 4e-20L * tt * ss)) return std::nullopt;
    return (atT * t + atS * s) / sum;
}

using Corners = std::array<V, 3>;
inline V areaOf(const Corners& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }
inline bool hasNoArea(const Corners& t) {
    return glm::length(areaOf(t)) <= 1e-12L * glm::distance(t[0], t[1]) * glm::distance(t[0], t[2]);
}
inline Real leastAngle(const Corners& t) {
    return std::min({between(t[1] - t[0], t[2] - t[0]), between(t[2] - t[1], t[0] - t[1]),
                     between(t[0] - t[2], t[1] - t[2])});
}
inline Real circumradius(const Corners& t) {
    return glm::distance(t[0], t[1]) * glm::distance(t[1], t[2]) * glm::distance(t[2], t[0]) /
           (2 * glm::length(areaOf(t)));
}

/// The part of the segment from u to v, as shares of it, that lies in the prism over a triangle.
inline std::array<Real, 2> insidePrism(const V& u, const V& v, const Corners& t) {
    const V up = areaOf(t);
    std::array<Real, 2> part{0, 1};
    for (std::size_t k = 0; k < 3; ++k) {
        const V inward = glm::cross(up, t[(k + 1) % 3] - t[k]);
        const Real a = glm::dot(inward, u - t[k]);
        const Real b = glm::dot(inward, v - t[k]);
        if (a < 0 && b < 0) return {1, 0};
        if (a < 0) part[0] = std::max(part[0], a / (a - b));
        if (b < 0) part[1] = std::min(part[1], a / (a - b));
    }
    return part;
}

/// True if an edge of `a` meets `b` in more than points that are corners of both, up to rounding.
inline bool edgeMeets(const Corners& a, const Corners& b) {
    constexpr Real kSmall = 1e-9L;
    const V up = glm::normalize(areaOf(b));
    const auto isCorner = [](const V& x, const Corners& t) {
        return x == t[0] || x == t[1] || x == t[2];
    };
    for (std::size_t k = 0; k < 3; ++k) {
        const V& u = a[k];
        const V& v = a[(k + 1) % 3];
        if (isCorner(u, b) && isCorner(v, b)) continue;
        const Real slack = kSmall * glm::distance(u, v);
        const Real atU = glm::dot(up, u - b[0]);
        const Real atV = glm::dot(up, v - b[0]);
        std::array<Real, 2> part = insidePrism(u, v, b);
        if (std::abs(atU) > slack || std::abs(atV) > slack) {
            const Real at = atU / (atU - atV);
            if (!(at > -kSmall && at < 1 + kSmall)) continue;
            if ((isCorner(u, b) && at < kSmall) || (isCorner(v, b) && at > 1 - kSmall)) continue;
            if (at >= part[0] - kSmall && at <= part[1] + kSmall) return true;
        } else if (part[1] > (isCorner(u, b) ? kSmall : part[0] - kSmall) &&
                   part[0] < (isCorner(v, b) ? 1 - kSmall : part[1] + kSmall)) {
            return true;
        }
    }
    return false;
}
inline bool trianglesMeet(const Corners& a, const Corners& b) {
    return edgeMeets(a, b) || edgeMeets(b, a);
}

/// True if triangles with these outward normals lie over one another: see isSecondLayer().
inline bool covers(const Corners& a, const V& outA, const Corners& b, const V& outB) {
    if (between(outA, outB) > 45 + 1e-6L) return false;
    const V up = glm::normalize(glm::normalize(outA) + glm::normalize(outB));
    std::vector<V> part(a.begin(), a.end());
    const Real turn = glm::dot(areaOf(b), up) < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3 && !part.empty(); ++k) {
        const V inward = turn * glm::cross(up, b[(k + 1) % 3] - b[k]);
        std::vector<V> left;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const V& p = part[i];
            const V& q = part[(i + 1) % part.size()];
            const Real atP = glm::dot(inward, p - b[k]);
            const Real atQ = glm::dot(inward, q - b[k]);
            if (atP >= 0) left.push_back(p);
            if (atP * atQ < 0) left.push_back(p + (q - p) * (atP / (atP - atQ)));
        }
        part = left;
    }
    V sum(0);
    for (std::size_t i = 2; i < part.size(); ++i) sum += areaOf({part[0], part[i - 1], part[i]});
    const Real smaller =
        std::min(std::abs(glm::dot(areaOf(a), up)), std::abs(glm::dot(areaOf(b), up)));
    if (part.size() < 3 || std::abs(glm::dot(sum, up)) < 0.01999L * smaller) return false;
    Real reach = 0;
    for (std::size_t k = 0; k < 3; ++k)
        reach += (glm::distance(a[k], a[(k + 1) % 3]) + glm::distance(b[k], b[(k + 1) % 3])) / 12;
    return std::any_of(part.begin(), part.end(), [&](const V& x) {
        const Real gap = glm::dot(areaOf(b), x - b[0]) / glm::dot(areaOf(b), up);
        return std::abs(gap) <= reach * (1 + 1e-9L);
    });
}

}  // namespace se::test::sentences
