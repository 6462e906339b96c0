/// Checks by edges and points. Sides are sorted by edge once for all of them; holes are connected
/// components of the boundary edges, unused points are classified by a grid. O(t log t).
#include <algorithm>
#include <cmath>
#include <map>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/mesh/inspection_checks.h"

namespace se::inspect {
namespace {

/// Calls `see(begin, end)` for the sides of each edge.
template <typename Visit>
void forEachEdge(const InspectedMesh& mesh, Visit&& visit) {
    for (std::size_t i = 0; i < mesh.sides.size();) {
        const std::size_t end = endOfEdge(mesh.sides, i);
        visit(i, end);
        i = end;
    }
}

MeshFailure atEdge(const InspectedMesh& mesh, std::size_t begin, std::size_t end) {
    std::vector<Index> triangles;
    for (std::size_t i = begin; i < end; ++i) triangles.push_back(mesh.sides[i].triangle);
    return mesh.at({mesh.sides[begin].low, mesh.sides[begin].high}, std::move(triangles));
}

/// Triangles at each point: those of p are at[first[p] .. first[p + 1]).
struct Incidence {
    std::vector<std::size_t> first;
    std::vector<Index> at;
};
Incidence incidenceOf(const InspectedMesh& mesh) {
    Incidence result;
    result.first.assign(mesh.points.size() + 1, 0);
    for (const Triangle& t : mesh.triangles) {
        for (const Index p : {t.a, t.b, t.c}) ++result.first[p + 1];
    }
    for (std::size_t p = 0; p < mesh.points.size(); ++p) result.first[p + 1] += result.first[p];
    result.at.resize(3 * mesh.triangles.size());
    std::vector<std::size_t> next = result.first;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        for (const Index p : {t.a, t.b, t.c}) result.at[next[p]++] = static_cast<Index>(i);
    }
    return result;
}

}  // namespace

void nonManifoldEdges(const InspectedMesh& mesh, Failures& failures) {
    forEachEdge(mesh, [&](std::size_t begin, std::size_t end) {
        if (end - begin > 2) failures.push_back(atEdge(mesh, begin, end));
    });
}

void inconsistentEdges(const InspectedMesh& mesh, Failures& failures) {
    forEachEdge(mesh, [&](std::size_t begin, std::size_t end) {
        std::size_t ascending = 0;
        for (std::size_t i = begin; i < end; ++i) ascending += mesh.sides[i].ascending ? 1U : 0U;
        if (ascending > 1 || end - begin - ascending > 1)
            failures.push_back(atEdge(mesh, begin, end));
    });
}

void nonManifoldVertices(const InspectedMesh& mesh, Failures& failures) {
    const Incidence incidence = incidenceOf(mesh);
    for (const Index p : nonManifoldPoints(mesh.triangles, mesh.sides, mesh.points.size())) {
        failures.push_back(mesh.at(
            {p}, {incidence.at.begin() + static_cast<std::ptrdiff_t>(incidence.first[p]),
                  incidence.at.begin() + static_cast<std::ptrdiff_t>(incidence.first[p + 1])}));
    }
}

