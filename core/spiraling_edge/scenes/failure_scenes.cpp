#include "spiraling_edge/scenes/failure_scenes.h"

#include <algorithm>

#include "spiraling_edge/base/random.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/surface_scenes.h"

namespace se {
namespace {

/// Adds lists with `reach`, so that the failure does not depend on options.
PointFile withLists(PointFile file, const NeighborOptions& reach) {
    const std::vector<bool> usable(file.position.size(), true);
    auto lists = findNeighbors(file.position, file.normal, usable, reach);
    if (lists.ok()) file.neighbors = std::move(lists.value());
    return file;
}

PointFile smallSphere() { return sampleClosed(unitSphere(), 300, 0.2195, 1); }

void add(PointFile& file, const Vec3& position, const Vec3& normal, unsigned faces = 0) {
    file.position.push_back(position);
    file.normal.push_back(normal);
    file.type.push_back(withCornerBit(static_cast<std::uint8_t>(faces)));
}

double lengthSq(const Vec3& v) { return glm::dot(v, v); }

}  // namespace

PointFile fourEdgeHole() {
    return withLists(sampleClosed(torus(), 160, 0.3375, 2), {KNearest{20}});
}

PointFile sparseSpot() {
    // Every second point of a cap is missing, and the reach stays that of the rest.
    const PointFile even = smallSphere();
    const Vec3 top(0.0, 0.0, 1.0);
    PointFile file;
    for (std::size_t i = 0; i < even.position.size(); ++i) {
        if (lengthSq(even.position[i] - top) > 0.5 || i % 2 == 0)
            add(file, even.position[i], even.normal[i]);
    }
    file.type.clear();
    return withLists(std::move(file), {WithinRadius{0.33}});
}

PointFile closeSheets() {
    constexpr double kGap = 0.12;  // the spacing is 0.2
    PointFile file = sampleSheet(flatSheet(), 7, 60, 1);
    const PointFile second = sampleSheet(flatSheet(), 7, 60, 2);
    for (std::size_t i = 0; i < second.position.size(); ++i)
        add(file, second.position[i] + Vec3(0, 0, kGap), second.normal[i], second.type[i]);
    return file;
}

PointFile sharpCrease() {
    // Two half planes that meet at 40 degrees along y; rows are shifted against each other.
    constexpr double kSine = 0.3420201433256687;
    constexpr double kCosine = 0.9396926207859084;
    constexpr double kSpacing = 0.2;
    constexpr double kRow = 0.1732050807568877;
    PointFile file;
    for (int y = -4; y <= 4; ++y) {
        for (int x = -8; x <= 8; ++x) {
            const double u = (x + (y % 2 != 0 ? 0.5 : 0.0)) * kSpacing;
            const double side = u < 0.0 ? -1.0 : 1.0;
            const Vec3 normal = u == 0.0 ? Vec3(0, 0, 1) : Vec3(side * kCosine, 0.0, kSine);
            add(file, Vec3(u * kSine, y * kRow, -side * u * kCosine), normal);
        }
    }
    file.type.clear();
    return file;
}

PointFile unevenDensity() {
    const PointFile even = sampleClosed(unitSphere(), 1200, 0.1097, 1);
    PointFile file;
    for (std::size_t i = 0; i < even.position.size(); ++i) {
        if (even.position[i].x < 0.0 || i % 12 == 0) add(file, even.position[i], even.normal[i]);
    }
    file.type.clear();
    return file;
}

PointFile noiseAlongNormal() {
    PointFile file = sampleClosed(unitSphere(), 400, 0.19, 1);
    SplitMix random(5);
    for (Vec3& x : file.position) x *= 1.0 + 0.3 * (random.unit() - 0.5);
    return file;
}

PointFile wrongLists() {
    // Every fortieth point lists points of the other side of the sphere.
    PointFile file = withLists(smallSphere(), {KNearest{10}});
    const auto count = static_cast<Index>(file.position.size());
    NeighborLists lists;
    for (Index p = 0; p < count; ++p) {
        std::vector<Index> list(file.neighbors[p].begin(), file.neighbors[p].end());
        if (p % 40 == 17) {
            for (Index& q : list) q = (q + count / 2) % count;
            std::erase(list, p);
        }
        lists.append(list);
    }
    file.neighbors = std::move(lists);
    return file;
}

PointFile flippedPatch() {
    PointFile file = smallSphere();
    for (std::size_t i = 0; i < file.position.size(); ++i) {
        if (file.position[i].z > 0.8) file.normal[i] = -file.normal[i];
    }
    return file;
}

PointFile nearDuplicates() {
    PointFile file = smallSphere();
    const std::size_t count = file.position.size();
    for (std::size_t i = 0; i < count; i += 15) {
        file.position.push_back(file.position[i] + Vec3(1e-7, 2e-7, 0.0));
        file.normal.push_back(file.normal[i]);
    }
    return file;
}

PointFile strandedPoint() {
    return withLists(sampleClosed(torus(), 160, 0.3375, 4), {KNearest{14}});
}

PointFile teeAtWall() {
    // A second sheet is upright on the middle of the first: where the two meet a wall, three walls'
    // points are neighbors.
    PointFile file = sampleSheet(flatSheet(), 5, 26, 1);
    for (Vec3& x : file.position) {
        if (x.x * x.x < 0.01 && x.y * x.y < 0.98) x.x = 0.0;
    }
    const PointFile second = sampleSheet(flatSheet(), 5, 26, 11);
    for (const Vec3& x : second.position) {
        if (x.x < -0.8) continue;
        unsigned faces = 0;
        if (x.y >= 1.0) faces |= kPositiveY;
        if (x.y <= -1.0) faces |= kNegativeY;
        if (x.x >= 1.0) faces |= kPositiveZ;
        add(file, Vec3(0.0, x.y, x.x + 1.0), Vec3(1, 0, 0), faces);
    }
    return file;
}

}  // namespace se
