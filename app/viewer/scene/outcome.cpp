#include "outcome.h"

#include "spiraling_edge/replay/reading.h"

namespace se::view {

std::optional<Color> outcomeColor(const Palette& palette, const Event& event) {
    if (std::holds_alternative<AlertEvidence>(event.evidence)) return palette.rejected;
    const std::optional<Verdict> verdict = verdictOf(event);
    if (!verdict) return std::nullopt;
    // Where start or end is now.
    if (*verdict == Verdict::Moved) return palette.test;
    const Outcome outcome = rowOf(*verdict).outcome;
    if (outcome == Outcome::Taken) return palette.used;
    if (outcome == Outcome::Refused) return palette.rejected;
    return outcome == Outcome::Unchanged ? palette.textDim : palette.test;
}

}  // namespace se::view
