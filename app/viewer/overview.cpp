#include "overview.h"

#include <algorithm>
#include <chrono>

#include "spiraling_edge/stepper.h"

namespace se::view {

namespace {

constexpr std::chrono::milliseconds kHandOver{60};

template <typename T>
void appendList(std::vector<T>& list, const std::vector<T>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

void noteMarks(RunOverview& run, const Counters& before, const State& state, std::size_t alerts) {
    const Counters& now = state.counters;
    const std::uint32_t pivot = now.pivots;
    if (now.seeds > before.seeds) run.marks.push_back({pivot, MarkKind::Seed});
    if (now.splits > before.splits) run.marks.push_back({pivot, MarkKind::Split});
    if (now.joins > before.joins) run.marks.push_back({pivot, MarkKind::Join});
    if (state.alerts.size() > alerts) run.marks.push_back({pivot, MarkKind::Alert});
}

void noteFigures(RunOverview& run, const State& state) {
    const EdgeRings& rings = state.rings;
    const std::uint32_t length = rings.active() == kNone ? 0 : rings.length(rings.active());
    const auto depth = static_cast<std::uint32_t>(rings.stack().size());
    run.ringLength.push_back(length);
    run.stackDepth.push_back(depth);
    run.triangles.push_back(static_cast<std::uint32_t>(state.triangles.size()));
    run.longestRing = std::max(run.longestRing, length);
    run.deepestStack = std::max(run.deepestStack, depth);
    run.lastPivot = state.counters.pivots;
}

}  // namespace

Stage stageOf(MarkKind kind) {
    switch (kind) {
        case MarkKind::Seed:
            return Stage::Seed;
        case MarkKind::Split:
            return Stage::Split;
        case MarkKind::Join:
            return Stage::Join;
        case MarkKind::Alert:
            return Stage::Done;
    }
    return Stage::Pivot;
}

void append(RunOverview& overview, const RunOverview& fresh) {
    appendList(overview.ringLength, fresh.ringLength);
    appendList(overview.stackDepth, fresh.stackDepth);
    appendList(overview.triangles, fresh.triangles);
    appendList(overview.marks, fresh.marks);
    overview.longestRing = std::max(overview.longestRing, fresh.longestRing);
    overview.deepestStack = std::max(overview.deepestStack, fresh.deepestStack);
    overview.lastPivot = std::max(overview.lastPivot, fresh.lastPivot);
    overview.complete = fresh.complete;
}

OverviewThread::OverviewThread(std::shared_ptr<const Model> model)
    : model_(std::move(model)), thread_([this](const std::stop_token& stop) { work(stop); }) {}

bool OverviewThread::update(RunOverview& overview) {
    const std::lock_guard lock(mutex_);
    if (!changed_) return false;
    append(overview, fresh_);
    fresh_ = {};
    changed_ = false;
    return true;
}

void OverviewThread::hand(RunOverview& fresh) {
    const std::lock_guard lock(mutex_);
    append(fresh_, fresh);
    changed_ = true;
    fresh = {};
}

void OverviewThread::work(const std::stop_token& stop) {
    Stepper stepper(model_->points, model_->params);
    RunOverview fresh;
    auto handed = std::chrono::steady_clock::now();
    while (!stop.stop_requested()) {
        const Counters before = stepper.state().counters;
        const std::size_t alerts = stepper.state().alerts.size();
        const bool complete = stepper.stepPivot();
        if (complete) noteFigures(fresh, stepper.state());
        noteMarks(fresh, before, stepper.state(), alerts);
        if (!complete) {
            // What happens behind the last pivot has the next number, if anything does.
            const bool any = !(stepper.state().counters == before);
            fresh.lastPivot = before.pivots + (any ? 1U : 0U);
            break;
        }
        if (std::chrono::steady_clock::now() - handed > kHandOver) {
            hand(fresh);
            handed = std::chrono::steady_clock::now();
        }
    }
    fresh.complete = stepper.state().finished();
    hand(fresh);
}

}  // namespace se::view
