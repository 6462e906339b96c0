#include "overview_job.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "spiraling_edge/stepper/stepper.h"

namespace se::view {

namespace {

constexpr std::chrono::milliseconds kHandOver{60};
/// Pivots between two checks of the clock.
constexpr std::uint32_t kLookEvery = 64;

double secondsSince(std::chrono::steady_clock::time_point began) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// Runs a model from pivot to pivot and records what is visible from afar.
class Observer {
  public:
    explicit Observer(const Model& model)
        : model_(model), stepper_(model.points, model.params, &log_) {
        if (model.points.size() <= kMaxWatched) live_.emplace(model.points, model.params.start);
        lanes_.begin(state().rings);
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
        stepper_.freePast();
        if (complete) noteFigures(run);
        if (complete || !log_.events().empty()) noteEvents(run);
        noteMarks(run, before, alerts);
        noteShape(run);
        noteFailures(run);
        // Events after the last pivot have the next number; a run that was stopped has none.
        if (!complete) run.lastPivot = before.pivots + (log_.events().empty() ? 0U : 1U);
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
        const auto changes = lanes_.takeChanges();
        run.laneChanges.insert(run.laneChanges.end(), changes.begin(), changes.end());
    }

    void noteMarks(RunOverview& run, const Counters& before, std::size_t alerts) const {
        const Counters& now = state().counters;
        const std::uint32_t pivot = now.pivots;
        if (now.seeds > before.seeds) run.marks.push_back({pivot, MarkKind::Seed});
        if (now.splits > before.splits) run.marks.push_back({pivot, MarkKind::Split});
        if (now.joins > before.joins) run.marks.push_back({pivot, MarkKind::Join});
        if (state().alerts.size() > alerts) noteAlerts(run, pivot);
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
        for (LiveFailure& each : live_->check(log_.events())) {
            if (noticed_++ == kMaxNoticed) live_.reset();
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
    LaneTracker lanes_;
    std::optional<LiveCheck> live_;  ///< Null for very large inputs.
    std::size_t noticed_ = 0;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

void watchRun(const Model& model, BackgroundJob<RunOverview>::Results& results) {
    Observer observer(model);
    RunOverview fresh;
    auto handed = std::chrono::steady_clock::now();
    std::uint32_t steps = 0;
    while (observer.step(fresh)) {
        if (++steps % kLookEvery != 0) continue;
        if (std::chrono::steady_clock::now() - handed > kHandOver) {
            results.add(std::exchange(fresh, {}));
            handed = std::chrono::steady_clock::now();
        }
        if (!results.report(0.0)) return;
    }
    fresh.complete = observer.state().finished();
    results.add(std::move(fresh));
}

}  // namespace

OverviewJob::OverviewJob(std::shared_ptr<const Model> model) : points_(model->points.size()) {
    job_.start([model = std::move(model)](auto& results) { watchRun(*model, results); });
}

bool OverviewJob::poll(RunOverview& overview) {
    const std::vector<RunOverview> found = job_.take();
    if (!found.empty() && overview.pivots.empty()) reservePivots(overview, points_);
    for (const RunOverview& fresh : found) append(overview, fresh);
    return !found.empty();
}

std::string OverviewJob::takeComplaint() {
    if (!done() || !std::exchange(hasComplaint_, false)) return {};
    return job_.complaint();
}

}  // namespace se::view
