#include "spiraling_edge/mesh/inspection.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/inspection_checks.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {

InspectedMesh::InspectedMesh(const PointSet& input, std::span<const Triangle> mesh)
    : triangles(mesh), sides(sortedSides(mesh)), used(usedPoints(input.size(), mesh)) {
    points.position = input.position;
    points.normal = input.normal;
    points.type = input.type;
    points.normal.resize(input.size(), Vec3(0.0));
    points.type.resize(input.size(), kInterior);
    FaultSearch search = searchFaults(points, mesh);
    faults = std::move(search.faults);
    allFaults = search.complete;
    faultWork = search.work;
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

namespace {

// ---- checks of triangles ------------------------------------------------------------------------

std::vector<Index> cornersOf(const InspectedMesh& mesh, std::initializer_list<Index> triangles) {
    std::vector<Index> points;
    for (const Index i : triangles) {
        if (i == kNone) continue;
        const Triangle& t = mesh.triangles[i];
        points.insert(points.end(), {t.a, t.b, t.c});
    }
    return points;
}

/// Appends the faults of a kind as failures; of intersections the first ones.
template <FaultKind kind>
void ofKind(const InspectedMesh& mesh, std::vector<MeshFailure>& failures) {
    constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
    std::size_t left = kind == FaultKind::Intersecting ? kMaxListed : kNoLimit;
    for (const Fault& fault : mesh.faults) {
        if (fault.kind != kind) continue;
        if (left-- == 0) return;
        std::vector<Index> triangles{fault.triangle};
        if (fault.other != kNone) triangles.push_back(fault.other);
        failures.push_back(
            mesh.at(cornersOf(mesh, {fault.triangle, fault.other}), std::move(triangles)));
    }
}

void duplicates(const InspectedMesh& mesh, std::vector<MeshFailure>& failures) {
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

void slivers(const InspectedMesh& mesh, std::vector<MeshFailure>& failures) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (isDegenerate(mesh.points, t) || leastAngleCosine(mesh.points, t) <= kSliverCosine)
            continue;
        const auto triangle = static_cast<Index>(i);
        failures.push_back(mesh.at(cornersOf(mesh, {triangle}), {triangle}));
    }
}

// ---- the table ----------------------------------------------------------------------------------

constexpr FailureClass kClasses[] = {
    {"non_manifold_edges", "Three or more triangles meet at an edge.", inspect::nonManifoldEdges},
    {"non_manifold_vertices", "The triangles about a point are more than one fan.",
     inspect::nonManifoldVertices},
    {"inconsistent_edges",
     "Two triangles pass an edge in the same direction: one of them is inside out.",
     inspect::inconsistentEdges},
    {"duplicate_triangles", "Two triangles have the same three points.", duplicates},
    {"degenerate_triangles", "A triangle has a corner twice, or no area.",
     ofKind<FaultKind::Degenerate>},
    {"intersecting_triangles", "Two triangles share more than their common corners.",
     ofKind<FaultKind::Intersecting>},
    {"folded_edges", "Two triangles at an edge lie nearly on one another.",
     ofKind<FaultKind::Folded>},
    {"flipped_triangles", "A triangle faces away from the normals of its points.",
     ofKind<FaultKind::Flipped>},
    {"slivers", "A triangle has an angle below one degree.", slivers},
    {"holes", "A boundary loop that does not run along the walls.", inspect::holes},
    {"small_components", "A piece of a few triangles that hangs on nothing.",
     inspect::smallComponents},
    {"unused_points", "A point is in no triangle, though the surface passes by.",
     inspect::unusedPoints},
    {"isolated_points", "A point is in no triangle, and far from all.", inspect::isolatedPoints},
    {"leftover_rings", "A ring was given up with points that the surface goes on at (runs only).",
     nullptr},
    {"triangle_cap", "The run was stopped: far too many triangles (runs only).", nullptr},
};

/// "1, 2, 3"; long lists end in "... (70)".
std::string list(const std::vector<Index>& numbers) {
    constexpr std::size_t kShown = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(kShown, numbers.size()); ++i)
        text += (text.empty() ? "" : ", ") + std::to_string(numbers[i]);
    if (numbers.size() > kShown) text += ", ... (" + std::to_string(numbers.size()) + ")";
    return text;
}

}  // namespace

std::span<const FailureClass> failureClasses() { return kClasses; }

const FailureClass* findFailureClass(std::string_view name) {
    const auto found = std::find_if(std::begin(kClasses), std::end(kClasses),
                                    [&](const FailureClass& c) { return c.name == name; });
    return found == std::end(kClasses) ? nullptr : found;
}

std::string describe(const MeshFailure& failure) {
    std::string text(failure.kind->name);
    text += failure.points.size() == 1 ? ": point " : ": points ";
    text += list(failure.points);
    if (!failure.triangles.empty()) {
        text += failure.triangles.size() == 1 ? "; triangle " : "; triangles ";
        text += list(failure.triangles);
    }
    if (failure.length > 0.0)
        text += "; length " + sixDigits(failure.length) + ", area " + sixDigits(failure.area);
    return text + "; at (" + sixDigits(failure.place.x) + ", " + sixDigits(failure.place.y) + ", " +
           sixDigits(failure.place.z) + ")";
}

std::string amountText(const ClassTotal& total) {
    const std::string known = std::to_string(total.total);
    if (total.all()) return known;
    const std::string first =
        total.listed < total.total ? "first " + std::to_string(total.listed) + " of " : "";
    return first + (total.exact ? "" : "at least ") + known;
}

bool isComplete(std::span<const ClassTotal> totals) {
    return std::all_of(totals.begin(), totals.end(),
                       [](const ClassTotal& each) { return each.all(); });
}

MeshInspection inspectWithTotals(const PointSet& points, std::span<const Triangle> triangles) {
    assert(cornersBelow(triangles, points.size()));
    const InspectedMesh mesh(points, triangles);
    MeshInspection found;
    std::vector<MeshFailure>& all = found.failures;
    for (const FailureClass& each : kClasses) {
        const std::size_t begin = all.size();
        if (each.find != nullptr) each.find(mesh, all);
        for (std::size_t i = begin; i < all.size(); ++i) all[i].kind = &each;
        ClassTotal total{all.size() - begin, all.size() - begin, true};
        if (each.find == ofKind<FaultKind::Intersecting>) {
            total.total = countFaults(mesh.faults)[std::size_t(FaultKind::Intersecting)];
            total.exact = mesh.allFaults;
        }
        found.totals.push_back(total);
    }
    found.work = mesh.faultWork;
    return found;
}

std::vector<MeshFailure> inspectMesh(const PointSet& points, std::span<const Triangle> triangles) {
    return inspectWithTotals(points, triangles).failures;
}

}  // namespace se
