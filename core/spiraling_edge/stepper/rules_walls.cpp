/// The rules of §7 that need more than one expression: third points, and the sector of a rim point.
/// Angles are keys, and walls have exact outward directions, so that no trigonometry decides. The
/// circumsphere of points extremely far apart, or near to each other, is here too.
#include <algorithm>

#include "spiraling_edge/stepper/rules.h"

namespace se {
namespace {

/// Angles up to this much over 180 degrees (in key units, about 2.5 degrees) count as straight:
/// wall points follow their wall only up to the sampling.
constexpr double kStraightSlack = 1e-3;

struct Wall {
    std::uint8_t bit;
    Vec3 outward;
};

constexpr Wall kWalls[] = {
    {kPositiveX, {1, 0, 0}},  {kPositiveY, {0, 1, 0}},  {kPositiveZ, {0, 0, 1}},
    {kNegativeX, {-1, 0, 0}}, {kNegativeY, {0, -1, 0}}, {kNegativeZ, {0, 0, -1}},
};

/// The direction in the middle of the sector from u counterclockwise to v, of any size.
Vec3 middleOf(const Frame& frame, const Vec3& u, const Vec3& v) {
    const auto unitInPlane = [&](const Vec3& d) {
        const Vec3 along = d - glm::dot(d, frame.normal) * frame.normal;
        const double lengthSq = glm::dot(along, along);
        return lengthSq > 0.0 ? along / std::sqrt(lengthSq) : along;
    };
    const Vec3 from = unitInPlane(u);
    const Vec3 chord = unitInPlane(v) - from;
    // A quarter turn clockwise from the chord; the sector is the full turn without one.
    return glm::dot(chord, chord) > 1e-18 ? glm::cross(chord, frame.normal) : -from;
}

}  // namespace

SphereTest testExtremeSphere(const Vec3& t, const Vec3& s, const Vec3& q) {
    double most = 0.0;
    for (const Vec3* each : {&t, &s, &q})
        most = std::max({most, std::abs(each->x), std::abs(each->y), std::abs(each->z)});
    const int power = most > 0.0 && std::isfinite(most) ? -std::ilogb(most) : 0;
    const auto scaled = [](const Vec3& x, int by) {
        return Vec3(std::ldexp(x.x, by), std::ldexp(x.y, by), std::ldexp(x.z, by));
    };
    const Vec3 a = scaled(t, power);
    const Vec3 b = scaled(s, power);
    const Vec3 c = scaled(q, power);
    SphereTest test = testUsualSphere(a, glm::dot(a, a), b, glm::dot(b, b), c, glm::dot(c, c));
    test.q = q;
    test.numerator = scaled(test.numerator, -power);
    return test;
}

bool pointsOut(const Vec3& direction, std::uint8_t faces) {
    for (const Wall& wall : kWalls) {
        if ((faces & wall.bit) != 0 && glm::dot(direction, wall.outward) > 0.0) return true;
    }
    return false;
}

bool sectorStaysInside(const Vec3& p, const Vec3& normal, std::uint8_t faces, const Vec3& from,
                       const Vec3& to) {
    const Frame frame = makeFrame(p, normal, from, true);
    const Angle end = angleOf(frame, to - p);
    if (end.key > kHalfTurnKey + kStraightSlack) return false;
    for (const Wall& wall : kWalls) {
        if ((faces & wall.bit) == 0) continue;
        // A surface that lies in the wall has no outward direction there.
        const Vec3 inPlane = wall.outward - glm::dot(wall.outward, normal) * normal;
        if (glm::dot(inPlane, inPlane) < 1e-12) continue;
        const Angle out = angleOf(frame, inPlane);
        if (strictlyBetween(out, Angle{}, end, 0.0)) return false;
    }
    return true;
}

ThirdPointSide printedThirdPointSide(const Vec3& p, const Vec3& normal, std::uint8_t faces,
                                     const Vec3& second) {
    const Vec3 cross = glm::cross(normal, second - p);
    return {cross, pointsOut(cross, faces)};
}

ThirdPointSide placeThirdPoint(const Vec3& p, const Vec3& normal, std::uint8_t faces,
                               const Vec3& second, const Vec3& third) {
    const auto [cross, printed] = printedThirdPointSide(p, normal, faces, second);
    // Choice: where the points do not lie along one wall, the cross product may choose "after" for
    // a sector that leads outside; then the other place is used if its sector stays inside.
    const auto fits = [&](bool before) {
        return before ? sectorStaysInside(p, normal, faces, third, second)
                      : sectorStaysInside(p, normal, faces, second, third);
    };
    const bool before = !fits(printed) && fits(!printed) ? !printed : printed;
    return {cross, before};
}

RimSector testRimSector(const Vec3& p, const Vec3& normal, const Vec3& first, const Vec3& last,
                        bool sameEntry, const Vec3& from, const Vec3& to) {
    constexpr double kSame = 1e-9;  // Up to rounding: first or last is an end of the gap itself.
    const Frame frame = makeFrame(p, normal, first, true);
    const Angle end = sameEntry ? kFullTurn : angleOf(frame, last - p);
    const Angle gapBegin = angleOf(frame, from - p);
    const Angle gapEnd = angleOf(frame, to - p);
    const Angle middle = angleOf(frame, middleOf(frame, from - p, to - p));
    const Frame fromGap = makeFrame(p, normal, from, true);
    const auto inGap = [&](const Vec3& x) {
        return strictlyBetween(angleOf(fromGap, x - p), Angle{}, angleOf(fromGap, to - p), kSame);
    };
    const bool holdsMiddle = strictlyBetween(middle, Angle{}, end, 0.0);
    const bool firstInGap = inGap(first);
    const bool lastInGap = inGap(last);
    if (!holdsMiddle && !firstInGap && !lastInGap) return {false, false, false};
    return {true,
            !firstInGap && strictlyBetween(gapBegin, Angle{}, holdsMiddle ? middle : end, kSame),
            !lastInGap && strictlyBetween(gapEnd, holdsMiddle ? middle : Angle{}, end, kSame)};
}

bool isRim(const PointSet& points, Index p, double gapCosine) {
    if (isBoundary(points.type[p])) return true;
    const auto list = points.neighbors[p];
    if (list.size() < 3) return true;
    // Choice: of three gaps one is over 120 degrees, or all are 120 up to rounding, as at a corner
    // of a tetrahedron: only one of 180 says that the surface ends.
    const double limit = list.size() == 3 ? -1.0 : gapCosine;
    const Frame frame =
        makeFrame(points.position[p], points.normal[p], points.position[list[0]], true);
    std::vector<Angle> angles;
    angles.reserve(list.size() + 1);
    for (const Index x : list) angles.push_back(angleOf(frame, points.position[x] - frame.origin));
    std::sort(angles.begin(), angles.end(),
              [](const Angle& a, const Angle& b) { return a.key < b.key; });
    angles.push_back({angles.front().cosine, angles.front().key + kFullTurn.key});
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        if (exceedsAngle(angles[i], angles[i + 1], limit)) return true;
    }
    return false;
}

}  // namespace se
