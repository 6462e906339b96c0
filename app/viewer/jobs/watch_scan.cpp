#include "watch_scan.h"

#include <algorithm>

namespace se::view {

void WatchScan::cancel() {
    if (!busy()) return;
    poll();
    // The scan may just have ended.
    if (!busy()) return;
    job_.cancel();
    givenUp_ = true;
}

void WatchScan::startNext() {
    if (busy()) return;
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
    job_.startPass(model_, [expressions](const Model& model, auto& results) {
        const auto add = [&results](std::uint32_t pivot, std::span<const double> values) {
            results.add({pivot, {values.begin(), values.end()}});
        };
        return watchVisitor(model.points, model.params, expressions, add);
    });
}

bool WatchScan::poll() {
    if (!busy()) return false;
    const bool ended = job_.ended();
    const std::vector<WatchValues> found = job_.take();
    for (std::size_t i = 0; i < sought_.size(); ++i) {
        WatchSeries& series = known_[sought_[i]];
        for (const WatchValues& each : found) {
            series.values.resize(each.pivot + std::size_t{1}, each.values[i]);
            series.values.back() = each.values[i];
        }
        series.complete = ended && job_.complaint().empty();
    }
    if (!ended) return !found.empty();
    if (!job_.complaint().empty()) {
        complaint_ = job_.complaint();
        givenUp_ = true;
        job_.close();
        return true;
    }
    job_.close();
    startNext();
    return true;
}

}  // namespace se::view
