/// A pivot played move by move: the moves of the run, those of a user, and the first that differs.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_name.h"
#include "spiraling_edge/stepper/event.h"

namespace se::teach {

/// Kind of a move, in the order in which a pivot is played.
enum class MoveKind : std::uint8_t {
    MoveStart,  ///< §6.1, Fig. 4: start advances to a point of the ring.
    MoveEnd,    ///< §6.1, Fig. 4: end advances to a point of the ring.
    Keep,       ///< §6.1 to §6.3: a candidate becomes a point of the fan.
    Remove,     ///< §6.1 to §6.3: a candidate is left out.
    Fan,        ///< §6.4: the points of the fan, from first to last; none: no triangle.
    NextPivot,  ///< §6.5; none: no ring is left.
};

/// One row of the table of moves.
struct MoveRow {
    MoveKind id;
    std::string_view name;  ///< "start", the first word of its line.
    std::string_view help;  ///< One sentence for the user.
};
/// All kinds of moves, in the order of the enum.
std::span<const MoveRow> moveTable();
const MoveRow& rowOf(MoveKind kind);

/// One move.
struct PlayMove {
    MoveKind kind = MoveKind::Fan;
    std::vector<Index> points;  ///< One; of Fan any number, of NextPivot at most one.
    friend bool operator==(const PlayMove&, const PlayMove&) = default;
};
/// "keep 17", "fan 20 9 31 39", "next none"; points by their names.
std::string moveText(const PlayMove& move, const std::vector<PointName>& names = {});
/// Reads moveText(). Fails with a sentence that names what was expected.
Result<PlayMove> moveFromText(std::string_view text, const std::vector<PointName>& names = {});

/// The last decision of a pivot about a point, up to a stage; of entries at which the reciprocal
/// test was made, one that kept it, if any did; of a point that start or end moved to, that move.
/// Null if there is none.
const Event* decisionAbout(std::span<const Event> events, Index point, Stage last);

/// A move of the run, and the decision that it stands for.
struct RunMove {
    PlayMove move;
    Event event;
};
/// The moves of a pivot from all of its events: moves of start, then of end, then one for each
/// candidate of the angle sort by increasing angle (but those that start or end moved to), the fan,
/// the next pivot. Empty if the pivot was passed over.
std::vector<RunMove> movesOfRun(std::span<const Event> events);
/// The moves alone.
std::vector<PlayMove> movesOf(const std::vector<RunMove>& moves);

/// The number of moves before the first that differs; that of `right` if none does.
std::size_t movesAlike(std::span<const PlayMove> given, std::span<const PlayMove> right);

/// The decision of the run that a wrong move contradicts. `expected`: the move of the run in its
/// place; null if the run has no further one. Null if no decision is about it. Requires a point in
/// `given`, unless it is a fan or the next pivot.
const Event* decisionAgainst(std::span<const Event> events, const PlayMove& given,
                             const RunMove* expected);

/// The reason why a move was wrong, by the decision against it, for users who go on trying: for the
/// next pivot the rule alone.
std::string moveReasonText(const Event& event, std::span<const PointName> names);

}  // namespace se::teach
