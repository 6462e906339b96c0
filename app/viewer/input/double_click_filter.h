/// Delay of the selection by a click until it cannot be the first half of a double click. Plain
/// values.
#pragma once

#include <optional>

#include "run/selection.h"

namespace se::view {

class DoubleClickFilter {
  public:
    /// A click ended on `what`; it counts at `until`, in seconds, unless it is cancelled.
    void begin(const Selection& what, double until) { waiting_ = Waiting{what, until}; }
    /// Cancels the click: it was the first half of a double click.
    void takeBack() { waiting_.reset(); }
    bool waiting() const { return waiting_.has_value(); }
    /// The thing to select now, once.
    std::optional<Selection> due(double now) {
        if (!waiting_ || now < waiting_->until) return std::nullopt;
        const Selection what = waiting_->what;
        waiting_.reset();
        return what;
    }

  private:
    struct Waiting {
        Selection what;
        double until = 0.0;
    };
    std::optional<Waiting> waiting_;
};

}  // namespace se::view
