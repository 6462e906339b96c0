/// The parameters of a run, with the paper's values as defaults.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "spiraling_edge/stepper/given_start.h"
#include "spiraling_edge/stepper/what_if.h"

namespace se {

/// Readings of the paper where it is silent, ambiguous or measurably wrong. Every switch is one
/// line in the table of ruleSettings(); docs/choices.md gives the reason for each reading. A switch
/// that is off means: the printed sentence, word for word, as in the set `printed`.
struct Readings {
    /// §6.1, Fig. 6: the reciprocal test takes the sector from e's predecessor counterclockwise to
    /// its successor, the side that is still free. Off: "preceding and succeeding ... (elast and
    /// efirst)" as printed, which is the finished side.
    bool freeSector = true;
    /// §6.1, Fig. 4: start and end advance before other neighbors are tested, until nothing moves.
    /// Off: as the candidates come in list order, each tested once.
    bool limitsFirst = true;
    /// §6.1, Fig. 4: start and end do not advance across 180 degrees or more at the pivot, since
    /// the triangle would be inverted. Off: every angle between the limits is allowed.
    bool belowHalfTurn = true;
    /// §6.2: a hole of three needs a third side that is an edge of the mesh, and a sector below 180
    /// degrees. Off: three entries on the ring are enough.
    bool realHole = true;
    /// §6.5: two adjacent entries whose edge has a triangle on both sides are one finished edge and
    /// are closed: a ring of two whose steps are both mesh edges, and within a longer ring an entry
    /// between two entries of one point. Off: they stay, and the sector is a full turn (§6.1,
    /// "when the first and last points are the same").
    bool closeTwo = true;
    /// §7: steps that are no mesh edges (a fresh ring of two; beside a point inserted by 7.1 or
    /// 7.2) are marked open, and no rule treats them as edges. Off: every step counts as an edge.
    bool openSteps = true;
    /// §4, §7: the points of a seed that gets no triangle are UNUSED again if all their neighbors
    /// are, too, and the search for a seed goes on after it, so that each point begins at most one
    /// ring in vain. Off: they are marked DONE, as on every ring that is freed.
    bool keepSeeds = true;

    friend bool operator==(const Readings&, const Readings&) = default;
};

/// The rules beyond the paper (docs/robust.md), off in the sets `paper` and `printed`. Every switch
/// is one line in the table of ruleSettings().
struct RobustRules {
    /// §6.1: angles are measured in the tangent plane of the pivot, not between 3-D vectors.
    bool tangent = false;
    /// §6.1, Fig. 4: start and end do not advance over a triangle whose circumsphere holds an
    /// UNUSED neighbor.
    bool unblocked = false;
    /// §6.3: after a removal the point before it is tested again.
    bool stepBack = false;
    /// §7: a boundary point whose ring neighbors both share a wall with it is complete, and no
    /// candidate.
    bool wallsDone = false;
    /// §7.2: a third point is put beside a boundary point only if its other ring neighbor shares a
    /// wall with it; else the side toward that neighbor would stay open permanently.
    bool bothWalls = false;
    /// A candidate that would use a directed edge twice, or close an edge without meeting its ring
    /// entries, is dropped: the mesh is an oriented manifold on any input, and every run ends.
    bool guard = false;
    /// A fan with a gap of 180 degrees or more between two neighbors is not made.
    bool gap = false;
    /// No second triangle on the same three points.
    bool noPillow = false;
    /// A candidate with a new edge that crosses a ring edge nearby, in projection along the pivot's
    /// normal, is dropped.
    bool noCross = false;
    /// A candidate with a triangle against the normal of one of its corners, or folded onto the
    /// triangle across an old edge, is dropped.
    bool noFold = false;
    /// A candidate with a triangle that meets a finished one nearby is dropped.
    bool noMeet = false;
    /// A candidate with a triangle that is a second layer of a finished one nearby is dropped.
    bool noLayer = false;
    /// Where the neighbors of all three corners leave a wide gap, the surface ends: no triangle
    /// over more than 120 degrees there, and a ring of mostly such points is an opening. Points are
    /// prepared with their rims (prepareOptionsOf()).
    bool rim = false;
    /// Fans with steep triangles wait until a circuit of the ring brought no triangle.
    bool delay = false;
    /// A ring without a triangle in a full circuit, after delayed fans were tried, is shelved
    /// instead of being freed: its points stay USED, and other components may join it. When no seed
    /// is left, it is taken up again.
    bool shelve = false;
    /// A ring that would be freed is closed by ears, best least angle first, unless it is too long
    /// or too wide, or an opening. One of up to five is an opening only where the surface ends at
    /// every point and the ring runs around a patch.
    bool fill = false;
    /// After the last pivot: a component of a few triangles beside a larger one is taken out; in
    /// the third round, at each point, all fans but the largest. `reinsert` may put their points
    /// back.
    bool dropPatches = false;
    /// After the last pivot: a stranded point takes the place of the triangles it lies over.
    bool reinsert = false;
    /// After the last pivot: a hole is filled with triangles between its points, if none of them
    /// has a fault.
    bool closeHoles = false;
    /// After the last pivot: edges whose flip improves the two triangles are flipped.
    bool flip = false;
    /// After the last pivot: the triangles about a faulty one are replaced by others between the
    /// same points, if none of them has a fault.
    bool remesh = false;

