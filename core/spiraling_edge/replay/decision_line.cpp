#include "spiraling_edge/replay/decision_line.h"

#include <array>

namespace se {

std::string_view roleName(LineRole role) {
    constexpr std::array<std::string_view, 5> kNames{"fact", "taken", "refused", "made", "undone"};
    return kNames[static_cast<std::size_t>(role)];
}

LedgerLine lineOf(const Event& event, const ReadingContext& context) {
    const Outcome outcome = outcomeOf(event);
    const LineRole role = outcome == Outcome::Taken ? LineRole::Taken
                          : isAgainst(outcome)      ? LineRole::Refused
                                                    : LineRole::Fact;
    return {event, context.pivot, role, readingOf(event, context)};
}

bool wasSettledBefore(const Event& event) {
    const auto* sort = std::get_if<SortEvidence>(&event.evidence);
    return sort != nullptr &&
           (sort->verdict == Verdict::AlreadyDone || sort->verdict == Verdict::OnRingEnd);
}

bool editsMesh(const Event& event) {
    return std::holds_alternative<FlipEvidence>(event.evidence) ||
           std::holds_alternative<RemoveFoldedEvidence>(event.evidence) ||
           std::holds_alternative<ReinsertEvidence>(event.evidence);
}

}  // namespace se
