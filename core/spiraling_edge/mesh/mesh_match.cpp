// Finds the vertices of a mesh from a file among the points, in a grid with about one point per
// cell: about O(1) per vertex.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "spiraling_edge/base/finite.h"
#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/mesh/mesh_compare.h"

namespace se {
namespace {

/// Points by position, to find one within a small distance.
class PointFinder {
  public:
    explicit PointFinder(std::span<const Vec3> points) : points_(points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!isFinite(points[i])) continue;
            known_.push_back(static_cast<Index>(i));
            if (box_) {
                box_->add(points[i]);
            } else {
                box_.emplace(points[i]);
            }
        }
        if (!box_) return;
        const double diagonal = glm::length(box_->high - box_->low);
        tolerance_ = kSamePointTolerance * diagonal;
        // Cells of about one point each; the tolerance is far smaller.
        const double cell = diagonal / std::max(2.0, std::sqrt(static_cast<double>(known_.size())));
        grid_.emplace(box_->low, box_->high, cell > 0.0 ? cell : 1.0);
        for (const Index p : known_) grid_->add(points[p]);
    }
    bool isAt(Index point, const Vec3& x) const {
        return point < points_.size() && glm::length(points_[point] - x) <= tolerance_;
    }
    /// kNone if no point is that near.
    Index at(const Vec3& x) const {
        Index best = kNone;
        if (!grid_ || !isFinite(x)) return best;
        double least = tolerance_;
        grid_->near(x, [&](Index number) {
            const Index p = known_[number];
            const double distance = glm::length(points_[p] - x);
            if (!(distance <= tolerance_)) return;
            if (best != kNone && (distance > least || (distance == least && p > best))) return;
            best = p;
            least = distance;
        });
        return best;
    }

  private:
    std::span<const Vec3> points_;
    std::vector<Index> known_;  ///< Points with a finite position, as the grid numbers them.
    std::optional<Box> box_;
    std::optional<CellGrid> grid_;
    double tolerance_ = 0.0;
};

}  // namespace

MatchedMesh matchMesh(std::span<const Vec3> points, const PointFile& mesh) {
    assert(cornersBelow(mesh.faces, mesh.position.size()));
    const PointFinder finder(points);
    const bool sameCount = points.size() == mesh.position.size();
    std::vector<bool> used(mesh.position.size(), false);
    for (const Triangle& t : mesh.faces) used[t.a] = used[t.b] = used[t.c] = true;
    MatchedMesh matched;
    std::vector<Index> pointOf(mesh.position.size(), kNone);
    for (Index v = 0; v < mesh.position.size(); ++v) {
        if (!used[v]) continue;
        const Vec3& x = mesh.position[v];
        pointOf[v] = sameCount && finder.isAt(v, x) ? v : finder.at(x);
        if (pointOf[v] != kNone) continue;
        pointOf[v] = static_cast<Index>(points.size() + matched.unmatchedVertices.size());
        matched.unmatchedVertices.push_back(x);
        matched.unmatchedNumbers.push_back(v);
    }
    matched.triangles.reserve(mesh.faces.size());
    for (const Triangle& t : mesh.faces)
        matched.triangles.push_back({pointOf[t.a], pointOf[t.b], pointOf[t.c]});
    return matched;
}

}  // namespace se
