/// Failures of a finished mesh, of this program or another: each with its class, place and size;
/// and whether the mesh is sound.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/mesh/mesh_report.h"

namespace se {

struct MeshFailure;
struct InspectedMesh;  // The input of the checks; made by inspectMesh().

/// One row of the table of classes: a new check is one function and one row.
struct FailureClass {
    std::string_view name;      ///< As in the report of a run: `non_manifold_edges`.
    std::string_view singular;  ///< One of them: "non-manifold edge".
    std::string_view meaning;   ///< One sentence.
    bool fault;                 ///< A mesh with one of these is not sound.
    int severity;               ///< Order of places with faults: 1 comes first.
    /// Null for a class that only a run can have, see failuresOfRun().
    void (*find)(const InspectedMesh& mesh, std::vector<MeshFailure>& failures);
};

/// All classes, in the order of the report.
std::span<const FailureClass> failureClasses();
/// Null if there is none of that name.
const FailureClass* findFailureClass(std::string_view name);

/// One failure.
struct MeshFailure {
    const FailureClass* kind = nullptr;
    std::vector<Index> points;                ///< Of the edge, the loop, ...; ascending.
    std::vector<Index> triangles;             ///< Involved, ascending; empty for points in none.
    std::vector<std::array<Index, 2>> edges;  ///< Of a loop, by their points; otherwise empty.
    Vec3 place{};                             ///< Its center, scene units.
    double length = 0.0;                      ///< Loops: length, scene units.
    double area = 0.0;  ///< Loops: area of the flat surface inside, scene units squared.
};
/// One sentence with points and numbers.
std::string describe(const MeshFailure& failure);
/// "non-manifold edge" for one, else "non-manifold edges".
std::string nounFor(const FailureClass& kind, std::size_t count);

/// A sliver's least angle is below this: the cosine of one degree.
inline constexpr double kSliverCosine = 0.9998476951563913;
/// A component of fewer triangles than this, with a point within kNearComponent mean lengths of the
/// edges of a larger one, is a small component: a late patch over a finished surface, or a splinter
/// of it.
inline constexpr std::size_t kSmallComponent = 14;
inline constexpr double kNearComponent = 2.0;
/// A point in no triangle is isolated if every used point is farther away than this times the
/// mean length of the edges.
inline constexpr double kIsolated = 4.0;

/// At most this many intersecting triangles, and second layers, are listed: a tangled mesh has
/// millions.
inline constexpr std::size_t kMaxListed = 10'000;

/// The number of failures of a class.
struct ClassTotal {
    std::size_t listed = 0;  ///< Those in the list, the first ones.
    std::size_t total = 0;   ///< Those known.
    bool exact = true;       ///< False: there are at least `total`, since the search ended early.

    bool all() const { return exact && listed == total; }
};
/// "12", "first 10000 of 34567", "first 10000 of at least 1204331".
std::string amountText(const ClassTotal& total);

/// The result of an inspection.
struct MeshInspection {
    std::vector<MeshFailure> failures;
    std::vector<ClassTotal> totals;  ///< One for each of failureClasses(), in its order.
    /// Per point: a corner of a triangle with a fault, listed or not.
    std::vector<bool> atFault;
    std::uint64_t work = 0;  ///< FaultSearch::work.
    double meanEdge = 0.0;   ///< Mean length of the edges, scene units; 0 without triangles.
    std::size_t twins =
        0;  ///< Points in no triangle that are not lost: beside a twin, or along a line.
    MeshReport report;
};
/// True if every failure is listed and the search was complete.
bool isComplete(std::span<const ClassTotal> totals);
/// True if the search for every class was complete, so that no total is a lower bound.
bool isExact(std::span<const ClassTotal> totals);
/// The number of failures of the classes that are faults.
std::size_t faultCount(std::span<const ClassTotal> totals);
/// The definition of a sound mesh, for every program and panel: it has triangles, and no failure of
/// a class that is a fault, after a complete search for them.
bool isSound(std::span<const ClassTotal> totals, std::size_t triangles);

/// All failures, in the order of failureClasses(), then by triangle or point. `points.normal` and
/// `points.type` may be empty: then nothing is flipped, and every boundary loop is an opening.
/// With PointSet::judge, that counts instead of the points. Neighbor lists are not used; points
/// that were set aside (PointSet::aside, placedPoints()) may be in no triangle. Requires corners
/// below points.size() and finite positions of used points. Self-intersections are exact; the
/// search for pairs has the limits of searchFaults(), and the first kMaxListed are listed.
/// Deterministic, on all cores. About O(t log t).
MeshInspection inspectWithTotals(const PointSet& points, std::span<const Triangle> triangles);
/// As inspectWithTotals(), but without the search for pairs, which takes most of the time: the
/// totals of intersecting triangles and of second layers are not exact.
MeshInspection inspectLocally(const PointSet& points, std::span<const Triangle> triangles);
/// The failures that inspectWithTotals() lists.
std::vector<MeshFailure> inspectMesh(const PointSet& points, std::span<const Triangle> triangles);
/// True for a boundary loop, be it a hole or an opening.
bool isLoop(const MeshFailure& failure);
/// True for failures of one class with the same points.
bool isSame(const MeshFailure& a, const MeshFailure& b);
/// True if the failure is still among `failures`. One of its class that shares two points with it,
/// or its only point, counts as the same: a hole that has become smaller is still there.
bool isStillThere(const MeshFailure& failure, std::span<const MeshFailure> failures);
/// True for one point in no triangle.
bool isLostPoint(const MeshFailure& failure);
/// Of a loop, LoopShape::width().
double widthOf(const MeshFailure& loop);

}  // namespace se
