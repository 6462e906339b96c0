/// What moves for a moment after a step, and what blinks while a key is held. Time comes from
/// outside, in seconds from any origin; nothing here looks at a clock.
#pragma once

#include <cstddef>
#include <cstdint>

#include "run/picture.h"

namespace se::view {

/// At which point of its short movements a picture is drawn.
struct Moment {
    enum class Kind : std::uint8_t {
        Rest,    ///< Over, or too fast to be followed.
        Moving,  ///< A while after the step.
        Paper,   ///< For a picture that is kept: what only passes by is there to be seen.
    } kind = Kind::Rest;
    double seconds = 0.0;  ///< Moving: since the step.
    bool single = false;   ///< Moving: by one decision on, so that only what is new in it moves.
    friend bool operator==(const Moment&, const Moment&) = default;
};

/// How strongly that is lit which blinks once: 1 to 0.
float blinkStrength(const Moment& moment);
/// How much is left of what fades to `rest`: from 1 on; half on paper, or `rest` if that is more.
float fadeStrength(const Moment& moment, float rest);
/// The size of number `i` of `count` things that pop up one after the other: 0 before its turn,
/// then more than 1, at last 1.
float popSize(const Moment& moment, std::size_t i, std::size_t count);
/// How long what a picture shows is in motion; 0 if nothing is.
double motionSeconds(const Picture& picture);

/// Notices steps, and tells how long ago the last one was.
class Motion {
  public:
    /// Where the cursor stands.
    struct Place {
        std::uint32_t generation = 0;
        std::uint32_t pivot = 0;
        std::size_t cursor = 0;
        friend bool operator==(const Place&, const Place&) = default;
    };

    /// The moment to draw. `seconds`: what motionSeconds() says, 0 where a step is not to be
    /// followed by the eye.
    const Moment& look(const Place& place, double seconds, double now);
    bool moving() const { return moment_.kind == Moment::Kind::Moving; }

  private:
    Place place_;
    Moment moment_;
    double began_ = 0.0;
    double seconds_ = 0.0;
};

/// A look at the state before the decision at the cursor, as long as a key is held: all the time,
/// or in turn with the state after it.
class LookBack {
  public:
    enum class Mode : std::uint8_t { Off, Before, Blink };
    /// How long each of the two is shown: twice a second there and back.
    static constexpr double kHalfSeconds = 0.25;

    /// Begins, until the key is released; 0: until the same is asked for again.
    void begin(Mode mode, int key, double now);
    /// What a menu does: on if it is off, off if it is on.
    void toggle(Mode mode, double now);
    /// Shift came down or went up while the key is held.
    void shift(bool down, double now);
    void released(int key);

    Mode mode() const { return mode_; }
    bool on() const { return mode_ != Mode::Off; }
    bool blinking() const { return mode_ == Mode::Blink; }
    /// True if the state before is to be shown; it comes first.
    bool showsBefore(double now) const;

  private:
    Mode mode_ = Mode::Off;
    int key_ = 0;
    double since_ = 0.0;
};

}  // namespace se::view
