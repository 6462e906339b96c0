/// Calls that would destroy what is being drawn: they wait for the end of the frame.
#pragma once

#include <functional>
#include <utility>
#include <vector>

namespace se::view {

class BetweenFrames {
  public:
    /// Makes the call at once, or at the end of the frame that is being drawn.
    void operator()(std::function<void()> call) {
        if (!drawing_) return call();
        waiting_.push_back(std::move(call));
    }
    void beginDrawing() { drawing_ = true; }
    /// Makes the calls that wait, in their order.
    void endDrawing() {
        drawing_ = false;
        for (const auto& call : std::exchange(waiting_, {})) call();
    }

  private:
    bool drawing_ = false;
    std::vector<std::function<void()>> waiting_;
};

}  // namespace se::view
