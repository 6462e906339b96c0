#include "spiraling_edge/explain/pivot_tests.h"

#include <algorithm>

#include "spiraling_edge/replay/reading.h"

namespace se {
namespace {

/// The last line for which `isCorner` holds for the point it took, or for both sides of a gap.
template <typename Test>
std::optional<LedgerLine> lastOf(const std::vector<LedgerLine>& decided, const Test& isCorner) {
    const auto found = std::find_if(decided.rbegin(), decided.rend(), [&](const LedgerLine& line) {
        if (const SphereEvidence* gap = closedGap(line.event))
            return isCorner(gap->t) && isCorner(gap->s);
        return !fillsHole(line.event) && isCorner(testedPoint(line.event));
    });
    return found == decided.rend() ? std::nullopt : std::optional(*found);
}

}  // namespace

bool hasCorner(const Triangle& t, Index p) { return t.a == p || t.b == p || t.c == p; }

bool fillsHole(const Event& event) {
    const auto* two = std::get_if<TwoPointEvidence>(&event.evidence);
    return two != nullptr && two->verdict == Verdict::Hole;
}

const SphereEvidence* closedGap(const Event& event) {
    const auto* sphere = std::get_if<SphereEvidence>(&event.evidence);
    return sphere != nullptr && sphere->verdict == Verdict::Removed ? sphere : nullptr;
}

std::optional<LedgerLine> lastDecision(const std::vector<LedgerLine>& decided,
                                       const Triangle& made) {
    return lastOf(decided, [&](Index p) { return hasCorner(made, p); });
}

std::optional<LedgerLine> lastDecision(const std::vector<LedgerLine>& decided, Index a, Index b) {
    return lastOf(decided, [&](Index p) { return p == a || p == b; });
}

}  // namespace se
