#include "alert_search.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "spiraling_edge/base/operating_system.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se::view {

void RunAlerts::open(std::shared_ptr<const Model> model) {
    query_.cancel();
    model_ = std::move(model);
    end_.reset();
    started_ = stopped_ = news_ = false;
    groups_.clear();
    openLoops_ = {};
    inOrder_.clear();
    alertOfFailure_.clear();
    placeOf_.clear();
    chosen_.reset();
    place_.reset();
    reduction_.cancel();
}

void RunAlerts::start(std::shared_ptr<const RunEnd> end) {
    if (!model_ || started_ || stopped_) return;
    started_ = true;
    end_ = std::move(end);
    const bool atEnd = end_ && !follows_;
    query_.start(
        [model = model_, end = end_, atEnd](const Progress& progress) -> Result<RunFailureSearch> {
            if (atEnd) return failuresAtEnd(model->points, end->counts, end->mesh);
            if (!end) return searchFailures(model->points, model->params, progress);
            return searchFailures(model->points, model->params, end->counts, end->mesh, progress);
        });
}

void RunAlerts::stop() {
    query_.stop();
    stopped_ = true;
    started_ = false;
}

void RunAlerts::resume() {
    assert(!busy());
    stopped_ = started_ = false;
    start(end_);
}

bool RunAlerts::poll() {
    const bool known = query_.poll();
    if (known && done()) indexAnswer();
    news_ = news_ || known;
    return reduction_.poll() || known;
}

void RunAlerts::waitUntilDone() {
    query_.waitUntilDone();
    reduction_.waitUntilDone();
}

void RunAlerts::indexAnswer() {
    const std::span<const RunFailure> all = failures();
    std::size_t first = 0;
    for (std::size_t i = 0; i < failureClasses().size(); ++i) {
        const ClassTotal& total = query_.answer()->verdict.totals[i];
        if (total.listed == 0) continue;
        groups_.push_back({&failureClasses()[i], first, total.listed, total});
        first += total.listed;
    }
    for (const MeshFailure& each : found()->all) {
        if (!isLoop(each)) continue;
        ++openLoops_.count;
        openLoops_.width = std::max(openLoops_.width, widthOf(each));
    }
    alertOfFailure_.assign(found()->all.size(), kNoAlert);
    for (std::size_t i = 0; i < all.size(); ++i) alertOfFailure_[all[i].position] = i;
    placeOf_.assign(all.size(), kNoAlert);
    for (std::size_t p = 0; p < places().size(); ++p) {
        for (const std::size_t alert : alertsAt(p)) placeOf_[alert] = p;
    }
    inOrder_.resize(all.size());
    std::iota(inOrder_.begin(), inOrder_.end(), std::size_t{0});
    std::stable_sort(inOrder_.begin(), inOrder_.end(), [&](std::size_t a, std::size_t b) {
        return isBefore(all[a].moments.created.event.address, all[b].moments.created.event.address);
    });
}

std::vector<std::size_t> RunAlerts::alertsAt(std::size_t place) const {
    std::vector<std::size_t> alerts;
    for (const std::size_t position : places()[place].faults) {
        if (alertOfFailure_[position] != kNoAlert) alerts.push_back(alertOfFailure_[position]);
    }
    return alerts;
}

std::optional<std::size_t> RunAlerts::placeOf(std::size_t alert) const {
    return placeOf_[alert] == kNoAlert ? std::nullopt : std::optional(placeOf_[alert]);
}

std::string alertName(const RunAlerts& alerts, std::size_t index) {
    for (const AlertGroup& group : alerts.groups()) {
        if (index < group.first || index >= group.first + group.count) continue;
        return std::string(group.kind->name) + ":" + std::to_string(index - group.first + 1);
    }
    return {};
}

