/// The record of a run, decision by decision. The stepper produces events only if it is given a
/// log; every event carries the evidence of its rule, and has an address that never changes between
/// equal runs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/neighbor_ring.h"

namespace se {

/// The stages of a pivot, in order, and those outside one. The same words everywhere.
enum class Stage : std::uint8_t {
    Seed,        ///< §4: a new ring of two.
    Strand,      ///< §4: a point that cannot begin a ring.
    Pivot,       ///< The ring entry that becomes the pivot.
    Skip,        ///< §7: a boundary point, passed over.
    Insert,      ///< §7.1, §7.2: a third boundary point joins the ring.
    Sort,        ///< §6.1, Fig. 3
    Limits,      ///< §6.1, Fig. 4
    Convex,      ///< §6.1, Fig. 5
    Reciprocal,  ///< §6.1, Fig. 6
    Hole,        ///< §6.2, Fig. 7
    Sphere,      ///< §6.3, Fig. 8
    TwoPoint,    ///< §6.4, Fig. 9
    Guard,       ///< Beyond the paper: the whole fan is examined (docs/robust.md).
    Fill,        ///< Beyond the paper: an ear of a hole.
    Emit,        ///< §6.4, Fig. 10
    Ring,        ///< §6.5, Fig. 11
    Split,       ///< §6.5, Fig. 11
    Join,        ///< §6.5, Fig. 12
    Advance,     ///< §6.5: the next pivot.
    // Beyond the paper, after the last pivot:
    DropPatch,  ///< A small component, or all fans at a point but the largest, is taken out.
    Reinsert,   ///< A stranded point is put in.
    CloseHole,  ///< A hole is filled.
    Flip,       ///< An edge is flipped.
    Remesh,     ///< The triangles about a fault are replaced.
    Done,       ///< §3, §7: a ring is freed or a component complete.
    Finished,   ///< §3: the end of the run.
};
inline constexpr std::size_t kStageCount = static_cast<std::size_t>(Stage::Finished) + 1;

/// True for the stages after the last pivot, which edit the mesh.
constexpr bool isRepair(Stage stage) { return stage >= Stage::DropPatch && stage <= Stage::Remesh; }

/// The tests of a stage that a what-if can override (what_if.h).
enum class StageTests : std::uint8_t {
    None,
    OfPoints,  ///< Each tests one point.
    OfFans,    ///< Also of the neighbor ring as a whole: refused, no triangle is made.
};

/// One stage.
struct StageRow {
    Stage id;
    std::string_view name;     ///< "sphere", as shown to users and in addresses.
    std::string_view section;  ///< "6.3"; empty for those beyond the paper (docs/robust.md).
    StageTests tests;
};

/// True if the rows of a table are in the order of the enum of their ids.
template <typename Rows>
constexpr bool isInOrder(const Rows& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].id != static_cast<decltype(rows[i].id)>(i)) return false;
    }
    return true;
}

/// All stages, in the order of the enum. A new stage is a value of Stage and a row of this table.
std::span<const StageRow> stageTable();
const StageRow& rowOf(Stage stage);

/// "sphere", "twopoint", ...
std::string_view stageName(Stage stage);
std::optional<Stage> stageFromName(std::string_view name);
/// "6.3"; the paper's section of a stage. Empty for those beyond the paper (docs/robust.md).
std::string_view stageSection(Stage stage);

/// PIVOT.STAGE.N, for example 137.sphere.3. Pivots count from 1 over the whole run, N from 1 within
/// the stage of the pivot. A seed has the number of the pivot that it leads to; the end of the run,
/// the number after the last pivot, or that of the pivot that exceeded the limit of triangles.
struct Address {
    std::uint32_t pivot = 0;
    Stage stage = Stage::Pivot;
    std::uint32_t n = 0;
    friend bool operator==(const Address&, const Address&) = default;
};
/// The order by pivot, stage and n. Within a pivot that is not always the order of the run, since
/// stages may be repeated (docs/robust.md); for that see RunPosition.
bool isBefore(const Address& a, const Address& b);
std::string toString(const Address& address);
/// Reads `137`, `137.sphere` or `137.sphere.3`; parts left out are stage Pivot and n = 0.
std::optional<Address> addressFromString(std::string_view text);

