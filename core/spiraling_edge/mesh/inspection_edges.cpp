/// Checks by edges and points. Sides are sorted by edge once for all of them; small components and
/// lost points are compared with the points near them by a grid. O(t log t).
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/mesh/inspection_checks.h"
#include "spiraling_edge/points/wall_types.h"

namespace se::inspect {
namespace {

MeshFailure atEdge(const InspectedMesh& mesh, std::span<const TriangleSide> edge) {
    std::vector<Index> triangles;
    for (const TriangleSide& side : edge) triangles.push_back(side.triangle);
    return mesh.at({edge[0].low, edge[0].high}, std::move(triangles));
}

/// The points in triangles, in a grid.
class UsedPoints {
  public:
    UsedPoints(const InspectedMesh& mesh, double reach) : mesh_(mesh), reach_(reach) {
        std::vector<Vec3> position;
        for (Index p = 0; p < mesh.points.size(); ++p) {
            if (!mesh.topology.used[p]) continue;
            points_.push_back(p);
            position.push_back(mesh.points.position[p]);
        }
        if (position.empty() || !(reach > 0.0)) return;
        const WallBox box = boxAround(position);
        grid_.emplace(box.low, box.high, reach);
        for (const Vec3& x : position) grid_->add(x);
    }
    /// True if one of those within reach of `x` passes a test.
    template <typename Test>
    bool anyNear(const Vec3& x, Test&& test) const {
        bool found = false;
        if (grid_) {
            grid_->near(x, [&](Index i) {
                const Vec3 d = mesh_.points.position[points_[i]] - x;
                found = found || (glm::dot(d, d) <= reach_ * reach_ && test(points_[i]));
            });
        }
        return found;
    }

  private:
    const InspectedMesh& mesh_;
    double reach_;
    std::vector<Index> points_;
    std::optional<CellGrid> grid_;
};

/// Finds the lost points near a used one, or the isolated ones.
void findUnused(const InspectedMesh& mesh, bool isolatedOnes, Failures& failures) {
    if (mesh.lostPoints.empty()) return;
    const UsedPoints used(mesh, kIsolated * mesh.meanEdge);
    for (const Index p : mesh.lostPoints) {
        const bool near = used.anyNear(mesh.points.position[p], [](Index) { return true; });
        if (near != isolatedOnes) failures.push_back(mesh.at({p}, {}));
    }
}

}  // namespace

void nonManifoldEdges(const InspectedMesh& mesh, Failures& failures) {
    for (const std::span<const TriangleSide> edge : mesh.topology.irregularEdges) {
        if (edge.size() > 2) failures.push_back(atEdge(mesh, edge));
    }
}

void inconsistentEdges(const InspectedMesh& mesh, Failures& failures) {
    for (const std::span<const TriangleSide> edge : mesh.topology.irregularEdges) {
        if (isInconsistent(edge)) failures.push_back(atEdge(mesh, edge));
    }
}

void nonManifoldVertices(const InspectedMesh& mesh, Failures& failures) {
    std::map<Index, std::vector<Index>> trianglesAt;
    for (const Index p : mesh.topology.nonManifoldPoints) trianglesAt[p] = {};
    for (std::size_t i = 0; i < mesh.triangles.size() && !trianglesAt.empty(); ++i) {
        const Triangle& t = mesh.triangles[i];
        for (const Index p : {t.a, t.b, t.c}) {
            const auto found = trianglesAt.find(p);
            if (found != trianglesAt.end()) found->second.push_back(static_cast<Index>(i));
        }
    }
    for (auto& [p, triangles] : trianglesAt) failures.push_back(mesh.at({p}, std::move(triangles)));
}

void smallComponents(const InspectedMesh& mesh, Failures& failures) {
    std::map<Index, std::vector<Index>> small;  // triangles by least point
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Index component = mesh.topology.component[mesh.triangles[i].a];
        if (mesh.componentTriangles[component] < kSmallComponent)
            small[component].push_back(static_cast<Index>(i));
    }
    if (small.empty() || !(mesh.meanEdge > 0.0)) return;
    const UsedPoints used(mesh, kNearComponent * mesh.meanEdge);
    for (auto& [component, triangles] : small) {
        std::vector<Index> points;
        for (const Index i : triangles) {
            const Triangle& t = mesh.triangles[i];
            points.insert(points.end(), {t.a, t.b, t.c});
        }
        const std::size_t size = triangles.size();
        const bool beside = std::any_of(points.begin(), points.end(), [&](Index p) {
            return used.anyNear(mesh.points.position[p],
                                [&](Index q) { return mesh.trianglesAround(q) > size; });
        });
        if (beside) failures.push_back(mesh.at(std::move(points), std::move(triangles)));
    }
}

void unusedPoints(const InspectedMesh& mesh, Failures& failures) {
    findUnused(mesh, false, failures);
}

void isolatedPoints(const InspectedMesh& mesh, Failures& failures) {
    findUnused(mesh, true, failures);
}

}  // namespace se::inspect
