#include "outcome.h"

#include "run/picture.h"
#include "spiraling_edge/replay/reading.h"

namespace se::view {

std::optional<Color> outcomeColor(const Palette& palette, const Event& event) {
    if (std::holds_alternative<AlertEvidence>(event.evidence)) return palette.rejected;
    const std::optional<Verdict> verdict = verdictOf(event);
    if (!verdict) return std::nullopt;
    if (rejects(event)) return palette.rejected;
    const auto* drop = std::get_if<DropEvidence>(&event.evidence);
    if (drop != nullptr && drop->isLimit) return palette.test;
    switch (*verdict) {
        case Verdict::Kept:
        case Verdict::InsideSphere:
        case Verdict::GapTooWide:
        case Verdict::NoCircle:
        case Verdict::Hole:
        case Verdict::Before:
        case Verdict::After:
        case Verdict::WhatIfKept:
            return palette.used;
        case Verdict::Moved:
            return palette.test;
        default:
            return palette.textDim;
    }
}

}  // namespace se::view
