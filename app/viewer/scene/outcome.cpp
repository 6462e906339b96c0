#include "outcome.h"

#include "spiraling_edge/replay/reading.h"

namespace se::view {

std::optional<Color> outcomeColor(const Palette& palette, const Event& event) {
    if (std::holds_alternative<AlertEvidence>(event.evidence)) return palette.rejected;
    const std::optional<Verdict> verdict = verdictOf(event);
    if (!verdict) return std::nullopt;
    // Where start or end is now.
    if (*verdict == Verdict::Moved) return palette.test;
    switch (rowOf(*verdict).outcome) {
        case Outcome::Taken:
            return palette.used;
        case Outcome::Refused:
            return palette.rejected;
        case Outcome::Unchanged:
            return palette.textDim;
        case Outcome::None:
            return palette.test;
    }
    return palette.textDim;
}

}  // namespace se::view
