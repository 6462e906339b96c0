#include "watch_scan.h"

#include <algorithm>
#include <utility>

namespace se::view {

void WatchScan::open(std::shared_ptr<const Model> model) {
    errand_.drop();
    model_ = std::move(model);
    known_.clear();
    givenUp_ = false;
    beginNext();
}

void WatchScan::want(std::span<const std::string> expressions) {
    if (std::equal(wanted_.begin(), wanted_.end(), expressions.begin(), expressions.end())) return;
    wanted_.assign(expressions.begin(), expressions.end());
    givenUp_ = false;
    if (!busy()) beginNext();
}

void WatchScan::cancel() {
    if (!busy()) return;
    poll();
    // The scan may just have ended.
    if (!busy()) return;
    errand_.drop();
    givenUp_ = true;
}

void WatchScan::resume() {
    givenUp_ = false;
    if (!busy()) beginNext();
}

void WatchScan::beginNext() {
    if (!model_) return;
    std::vector<WatchExpression> expressions;
    sought_.clear();
    for (const std::string& each : wanted_) {
        const auto expression = WatchExpression::parse(each);
        const bool twice = std::find(sought_.begin(), sought_.end(), each) != sought_.end();
        if (!expression || twice || known_[each].complete) continue;
        known_[each] = {};
        sought_.push_back(each);
        expressions.push_back(expression.value());
    }
    if (sought_.empty()) return;
    errand_.begin([model = model_, expressions](auto& basket) {
        scanWatches(
            model->points, model->params, expressions,
            [&](std::uint32_t pivot, std::span<const double> values) {
                basket.add({pivot, {values.begin(), values.end()}});
            },
            [&](double share) { return basket.report(share); });
    });
}

bool WatchScan::poll() {
    if (!busy()) return false;
    const bool ended = errand_.ended();
    const std::vector<Values> found = errand_.take();
    for (std::size_t i = 0; i < sought_.size(); ++i) {
        WatchSeries& series = known_[sought_[i]];
        for (const Values& each : found) {
            series.values.resize(each.pivot + std::size_t{1}, each.values[i]);
            series.values.back() = each.values[i];
        }
        series.complete = ended && errand_.complaint().empty();
    }
    if (!ended) return !found.empty();
    if (!errand_.complaint().empty()) {
        complaint_ = errand_.complaint();
        givenUp_ = true;
        errand_.close();
        return true;
    }
    errand_.close();
    beginNext();
    return true;
}

void WatchScan::finish() {
    while (busy()) {
        errand_.wait();
        poll();
    }
}

const WatchSeries* WatchScan::of(const std::string& expression) const {
    const auto found = known_.find(expression);
    return found == known_.end() ? nullptr : &found->second;
}

}  // namespace se::view
