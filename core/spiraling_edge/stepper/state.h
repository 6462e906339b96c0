/// The whole state of a run as one value: a copy is a place to return to.
#pragma once

#include <cstdint>
#include <vector>

#include "spiraling_edge/mesh/edge_table.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/edge_ring.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/neighbor_ring.h"
#include "spiraling_edge/stepper/repair.h"

namespace se {

/// The next phase that advance() runs. One function each, in the order of a pivot's stages.
enum class Phase : std::uint8_t {
    Seed,  ///< §4
    Pivot,  ///< Takes the entry as pivot; passes over it (§7) or inserts a third point (§7.1, 7.2).
    Sort,        ///< §6.1
    Limits,      ///< §6.1
    Convex,      ///< §6.1
    Reciprocal,  ///< §6.1
    Hole,        ///< §6.2
    Sphere,      ///< §6.3
    TwoPoint,    ///< §6.4
    Guard,       ///< Beyond the paper: the rules that examine the whole fan.
    Emit,        ///< §6.4
    Ring,        ///< §6.5
    Link,        ///< §6.5: splits and joins.
    Fill,        ///< Beyond the paper: the next ear of a hole.
    Advance,     ///< §6.5, §7
    // Beyond the paper, after the last pivot (repair.h):
    DropFans,   ///< All fans but the largest at one point.
    DropPatch,  ///< One small patch.
    Reinsert,   ///< One stranded point.
    CloseHole,  ///< One hole.
    Flip,       ///< One edge.
    Remesh,     ///< The triangles about one with a fault.
    Finished,
};

/// True for the phases after the last pivot, which edit the mesh.
constexpr bool isRepair(Phase phase) { return phase >= Phase::DropFans && phase <= Phase::Remesh; }

/// Status of a point (§4): UNUSED 0, USED n > 0 = number of its ring entries, DONE -1.
using PointStatus = std::int32_t;
inline constexpr PointStatus kUnused = 0;
inline constexpr PointStatus kDone = -1;

/// Value of State::retryLevel: delayed fans (RobustRules::delay) may be made.
inline constexpr std::uint32_t kDelayedAllowed = 1;
/// Value of State::retryLevel: triangles against the normal of one corner, but not against the sum
/// of the three, may be made as well.
inline constexpr std::uint32_t kCornerAllowed = 2;
/// Value of State::retryLevel: no ear of the hole could be closed (RobustRules::fill).
inline constexpr std::uint32_t kFillFailed = 3;

/// Counts of the run so far.
struct Counters {
    std::uint32_t pivots = 0;
    std::uint32_t skipped = 0;
    std::uint32_t seeds = 0;
    std::uint32_t isolated = 0;
    std::uint32_t stranded = 0;
    std::uint32_t inserted = 0;   ///< Third points of §7 that led to triangles.
    std::uint32_t discarded = 0;  ///< Two-point rings over 180 degrees.
    std::uint32_t refused = 0;    ///< Fans that a rule beyond the paper refused.
    std::uint32_t splits = 0;
    std::uint32_t joins = 0;
    std::uint32_t closedRings = 0;  ///< Finished edges and lone entries, see Readings::closeTwo.
    std::uint32_t freedRings = 0;
    std::uint32_t shelved = 0;  ///< Times that RobustRules::shelve put a ring on the shelf.
    std::uint32_t holes = 0;    ///< Freed rings with interior points.
    /// Freed rings that RobustRules::rim treats as an end of the surface.
    std::uint32_t openings = 0;
    std::uint32_t filled = 0;     ///< Triangles made by RobustRules::fill.
    std::uint32_t lostSeeds = 0;  ///< Rings of two that got no triangle; their points are DONE.
    /// Those whose points are UNUSED again (Readings::keepSeeds).
    std::uint32_t failedSeeds = 0;
    std::uint32_t maxRingLength = 0;
    std::uint32_t maxStackDepth = 0;
    friend bool operator==(const Counters&, const Counters&) = default;
};

/// An event that deserves the user's attention.
struct Alert {
    AlertKind kind;
    std::uint32_t pivot;
    Index point;
};

/// A third point inserted by §7, kept until the pivot has made triangles or not.
struct InsertedPoint {
    Index entry = kNone;
    bool stepBeforeWasOpen = false;  ///< Open mark of the step that the entry was inserted into.
};

struct State {
    State() = default;
    explicit State(std::size_t pointCount) : status(pointCount, kUnused), rings(pointCount) {}

    Phase phase = Phase::Seed;
    Index startPointer = 0;   ///< §4: position in PointSet::order; never moves back.
    bool seedsSpent = false;  ///< RobustRules::shelve: the shelved rings came back to the stack.
    Index circuit = 0;        ///< Pivots since the last triangle, in the active ring.
    /// Beyond the paper: the degree to which rules are relaxed for the active ring since its last
    /// triangle: 0, kDelayedAllowed, kCornerAllowed or kFillFailed.
    std::uint32_t retryLevel = 0;
    NeighborRing pivot;   ///< The current pivot.
    InsertedPoint third;  ///< §7.1, §7.2
    /// The verdict on a candidate next on the ring beyond start, or end: why that did not move
    /// there. For the log alone: without one BeyondOther.
    Verdict beyondStart = Verdict::BeyondOther;
    Verdict beyondEnd = Verdict::BeyondOther;
    std::uint32_t pivotTriangles = 0;    ///< Triangles made by this pivot.
    std::vector<Index> insertedEntries;  ///< Entries inserted by this pivot, in order (§6.5).
    std::vector<Index> instances;        ///< The "other instance" of each, kNone if none.
    std::vector<PointStatus> status;
    EdgeRings rings;
    EdgeTable edges;                  ///< Edges of `triangles`; kept only where a rule needs it.
    std::vector<Triangle> triangles;  ///< Append-only (§6.4).
    /// The mesh edited by the steps after the last pivot; empty before them. `triangles` is
    /// unchanged.
    RepairState repair;
    std::vector<Alert> alerts;  ///< Append-only.
    std::vector<Index> done;    ///< The DONE points, in the order in which they became so (§4).
    Counters counters;

    /// Marks a point DONE, permanently (invariant 7).
    void finish(Index p) {
        status[p] = kDone;
        done.push_back(p);
    }
    /// The mesh made so far.
    const std::vector<Triangle>& mesh() const {
        if (repair.empty()) return triangles;
        return repair.triangles;
    }
    bool finished() const { return phase == Phase::Finished; }
    /// The run was stopped with AlertKind::TriangleCap.
    bool capped() const { return !alerts.empty() && alerts.back().kind == AlertKind::TriangleCap; }
};

/// Hash of phase, counters, pivot, point statuses, rings, triangles, edited mesh and alerts. Equal
/// input, params and step number give equal hashes on every machine, compiler and build type.
/// O(points).
std::uint64_t stateHash(const State& state);

}  // namespace se
