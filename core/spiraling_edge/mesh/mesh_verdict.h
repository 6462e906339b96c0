/// The verdict: what a mesh is, in numbers, judged by the points as they were given. One record for
/// every program, panel and comparison.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/mesh/fault_places.h"
#include "spiraling_edge/mesh/fidelity.h"
#include "spiraling_edge/mesh/inspection.h"

namespace se {

/// The verdict on a mesh. A number is 0 where the judge does not know what it takes: without one
/// (PointSet::judge) those of strays, twins, noise, pieces of points, openings of points.
struct MeshVerdict {
    std::vector<ClassTotal> totals;     ///< One for each of failureClasses(), in its order.
    std::vector<std::size_t> placesOf;  ///< Of each class: places at which it is the worst.
    std::size_t places = 0;             ///< Places with faults: faultPlaces() of those listed.
    bool allPlaces = true;              ///< False: faults beyond the listed ones may have others.
    std::size_t triangles = 0;
    std::size_t points = 0;  ///< All, used or not.
    std::size_t usedPoints = 0;
    /// Usable points in no triangle: of those that a mesh should have, and of the others by reason.
    std::size_t lost = 0;
    std::size_t strays = 0;
    std::size_t noise = 0;
    /// Beside a point in a triangle: a twin, or one of the same line.
    std::size_t twins = 0;
    std::size_t pieces = 0;          ///< Of the mesh.
    std::size_t piecesOfPoints = 0;  ///< MeshJudge::pieces.
    /// Edges of holes: of loops that are faults, and of those where the points do not end.
    std::size_t holeEdges = 0;  ///< Edges of all holes.
    std::size_t openings = 0;   ///< MeshJudge::openings.
    std::size_t closed = 0;     ///< Of these, those that the mesh covers.
    std::size_t against = 0;    ///< Triangles against given normals that fit.
    std::size_t facingIn = 0;   ///< Closed pieces that face in.
    /// Points that a mesh should have, away from it by over half a spacing, or in it beside a hole.
    std::size_t uncovered = 0;
    std::size_t toCover = 0;  ///< Points that a mesh should have.
    /// Points at a fault, not covered, or on the rim of an opening that the mesh covers.
    std::size_t amiss = 0;
    Fidelity fidelity;     ///< Distances of all points from the mesh.
    bool stopped = false;  ///< The run made too many triangles; the mesh is a part.

    /// Pieces of the mesh beyond those of the points; 0 if those are unknown.
    std::size_t extraPieces() const {
        return piecesOfPoints > 0 && pieces > piecesOfPoints ? pieces - piecesOfPoints : 0;
    }
    /// The share of the points that are covered, in [0, 1].
    double covered() const {
        return toCover == 0 ? 0.0
                            : 1.0 - static_cast<double>(uncovered) / static_cast<double>(toCover);
    }
    /// isSound() of the mesh of a run that was not stopped.
    bool isSound() const { return !stopped && se::isSound(totals, triangles); }
};

/// A mesh with all failures, and the verdict on it.
struct JudgedMesh {
    MeshInspection inspection;
    std::vector<FaultPlace> places;
    MeshVerdict verdict;
};
/// Judges a mesh by PointSet::judge, or else by the points themselves: inspectWithTotals(), and
/// what follows. Requires what that does. Deterministic, on all cores. About O(t log t + n log n).
JudgedMesh judgeMesh(const PointSet& points, std::span<const Triangle> triangles);
/// The verdict on a mesh whose failures and places are known already.
MeshVerdict verdictOn(const PointSet& points, std::span<const Triangle> triangles,
                      const MeshInspection& inspection, std::span<const FaultPlace> places);

/// One count in which a mesh can be worse than another of the same points; more is worse.
struct VerdictCount {
    std::string_view name;      ///< As in reports: `points_lost`.
    std::string_view singular;  ///< "point lost".
    std::string_view plural;    ///< "points lost".
    std::size_t (*of)(const MeshVerdict& verdict);
    std::array<std::string_view, 2> classes = {};  ///< The classes of faults that it counts.
};
/// Points lost, pieces beyond those of the points, edges of holes, openings closed, triangles
/// against given normals, pieces that face in, points not covered.
std::span<const VerdictCount> verdictCounts();
/// True for a class of faults that one of verdictCounts() counts, or the edges of.
bool isCounted(const FailureClass& kind);
/// True if a mesh comes before another: with triangles and not stopped; sound; with fewer points
/// amiss. The first that differs decides.
bool isSounder(const MeshVerdict& mesh, const MeshVerdict& other);
/// True if a mesh comes before another of the same points: sounder, or else with fewer pieces
/// beyond those of the points, or at as many at a lesser mean distance from the points.
bool isBetter(const MeshVerdict& mesh, const MeshVerdict& other);

/// "73 places", "73 places or more".
std::string placesText(const MeshVerdict& verdict);
/// "sound", "not sound: no triangle", "73 places: 11 of holes, 34 of intersecting pairs; 82 points
/// lost" with the most severe classes first, "no fault found, but the search ended early",
/// "stopped: too many triangles".
std::string headlineOf(const MeshVerdict& verdict);

}  // namespace se
