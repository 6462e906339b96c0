/// How long a user waits for the first frame, and between two frames while an input is opened.
#pragma once

#include <algorithm>
#include <chrono>
#include <utility>

#include "application.h"
#include "render/context.h"

namespace se::view::test {

class OpeningTimes {
  public:
    using Clock = std::chrono::steady_clock;

    /// `began`: start of the program.
    explicit OpeningTimes(Clock::time_point began) : began_(began) {}

    /// To be called after each frame, with its OpenGL context.
    void noteFrame(Application& app) {
        const Session& session = app.session();
        const auto submitted = Clock::now();
        const bool first = firstFrame_ == 0.0 && session.ready();
        if (first) finishGl();
        const auto drawn = Clock::now();
        const double gl = app.glSeconds() + seconds(drawn - submitted);
        if (first) firstFrame_ = seconds(drawn - began_);
        if (firstWindow_ == 0.0) firstWindow_ = seconds(drawn - began_);
        if (std::exchange(opening_, session.input().phase() == SessionPhase::Loading))
            longest_ = std::max(longest_, seconds(drawn - lastFrame_) - gl);
        lastFrame_ = drawn;
    }

    /// Seconds from the start of the program until the input was first drawn; 0 before.
    double firstFrame() const { return firstFrame_; }
    /// Seconds until the first frame at all, with or without an input.
    double firstWindow() const { return firstWindow_; }
    /// The longest time between two frames while an input was opened, including the frame that
    /// shows it, without OpenGL, in seconds.
    double longest() const { return longest_; }

  private:
    static double seconds(Clock::duration time) {
        return std::chrono::duration<double>(time).count();
    }

    Clock::time_point began_;
    Clock::time_point lastFrame_;
    double firstFrame_ = 0.0;
    double firstWindow_ = 0.0;
    double longest_ = 0.0;
    bool opening_ = false;  ///< An input was being opened in the previous frame.
};

}  // namespace se::view::test
