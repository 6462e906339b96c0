/// Beyond the paper: repairs of the mesh after the last pivot (docs/robust.md). The list of emitted
/// triangles is unchanged; the repairs edit a copy, one step at a time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "spiraling_edge/base/journaled_list.h"
#include "spiraling_edge/mesh/edge_table.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

class MeshTree;

/// A side that leaves a pinched point.
struct PinchedSide {
    Index point;
    HalfEdge leaving;
    friend bool operator==(const PinchedSide&, const PinchedSide&) = default;
};

/// The triangles near a place. A copy is empty, and made again when needed.
struct MeshIndex {
    MeshIndex() = default;
    MeshIndex(const MeshIndex& /*other*/) {}
    MeshIndex(MeshIndex&&) noexcept = default;
    MeshIndex& operator=(const MeshIndex& other) {
        if (this != &other) *this = MeshIndex();
        return *this;
    }
    MeshIndex& operator=(MeshIndex&&) noexcept = default;
    ~MeshIndex() = default;

    std::shared_ptr<MeshTree> tree;
    const PointSet* points = nullptr;  ///< Those of the tree: what-ifs may move points.
    std::vector<Index> changed;        ///< Triangles that changed since.
};

/// The direction and shape of a triangle that clearlyFaces() by kRough, as most do.
struct FacingTriangle {
    std::array<float, 3> normal{};  ///< Of unit length.
    /// Cosine of the least angle; kNotFacing if the triangle does not face its normals, kUnknown
    /// before the test.
    float cosine = kUnknown;

    static constexpr float kNotFacing = 2;
    static constexpr float kUnknown = 3;
};

/// The triangles that flips look at, each found once for its three edges.
struct FacingTriangles {
    const PointSet* points = nullptr;
    std::vector<FacingTriangle> at;  ///< Per triangle.
};

/// Corners about which RobustRules::remesh found nothing.
struct FailedCorners {
    const PointSet* points = nullptr;
    /// Per point: RepairNumbers::remeshed at the last try, plus 1; 0 before the first one. Until
    /// that number grows, another try finds nothing, either.
    std::vector<std::uint32_t> at;
};

/// The numbers of a RepairState.
struct RepairNumbers {
    std::size_t queueFront = 0;  ///< The next side to examine: a position in RepairState::queue.
    /// The next place for the present phase to look at: a position in PointSet::order (twice
    /// over all from kSettlingRound on), a triangle, or a side.
    Index next = 0;
    std::uint32_t takenOut = 0;
    std::uint32_t round = 0;  ///< The phases are repeated kRepairRounds times.
    std::uint32_t reinserted = 0;
    std::uint32_t flipped = 0;
    std::uint32_t droppedPatches = 0;
    std::uint32_t closedHoles = 0;
    std::uint32_t remeshed = 0;
};

/// A place among the steps of one RepairState, to return to.
struct RepairPlace {
    RepairNumbers numbers;
    std::array<std::uint32_t, 8> changes{};  ///< JournaledList::changes() of each list.
};

/// Triangles with their neighbors, for local changes. A plain value: a copy is a place to return
/// to. With a journal, so is a RepairPlace, which takes little memory.
struct RepairState : RepairNumbers {
    JournaledList<Triangle> triangles;
    /// For each side 3 t + k, the opposite side in the adjacent triangle; kNone at a border.
    JournaledList<HalfEdge> twin;
    /// One side that leaves each point; kNone for a point in no triangle.
    JournaledList<HalfEdge> sideOf;
    /// Points whose triangles form more than one fan: 0 or 1. Only `closeholes` and
    /// `droppatches` change triangles at them.
    JournaledList<std::uint8_t> pinched;
    JournaledList<HalfEdge> queue;  ///< Sides to examine.
    /// Per triangle: the flips it took part in that only made fewer conflicts.
    JournaledList<std::uint8_t> conflictFlips;
    /// Per triangle: 1 if it was found without a fault since it got its corners; else 0, or beyond
    /// the end.
    JournaledList<std::uint8_t> sound;
    /// Sides at pinched points, by point; up to date while holes are closed and fans dropped.
    JournaledList<PinchedSide> pinchedSides;
    // Not in the journal, since they follow from the rest:
    MeshIndex near;
    FacingTriangles facing;
    FailedCorners failedCorners;

    bool empty() const { return triangles.empty(); }
    /// Sets the corners of a triangle; at the end of the list, adds it.
    void setTriangle(Index t, const Triangle& corners);
    /// Removes the last triangle.
    void popTriangle();
    /// Writes down all changes from now on.
    void beginJournal();
    /// The present place. Requires a journal.
    RepairPlace place() const;
    /// Goes back or forward to a place. O(changes between).
    void moveTo(const RepairPlace& place);
};

/// Number of rounds: flips make room for more points, and new points for more flips. In the last
/// one, points are put in and nothing else is done.
inline constexpr std::uint32_t kRepairRounds = 4;
/// From this round on, a point that fits nowhere without a fault may add one: in no triangle, it is
/// a fault itself. The third round.
inline constexpr std::uint32_t kSettlingRound = 2;

/// A RepairState of `triangles`. Sides of edges with more than two triangles get no twin.
RepairState beginRepair(std::size_t pointCount, const std::vector<Triangle>& triangles);

/// As above, with the table of all their edges at hand.
RepairState beginRepair(std::size_t pointCount, const std::vector<Triangle>& triangles,
                        const EdgeTable& table);

/// RobustRules::dropPatches: takes out the next component of under kSmallComponent triangles with a
/// point that lists one of a component of more. Nothing if none is left.
std::optional<DropPatchEvidence> dropNextPatch(const PointSet& points, RepairState& repair);

/// RobustRules::dropPatches: takes out all fans at the next pinched point but the largest, of equal
/// ones the first. Nothing if no point is pinched.
std::optional<DropPatchEvidence> dropNextFans(RepairState& repair);

/// RobustRules::reinsert: puts the next stranded point in the place of triangles it lies over, onto
/// a side of the border or beside it, if no new triangle has a fault. From kSettlingRound on, a
/// point without such a place goes into a patch that is filled around it or, when all others were
/// tried, where it adds the fewest faults, at most one, since it is one itself. A point stays out
/// if none of the mesh's points that it lists is within three spacings, by the spacing there (the
/// distance to the sixth neighbor). Nothing if no point is left to try.
std::optional<ReinsertEvidence> reinsertNext(const PointSet& points, RepairState& repair);

/// RobustRules::closeHoles: fills the next hole (isOpening(), boundary_loop.h) of at most 64
/// points, Params::maxFillLength and Params::maxFillWidth, if no new triangle has a fault. Where
/// the user limits holes (Params::limitsHoles()), those limits take the place of that width, and
/// openings are filled, too. Nothing if none is left.
std::optional<CloseHoleEvidence> closeNextHole(const PointSet& points, const Params& params,
                                               RepairState& repair);

/// RobustRules::flip: flips the next edge whose flip leaves fewer faults, or equally many and a
/// larger least angle where the surface is flat. Nothing if none is left. Terminates: every flip
/// makes fewer faults of shape, or keeps them and increases the least angle of its two triangles,
/// or makes fewer conflicts, which each triangle may be flipped for a few times.
std::optional<FlipEvidence> flipNext(const PointSet& points, const RobustThresholds& thresholds,
                                     RepairState& repair);

/// RobustRules::remesh: replaces the triangles about the next faulty one by others between the same
/// points, if none of them has a fault; in kSettlingRound, also those around one of its corners.
/// Nothing if none is left.
std::optional<RemeshEvidence> remeshNext(const PointSet& points, RepairState& repair);

}  // namespace se
