#include "spiraling_edge/mesh/inspection.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/inspection_checks.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {
namespace {

/// A copy of points that lack normals or types, with zeros there; nothing if they have both.
std::optional<PointSet> withNormalsAndTypes(const PointSet& input) {
    const std::size_t n = input.size();
    if (input.normal.size() == n && input.type.size() == n) return {};
    PointSet points;
    points.position = input.position;
    points.normal = input.normal;
    points.type = input.type;
    points.normal.resize(n, Vec3(0.0));
    points.type.resize(n, kInterior);
    return points;
}

/// InspectedMesh::lostPoints. Copies of points are looked for only where some point is in no
/// triangle.
std::vector<Index> findLostPoints(const InspectedMesh& mesh, const PointSet& input) {
    std::vector<Index> lost;
    for (Index p = 0; p < input.size(); ++p) {
        if (!mesh.topology.used[p]) lost.push_back(p);
    }
    if (lost.empty()) return lost;
    const std::vector<Fitness> fitness = fitnessOf(input.position);
    const auto isAside = [&](Index p) { return p < input.setAside.size() && input.setAside[p]; };
    const auto isPlaneless = [&](Index p) {
        return !input.normal.empty() && !hasDirection(input.normal[p]);
    };
    std::erase_if(lost, [&](Index p) {
        return isAside(p) || isPlaneless(p) || fitness[p] != Fitness::Usable;
    });
    return lost;
}

/// Removes points whose twin is in a triangle from the points in no triangle, and counts them.
std::size_t dropTwins(const InspectedMesh& mesh, std::vector<Index>& lost) {
    if (mesh.judge == nullptr) return 0;
    return std::erase_if(lost, [&](Index p) {
        const Index twin = mesh.judge->twinOf(p);
        return twin != kNone && mesh.topology.used[twin];
    });
}

/// The points by which a mesh of `input` is judged.
const PointSet& judgeOf(const PointSet& input) { return input.judge ? input.judge->points : input; }

double meanLength(const PointSet& points, std::span<const TriangleSide> sides) {
    double sum = 0.0;
    for (const TriangleSide& side : sides) {
        const Vec3 d = points.position[side.high] - points.position[side.low];
        sum += std::sqrt(glm::dot(d, d));
    }
    return sides.empty() ? 0.0 : sum / static_cast<double>(sides.size());
}

}  // namespace

