/// The checks, the table of them, and the counts. Sides are sorted by edge once for all checks;
/// small components and lost points are compared with the points near them by a grid. O(t log t).
#include "spiraling_edge/mesh/inspection.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/geometry/loop_shape.h"
#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/boundary_loop.h"
#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/mesh/mesh_judge.h"
#include "spiraling_edge/mesh/mesh_topology.h"
#include "spiraling_edge/mesh/moderate_size.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/points/wall_types.h"

namespace se {

/// A connected part of the boundary: a closed chain of edges of one triangle each, or several
/// through common points.
struct BoundaryLoop {
    std::vector<TriangleSide> sides;
    LoopShape shape;
    bool isOpening = false;  ///< The surface ends there; else it is a hole.
};

/// A mesh with values that several checks share. Refers to its points and triangles, which must
/// outlive it.
struct InspectedMesh {
    /// All values but `search`.
    InspectedMesh(const PointSet& given, std::span<const Triangle> mesh);
    InspectedMesh(const InspectedMesh&) = delete;
    InspectedMesh& operator=(const InspectedMesh&) = delete;

    ModerateSize size;                 ///< All lengths below are of this size.
    const MeshJudge* judge = nullptr;  ///< Null: the points themselves.
    std::optional<PointSet> filled;    ///< The points, if the input lacks normals or types: zeros.
    const PointSet& points;            ///< With normals and types; lists may be absent.
    std::span<const Triangle> triangles;
    MeshTopology topology;
    FaultSearch search;                           ///< Empty unless assigned.
    std::vector<Index> lostPoints;                ///< Points in no triangle, neither set aside nor
                                                  ///< unfit for any mesh; ascending.
    std::size_t twins = 0;                        ///< Points in no triangle beside a twin in one,
                                                  ///< or along a line.
    double meanEdge = 0.0;                        ///< Length.
    std::vector<std::size_t> componentTriangles;  ///< By the least point of a component.
    std::vector<BoundaryLoop> loops;              ///< By least point.

