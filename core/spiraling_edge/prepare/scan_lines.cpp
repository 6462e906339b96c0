#include "spiraling_edge/prepare/scan_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "spiraling_edge/base/median.h"
#include "spiraling_edge/prepare/normals.h"

namespace se {
namespace {

/// Points lie in lines if the median of the spread along a place by that across is above this. Of
/// eight nearest none is in another line from a ratio of five on, where meshes begin to suffer.
constexpr double kInLines = 4.0;
constexpr std::size_t kOfLine = 8;
constexpr std::size_t kMeasured = 256;

/// About kMeasured of the present points, spread over the file.
std::vector<Index> measuredOf(const std::vector<bool>& present) {
    const std::size_t step = std::max<std::size_t>(1, present.size() / kMeasured);
    std::vector<Index> measured;
    for (std::size_t p = 0; p < present.size(); p += step) {
        if (present[p]) measured.push_back(static_cast<Index>(p));
    }
    return measured;
}

std::span<const Index> someNearest(const NeighborLists& nearest, Index p) {
    const std::span<const Index> list = nearest[p];
    return list.first(std::min(list.size(), kOfLine));
}

/// The axis of the points around a place, and how much longer they reach along it than across.
struct LineAt {
    Vec3 axis{0.0};
    double ratio = 1.0;
};
LineAt lineAt(std::span<const Vec3> position, Index p, std::span<const Index> list) {
    const PlaneFit plane = planeAt(position, p, list);
    if (list.empty() || !(plane.variance[2] > 0.0)) return {};
    const Vec3 far = position[list.back()] - position[p];
    return {glm::normalize(far),
            std::sqrt(plane.variance[2] / std::max(plane.variance[1], 1e-4 * plane.variance[2]))};
}

/// Distance from p to the nearest present point that is more across than along the axis.
double distanceAcross(std::span<const Vec3> position, const std::vector<bool>& present, Index p,
                      const Vec3& axis) {
    double nearest = std::numeric_limits<double>::max();
    for (Index q = 0; q < present.size(); ++q) {
        const Vec3 d = position[q] - position[p];
        const double along = std::abs(glm::dot(d, axis));
        if (present[q] && q != p && 2.0 * along * along <= glm::dot(d, d))
            nearest = std::min(nearest, glm::length(d));
    }
    return nearest;
}

}  // namespace

bool lieInLines(std::span<const Vec3> position, const std::vector<bool>& present,
                const NeighborLists& nearest) {
    std::vector<double> ratios;
    for (const Index p : measuredOf(present))
        ratios.push_back(lineAt(position, p, someNearest(nearest, p)).ratio);
    return !ratios.empty() && medianOf(ratios) > kInLines;
}

std::optional<ScanLines> scanLinesOf(std::span<const Vec3> position,
                                     const std::vector<bool>& present,
                                     const NeighborLists& nearest) {
    if (!lieInLines(position, present, nearest)) return std::nullopt;
    std::vector<double> along;
    std::vector<double> across;
    for (const Index p : measuredOf(present)) {
        const std::span<const Index> list = someNearest(nearest, p);
        const double each = distanceAcross(position, present, p, lineAt(position, p, list).axis);
        if (each == std::numeric_limits<double>::max() || list.size() < 2) continue;
        across.push_back(each);
        along.push_back(0.5 * (glm::distance(position[p], position[list.front()]) +
                               glm::distance(position[p], position[list[1]])));
    }
    if (across.empty()) return std::nullopt;
    return ScanLines{medianOf(along), medianOf(across)};
}

}  // namespace se
