/// Playing: the number of steps that are due. Plain arithmetic; the caller makes the steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "spiraling_edge/stepper/event.h"
#include "teach/lesson.h"

namespace se::view {

enum class PlayUnit : std::uint8_t {
    SubStep,  ///< To the next decision.
    Pivot,    ///< To the end of the next pivot.
    Event,    ///< To the next split, join, seed or alert.
};

/// One of teach::kPlayUnits, which are in the same order.
inline std::string_view unitName(PlayUnit unit) {
    return teach::kPlayUnits[static_cast<std::size_t>(unit)];
}
/// Nothing for another name.
std::optional<PlayUnit> unitFromName(std::string_view name);
/// The next unit; after the last, the first.
PlayUnit following(PlayUnit unit);

/// The range of the run that is played in a loop, once both marks are set.
struct PlayLoop {
    std::optional<Address> from;
    std::optional<Address> to;

    bool complete() const { return from && to; }
    bool empty() const { return !from && !to; }
    /// Sets one mark. The other is removed if it would be on the wrong side.
    void setFrom(const Address& address);
    void setTo(const Address& address);
};

/// How fast is played.
struct PlaySpeed {
    PlayUnit unit = PlayUnit::Pivot;
    double rate = 4.0;       ///< Steps per second.
    bool unlimited = false;  ///< One step every frame.
};

class Playback {
  public:
    static constexpr double kSlowest = 0.5;
    static constexpr double kFastest = 60.0;

    bool playing() const { return playing_; }
    void play() {
        playing_ = true;
        owed_ = 1.0;
    }
    void pause() {
        playing_ = false;
        until.reset();
    }
    void toggle() { playing_ ? pause() : play(); }

    PlayUnit unit() const { return speed_.unit; }
    void setUnit(PlayUnit unit) { speed_.unit = unit; }
    /// Steps per second.
    double rate() const { return speed_.rate; }
    void setRate(double rate);
    /// One notch up or down on a scale of 0.5, 1, 2, 4, ... 60; above it, as fast as drawn.
    void faster();
    void slower();
    /// One step every frame, however long a frame takes.
    bool unlimited() const { return speed_.unlimited; }
    const PlaySpeed& speed() const { return speed_; }
    void setSpeed(const PlaySpeed& speed) { speed_ = speed; }

    /// Steps due after `seconds` more have passed; 0 while paused. Never more than 8, so that a
    /// long frame does not lead to a longer one.
    int due(double seconds);

    PlayLoop loop;
    std::optional<Address> until;  ///< Where playing ends by itself.

  private:
    bool playing_ = false;
    PlaySpeed speed_;
    double owed_ = 0.0;
};

}  // namespace se::view
