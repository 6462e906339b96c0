/// Minimal inputs for a rule that examines the fan of one pivot, and their results.
#pragma once

#include "support/oracles.h"
#include "support/rig.h"

namespace se::test {

/// p = 0 between first = 1 in the east and last = 2 in the west, a little under 180 degrees apart,
/// so that the three alone make a triangle. 3 and 4 are far in the south, and their sectors, as
/// those of 1 and 2, lead outside: no other pivot of the ring makes a triangle.
inline std::vector<Vec3> underHalf(const std::vector<Vec3>& more) {
    std::vector<Vec3> position{{0, 0, 0}, {1, 0.2, 0}, {-1, 0.2, 0}, {-9, -9, 0}, {9, -9, 0}};
    position.insert(position.end(), more.begin(), more.end());
    return position;
}
/// As underHalf(), but a little over 180 degrees: the three alone make no triangle.
inline std::vector<Vec3> overHalf(const std::vector<Vec3>& more) {
    std::vector<Vec3> position = underHalf(more);
    position[1].y = position[2].y = -0.2;
    return position;
}
/// p = 0 at the origin, first = 1 in the east, last = 2 at an angle, candidates from 5 on.
inline std::vector<Vec3> inSector(double lastDegrees, std::vector<Vec3> more) {
    std::vector<Vec3> position{Vec3(0), polar(0), polar(lastDegrees), {-9, -9, 0}, {9, -9, 0}};
    position.insert(position.end(), more.begin(), more.end());
    return position;
}
inline const Points kRing{0, 2, 3, 4, 1};
inline const Triangles kWithout5{{0, 1, 2}};
inline const Triangles kWith5{{0, 1, 5}, {0, 5, 2}};
inline const Triangles kWith5And6{{0, 1, 5}, {0, 5, 6}, {0, 6, 2}};

/// The verdicts of the guard.
inline std::vector<Verdict> objections(const Rig& rig) {
    std::vector<Verdict> verdicts;
    for (const auto& e : rig.all<GuardEvidence>()) verdicts.push_back(e.verdict);
    return verdicts;
}
using Verdicts = std::vector<Verdict>;

}  // namespace se::test
