#include "alert_search.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se::view {

void AlertSearch::enqueue(std::shared_ptr<const Model> model) {
    query_.cancel();
    model_ = std::move(model);
    end_.reset();
    started_ = stopped_ = false;
    groups_.clear();
    openLoops_ = {};
    inOrder_.clear();
    alertOfFailure_.clear();
    placeOf_.clear();
}

void AlertSearch::start(std::shared_ptr<const RunEnd> end) {
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

void AlertSearch::stop() {
    query_.stop();
    stopped_ = true;
    started_ = false;
}

void AlertSearch::resume() {
    assert(!busy());
    stopped_ = started_ = false;
    start(end_);
}

bool AlertSearch::poll() {
    if (!query_.poll()) return false;
    if (done()) indexAnswer();
    return true;
}

void AlertSearch::indexAnswer() {
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

std::vector<std::size_t> AlertSearch::alertsAt(std::size_t place) const {
    std::vector<std::size_t> alerts;
    for (const std::size_t position : places()[place].faults) {
        if (alertOfFailure_[position] != kNoAlert) alerts.push_back(alertOfFailure_[position]);
    }
    return alerts;
}

std::optional<std::size_t> AlertSearch::placeOf(std::size_t alert) const {
    return placeOf_[alert] == kNoAlert ? std::nullopt : std::optional(placeOf_[alert]);
}

std::string alertName(const AlertSearch& alerts, std::size_t index) {
    for (const AlertGroup& group : alerts.groups()) {
        if (index < group.first || index >= group.first + group.count) continue;
        return std::string(group.kind->name) + ":" + std::to_string(index - group.first + 1);
    }
    return {};
}

std::optional<std::size_t> alertNamed(const AlertSearch& alerts, std::string_view name) {
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

void RunAlerts::open(std::shared_ptr<const Model> model) {
    model_ = std::move(model);
    search_.enqueue(model_);
    chosen_.reset();
    place_.reset();
    remediesOf_.reset();
    remedies_.cancel();
    reduction_.cancel();
    news_ = false;
}

bool RunAlerts::poll() {
    const bool known = search_.poll();
    news_ = news_ || known;
    const bool reduced = reduction_.poll();
    return remedies_.poll() || reduced || known;
}

void RunAlerts::waitUntilDone() {
    search_.waitUntilDone();
    remedies_.waitUntilDone();
    reduction_.waitUntilDone();
}

void RunAlerts::choose(std::optional<std::size_t> alert) {
    if (chosen_ == alert && !place_) return;
    chosen_ = alert;
    place_.reset();
    ++revision_;
}

void RunAlerts::choosePlace(std::size_t place) {
    const std::vector<std::size_t> alerts = search_.alertsAt(place);
    chosen_ = alerts.empty() ? std::nullopt : std::optional(alerts.front());
    place_ = place;
    ++revision_;
}

void RunAlerts::seekRemedies() {
    assert(shown() != nullptr);
    remediesOf_ = chosen_;
    remedies_.start([model = model_, failure = shown()->failure](const Progress& progress) {
        return findRemedies(model->points, model->params, failure, progress);
    });
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

}  // namespace se::view
