/// The first run of a user: the opened points are triangulated once before their eyes, then the
/// tour is offered.
#pragma once

#include "document.h"
#include "session/playback.h"

namespace se::view {

class FirstRun {
  public:
    explicit FirstRun(CommandContext& context) : c_(context) {}

    /// Plays the whole run in about that many seconds, as soon as its length is known; 0: not.
    void begin(double seconds) { seconds_ = seconds; }
    /// Begins and ends playing; true if it did.
    bool poll();
    /// Pauses at any key; true if the key meant just that.
    bool key();
    /// It plays, or is about to.
    bool active() const { return seconds_ > 0.0 || plays_; }

  private:
    void end();

    CommandContext& c_;
    double seconds_ = 0.0;  ///< Until it plays.
    bool plays_ = false;
    PlaySpeed before_;
};

}  // namespace se::view