InspectedMesh::InspectedMesh(const PointSet& input, std::span<const Triangle> mesh)
    : judge(input.judge.get()),
      filled(withNormalsAndTypes(judgeOf(input))),
      points(filled ? *filled : judgeOf(input)),
      triangles(mesh),
      topology(input.size(), mesh),
      componentTriangles(input.size(), 0) {
    runTasks(
        threadsFor(mesh), [&] { meanEdge = meanLength(points, topology.sides); },
        [&] {
            for (const Triangle& t : triangles) ++componentTriangles[topology.component[t.a]];
            loops = inspect::boundaryLoops(*this);
        },
        [&] {
            lostPoints = findLostPoints(*this, judgeOf(input));
            twins = dropTwins(*this, lostPoints);
        });
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

constexpr bool isOfPairs(FaultKind kind) {
    return kind == FaultKind::Intersecting || kind == FaultKind::SecondLayer;
}

/// Appends the faults of a kind as failures: of pairs, which may be millions, the first ones.
template <FaultKind kind>
void ofKind(const InspectedMesh& mesh, std::vector<MeshFailure>& failures) {
    constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
    std::size_t left = isOfPairs(kind) ? kMaxListed : kNoLimit;
    for (const Fault& fault : mesh.search.faults) {
        if (fault.kind != kind) continue;
        if (left-- == 0) return;
        std::vector<Index> triangles{fault.triangle};
        if (fault.other != kNone) triangles.push_back(fault.other);
        failures.push_back(
            mesh.at(cornersOf(mesh, {fault.triangle, fault.other}), std::move(triangles)));
    }
}

/// The corner of a triangle that is not on this side; the same point again if there is none.
Index cornerOpposite(const Triangle& t, const TriangleSide& side) {
    return t.a ^ t.b ^ t.c ^ side.low ^ side.high;
}

/// Triangles of the same points share all sides: those at the side of their two lowest points.
void duplicates(const InspectedMesh& mesh, std::vector<MeshFailure>& failures) {
    std::vector<std::pair<Index, Index>> at;  // highest corner and triangle
    forEachEdge(mesh.topology.sides, [&](std::span<const TriangleSide> edge) {
        if (edge.size() < 2) return;
        at.clear();
        for (const TriangleSide& side : edge) {
            const Index highest = cornerOpposite(mesh.triangles[side.triangle], side);
            if (highest >= side.high) at.emplace_back(highest, side.triangle);
        }
        std::sort(at.begin(), at.end());
        at.erase(std::unique(at.begin(), at.end()), at.end());
        for (std::size_t i = 0; i < at.size();) {
            std::vector<Index> same;
            const Index highest = at[i].first;
            for (; i < at.size() && at[i].first == highest; ++i) same.push_back(at[i].second);
            if (same.size() > 1)
                failures.push_back(mesh.at({edge[0].low, edge[0].high, highest}, std::move(same)));
        }
    });
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
    {"non_manifold_edges", "non-manifold edge", "Three or more triangles meet at an edge.", true, 5,
     inspect::nonManifoldEdges},
    {"non_manifold_vertices", "non-manifold vertex",
     "The triangles about a point are more than one fan.", true, 6, inspect::nonManifoldVertices},
    {"inconsistent_edges", "inconsistent edge",
     "Two triangles pass an edge in the same direction: one of them is inside out.", true, 7,
     inspect::inconsistentEdges},
    {"duplicate_triangles", "duplicate triangle", "Two triangles have the same three points.", true,
     9, duplicates},
    {"degenerate_triangles", "degenerate triangle",
     "A triangle has a corner twice, or a height of at most a millionth of its longest edge.", true,
     13, ofKind<FaultKind::Degenerate>},
    {"intersecting_triangles", "intersecting pair",
     "Two triangles share more than their common corners.", true, 10,
     ofKind<FaultKind::Intersecting>},
    {"folded_edges", "folded edge", "Two triangles at an edge lie nearly on one another.", true, 11,
     ofKind<FaultKind::Folded>},
    {"second_layers", "second layer", "A triangle lies over another one that faces the same way.",
     true, 8, ofKind<FaultKind::SecondLayer>},
    {"flipped_triangles", "flipped triangle",
     "A triangle faces away from the normals of its points.", true, 12, ofKind<FaultKind::Flipped>},
    {"holes", "hole", "A boundary loop in the middle of the surface.", true, 2, inspect::holes},
    {"small_components", "small component", "A piece of a few triangles beside a larger one.", true,
     4, inspect::smallComponents},
    {"lost_points", "lost point", "A point is in no triangle, though the surface passes by.", true,
     3, inspect::unusedPoints},
    {"isolated_points", "isolated point", "A point is in no triangle, and far from all.", true, 3,
     inspect::isolatedPoints},
    {"inward_pieces", "inward piece", "A closed piece of the surface faces inward.", true, 2,
     inspect::inwardPieces},
    {"spikes", "spike",
     "A triangle reaches far beyond the spacing of its points, and closes no hole.", true, 4,
     inspect::spikes},
    {"openings", "opening", "A boundary loop where the surface ends: no fault.", false, 14,
     inspect::openings},
    {"slivers", "sliver", "A triangle has an angle below one degree: no fault.", false, 16,
     slivers},
    {"leftover_rings", "leftover ring",
     "A ring was given up with points that the surface goes on at (runs only).", false, 15,
     nullptr},
    {"triangle_cap", "triangle cap", "The run was stopped: far too many triangles (runs only).",
     true, 1, nullptr},
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
    // Sessions, lessons and queries of version 0.2 name it so.
    if (name == "unused_points") name = "lost_points";
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

std::string nounFor(const FailureClass& kind, std::size_t count) {
    std::string noun(kind.singular);
    constexpr std::string_view kVertex = "vertex";
    if (count != 1) {
        if (noun.ends_with(kVertex))
            noun.replace(noun.size() - kVertex.size(), kVertex.size(), "vertice");
        noun += "s";
    }
    return noun;
}

std::string amountText(const ClassTotal& total) {
    const std::string known = std::to_string(total.total);
    if (total.all()) return known;
    const std::string first = total.listed > 0 && total.listed < total.total
                                  ? "first " + std::to_string(total.listed) + " of "
                                  : "";
    return first + (total.exact ? "" : "at least ") + known;
}

bool isComplete(std::span<const ClassTotal> totals) {
    return std::all_of(totals.begin(), totals.end(),
                       [](const ClassTotal& each) { return each.all(); });
}

std::size_t faultCount(std::span<const ClassTotal> totals) {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < totals.size(); ++i) sum += kClasses[i].fault ? totals[i].total : 0;
    return sum;
}

bool isExact(std::span<const ClassTotal> totals) {
    return std::all_of(totals.begin(), totals.end(), [](const ClassTotal& t) { return t.exact; });
}

bool isSound(std::span<const ClassTotal> totals, std::size_t triangles) {
    return triangles > 0 && faultCount(totals) == 0 && isExact(totals);
}

bool isLoop(const MeshFailure& failure) {
    return failure.kind->find == inspect::holes || failure.kind->find == inspect::openings;
}

double widthOf(const MeshFailure& loop) {
    assert(isLoop(loop));
    return LoopShape{static_cast<Index>(loop.edges.size()), loop.length, loop.area}.width();
}

namespace {

/// The kind of pairs that a class is of, if any.
std::optional<FaultKind> pairsOf(const FailureClass& each) {
    if (each.find == ofKind<FaultKind::Intersecting>) return FaultKind::Intersecting;
    if (each.find == ofKind<FaultKind::SecondLayer>) return FaultKind::SecondLayer;
    return {};
}

/// Counts the mesh; the search has the triangles without a good shape already.
MeshReport reportOf(const InspectedMesh& mesh, std::span<const std::size_t> counts) {
    MeshReport report = reportTopology(mesh.points, mesh.triangles, mesh.topology);
    report.degenerateTriangles = counts[static_cast<std::size_t>(FaultKind::Degenerate)];
    report.flippedTriangles = counts[static_cast<std::size_t>(FaultKind::Flipped)];
    return report;
}

MeshInspection inspected(const InspectedMesh& mesh) {
    const auto counts = countFaults(mesh.search.faults);
    MeshInspection found;
    std::array<std::vector<MeshFailure>, std::size(kClasses)> failures;
    forEachTask(std::size(kClasses), threadsFor(mesh.triangles), [&](std::size_t i) {
        if (kClasses[i].find != nullptr) kClasses[i].find(mesh, failures[i]);
    });
    for (std::size_t i = 0; i < std::size(kClasses); ++i) {
        const FailureClass& each = kClasses[i];
        ClassTotal total{failures[i].size(), failures[i].size(), true};
        if (const auto kind = pairsOf(each)) {
            total.total = counts[static_cast<std::size_t>(*kind)];
            total.exact = mesh.search.complete;
        }
        found.totals.push_back(total);
        for (MeshFailure& failure : failures[i]) {
            failure.kind = &each;
            found.failures.push_back(std::move(failure));
        }
    }
    found.work = mesh.search.work;
    found.meanEdge = mesh.meanEdge;
    found.twins = mesh.twins;
    found.report = reportOf(mesh, counts);
    return found;
}

}  // namespace

MeshInspection inspectWithTotals(const PointSet& points, std::span<const Triangle> triangles) {
    assert(cornersBelow(triangles, points.size()));
    InspectedMesh mesh(points, triangles);
    mesh.search = searchFaults(mesh.points, triangles, mesh.topology.sides);
    return inspected(mesh);
}

MeshInspection inspectLocally(const PointSet& points, std::span<const Triangle> triangles) {
    assert(cornersBelow(triangles, points.size()) && haveFinitePositions(points, triangles));
    InspectedMesh mesh(points, triangles);
    mesh.search = searchLocalFaults(mesh.points, triangles, mesh.topology.sides);
    return inspected(mesh);
}

std::vector<MeshFailure> inspectMesh(const PointSet& points, std::span<const Triangle> triangles) {
    return inspectWithTotals(points, triangles).failures;
}

}  // namespace se