/// The verdict of a test.
enum class Verdict : std::uint8_t {
    Kept,
    // sort
    NotAfterStart,  ///< Not strictly after the starting angle.
    NotBeforeEnd,   ///< Not strictly before the ending angle (Fig. 3).
    SameAngle,      ///< The same angle as a nearer point, or by PaperRules::tie as a farther one.
    AlreadyDone,    ///< DONE (§4).
    OnRingEnd,      ///< The point at first or last itself.
    // limits
    Moved,       ///< start or end advanced to the tested point (Fig. 4).
    NotListed,   ///< Not among p's neighbors.
    NotConcave,  ///< The ring is convex there.
    NotAnEdge,   ///< The ring step is open.
    Outside,     ///< A candidate outside the new limits.
    OtherLimit,  ///< The next point is the other limit: a hole of three.
    HalfTurn,    ///< The move would span 180 degrees or more (Readings::belowHalfTurn).
    Blocked,     ///< An UNUSED neighbor is in the way (RobustRules::unblocked).
    NowStart,    ///< A candidate that start moved to: not refused.
    NowEnd,      ///< A candidate that end moved to: not refused.
    // convex
    // Next on the ring beyond a start or end (Fig. 5) that did not move there,
    BeyondConvex,    ///< since the ring is convex there,
    BeyondHalfTurn,  ///< since the move would span 180 degrees or more,
    BeyondBlocked,   ///< since an UNUSED neighbor is in the way,
    BeyondOther,     ///< or for another reason: no edge, another rule, a what-if.
    // reciprocal
    NotReciprocal,  ///< p is outside the sector of e (Fig. 6).
    WallComplete,   ///< e is complete along its walls (RobustRules::wallsDone).
    // hole
    FarSide,  ///< On the far side of the plane (Fig. 7).
    // sphere
    InsideSphere,  ///< Kept: inside the circumsphere (Fig. 8).
    GapTooWide,    ///< Kept: without it the gap would exceed 120 degrees.
    NoCircle,      ///< Kept: p, s and t lie in line.
    Removed,       ///< Outside or on the sphere, and the gap is small enough.
    // twopoint
    Discarded,  ///< Over 180 degrees: the neighbor ring is discarded (Fig. 9).
    Hole,       ///< Under 180 degrees: an ear or hole, filled.
    // guard
    WideGap,        ///< A gap of 180 degrees or more (RobustRules::gap).
    EdgeTaken,      ///< A directed edge would be used twice (RobustRules::guard).
    EntryMissed,    ///< An edge would be closed away from its ring entries (RobustRules::guard).
    Pillow,         ///< A second triangle on the same three points (RobustRules::noPillow).
    Crosses,        ///< A new edge crosses a ring edge (RobustRules::noCross).
    AgainstNormal,  ///< A triangle against the normal of a corner (RobustRules::noFold).
    FoldsOver,      ///< A triangle folded onto an old one (RobustRules::noFold).
    OverRim,        ///< Over 120 degrees between points where the surface ends (RobustRules::rim).
    Steep,          ///< A steep triangle, for now (RobustRules::delay).
    Meets,          ///< A triangle meets a finished one (RobustRules::noMeet).
    Covers,         ///< A triangle is a second layer of a finished one (RobustRules::noLayer).
    // insert
    Before,
    After,
    OtherSideOpen,  ///< The pivot's other side would be left open (RobustRules::bothWalls).
    NoThirdPoint,
    // any test
    WhatIfKept,     ///< Kept by a what-if (what_if.h).
    WhatIfDropped,  ///< Dropped by a what-if.
};
inline constexpr std::size_t kVerdictCount = static_cast<std::size_t>(Verdict::WhatIfDropped) + 1;
/// "inside sphere", ... (verdict_table.h).
std::string_view verdictText(Verdict verdict);

/// One of the two sides of a pivot.
enum class Side : std::uint8_t { Start, End };