void holes(const InspectedMesh& mesh, Failures& failures) {
    struct Loop {
        std::vector<Index> points;
        std::vector<Index> triangles;
        std::vector<TriangleSide> steps;
    };
    DisjointSets joined(mesh.points.size());
    std::vector<TriangleSide> border;
    forEachEdge(mesh, [&](std::size_t begin, std::size_t end) {
        if (end - begin != 1) return;
        border.push_back(mesh.sides[begin]);
        joined.unite(border.back().low, border.back().high);
    });
    std::map<Index, Loop> loops;  // by least point
    for (const TriangleSide& side : border) {
        Loop& loop = loops[joined.find(side.low)];
        loop.points.insert(loop.points.end(), {side.low, side.high});
        loop.triangles.push_back(side.triangle);
        loop.steps.push_back(side);
    }
    for (auto& [least, loop] : loops) {
        const bool alongWalls = std::all_of(loop.points.begin(), loop.points.end(), [&](Index p) {
            return isBoundary(mesh.points.type[p]);
        });
        if (alongWalls) continue;
        MeshFailure failure = mesh.at(std::move(loop.points), std::move(loop.triangles));
        Vec3 area(0.0);
        for (const TriangleSide& step : loop.steps) {
            const Vec3 u = mesh.points.position[step.ascending ? step.low : step.high];
            const Vec3 v = mesh.points.position[step.ascending ? step.high : step.low];
            failure.length += std::sqrt(glm::dot(v - u, v - u));
            area += glm::cross(u - failure.place, v - failure.place);
        }
        failure.area = 0.5 * std::sqrt(glm::dot(area, area));
        failures.push_back(std::move(failure));
    }
}

void smallComponents(const InspectedMesh& mesh, Failures& failures) {
    DisjointSets pieces(mesh.points.size());
    for (const Triangle& t : mesh.triangles) {
        pieces.unite(t.a, t.b);
        pieces.unite(t.b, t.c);
    }
    std::map<Index, std::vector<Index>> triangles;  // by least point
    std::size_t largest = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        std::vector<Index>& piece = triangles[pieces.find(mesh.triangles[i].a)];
        piece.push_back(static_cast<Index>(i));
        largest = std::max(largest, piece.size());
    }
    for (auto& [least, piece] : triangles) {
        if (piece.size() >= kSmallComponent || 100 * piece.size() >= largest) continue;
        std::vector<Index> points;
        for (const Index i : piece) {
            const Triangle& t = mesh.triangles[i];
            points.insert(points.end(), {t.a, t.b, t.c});
        }
        failures.push_back(mesh.at(std::move(points), std::move(piece)));
    }
}

namespace {

/// Calls `see(p, isolated)` for the points in no triangle that have a finite position.
template <typename Visit>
void forEachUnused(const InspectedMesh& mesh, Visit&& visit) {
    const auto finite = [&](std::size_t p) {
        const Vec3& x = mesh.points.position[p];
        return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
    };
    const double reach = kIsolated * mesh.meanEdge;
    Vec3 low(0.0);
    Vec3 high(0.0);
    bool any = false;
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
        if (!mesh.used[p]) continue;
        low = any ? glm::min(low, mesh.points.position[p]) : mesh.points.position[p];
        high = any ? glm::max(high, mesh.points.position[p]) : mesh.points.position[p];
        any = true;
    }
    if (!any || !(reach > 0.0)) {
        for (std::size_t p = 0; p < mesh.points.size(); ++p) {
            if (!mesh.used[p] && finite(p)) visit(static_cast<Index>(p), true);
        }
        return;
    }
    CellGrid grid(low, high, reach);
    std::vector<Index> numbers;
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
        if (!mesh.used[p]) continue;
        grid.add(mesh.points.position[p]);
        numbers.push_back(static_cast<Index>(p));
    }
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
        if (mesh.used[p] || !finite(p)) continue;
        bool isolated = true;
        grid.near(mesh.points.position[p], [&](Index i) {
            const Vec3 d = mesh.points.position[numbers[i]] - mesh.points.position[p];
            if (glm::dot(d, d) <= reach * reach) isolated = false;
        });
        visit(static_cast<Index>(p), isolated);
    }
}

}  // namespace

void unusedPoints(const InspectedMesh& mesh, Failures& failures) {
    forEachUnused(mesh, [&](Index p, bool isolated) {
        if (!isolated) failures.push_back(mesh.at({p}, {}));
    });
}

void isolatedPoints(const InspectedMesh& mesh, Failures& failures) {
    forEachUnused(mesh, [&](Index p, bool isolated) {
        if (isolated) failures.push_back(mesh.at({p}, {}));
    });
}

}  // namespace se::inspect
