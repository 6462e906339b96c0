/// The few things that can be set, with the paper's values as defaults.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace se {

/// How each place is read where the paper is silent, ambiguous or measurably wrong. Every switch is
/// one line in the table of ruleSwitches(); docs/choices.md says why each reading was taken.
/// A switch that is off means: the printed sentence, word for word.
struct Rules {
    /// §6.1, Fig. 6: the reciprocal test takes the sector from e's predecessor counterclockwise to
    /// its successor, the side that is still free. Off: "preceding and succeeding ... (elast and
    /// efirst)" as printed, which is the finished side.
    bool freeSector = true;
    /// §6.1, Fig. 4: start and end advance before other neighbors are looked at, until nothing
    /// moves. Off: as the neighbors come in list order, each looked at once.
    bool limitsFirst = true;
    /// §6.2: a hole of three needs a third side that is an edge of the mesh, and a sector below 180
    /// degrees. Off: three entries on the ring are enough.
    bool realHole = true;
    /// §6.5: a ring of two entries whose two steps are both mesh edges is one finished edge and is
    /// closed. Off: it stays and is taken for a fresh ring of two.
    bool closeTwo = true;
    /// §7: steps that are no mesh edges (a fresh ring of two; beside a point inserted by 7.1 or
    /// 7.2) are known as open, and no rule takes them for edges. Off: every step counts as an edge.
    bool openSteps = true;

    // Beyond the paper (docs/robust.md): off in the sets `paper` and `printed`.

    /// §6.1: angles are measured in the tangent plane of the pivot, not between 3-D vectors.
    bool tangent = false;
    /// §6.1, Fig. 4: start and end do not advance over a triangle whose circumsphere holds an
    /// UNUSED neighbor.
    bool unblocked = false;
    /// §6.3: after a removal the point before it is looked at again.
    bool stepBack = false;
    /// §7: a boundary point whose ring neighbors both share a wall with it is complete, and no
    /// candidate.
    bool wallsDone = false;

    friend bool operator==(const Rules&, const Rules&) = default;
};

/// One row of the table of rule switches.
struct RuleSwitch {
    std::string_view name;     ///< As on the command line: `closetwo`.
    std::string_view section;  ///< "6.5"
    std::string_view summary;  ///< One sentence: what "on" does.
    bool Rules::*member;
};

/// All switches, in the order of the paper.
std::span<const RuleSwitch> ruleSwitches();

/// Everything the stepper can be told. Equal points and equal Params give equal steps.
struct Params {
    Rules rules;
    /// §6.3: a point whose removal would leave a gap of more than 120 degrees is kept. Stored as
    /// the cosine of that angle, so that no trigonometry decides; -1/2 is exact. Range (-1, 0].
    double maxGapCosine = -0.5;
    /// §6.1: two points with angles nearer than this count as "the same angle". In units of
    /// 1 - cos(angle); grids give equal angles only up to rounding.
    double sameAngle = 1e-12;
    /// The run stops with AlertKind::TriangleCap when it holds more triangles than this times the
    /// number of points: the paper's own rules need not end on tangled input.
    std::uint32_t maxTrianglesPerPoint = 8;
    /// Opposing normals are left out of neighbor lists that are computed (see prepare.h).
    bool dropOpposingNormals = true;

    friend bool operator==(const Params&, const Params&) = default;
};

/// A named set of params: `paper` (the default: the reading of docs/choices.md) or `printed` (the
/// paper word for word, for teaching). Empty if there is no such set.
std::optional<Params> paramsByName(std::string_view name);
/// The names that paramsByName() knows.
std::span<const std::string_view> paramSetNames();

}  // namespace se
