/// Where a cursor belongs in another run over the same points: other rules, or a what-if.
#pragma once

#include <functional>
#include <string>

#include "pivot_record.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"

namespace se::view {

/// Where the cursor goes in a run by other rules.
enum class Resume : std::uint8_t {
    SamePlace,  ///< Where it is by state, as findSamePlace() says.
    End,        ///< To the end of the new run.
};

/// A run, by what decides it.
struct RunInput {
    const PointSet& points;
    const Params& params;
};

/// Where the cursor stands in the old run.
struct CursorPlace {
    Address address;
    Index subject = kNone;  ///< The point that the event is about.
    bool atEnd = false;     ///< Nothing more happens in the run.
};

/// Where it belongs in the new one.
struct SamePlace {
    enum class Kind : std::uint8_t {
        Start,    ///< It stood at the start of the run.
        End,      ///< It stood at the end of the run.
        Same,     ///< The same pivot of the same component: so many times that point was pivot.
        Earlier,  ///< There is no such pivot: the nearest earlier state that both runs share.
    };
    Kind kind = Kind::Start;
    CursorPlace from;
    std::uint32_t pivot = 0;
    Index point = kNone;     ///< The pivot that was looked for.
    std::uint32_t part = 0;  ///< The first pivot in which the runs differ; 0: not found to differ.
};

/// Goes through both runs, as far as it takes; nothing if `keepGoing` says no. A component is known
/// by its first pivot, a pivot by its point and by how often that was pivot of the component
/// before. Deterministic. O(both runs).
std::optional<SamePlace> findSamePlace(const RunInput& before, const CursorPlace& from,
                                       const RunInput& after,
                                       const std::function<bool()>& keepGoing = {});

/// The event of the pivot at which the sub-step of the old run belongs: the same test of the same
/// point; else another test of that stage, or the end of the last stage before it.
std::size_t sameStep(const PivotRecord& record, const SamePlace& place);

/// Where the cursor landed and why: one sentence for the status bar.
std::string describe(const SamePlace& place, const Address& landed);

}  // namespace se::view
