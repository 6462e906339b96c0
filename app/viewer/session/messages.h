/// Messages of the session to the user, beside the decision at the cursor.
#pragma once

#include <chrono>
#include <string>

namespace se::view {

class Messages {
  public:
    using Clock = std::chrono::steady_clock;

    void say(std::string message);
    /// Shows an error; nothing if it is empty.
    void sayIfAny(std::string complaint);
    /// Says why a move did not find its target.
    void miss(std::string message);
    /// The last message becomes empty, and nothing is missed: a move begins.
    void clear();

    /// The last message that is not about an event, for example that an address does not exist.
    const std::string& last() const { return message_; }
    /// The message while it is new, then empty: it must not cover the decision.
    std::string notice(Clock::time_point now = Clock::now()) const;
    /// The last move did not find its target; last() gives the reason. False again with the next
    /// move.
    bool missed() const { return missed_; }
    void forgetMiss() { missed_ = false; }

  private:
    std::string message_;
    bool missed_ = false;
    Clock::time_point saidAt_;
};

}  // namespace se::view