    /// Number of triangles of the component that a used point belongs to.
    std::size_t trianglesAround(Index p) const { return componentTriangles[topology.component[p]]; }
    /// A failure at these points and triangles; its place is the center of the points.
    MeshFailure at(std::vector<Index> itsPoints, std::vector<Index> itsTriangles) const;
};

namespace {

using Failures = std::vector<MeshFailure>;

// ---- the shared values --------------------------------------------------------------------------

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
/// triangle, and no preparation has found them.
std::vector<Index> findLostPoints(const InspectedMesh& mesh, const PointSet& input) {
    std::vector<Index> lost;
    for (Index p = 0; p < input.size(); ++p) {
        if (!mesh.topology.used[p]) lost.push_back(p);
    }
    if (lost.empty()) return lost;
    const std::vector<Aside> unusable =
        input.aside.empty() ? placedPoints(input.position).aside : input.aside;
    const auto isPlaneless = [&](Index p) {
        return !input.normal.empty() && !hasDirection(input.normal[p]);
    };
    std::erase_if(lost, [&](Index p) { return isPlaneless(p) || unusable[p] != Aside::No; });
    return lost;
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
                const double distance = glm::distance(mesh_.points.position[points_[i]], x);
                found = found || (distance <= reach_ && test(points_[i]));
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

/// Removes points of lines from the points in no triangle, if one in a triangle is no farther than
/// the lines are apart, and counts them.
std::size_t dropAlongLines(const InspectedMesh& mesh, std::vector<Index>& lost) {
    if (mesh.judge->facts.across == 0.0 || lost.empty()) return 0;
    const UsedPoints used(mesh, mesh.judge->facts.across);
    return std::erase_if(lost, [&](Index p) {
        return used.anyNear(mesh.points.position[p], [](Index) { return true; });
    });
}

/// Removes points whose twin is in a triangle from the points in no triangle, and those along
/// lines, and counts them.
std::size_t dropTwins(const InspectedMesh& mesh, std::vector<Index>& lost) {
    if (mesh.judge == nullptr) return 0;
    return dropAlongLines(mesh, lost) + std::erase_if(lost, [&](Index p) {
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

bool isOutlineOfPatch(const InspectedMesh& mesh, const BoundaryLoop& loop) {
    return loop.shape.turnsRoundPatch &&
           mesh.trianglesAround(loop.sides.front().low) <= largestPatch(loop.shape);
}

/// InspectedMesh::loops, of a mesh that has all other values.
std::vector<BoundaryLoop> boundaryLoops(const InspectedMesh& mesh) {
    std::vector<BoundaryLoop> loops;
    for (auto& its : connectedParts(mesh.topology.border, mesh.points.size())) {
        const std::vector<LoopSide> chain = loopSidesOf(its);
        BoundaryLoop loop{std::move(its), shapeOf(mesh.points, chain)};
        loop.isOpening = isOutlineOfPatch(mesh, loop) || isOpening(mesh.points, chain, loop.shape);
        loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace

InspectedMesh::InspectedMesh(const PointSet& given, std::span<const Triangle> mesh)
    : size(given, mesh),
      judge(size.points().judge.get()),
      filled(withNormalsAndTypes(judgeOf(size.points()))),
      points(filled ? *filled : judgeOf(size.points())),
      triangles(mesh),
      topology(given.size(), mesh),
      componentTriangles(given.size(), 0) {
    runTasks(
        threadsFor(mesh), [&] { meanEdge = meanLength(points, topology.sides); },
        [&] {
            for (const Triangle& t : triangles) ++componentTriangles[topology.component[t.a]];
            loops = boundaryLoops(*this);
        },
        [&] {
            lostPoints = findLostPoints(*this, judgeOf(size.points()));
            twins = dropTwins(*this, lostPoints);
        });
}

MeshFailure InspectedMesh::at(std::vector<Index> itsPoints, std::vector<Index> itsTriangles) const {
    MeshFailure failure;
    sortUnique(itsPoints);
    sortUnique(itsTriangles);
    for (const Index p : itsPoints) failure.place += points.position[p];
    failure.place /= static_cast<double>(std::max<std::size_t>(itsPoints.size(), 1));
    failure.points = std::move(itsPoints);
    failure.triangles = std::move(itsTriangles);
    return failure;
}

namespace {

// ---- checks of triangles ------------------------------------------------------------------------

std::vector<Index> cornersOf(const InspectedMesh& mesh, std::span<const Index> triangles) {
    std::vector<Index> points;
    for (const Index i : triangles) {
        const Triangle& t = mesh.triangles[i];
        points.insert(points.end(), {t.a, t.b, t.c});
    }
    return points;
}

/// A failure at these triangles and their corners.
MeshFailure atTriangles(const InspectedMesh& mesh, std::vector<Index> triangles) {
    std::vector<Index> corners = cornersOf(mesh, triangles);
    return mesh.at(std::move(corners), std::move(triangles));
}

constexpr bool isOfPairs(FaultKind kind) {
    return kind == FaultKind::Intersecting || kind == FaultKind::SecondLayer;
}

/// Appends the faults of a kind as failures: of pairs, which may be millions, the first ones.
template <FaultKind kind>
void ofKind(const InspectedMesh& mesh, Failures& failures) {
    constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
    std::size_t left = isOfPairs(kind) ? kMaxListed : kNoLimit;
    for (const Fault& fault : mesh.search.faults) {
        if (fault.kind != kind) continue;
        if (left-- == 0) return;
        std::vector<Index> triangles{fault.triangle};
        if (fault.other != kNone) triangles.push_back(fault.other);
        failures.push_back(atTriangles(mesh, std::move(triangles)));
    }
}

/// The corner of a triangle that is not on this side; the same point again if there is none.
Index cornerOpposite(const Triangle& t, const TriangleSide& side) {
    return t.a ^ t.b ^ t.c ^ side.low ^ side.high;
}

/// Triangles of the same points share all sides: those at the side of their two lowest points.
void duplicates(const InspectedMesh& mesh, Failures& failures) {
    std::vector<std::pair<Index, Index>> at;  // highest corner and triangle
    forEachEdge(mesh.topology.sides, [&](std::span<const TriangleSide> edge) {
        if (edge.size() < 2) return;
        at.clear();
        for (const TriangleSide& side : edge) {
            const Index highest = cornerOpposite(mesh.triangles[side.triangle], side);
            if (highest >= side.high) at.emplace_back(highest, side.triangle);
        }
        sortUnique(at);
        for (std::size_t i = 0; i < at.size();) {
            std::vector<Index> same;
            const Index highest = at[i].first;
            for (; i < at.size() && at[i].first == highest; ++i) same.push_back(at[i].second);
            if (same.size() > 1)
                failures.push_back(mesh.at({edge[0].low, edge[0].high, highest}, std::move(same)));
        }
    });
}

void slivers(const InspectedMesh& mesh, Failures& failures) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (isDegenerate(mesh.points, t) || leastAngleCosine(mesh.points, t) <= kSliverCosine)
            continue;
        failures.push_back(atTriangles(mesh, {static_cast<Index>(i)}));
    }
}

// ---- checks of edges and points -----------------------------------------------------------------

/// The lost points near a used one, or the isolated ones.
template <bool isolated>
void lostPoints(const InspectedMesh& mesh, Failures& failures) {
    if (mesh.lostPoints.empty()) return;
    const UsedPoints used(mesh, kIsolated * mesh.meanEdge);
    for (const Index p : mesh.lostPoints) {
        const bool near = used.anyNear(mesh.points.position[p], [](Index) { return true; });
        if (near != isolated) failures.push_back(mesh.at({p}, {}));
    }
}

bool isNonManifold(std::span<const TriangleSide> edge) { return edge.size() > 2; }

/// The edges that pass a test.
template <bool (*test)(std::span<const TriangleSide>)>
void edgesWhere(const InspectedMesh& mesh, Failures& failures) {
    for (const std::span<const TriangleSide> edge : mesh.topology.irregularEdges) {
        if (!test(edge)) continue;
        std::vector<Index> triangles;
        for (const TriangleSide& side : edge) triangles.push_back(side.triangle);
        failures.push_back(mesh.at({edge[0].low, edge[0].high}, std::move(triangles)));
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
        const std::vector<Index> points = cornersOf(mesh, triangles);
        const std::size_t size = triangles.size();
        const bool beside = std::any_of(points.begin(), points.end(), [&](Index p) {
            return used.anyNear(mesh.points.position[p],
                                [&](Index q) { return mesh.trianglesAround(q) > size; });
        });
        if (beside) failures.push_back(atTriangles(mesh, std::move(triangles)));
    }
}

// ---- checks of loops ----------------------------------------------------------------------------

/// The loops that are openings, or those that are holes.
template <bool openings>
void loopsOf(const InspectedMesh& mesh, Failures& failures) {
    for (const BoundaryLoop& loop : mesh.loops) {
        if (loop.isOpening != openings) continue;
        std::vector<Index> points;
        std::vector<Index> triangles;
        for (const TriangleSide& side : loop.sides) {
            points.insert(points.end(), {side.low, side.high});
            triangles.push_back(side.triangle);
        }
        MeshFailure failure = mesh.at(std::move(points), std::move(triangles));
        for (const TriangleSide& side : loop.sides) failure.edges.push_back({side.low, side.high});
        failure.length = loop.shape.perimeter;
        failure.area = loop.shape.area;
        failures.push_back(std::move(failure));
    }
}

// ---- closed pieces that face in -----------------------------------------------------------------

/// A closed piece: every edge is of two triangles that pass it in opposite directions.
struct ClosedPiece {
    std::vector<Index> triangles;
    Box box{Vec3(0.0)};
    double volume = 0.0;  ///< Six times; above 0 where it faces out.
};

/// The closed pieces, by their least points.
std::map<Index, ClosedPiece> closedPieces(const InspectedMesh& mesh) {
    std::vector<bool> open(mesh.points.size(), false);
    for (const std::span<const TriangleSide> edge : mesh.topology.irregularEdges)
        open[mesh.topology.component[edge.front().low]] = true;
    std::map<Index, ClosedPiece> pieces;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const Index name = mesh.topology.component[t.a];
        if (open[name]) continue;
        ClosedPiece& piece = pieces[name];
        // Relative to a point of the piece: far from the origin little would be left.
        const Vec3& origin = mesh.points.position[name];
        if (piece.triangles.empty()) piece.box = Box(origin);
        piece.triangles.push_back(static_cast<Index>(i));
        const Vec3 a = mesh.points.position[t.a] - origin;
        const Vec3 b = mesh.points.position[t.b] - origin;
        const Vec3 c = mesh.points.position[t.c] - origin;
        piece.volume += glm::dot(a, glm::cross(b, c));
        for (const Index p : {t.a, t.b, t.c}) piece.box.add(mesh.points.position[p]);
    }
    return pieces;
}

/// True if `x` is within a closed piece, by the solid angle of its triangles (van Oosterom and
/// Strackee 1983).
bool isWithin(const InspectedMesh& mesh, const ClosedPiece& piece, const Vec3& x) {
    double angle = 0.0;
    for (const Index i : piece.triangles) {
        const Triangle& t = mesh.triangles[i];
        const Vec3 a = mesh.points.position[t.a] - x;
        const Vec3 b = mesh.points.position[t.b] - x;
        const Vec3 c = mesh.points.position[t.c] - x;
        const double la = glm::length(a);
        const double lb = glm::length(b);
        const double lc = glm::length(c);
        angle += std::atan2(
            glm::dot(a, glm::cross(b, c)),
            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return std::abs(angle) > std::numbers::pi;
}

bool contains(const Box& outer, const Box& inner) {
    return glm::all(glm::lessThanEqual(outer.low, inner.low)) &&
           glm::all(glm::lessThanEqual(inner.high, outer.high));
}

void inwardPieces(const InspectedMesh& mesh, Failures& failures) {
    const std::map<Index, ClosedPiece> pieces = closedPieces(mesh);
    for (const auto& named : pieces) {
        const Index name = named.first;
        const ClosedPiece& piece = named.second;
        if (!(piece.volume < 0.0)) continue;
        const Vec3& x = mesh.points.position[name];
        const bool nested = std::any_of(pieces.begin(), pieces.end(), [&](const auto& other) {
            return other.first != name && contains(other.second.box, piece.box) &&
                   isWithin(mesh, other.second, x);
        });
        if (nested && (mesh.judge == nullptr || mesh.judge->facts.normalsFit)) continue;
        failures.push_back(atTriangles(mesh, {piece.triangles.front()}));
    }
}

// ---- spikes -------------------------------------------------------------------------------------

/// An edge longer than this many times the reach of the 12 nearest points of either end is a spike,
/// unless it closes a hole. Reaches count, since spacings differ much where points lie in clusters.
constexpr double kSpike = 5.0;

void spikes(const InspectedMesh& mesh, Failures& failures) {
    if (mesh.judge == nullptr || mesh.judge->reach.empty()) return;
    const MeshJudge& judge = *mesh.judge;
    const std::vector<bool> ends = endsOf(judge);
    const auto isLong = [&](Index p, Index q) {
        const double reach = std::max(judge.reach[p], judge.reach[q]);
        return !(ends[p] && ends[q]) &&
               glm::distance(mesh.points.position[p], mesh.points.position[q]) > kSpike * reach;
    };
    const auto isStray = [&](Index p) { return judge.points.asideOf(p) == Aside::Stray; };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const bool spike = isStray(t.a) || isStray(t.b) || isStray(t.c) || isLong(t.a, t.b) ||
                           isLong(t.b, t.c) || isLong(t.c, t.a);
        if (spike) failures.push_back(atTriangles(mesh, {static_cast<Index>(i)}));
    }
}

// ---- the table ----------------------------------------------------------------------------------

constexpr FailureClass kClasses[] = {
    {"non_manifold_edges", "non-manifold edge", "Three or more triangles meet at an edge.", true, 5,
     edgesWhere<isNonManifold>},
    {"non_manifold_vertices", "non-manifold vertex",
     "The triangles about a point are more than one fan.", true, 6, nonManifoldVertices},
    {"inconsistent_edges", "inconsistent edge",
     "Two triangles pass an edge in the same direction: one of them is inside out.", true, 7,
     edgesWhere<isInconsistent>},
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
    {"holes", "hole", "A boundary loop in the middle of the surface.", true, 2, loopsOf<false>},
    {"small_components", "small component", "A piece of a few triangles beside a larger one.", true,
     4, smallComponents},
    {"lost_points", "lost point", "A point is in no triangle, though the surface passes by.", true,
     3, lostPoints<false>},
    {"isolated_points", "isolated point", "A point is in no triangle, and far from all.", true, 3,
     lostPoints<true>},
    {"inward_pieces", "inward piece", "A closed piece of the surface faces inward.", true, 2,
     inwardPieces},
    {"spikes", "spike",
     "A triangle reaches far beyond the spacing of its points, and closes no hole.", true, 4,
     spikes},
    {"openings", "opening", "A boundary loop where the surface ends: no fault.", false, 14,
     loopsOf<true>},
    {"slivers", "sliver", "A triangle has an angle below one degree: no fault.", false, 16,
     slivers},
    {"leftover_rings", "leftover ring",
     "A ring was given up with points that the surface goes on at (runs only).", false, 15,
     nullptr},
    {"triangle_cap", "triangle cap", "The run was stopped: far too many triangles (runs only).",
     true, 1, nullptr},
};

/// "1, 2, 3"; long lists end in "... (70)".
std::string list(const std::vector<Index>& numbers) { return firstNumbers(numbers, 8); }

}  // namespace

std::span<const FailureClass> failureClasses() { return kClasses; }

const FailureClass* findFailureClass(std::string_view name) {
    // Sessions, lessons and queries of version 0.2 name it so.
    if (name == "unused_points") name = "lost_points";
    return findNamed(kClasses, name);
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
    return failure.kind->find == loopsOf<false> || failure.kind->find == loopsOf<true>;
}

bool isSame(const MeshFailure& a, const MeshFailure& b) {
    return a.kind == b.kind && a.points == b.points;
}

namespace {

/// True if the classes mean the same failure: points in no triangle near the surface and far from
/// it do, and loops of any width.
bool sameProblem(const FailureClass& a, const FailureClass& b) {
    const auto bothOf = [&](std::string_view one, std::string_view other) {
        return (a.name == one || a.name == other) && (b.name == one || b.name == other);
    };
    return &a == &b || bothOf("lost_points", "isolated_points") || bothOf("holes", "openings");
}

}  // namespace

bool isStillThere(const MeshFailure& failure, std::span<const MeshFailure> failures) {
    const std::size_t enough = std::min<std::size_t>(2, failure.points.size());
    return std::any_of(failures.begin(), failures.end(), [&](const MeshFailure& each) {
        if (!sameProblem(*each.kind, *failure.kind)) return false;
        const std::size_t shared = countWhere(each.points, [&](Index p) {
            return std::binary_search(failure.points.begin(), failure.points.end(), p);
        });
        return shared >= enough;
    });
}

bool isLostPoint(const MeshFailure& failure) {
    return failure.kind->find != nullptr && failure.triangles.empty() && failure.points.size() == 1;
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
            failure.place = mesh.size.place(failure.place);
            failure.length = mesh.size.length(failure.length);
            failure.area = mesh.size.area(failure.area);
            found.failures.push_back(std::move(failure));
        }
    }
    found.atFault.assign(mesh.points.size(), false);
    for (const Fault& fault : mesh.search.faults) {
        for (const Index i : {fault.triangle, fault.other}) {
            if (i == kNone) continue;
            const Triangle& t = mesh.triangles[i];
            for (const Index p : {t.a, t.b, t.c}) found.atFault[p] = true;
        }
    }
    found.work = mesh.search.work;
    found.meanEdge = mesh.size.length(mesh.meanEdge);
    found.twins = mesh.twins;
    found.report = reportOf(mesh.points, mesh.triangles, mesh.topology, mesh.search.faults);
    found.report.widestLoopWidth = mesh.size.length(found.report.widestLoopWidth);
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
