// One pass over the whole run with the log of one pivot at a time. Each pivot is reduced to 16
// bytes (a bit per stage and verdict, and counts), by which the filter of the tree can test it
// without running it again. The thread hands over what is new in batches; append() adds them to
// the lists of the window.
#include "overview.h"

#include <algorithm>
#include <array>
#include <limits>

#include "picture.h"
#include "spiraling_edge/replay/reading.h"

namespace se::view {

namespace {

template <typename T>
void appendList(std::vector<T>& list, const std::vector<T>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

void countUp(std::uint16_t& number) {
    if (number < std::numeric_limits<std::uint16_t>::max()) ++number;
}

/// Counts the new pivots of `overview` for their components.
void countComponents(RunOverview& overview, const std::vector<PivotSummary>& fresh) {
    auto pivot = static_cast<std::uint32_t>(overview.pivots.size() - fresh.size());
    for (const PivotSummary& summary : fresh) {
        ++pivot;
        if ((summary.found & findingOf(Stage::Seed)).any() || overview.components.empty()) {
            overview.components.push_back({pivot, 0, 0});
        }
        overview.components.back().tests += summary.tests;
        overview.components.back().refused += summary.refused;
    }
}

}  // namespace

Stage stageOf(MarkKind kind) {
    // In the order of the enum.
    constexpr std::array kStages = {Stage::Seed, Stage::Split, Stage::Join, Stage::Done};
    static_assert(kStages.size() == static_cast<std::size_t>(MarkKind::Alert) + 1);
    return kStages[static_cast<std::size_t>(kind)];
}

void count(PivotSummary& summary, const Event& event) {
    summary.found |= findingOf(event.address.stage);
    if (const auto verdict = verdictOf(event)) {
        summary.found |= findingOf(*verdict);
        countUp(summary.tests);
        if (rejects(event)) countUp(summary.refused);
    }
    const bool names =
        std::holds_alternative<PivotEvidence>(event.evidence) || summary.point == kNone;
    if (names && event.address.stage != Stage::Seed) summary.point = subjectOf(event);
}

void append(RunOverview& overview, const RunOverview& fresh) {
    appendList(overview.ringLength, fresh.ringLength);
    appendList(overview.stackDepth, fresh.stackDepth);
    appendList(overview.triangles, fresh.triangles);
    appendList(overview.pivots, fresh.pivots);
    countComponents(overview, fresh.pivots);
    appendList(overview.marks, fresh.marks);
    appendList(overview.shapes, fresh.shapes);
    appendList(overview.laneChanges, fresh.laneChanges);
    appendList(overview.failures, fresh.failures);
    overview.lanes = std::max(overview.lanes, fresh.lanes);
    overview.longestRing = std::max(overview.longestRing, fresh.longestRing);
    overview.deepestStack = std::max(overview.deepestStack, fresh.deepestStack);
    overview.lastPivot = std::max(overview.lastPivot, fresh.lastPivot);
    overview.complete = fresh.complete;
}

std::span<const LiveFailure> failuresAt(const RunOverview& run, const Address& address) {
    // Within a pivot a strand may come before a seed: only the pivots are guaranteed to be in
    // order.
    const auto begin = std::partition_point(
        run.failures.begin(), run.failures.end(),
        [&](const LiveFailure& each) { return each.address.pivot < address.pivot; });
    const auto first = std::find_if(begin, run.failures.end(), [&](const LiveFailure& each) {
        return each.address.pivot > address.pivot || each.address == address;
    });
    const auto last = std::find_if_not(first, run.failures.end(), [&](const LiveFailure& each) {
        return each.address == address;
    });
    return std::span(run.failures)
        .subspan(static_cast<std::size_t>(first - run.failures.begin()),
                 static_cast<std::size_t>(last - first));
}

std::size_t noticedUpTo(const RunOverview& run, const Address& address) {
    const auto end = std::partition_point(
        run.failures.begin(), run.failures.end(),
        [&](const LiveFailure& each) { return each.address.pivot <= address.pivot; });
    return static_cast<std::size_t>(end - run.failures.begin());
}

}  // namespace se::view
