// One pass over the whole run with the log of one pivot at a time. Each pivot is reduced to 16
// bytes (a bit per stage and verdict, and counts), by which the filter of the tree can test it
// without running it again. The thread hands over what is new in batches; append() adds them to
// the lists of the window.
#include "overview.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "guarded.h"
#include "picture.h"
#include "spiraling_edge/reading.h"
#include "spiraling_edge/stepper.h"

namespace se::view {

namespace {

constexpr std::chrono::milliseconds kHandOver{60};
/// Pivots between two checks of the clock.
constexpr std::uint32_t kLookEvery = 64;

template <typename T>
void appendList(std::vector<T>& list, const std::vector<T>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

void countUp(std::uint16_t& number) {
    if (number < std::numeric_limits<std::uint16_t>::max()) ++number;
}

double secondsSince(std::chrono::steady_clock::time_point began) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// Runs a model from pivot to pivot and records what is visible from afar.
class Observer {
  public:
    explicit Observer(const Model& model)
        : model_(model), stepper_(model.points, model.params, &log_) {
        if (model.points.size() <= kMostWatched) live_.emplace(model.points);
    }

    const State& state() const { return stepper_.state(); }

    /// Runs to the end of the next pivot. False if there was none.
    bool step(RunOverview& run) {
        const Counters before = state().counters;
        const std::size_t alerts = state().alerts.size();
        triangles_ = state().triangles.size();
        bool complete = true;
        // Each of the steps after the last pivot proceeds to its next kind without a counted one.
        while (complete && state().counters.pivots == before.pivots)
            complete = stepper_.stepPivot();
        if (complete) noteFigures(run);
        if (complete || !log_.events().empty()) noteEvents(run);
        noteMarks(run, before, alerts);
        noteShape(run);
        noteFailures(run);
        if (!complete) {
            // Events after the last pivot have the next number, if there are any.
            const bool any = !(state().counters == before);
            run.lastPivot = before.pivots + (any ? 1U : 0U);
        }
        log_.clear();
        return complete;
    }

  private:
    void noteFigures(RunOverview& run) {
        const EdgeRings& rings = state().rings;
        const std::uint32_t length = rings.active() == kNone ? 0 : rings.length(rings.active());
        const auto depth = static_cast<std::uint32_t>(rings.stack().size());
        run.ringLength.push_back(length);
        run.stackDepth.push_back(depth);
        run.triangles.push_back(static_cast<std::uint32_t>(state().triangles.size()));
        run.longestRing = std::max(run.longestRing, length);
        run.deepestStack = std::max(run.deepestStack, depth);
        run.lastPivot = state().counters.pivots;
    }

    void noteEvents(RunOverview& run) {
        PivotSummary summary;
        for (const Event& event : log_.events()) {
            count(summary, event);
            lanes_.take(event);
            run.lanes = std::max(run.lanes, lanes_.live());
        }
        lanes_.settle(state().rings);
        run.pivots.push_back(summary);
        appendList(run.laneChanges, lanes_.takeChanges());
    }

    void noteMarks(RunOverview& run, const Counters& before, std::size_t alerts) const {
        const Counters& now = state().counters;
        const std::uint32_t pivot = now.pivots;
        if (now.seeds > before.seeds) run.marks.push_back({pivot, MarkKind::Seed});
        if (now.splits > before.splits) run.marks.push_back({pivot, MarkKind::Split});
        if (now.joins > before.joins) run.marks.push_back({pivot, MarkKind::Join});
        if (state().alerts.size() > alerts) {
            noteAlerts(run, pivot);
        }
    }

    /// The first alert of this pivot.
    void noteAlerts(RunOverview& run, std::uint32_t pivot) const {
        for (const Event& event : log_.events()) {
            const auto* alert = std::get_if<AlertEvidence>(&event.evidence);
            if (alert == nullptr) continue;
            run.marks.push_back({pivot, MarkKind::Alert, event.address.n, *alert});
            return;
        }
    }

    void noteFailures(RunOverview& run) {
        if (!live_) return;
        for (LiveFailure& each : live_->see(log_.events())) {
            if (noticed_++ == kMostNoticed) live_.reset();
            if (!live_) return;
            run.failures.push_back(std::move(each));
        }
    }

    /// Whether this pivot, or a seed, has begun or completed a component.
    void noteShape(RunOverview& run) {
        for (const Event& event : log_.events()) {
            if (event.address.stage == Stage::Seed) begin_ = triangles_;
            const auto* complete = std::get_if<ComponentEvidence>(&event.evidence);
            if (complete == nullptr) continue;
            const std::span<const Triangle> all(state().triangles);
            const std::size_t end = std::min<std::size_t>(complete->triangles, all.size());
            const std::size_t begin = std::min(begin_, end);
            run.shapes.push_back(shapeOf(model_, all.subspan(begin, end - begin), begin));
            run.shapes.back().pivot = event.address.pivot;
            run.shapes.back().seconds = secondsSince(began_);
        }
    }

    const Model& model_;
    std::size_t triangles_ = 0;  ///< Before this pivot.
    std::size_t begin_ = 0;      ///< The first triangle of the current component.
    EventLog log_;
    Stepper stepper_;
    LaneKeeper lanes_;
    std::optional<LiveCheck> live_;  ///< Null for very large inputs.
    std::size_t noticed_ = 0;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

/// Counts the new pivots of `overview` for their components.
void countComponents(RunOverview& overview, const std::vector<PivotSummary>& fresh) {
    auto pivot = static_cast<std::uint32_t>(overview.pivots.size() - fresh.size());
    for (const PivotSummary& summary : fresh) {
        ++pivot;
        if ((summary.found & findingOf(Stage::Seed)) != 0 || overview.components.empty()) {
            overview.components.push_back({pivot, 0, 0});
        }
        overview.components.back().tests += summary.tests;
        overview.components.back().refused += summary.refused;
    }
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
    auto last = first;
    while (last != run.failures.end() && last->address == address) ++last;
    return {first, last};
}

std::size_t noticedUpTo(const RunOverview& run, const Address& address) {
    const auto end = std::partition_point(
        run.failures.begin(), run.failures.end(),
        [&](const LiveFailure& each) { return each.address.pivot <= address.pivot; });
    return static_cast<std::size_t>(end - run.failures.begin());
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
    const Status good = guarded([&] { watch(stop); });
    if (!good) complaint_ = good.error().message;
    done_ = true;
}

void OverviewThread::watch(const std::stop_token& stop) {
    Observer observer(*model_);
    RunOverview fresh;
    auto handed = std::chrono::steady_clock::now();
    std::uint32_t steps = 0;
    while (!stop.stop_requested() && observer.step(fresh)) {
        if (++steps % kLookEvery != 0) continue;
        if (std::chrono::steady_clock::now() - handed > kHandOver) {
            hand(fresh);
            handed = std::chrono::steady_clock::now();
        }
    }
    fresh.complete = observer.state().finished();
    hand(fresh);
}

}  // namespace se::view
