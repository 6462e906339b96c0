/// The matching cursor position in another run over the same points: with other rules, or a
/// what-if.
#pragma once

#include <functional>
#include <string>

#include "spiraling_edge/run/pivot_record.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"

namespace se::view {

/// Target of the cursor in a run with other rules.
enum class Resume : std::uint8_t {
    SamePosition,  ///< The same position by state, see findSamePosition().
    End,           ///< To the end of the new run.
};

/// A run, by its inputs.
struct RunInput {
    const PointSet& points;
    const Params& params;
};

/// Cursor position in the old run.
struct CursorPosition {
    Address address;
    Index subject = kNone;  ///< Subject point of the event.
    bool atEnd = false;     ///< No event of the run follows.
};

/// Cursor position in the new run.
struct SamePosition {
    enum class Kind : std::uint8_t {
        Start,    ///< It was at the start of the run.
        End,      ///< It was at the end of the run.
        Same,     ///< The same pivot of the same component: the same point, for the same number of
                  ///< times.
        Earlier,  ///< There is no such pivot: the nearest earlier state that both runs share.
    };
    Kind kind = Kind::Start;
    CursorPosition from;
    std::uint32_t pivot = 0;
    Index point = kNone;     ///< The pivot that was searched for.
    std::uint32_t part = 0;  ///< The first pivot in which the runs differ; 0: no difference found.
};

/// Runs both as far as needed; empty if `keepGoing` returns false. A component is identified
/// by its first pivot, a pivot by its point and by how often that was pivot of the component
/// before. Deterministic. O(both runs).
std::optional<SamePosition> findSamePosition(const RunInput& before, const CursorPosition& from,
                                             const RunInput& after,
                                             const std::function<bool()>& keepGoing = {});

/// The matching event of a pivot in the new run: the same test of the same point; otherwise another
/// test of that stage, or the end of the last stage before it.
std::size_t sameStep(const PivotRecord& record, const SamePosition& place);

/// The new cursor position and the reason for it: one sentence, shown as a notice.
std::string describe(const SamePosition& place, const Address& landed);

}  // namespace se::view
