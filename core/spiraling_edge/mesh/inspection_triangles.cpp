#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/inspection_checks.h"

namespace se {

InspectedMesh::InspectedMesh(const PointSet& input, std::span<const Triangle> mesh)
    : triangles(mesh), sides(sortedSides(mesh)), used(input.size(), false) {
    points.position = input.position;
    points.normal = input.normal;
    points.type = input.type;
    points.normal.resize(input.size(), Vec3(0.0));
    points.type.resize(input.size(), kInterior);
    FaultSearch search = searchFaults(points, mesh);
    faults = std::move(search.faults);
    allFaults = search.complete;
    faultWork = search.work;
    for (const Triangle& t : mesh) used[t.a] = used[t.b] = used[t.c] = true;
    double sum = 0.0;
    for (const TriangleSide& side : sides) {
        const Vec3 d = points.position[side.high] - points.position[side.low];
        sum += std::sqrt(glm::dot(d, d));
    }
    if (!sides.empty()) meanEdge = sum / static_cast<double>(sides.size());
}

MeshFailure InspectedMesh::at(std::vector<Index> itsPoints, std::vector<Index> itsTriangles) const {
    MeshFailure failure;
    const auto inOrder = [](std::vector<Index>& list) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    };
    inOrder(itsPoints);
    inOrder(itsTriangles);
    for (const Index p : itsPoints) failure.place += points.position[p];
    failure.place /= static_cast<double>(std::max<std::size_t>(itsPoints.size(), 1));
    failure.points = std::move(itsPoints);
    failure.triangles = std::move(itsTriangles);
    return failure;
}

namespace inspect {
namespace {

std::vector<Index> cornersOf(const InspectedMesh& mesh, std::initializer_list<Index> triangles) {
    std::vector<Index> points;
    for (const Index i : triangles) {
        if (i == kNone) continue;
        const Triangle& t = mesh.triangles[i];
        points.insert(points.end(), {t.a, t.b, t.c});
    }
    return points;
}

/// Appends the first `limit` faults of one kind as failures.
void ofKind(FaultKind kind, const InspectedMesh& mesh, Failures& failures,
            std::size_t limit = std::numeric_limits<std::size_t>::max()) {
    std::size_t listed = 0;
    for (const Fault& fault : mesh.faults) {
        if (fault.kind != kind) continue;
        if (listed++ == limit) return;
        std::vector<Index> triangles{fault.triangle};
        if (fault.other != kNone) triangles.push_back(fault.other);
        failures.push_back(
            mesh.at(cornersOf(mesh, {fault.triangle, fault.other}), std::move(triangles)));
    }
}

}  // namespace

void degenerate(const InspectedMesh& mesh, Failures& failures) {
    ofKind(FaultKind::Degenerate, mesh, failures);
}
void intersecting(const InspectedMesh& mesh, Failures& failures) {
    ofKind(FaultKind::Intersecting, mesh, failures, kMaxListed);
}
void folded(const InspectedMesh& mesh, Failures& failures) {
    ofKind(FaultKind::Folded, mesh, failures);
}
void flipped(const InspectedMesh& mesh, Failures& failures) {
    ofKind(FaultKind::Flipped, mesh, failures);
}

void duplicates(const InspectedMesh& mesh, Failures& failures) {
    struct Corners {
        std::array<Index, 3> points;
        Index triangle;
    };
    std::vector<Corners> all;
    all.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        Corners corners{{t.a, t.b, t.c}, static_cast<Index>(i)};
        std::sort(corners.points.begin(), corners.points.end());
        all.push_back(corners);
    }
    std::sort(all.begin(), all.end(), [](const Corners& x, const Corners& y) {
        return std::tie(x.points, x.triangle) < std::tie(y.points, y.triangle);
    });
    for (std::size_t i = 0; i < all.size();) {
        std::size_t end = i + 1;
        std::vector<Index> same{all[i].triangle};
        for (; end < all.size() && all[end].points == all[i].points; ++end)
            same.push_back(all[end].triangle);
        if (same.size() > 1) {
            failures.push_back(
                mesh.at({all[i].points.begin(), all[i].points.end()}, std::move(same)));
        }
        i = end;
    }
}

void slivers(const InspectedMesh& mesh, Failures& failures) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (isDegenerate(mesh.points, t) || leastAngleCosine(mesh.points, t) <= kSliverCosine)
            continue;
        const auto triangle = static_cast<Index>(i);
        failures.push_back(mesh.at(cornersOf(mesh, {triangle}), {triangle}));
    }
}

}  // namespace inspect
}  // namespace se
