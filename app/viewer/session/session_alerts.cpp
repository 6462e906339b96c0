#include "session_alerts.h"

namespace se::view {

void SessionAlerts::open(std::shared_ptr<const Model> model) {
    model_ = std::move(model);
    search_.enqueue(model_);
    chosen_.reset();
    remedies_.cancel();
    news_ = false;
}

bool SessionAlerts::poll() {
    const bool known = search_.poll();
    news_ = news_ || known;
    return remedies_.poll() || known;
}

void SessionAlerts::waitUntilDone() {
    search_.waitUntilDone();
    remedies_.waitUntilDone();
}

void SessionAlerts::choose(std::optional<std::size_t> alert) {
    if (chosen_ == alert) return;
    chosen_ = alert;
    ++revision_;
}

void SessionAlerts::seekRemedies() { remedies_.start(model_, *chosen_, shown()->failure); }

}  // namespace se::view