    /// True if some rule examines the whole fan before it is made.
    bool looksAtFan() const {
        return guard || gap || noPillow || noCross || noFold || noMeet || noLayer || rim || delay;
    }
    /// True if some rule examines finished triangles.
    bool needsEdges() const {
        return guard || noPillow || noFold || noMeet || noLayer || rim || fill;
    }

    friend bool operator==(const RobustRules&, const RobustRules&) = default;
};

/// §6.1: the one of two neighbors at the same angle that stays.
enum class TieRule : std::uint8_t {
    Nearest,   ///< "the point closest to p is included", as printed.
    Farthest,  ///< The other one.
    Both,      ///< Both: no such rule.
};
/// §6.1: the direction in which angles grow.
enum class TurnRule : std::uint8_t {
    Counterclockwise,  ///< n = normal x z, the reading of docs/choices.md.
    Clockwise,         ///< n = z x normal, "the cross product of z and p's normals".
};
/// §6.5: the entry of an already USED point that is its "other instance".
enum class InstanceRule : std::uint8_t {
    Sector,  ///< The first one whose sector holds p.
    First,   ///< "the first other instance of the point in the edge ring", as printed.
};
/// §6.3: the treatment of a point exactly on the sphere.
enum class OnSphereRule : std::uint8_t { Removed, Kept };
/// §6.4: the neighbor rings of first and last alone that are discarded.
enum class TwoPointRule : std::uint8_t {
    Over,  ///< Those over 180 degrees, as printed.
    From,  ///< Those of exactly 180 degrees as well.
    None,  ///< None but the full turn, which has no triangle.
};
/// §6.5: the part of a split ring that stays active; the other is pushed.
enum class ActiveRule : std::uint8_t { End, Other, Longer, Shorter };
/// §6.5: the stacked ring that is popped next.
enum class StackRule : std::uint8_t { Last, First };
/// §6.5: the point at which the traversal continues after triangles.
enum class NextRule : std::uint8_t { End, Start };

/// The paper's own rules, which can be switched off or varied to show the purpose of each. The
/// defaults are the paper's, or the readings of docs/choices.md.
struct PaperRules {
    TieRule tie = TieRule::Nearest;                 ///< §6.1
    TurnRule turn = TurnRule::Counterclockwise;     ///< §6.1
    bool maxAngle = true;                           ///< §6.1, Fig. 3: nothing beyond last.
    bool limits = true;                             ///< §6.1, Fig. 4: start and end advance,
    bool concave = true;                            ///< ... only where the ring is concave.
    bool convex = true;                             ///< §6.1, Fig. 5: the convexity test,
    bool convexShared = false;                      ///< ... of each point beyond a convex one.
    bool reciprocal = true;                         ///< §6.1, Fig. 6
    std::uint32_t holeSize = 3;                     ///< §6.2: largest hole known; 0: none.
    bool sphere = true;                             ///< §6.3: the test by the circumsphere.
    OnSphereRule onSphere = OnSphereRule::Removed;  ///< §6.3
    TwoPointRule twoPoint = TwoPointRule::Over;     ///< §6.4, Fig. 9
    InstanceRule instance = InstanceRule::Sector;   ///< §6.5
    ActiveRule active = ActiveRule::End;            ///< §6.5
    StackRule stack = StackRule::Last;              ///< §6.5
    NextRule next = NextRule::End;                  ///< §6.5
    bool walls = true;                              ///< §7: boundary points are passed over.
    bool thirdPoint = true;                         ///< §7.1
    bool stayInside = true;                         ///< §7.1, §7.2: no sector out of the box.
    bool corners = true;                            ///< §7.2