// One struct of evidence per kind of decision. Points are point indices, entries are not shown.
struct SeedEvidence {
    Index first, second;
    double distance;
};
struct StrandEvidence {
    Index point;
    bool isolated;          ///< Its list is empty.
    bool unseeded = false;  ///< Neighbors are UNUSED, but no seed is left; else every one is DONE.
};
struct PivotEvidence {
    Index pivot, first, last;
    Index ringLength;
    double sectorDegrees;
};
struct SkipEvidence {
    Index pivot;
    std::uint8_t type;
};
/// §7.1 and §7.2: the inserted point, its place and the numbers that decided.
struct InsertEvidence {
    Index pivot, other, third;
    bool corner;  ///< 7.2; else 7.1.
    /// 7.1 at a wall (else 0): of the normal of p and the vector to the second point, in the order
    /// of PaperRules::turn.
    Vec3 cross;
    std::uint8_t faces;          ///< Type bits of p.
    Verdict verdict;             ///< Before, After, OtherSideOpen or NoThirdPoint.
    double sectorDegrees = 0.0;  ///< Free sector of p from now on.
};
struct SortEvidence {
    Index point;
    double cosine;      ///< z . v
    bool secondHalf;    ///< n . v < 0
    double degrees;     ///< The angle.
    double endDegrees;  ///< The limit.
    Verdict verdict;    ///< Kept, NotAfterStart, NotBeforeEnd, SameAngle, AlreadyDone, OnRingEnd
    Index rival;        ///< SameAngle: the point that stays.
    /// SameAngle: the squared distance beyond that of the rival; below 0: the rival is farther.
    double farther = 0.0;
};
/// A test of the ring neighbor beyond start or end (Fig. 4).
struct LimitEvidence {
    Side side;
    Index from, to;
    double turn;  ///< ((before - s) x (after - s)) . N_s; > 0: concave.
    double fromDegrees, toDegrees;
    Verdict verdict;        ///< Moved, NotListed, NotConcave, NotAnEdge, Outside, OtherLimit
    Index blocker = kNone;  ///< Blocked: the first neighbor in the way.
    /// True if start or end is at `to` afterwards.
    bool moves() const { return verdict == Verdict::Moved || verdict == Verdict::WhatIfKept; }
};
/// A candidate that the new limits leave outside, or the convexity rule drops.
struct DropEvidence {
    Index point;
    Side side;
    double degrees;
    Verdict verdict;  ///< Outside, NowStart, NowEnd, or one of Beyond
    /// The candidate is the moved start or end.
    bool isLimit() const { return verdict == Verdict::NowStart || verdict == Verdict::NowEnd; }
};
struct ReciprocalEvidence {
    Index point;
    Index pred, succ;  ///< Of the tested entry of `point`.
    double degrees;    ///< Angle of p at the point.
    double limitDegrees;
    Verdict verdict;  ///< Kept, NotReciprocal
    /// The sector is that of elast and efirst (Readings::freeSector is off).
    bool printed = false;
};
struct HoleEvidence {
    Index point;
    Vec3 planeNormal;        ///< Not unit.
    double side, pivotSide;  ///< Signed distances (scene units) of the point and of p.
    Verdict verdict;         ///< Kept, FarSide
    Index edges = 3;         ///< Of the hole.
};
struct SphereEvidence {
    Index t, q, s;            ///< q: tested; t, s: its neighbors on the neighbor ring.
    Vec3 center;              ///< Of the circumsphere of the pivot, s and t.
    double radius, distance;  ///< `distance`: of q from the center; both 0 without a circle.
    double gapDegrees;        ///< Angle from t to s.
    Verdict verdict;          ///< InsideSphere, GapTooWide, NoCircle, Removed
};
struct TwoPointEvidence {
    double degrees;
    Verdict verdict;        ///< Discarded, Hole
    bool onePoint = false;  ///< First and last are the same point.
};
/// A rule beyond the paper found something against the fan (docs/robust.md).
struct GuardEvidence {
    Verdict verdict;
    Index a, b;     ///< The spoke to a (b is kNone), or the triangle pivot, a, b.
    Index dropped;  ///< The candidate that is dropped; kNone: the fan is refused. Of a what-if: the
                    ///< candidate that stays, or the pivot.
};
/// The next ear of a hole (RobustRules::fill).
struct FillEvidence {
    Index pivot, first, last;
    Index ringLength;
    double leastDegrees;   ///< The ear's least angle.
    bool forced;           ///< No ear without a fault was left.
    double sectorDegrees;  ///< Free sector of the pivot.
};
/// A small component beside a larger one was taken out, or all fans at a point but the largest
/// (RobustRules::dropPatches).
struct DropPatchEvidence {
    Index point;      ///< The least of the component's points, or the one with the fans.
    Index triangles;  ///< Number of triangles that were taken out.
    Index kept = 0;   ///< Number of triangles in the fan that stays; 0 for a component.
};
/// A stranded point took the place of triangles, or divided or joined the border
/// (RobustRules::reinsert).
struct ReinsertEvidence {
    Index point;
    Index replaced;  ///< Number of triangles in whose place it is; 0: beside the border.
};
/// A hole of the finished mesh was filled with triangles between its points
/// (RobustRules::closeHoles).
struct CloseHoleEvidence {
    Index first, second;  ///< The side of the hole with which its ring begins.
    Index length;         ///< Of the ring, before it was widened.
};
/// The triangles about a faulty one were replaced by others between the same points
/// (RobustRules::remesh).
struct RemeshEvidence {
    Triangle faulty;
};
/// The edge u v became x y (RobustRules::flip).
struct FlipEvidence {
    Index u, v, x, y;
    bool forAngles;  ///< For a larger least angle; else for fewer faults.
};
struct EmitEvidence {
    Index triangle;  ///< Position in the list of triangles.
    Triangle corners;
};
/// One change of the edge ring (§6.5).
struct RingEvidence {
    Index point;
    bool inserted;  ///< Else removed.
    int status;     ///< Afterwards.
};
struct SplitEvidence {
    Index point;
    Index activeLength, stackedLength;
    Index stackDepth;  ///< Afterwards.
};
struct JoinEvidence {
    Index point;
    Index depthFromTop;  ///< Position of the other ring; kNone: it was the active one.
    Index length;        ///< Of the joined ring.
};
/// A finished edge, or a lone entry, was closed: see Readings::closeTwo.
struct CloseEvidence {
    Index a, b;      ///< b is kNone for a lone entry.
    Index rest = 0;  ///< Length of the ring that a and b left; 0: they were the whole ring.
    Index depthFromTop = kNone;  ///< With `rest`: position of that ring; kNone: the active one.
};
struct AdvanceEvidence {
    Index to;             ///< kNone: no ring is left.
    Index circuit;        ///< Pivots of this circuit without a triangle.
    bool popped;          ///< The ring came off the stack.
    bool whatIf = false;  ///< Set by a what-if (what_if.h).
    Index shelved = 0;    ///< Where no ring is left: those on the shelf.
};
/// A ring without a triangle in a full circuit was shelved (RobustRules::shelve).
struct ShelveEvidence {
    Index length;
    Index shelved;  ///< Rings on the shelf before it.
};
/// The rings on the shelf became ordinary ones of the stack, since no seed is left.
struct TakeUpEvidence {
    Index to;     ///< The next pivot.
    Index rings;  ///< Their number.
};
/// A ring was freed after a full circuit without a triangle (§7).
struct FreeEvidence {
    Index length;
    Index interior;     ///< Interior points on it: > 0 means a hole stayed open.
    bool seed = false;  ///< A seed: its points are UNUSED again (Readings::keepSeeds).
};
struct ComponentEvidence {
    std::uint32_t component;  ///< From 1.
    std::uint32_t triangles;  ///< Of the whole run so far.
};
enum class AlertKind : std::uint8_t {
    TriangleCap,  ///< Params::maxTrianglesPerPoint was exceeded; the run was stopped.
    Hole,         ///< A ring with interior points was freed.
    LostSeed,     ///< A ring of two got no triangle.
};
struct AlertEvidence {
    AlertKind kind;
    Index point;
};
/// The last event of every run: what ended it, and its mesh, with the steps after the last pivot.
struct FinishedEvidence {
    Index triangles;
    Index components;  ///< Sets of triangles joined by common points.
    Index unused;      ///< Points in no triangle.
    Index loops;       ///< Connected pieces of the boundary.
    bool capped;       ///< Stopped by AlertKind::TriangleCap; else every point is DONE.
};

using Evidence =
    std::variant<SeedEvidence, StrandEvidence, PivotEvidence, SkipEvidence, InsertEvidence,
                 SortEvidence, LimitEvidence, DropEvidence, ReciprocalEvidence, HoleEvidence,
                 SphereEvidence, TwoPointEvidence, GuardEvidence, FillEvidence, DropPatchEvidence,
                 ReinsertEvidence, CloseHoleEvidence, FlipEvidence, RemeshEvidence, EmitEvidence,
                 RingEvidence, SplitEvidence, JoinEvidence, CloseEvidence, AdvanceEvidence,
                 ShelveEvidence, TakeUpEvidence, FreeEvidence, ComponentEvidence, AlertEvidence,
                 FinishedEvidence>;

struct Event {
    Address address;
    Evidence evidence;
};

/// Receives every decision, in order. Not part of State: a copy of a State has no log.
class EventLog {
  public:
    void add(std::uint32_t pivot, Stage stage, const Evidence& evidence);
    const std::vector<Event>& events() const { return events_; }
    void clear();

  private:
    std::vector<Event> events_;
    std::uint32_t pivot_ = 0;
    std::array<std::uint32_t, kStageCount> counts_{};
};

}  // namespace se
