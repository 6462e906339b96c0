#include "run_answers.h"

#include <algorithm>
#include <array>

#include "find_named.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/why/figure_check.h"

namespace se::teach {
namespace {

/// True for a neighbor that was left out by a fact before any test: DONE, or first or last itself.
bool isSettled(const CandidateMark& mark) {
    return mark.verdict == Verdict::AlreadyDone || mark.verdict == Verdict::OnRingEnd;
}

std::vector<Index> candidatesIn(const DecisionState& state, CandidateState which) {
    std::vector<Index> points;
    for (const CandidateMark& mark : state.candidates) {
        if (mark.state == which && !isSettled(mark)) points.push_back(mark.point);
    }
    std::sort(points.begin(), points.end());
    return points;
}

RunValue refusedPoints(const RunRange& range) {
    const std::vector<Index> before = candidatesIn(range.before, CandidateState::Rejected);
    const std::vector<Index> after = candidatesIn(range.after, CandidateState::Rejected);
    RunValue value;
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                        std::back_inserter(value.points));
    return value;
}

RunValue keptPoints(const RunRange& range) {
    return {.points = candidatesIn(range.after, CandidateState::Kept)};
}

RunValue fanPoints(const RunRange& range) {
    RunValue value;
    for (const RingPoint& each : range.after.fan()) value.points.push_back(each.point);
    return value;
}

RunValue onePoint(Index point) {
    if (point == kNone) return {};
    return {.points = {point}};
}
RunValue nextPivot(const RunRange& range) {
    for (const Event& event : range.events) {
        if (const auto* advance = as<AdvanceEvidence>(event); advance && advance->to != kNone)
            return onePoint(advance->to);
    }
    return {};
}
RunValue startPoint(const RunRange& range) { return onePoint(range.after.start); }
RunValue endPoint(const RunRange& range) { return onePoint(range.after.end); }

RunValue verdictThere(const RunRange& range) {
    if (range.events.empty()) return {};
    return {.outcome = outcomeText(range.events.back())};
}

RunValue playedMoves(const RunRange& range) {
    // Within a pivot its first decisions are known already.
    if (!range.before.candidates.empty() && !range.before.complete) return {};
    return {.moves = movesOf(movesOfRun(range.events))};
}

RunValue numberOf(std::size_t count) { return {.number = static_cast<double>(count)}; }

RunValue triangleCount(const RunRange& range) {
    return numberOf(range.trianglesAfter - std::min(range.trianglesBefore, range.trianglesAfter));
}
template <bool kInserted>
RunValue ringChanges(const RunRange& range) {
    return numberOf(static_cast<std::size_t>(
        std::count_if(range.events.begin(), range.events.end(), [](const Event& event) {
            const auto* ring = as<RingEvidence>(event);
            return ring != nullptr && ring->inserted == kInserted;
        })));
}
RunValue refusedCount(const RunRange& range) {
    return numberOf(refusedPoints(range).points.size());
}
RunValue keptCount(const RunRange& range) { return numberOf(keptPoints(range).points.size()); }

/// Entries of a ring; 0 without one.
RunValue lengthOf(std::span<const RingPath> rings) {
    return numberOf(rings.empty() ? 0 : rings.front().points.size());
}
RunValue activeLength(const RunRange& range) {
    const std::vector<RingPath>& rings = range.after.rings;
    return lengthOf({rings.data(), rings.size() - stackedCount(rings)});
}
RunValue stackedLength(const RunRange& range) {
    const std::span<const RingPath> rings = range.after.rings;
    return lengthOf(rings.last(stackedCount(rings)));
}
RunValue ringCount(const RunRange& range) { return numberOf(range.after.rings.size()); }

constexpr std::array kRunAnswers{
    RunAnswer{"refused", "points", "the points refused after `at`, up to `until`", refusedPoints},
    RunAnswer{"kept", "points", "the neighbors that are left at `until`", keptPoints},
    RunAnswer{"fan", "points", "the points of the fan at `until`, first and last included",
              fanPoints},
    RunAnswer{"next", "point", "the next pivot", nextPivot},
    RunAnswer{"start", "point", "the point at start of the neighbor ring at `until`", startPoint},
    RunAnswer{"end", "point", "the point at end of the neighbor ring at `until`", endPoint},
    RunAnswer{"verdict", "choice", "the outcome of the decision at `until`", verdictThere},
    RunAnswer{"moves", "play", "the moves of the pivot that begins at `at`", playedMoves},
    RunAnswer{"count:triangles", "number", "the triangles made after `at`, up to `until`",
              triangleCount},
    RunAnswer{"count:enter", "number", "the points that enter the edge ring", ringChanges<true>},
    RunAnswer{"count:leave", "number", "the points that leave the edge ring", ringChanges<false>},
    RunAnswer{"count:refused", "number", "how many are refused", refusedCount},
    RunAnswer{"count:kept", "number", "how many neighbors are left at `until`", keptCount},
    RunAnswer{"count:ring", "number", "the entries of the active edge ring at `until`",
              activeLength},
    RunAnswer{"count:stack", "number", "the entries of the ring on top of the stack at `until`",
              stackedLength},
    RunAnswer{"count:rings", "number", "the edge rings at `until`", ringCount},
};

}  // namespace

bool isOutcome(std::string_view words, std::string_view outcome) {
    if (words.empty() || !outcome.starts_with(words)) return words == outcome;
    const std::string_view rest = outcome.substr(words.size());
    return rest.empty() || rest.front() == ' ' || rest.front() == ',';
}

bool isPossibleOutcome(std::string_view words) {
    const std::vector<std::string_view> known = outcomeWords();
    return std::any_of(known.begin(), known.end(), [&](std::string_view each) {
        if (isOutcome(words, each)) return true;
        // As in "splits into 19 and 13", "leaves, DONE".
        const std::string_view rest = words.substr(std::min(each.size(), words.size()));
        return isOutcome(each, words) &&
               (rest == ", DONE" || rest.find_first_of("0123456789") != std::string_view::npos);
    });
}

std::span<const RunAnswer> runAnswers() { return kRunAnswers; }

const RunAnswer* findRunAnswer(std::string_view name) { return findNamed(kRunAnswers, name); }

}  // namespace se::teach
