/// Nearest triangles by a hierarchy of boxes over the triangles in the order of a Z-curve: eight
/// consecutive ones share a box, eight boxes the next one, and so on. The nearest box is searched
/// first, and one that is farther away than the best triangle so far is skipped.
#include "spiraling_edge/mesh/fidelity.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/geometry/z_curve.h"
#include "spiraling_edge/mesh/moderate_size.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {
namespace {

/// Entries under one box.
constexpr std::size_t kFanOut = 8;

double squaredDistance(const Box& box, const Vec3& x) {
    const Vec3 d = glm::max(glm::max(box.low - x, x - box.high), Vec3(0.0));
    return glm::dot(d, d);
}

class TriangleTree {
  public:
    TriangleTree(const PointSet& points, std::span<const Triangle> triangles) : points_(points) {
        std::vector<Vec3> centers;
        centers.reserve(triangles.size());
        for (const Triangle& t : triangles) {
            const Box box = boxOf(points, t);
            centers.push_back(0.5 * (box.low + box.high));
        }
        ordered_.reserve(triangles.size());
        for (const Index i : zCurveOrder(centers)) ordered_.push_back(triangles[i]);
        levels_.push_back(
            boxesOver(ordered_.size(), [&](std::size_t i) { return boxOf(points, ordered_[i]); }));
        while (levels_.back().size() > 1) {
            const std::vector<Box>& below = levels_.back();
            levels_.push_back(boxesOver(below.size(), [&](std::size_t i) { return below[i]; }));
        }
    }

    /// Distance from `x` to the nearest triangle. Requires one.
    double distance(const Vec3& x) const {
        assert(!levels_.empty());
        double best = std::numeric_limits<double>::max();
        visit(levels_.size() - 1, 0, x, best);
        return std::sqrt(best);
    }

  private:
    /// The boxes of a level, each around kFanOut of the `count` boxes below.
    template <typename BoxBelow>
    static std::vector<Box> boxesOver(std::size_t count, const BoxBelow& boxBelow) {
        std::vector<Box> boxes;
        boxes.reserve((count + kFanOut - 1) / kFanOut);
        for (std::size_t i = 0; i < count; ++i) {
            const Box box = boxBelow(i);
            if (i % kFanOut == 0) boxes.push_back(box);
            boxes.back().add(box.low);
            boxes.back().add(box.high);
        }
        return boxes;
    }

    /// Lowers `best`, a squared distance, to the nearest triangle under a box.
    void visit(std::size_t level, std::size_t box, const Vec3& x, double& best) const {
        if (squaredDistance(levels_[level][box], x) >= best) return;
        const std::size_t below = level == 0 ? ordered_.size() : levels_[level - 1].size();
        const std::size_t end = std::min((box + 1) * kFanOut, below);
        if (level > 0) {
            std::array<std::pair<double, std::size_t>, kFanOut> nearest;
            std::size_t count = 0;
            for (std::size_t i = box * kFanOut; i < end; ++i)
                nearest[count++] = {squaredDistance(levels_[level - 1][i], x), i};
            std::sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count));
            for (std::size_t k = 0; k < count; ++k) visit(level - 1, nearest[k].second, x, best);
            return;
        }
        for (std::size_t i = box * kFanOut; i < end; ++i) {
            const Triangle& t = ordered_[i];
            const Vec3 d = x - nearestPoint(x, points_.position[t.a], points_.position[t.b],
                                            points_.position[t.c]);
            best = std::min(best, glm::dot(d, d));
        }
    }

    const PointSet& points_;
    std::vector<Triangle> ordered_;
    std::vector<std::vector<Box>> levels_;  ///< Boxes of kFanOut entries of the level below.
};

}  // namespace

std::vector<double> distancesFromMesh(const PointSet& points, std::span<const Triangle> triangles) {
    assert(cornersBelow(triangles, points.size()) && haveFinitePositions(points, triangles));
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> distances(points.size(), kUnknown);
    if (triangles.empty()) return distances;
    const ModerateSize size(points, triangles);
    std::optional<TriangleTree> tree;
    const std::vector<bool> used = usedPoints(points.size(), triangles);
    for (std::size_t p = 0; p < points.size(); ++p) {
        const bool missing = points.asideOf(static_cast<Index>(p)) == Aside::Sentinel;
        if (missing || !isFinite(points.position[p])) continue;
        if (!used[p] && !tree) tree.emplace(size.points(), triangles);
        distances[p] = used[p] ? 0.0 : size.length(tree->distance(size.points().position[p]));
    }
    return distances;
}

Fidelity fidelityFrom(std::span<const double> distances) {
    Fidelity fidelity;
    std::size_t count = 0;
    double sum = 0.0;
    for (const double distance : distances) {
        if (std::isnan(distance)) continue;
        ++count;
        fidelity.greatestDistance = std::max(fidelity.greatestDistance, distance);
        sum += distance;
    }
    if (count > 0) fidelity.meanDistance = sum / static_cast<double>(count);
    return fidelity;
}

Fidelity fidelityOf(const PointSet& points, std::span<const Triangle> triangles) {
    return fidelityFrom(distancesFromMesh(points, triangles));
}

}  // namespace se
