/// A click picks only once it is sure to be no half of a double click. Plain values.
#pragma once

#include <optional>

#include "run/selection.h"

namespace se::view {

class ClickWait {
  public:
    /// A click ended on `what`; it counts at `until`, in seconds, unless it is taken back.
    void begin(const Selection& what, double until) { waiting_ = Waiting{what, until}; }
    /// It was the first half of a double click.
    void takeBack() { waiting_.reset(); }
    bool waiting() const { return waiting_.has_value(); }
    /// What is to be selected now, once.
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
