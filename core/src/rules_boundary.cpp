#include "spiraling_edge/rules.h"

namespace se {
namespace {

/// Angles up to this much over 180 degrees (in key units, about 2.5 degrees) pass as straight: wall
/// points lie along their wall only up to the sampling.
constexpr double kStraightSlack = 1e-3;

struct Wall {
    std::uint8_t bit;
    Vec3 outward;
};

constexpr Wall kWalls[] = {
    {kPositiveX, {1, 0, 0}},  {kPositiveY, {0, 1, 0}},  {kPositiveZ, {0, 0, 1}},
    {kNegativeX, {-1, 0, 0}}, {kNegativeY, {0, -1, 0}}, {kNegativeZ, {0, 0, -1}},
};

}  // namespace

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
        // A surface that lies in the wall has no outward direction of its own.
        const Vec3 inPlane = wall.outward - glm::dot(wall.outward, normal) * normal;
        if (glm::dot(inPlane, inPlane) < 1e-12) continue;
        const Angle out = angleOf(frame, inPlane);
        if (strictlyBetween(out, Angle{}, end, 0.0)) return false;
    }
    return true;
}

ThirdPointPlace placeThirdPoint(const Vec3& p, const Vec3& normal, std::uint8_t faces,
                                const Vec3& second, const Vec3& third) {
    const Vec3 cross = glm::cross(normal, second - p);
    const bool printed = pointsOut(cross, faces);
    // Choice: where the points do not lie along one wall, the cross product may say "after" for a
    // sector that leads outside; then the other place is taken if its sector stays inside.
    const auto fits = [&](bool before) {
        return before ? sectorStaysInside(p, normal, faces, third, second)
                      : sectorStaysInside(p, normal, faces, second, third);
    };
    const bool before = !fits(printed) && fits(!printed) ? !printed : printed;
    return {cross, before};
}

}  // namespace se
