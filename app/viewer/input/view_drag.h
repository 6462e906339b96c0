/// Drags and clicks in the view or on a strip, distinguished by the motion since the press.
/// Plain values.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "run/selection.h"

namespace se::view {

class ViewDrag {
  public:
    /// A button came down at `pointer`, in pixels of the window: as the window reports it, since by
    /// the next frame the pointer may be elsewhere.
    void press(glm::vec2 pointer) { press_ = pointer; }
    /// Where the last button came down.
    glm::vec2 pressedAt() const { return press_; }
    /// The latest button keeps what is under it. Motion of the pointer before it does
    /// not count.
    void begin() {
        begun_ = last_ = press_;
        drags_ = false;
    }
    /// The pointer's motion since the previous frame, once it was `threshold` pixels away from the
    /// press; all of it in the frame in which the drag begins, so that the dragged
    /// thing stays under the pointer.
    glm::vec2 move(glm::vec2 pointer, float threshold) {
        drags_ = drags_ || glm::distance(pointer, begun_) >= threshold;
        if (!drags_) return glm::vec2(0.0F);
        const glm::vec2 by = pointer - last_;
        last_ = pointer;
        return by;
    }
    /// True from when the pointer has reached the threshold, until the next begin().
    bool drags() const { return drags_; }

  private:
    glm::vec2 press_{0.0F};
    glm::vec2 begun_{0.0F};
    glm::vec2 last_{0.0F};
    bool drags_ = false;
};

/// Delay of the selection by a click until it cannot be the first half of a double click.
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
