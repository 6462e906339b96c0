#include "spiraling_edge/replay/pivot_tally.h"

#include "spiraling_edge/replay/reading.h"

namespace se {

PivotTally tallyOf(std::span<const Event> events) {
    PivotTally tally;
    for (const Event& event : events) {
        if (const auto* pivot = std::get_if<PivotEvidence>(&event.evidence))
            tally.ringLength = pivot->ringLength;
        const Outcome outcome = outcomeOf(event);
        if (outcome == Outcome::None) continue;
        ++tally.tests;
        const bool sorted = std::holds_alternative<SortEvidence>(event.evidence);
        if (sorted && outcome == Outcome::Taken) ++tally.candidates;
    }
    return tally;
}

}  // namespace se