    friend bool operator==(const PaperRules&, const PaperRules&) = default;
};

/// Thresholds of the rules beyond the paper (docs/robust.md). Angles are stored as their cosines,
/// so that no trigonometry decides.
struct RobustThresholds {
    /// RobustRules::noFold: two triangles at an edge, 150.
    double foldCosine = -0.8660254037844386;
    double steepCosine = 0.5;    ///< RobustRules::delay: off a corner's normal, 60.
    double rimGapCosine = -0.5;  ///< RobustRules::rim: between neighbors, 120.
    /// RobustRules::rim: of a triangle at the pivot, 120.
    double rimAngleCosine = -0.5;
    double openingWidth = 2.5;  ///< RobustRules::rim: of an opening, in its edges.
    double flatCosine =
        /// RobustRules::noMeet: tested where normals are farther apart, 45.
        0.70710678118654752;
    double flipFlatCosine = 0.9;     ///< RobustRules::flip: two triangles of a flat piece.
    double flipNarrowCosine = 0.94;  ///< RobustRules::flip: the least angle of a narrow one.

    friend bool operator==(const RobustThresholds&, const RobustThresholds&) = default;
};

inline constexpr double kRightAngle = 0.0;  ///< Its cosine.
/// Cosine of 105 degrees: normals of one surface differ by less at its edges, most of which are
/// right angles, than those of two sheets that face away from each other.
inline constexpr double kSheetsCosine = -0.25881904510252076;

/// All parameters of the stepper. Equal points and equal Params give equal steps.
struct Params {
    Readings readings;
    RobustRules robust;
    PaperRules paper;
    /// §6.3: a point whose removal would leave a gap of more than 120 degrees is kept. Stored as
    /// the cosine of that angle, so that no trigonometry decides; -1/2 is exact. Range (-1, 0].
    double maxGapCosine = -0.5;
    /// §6.1: two points with angles nearer than this count as "the same angle". In units of
    /// 1 - cos(angle); grids give equal angles only up to rounding.
    double sameAngle = 1e-12;
    /// The run stops with AlertKind::TriangleCap when it holds more triangles than this times the
    /// number of points: the paper's own rules need not end on tangled input.
    std::uint32_t maxTrianglesPerPoint = 8;
    /// RobustRules::fill closes rings of at most this many entries.
    std::uint32_t maxFillLength = 64;
    /// ... and of at most this width, in mean distances of its points to their nearest neighbor.
    double maxFillWidth = 48.0;
    /// The user's limit: RobustRules::closeHoles fills openings of at most this width as well, and
    /// wider holes stay open. In the unit of the points, as LoopShape::width(); 0: no limit.
    double maxHoleWidth = 0.0;
    /// ... and of at most this many edges; 0: no limit.
    std::uint32_t maxHoleEdges = 0;
    RobustThresholds thresholds;
    /// Opposing normals are left out of neighbor lists that are computed (see prepare.h).
    bool dropOpposingNormals = true;
    /// ... from this angle between normals on; held as its cosine. 105 degrees in `robust`.
    double opposingCosine = kRightAngle;
    /// Points are left out where noise is as wide as their spacing (see noise.h). On in `robust`.
    bool setNoiseAside = false;
    /// Points far from all others are left out (see strays.h). On in `corrected` and `robust`.
    bool setStraysAside = false;
    /// Overrides of single decisions by the user; empty: the rules decide everything.
    std::vector<WhatIf> whatIf = {};
    /// The state that the run begins with; empty: nothing is made yet.
    GivenStart start = {};

    /// True if the user limits the holes that are closed.
    bool limitsHoles() const { return maxHoleWidth > 0.0 || maxHoleEdges > 0; }
    /// True if a loop of this width and number of edges is within the user's limits.
    bool isWithinHoleLimits(double width, std::size_t edges) const {
        return (maxHoleWidth == 0.0 || width <= maxHoleWidth) &&
               (maxHoleEdges == 0 || edges <= maxHoleEdges);
    }

    friend bool operator==(const Params&, const Params&) = default;
};

/// A named set of params: `paper` (the default: the reading of docs/choices.md), `printed` (the
/// letter: each setting at the value of the sentence that its row of ruleSettings() quotes, for
/// teaching), `corrected` or `robust` (with rules beyond the paper). Where the paper has no
/// sentence, `printed` takes the default of Params; its rules need not end, and
/// maxTrianglesPerPoint ends them. Empty if there is no such set.
std::optional<Params> paramsByName(std::string_view name);
/// The names that paramsByName() accepts.
std::span<const std::string_view> paramSetNames();

}  // namespace se
