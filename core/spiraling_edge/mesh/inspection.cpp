#include "spiraling_edge/mesh/inspection.h"

#include <algorithm>
#include <cassert>
#include <cstdio>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/mesh/inspection_checks.h"

namespace se {
namespace {

constexpr FailureClass kClasses[] = {
    {"non_manifold_edges", "Three or more triangles meet at an edge.", inspect::nonManifoldEdges},
    {"non_manifold_vertices", "The triangles about a point are more than one fan.",
     inspect::nonManifoldVertices},
    {"inconsistent_edges",
     "Two triangles pass an edge in the same direction: one of them is inside out.",
     inspect::inconsistentEdges},
    {"duplicate_triangles", "Two triangles have the same three points.", inspect::duplicates},
    {"degenerate_triangles", "A triangle has a corner twice, or no area.", inspect::degenerate},
    {"intersecting_triangles", "Two triangles share more than their common corners.",
     inspect::intersecting},
    {"folded_edges", "Two triangles at an edge lie nearly on one another.", inspect::folded},
    {"flipped_triangles", "A triangle faces away from the normals of its points.",
     inspect::flipped},
    {"slivers", "A triangle has an angle below one degree.", inspect::slivers},
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
        if (each.find == inspect::intersecting) {
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