std::optional<std::size_t> alertNamed(const RunAlerts& alerts, std::string_view name) {
    if (name == "first")
        return alerts.inOrder().empty() ? std::nullopt : std::optional(alerts.inOrder().front());
    const std::size_t colon = name.find(':');
    const bool numbered = colon != std::string_view::npos;
    const std::size_t number =
        numbered ? numberIn<std::size_t>(name.substr(colon + 1)).value_or(0) : 1;
    for (const AlertGroup& group : alerts.groups()) {
        if (group.kind->name != name.substr(0, colon)) continue;
        if (number < 1 || number > group.count) return {};
        return group.first + number - 1;
    }
    return {};
}

void RunAlerts::choose(std::optional<std::size_t> alert) {
    if (chosen_ == alert && !place_) return;
    chosen_ = alert;
    place_.reset();
    ++revision_;
}

void RunAlerts::choosePlace(std::size_t place) {
    const std::vector<std::size_t> alerts = alertsAt(place);
    chosen_ = alerts.empty() ? std::nullopt : std::optional(alerts.front());
    place_ = place;
    ++revision_;
}

void RunAlerts::reduce(const RunSpec& spec, std::shared_ptr<const PointFile> input,
                       std::shared_ptr<const RunEnd> end) {
    assert(shown() != nullptr && shown()->failure.kind->find != nullptr);
    reducedClass_ = shown()->failure.kind;
    reduction_.startSlices([spec = withFixesAsOptions(spec), model = model_,
                            input = std::move(input), end = std::move(end),
                            failure = shown()->failure,
                            made = std::shared_ptr<Reduction>()](double& share) mutable {
        std::optional<Result<Reduced>> answer;
        if (!made) {
            PointFile points = *input;
            storeDerived(model->points, model->report, points);
            made = std::make_shared<Reduction>(
                applyFixes(points).file, failure.place,
                failsAlike(spec, model->params, model->points, failure, end->mesh), kReduceEffort);
        } else if (!made->advance()) {
            answer = made->result();
        }
        share = made->share();
        return answer;
    });
}

void TrialJob::open(std::shared_ptr<const PointFile> file, RunSpec spec) {
    job_.cancel();
    file_ = std::move(file);
    spec_ = std::move(spec);
    // Preparing takes one thread; the search for faults takes all, at low priority.
    spec_.neighbors.threads = 1;
    started_ = false;
    now_ = {};
}

void TrialJob::start() {
    if (started_ || file_ == nullptr) return;
    started_ = true;
    now_.next = trialText({});
    job_.start([file = file_, spec = spec_](auto& results) {
        if (usesThreads()) os::lowerPriority();
        double share = 0.0;
        std::size_t best = 0;
        std::shared_ptr<const MeshChange> change;
        // Of the meshes, only their difference is handed on.
        const auto add = [&](Trials trials, std::string next) {
            if (trials.best != std::exchange(best, trials.best)) {
                change = std::make_shared<const MeshChange>(
                    changeOf(file->position, *trials.tried.front().mesh, *trials.tried[best].mesh));
            }
            for (Trial& each : trials.tried) each.mesh.reset();
            results.add({std::move(trials), std::move(next), change});
        };
        const auto visit = [&](const Trials& trials, const SpecChange& next) {
            add(trials, trialText(next));
            results.report(share);
        };
        Result<Trials> all = tryChanges(*file, spec, visit, [&](double done) {
            share = done;
            return results.report(done);
        });
        if (all) {
            add(std::move(all.value()), {});
        } else {
            results.add({{}, {}, nullptr, all.error().message});
        }
    });
}

void TrialJob::stop() {
    job_.cancel();
    now_.next.clear();
}

bool TrialJob::poll() {
    auto taken = job_.take();
    for (Progressed& each : taken.items) {
        if (each.complaint.empty())
            now_ = std::move(each);
        else
            now_.complaint = std::move(each.complaint);
    }
    if (!taken.complaint.empty()) now_.complaint = std::move(taken.complaint);
    if (taken.ended) now_.next.clear();
    return taken.any();
}

}  // namespace se::view
