/// Short animations after a step, and the blinking while a key is held. Time is a parameter,
/// in seconds from any origin; no function here reads a clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "camera.h"
#include "spiraling_edge/run/pivot_replay.h"

namespace se::view {

/// Phase of the short animations at which a picture is drawn.
struct Moment {
    enum class Kind : std::uint8_t {
        Rest,    ///< Over, or too fast to follow.
        Moving,  ///< A while after the step.
        Paper,   ///< For a saved picture: brief highlights are shown.
    } kind = Kind::Rest;
    double seconds = 0.0;  ///< Moving: since the step.
    bool single = false;   ///< Moving: forward by one decision, so that only its new parts move.
    friend bool operator==(const Moment&, const Moment&) = default;
};

/// Brightness of something that blinks once: 1 to 0.
float blinkStrength(const Moment& moment);
/// Strength of something that fades to `rest`: from 1 on; half in a saved picture, or `rest` if
/// that is more.
float fadeStrength(const Moment& moment, float rest);
/// The size of number `i` of `count` things that pop up one after the other: 0 before its turn,
/// then more than 1, at last 1.
float popSize(const Moment& moment, std::size_t i, std::size_t count);
/// Duration of the motion in a picture; 0 if nothing moves.
double motionSeconds(const DecisionState& picture);

/// Detects steps, and measures the time since the last one.
class Motion {
  public:
    /// Position of the cursor.
    struct Instant {
        std::uint32_t generation = 0;
        std::uint32_t pivot = 0;
        std::size_t cursor = 0;
        friend bool operator==(const Instant&, const Instant&) = default;
    };

    /// The moment to draw. `seconds`: result of motionSeconds(), 0 if the step is not to be
    /// animated.
    const Moment& look(const Instant& place, double seconds, double now);
    bool moving() const { return moment_.kind == Moment::Kind::Moving; }
    /// Number of steps that were animated so far.
    std::size_t count() const { return count_; }

  private:
    Instant place_;
    Moment moment_;
    double began_ = 0.0;
    double seconds_ = 0.0;
    std::size_t count_ = 0;
};

/// A look at the state before the decision at the cursor, while a key is held: permanently,
/// or alternating with the state after it.
class LookBack {
  public:
    enum class Mode : std::uint8_t { Off, Before, Blink };
    /// Time for which each of the two is shown: twice a second there and back.
    static constexpr double kHalfSeconds = 0.25;

    /// Begins, until the key is released; 0: until the same look is requested again.
    void begin(Mode mode, int key, double now);
    /// Action of a menu: on if it is off, off if it is on.
    void toggle(Mode mode, double now);
    /// Shift was pressed or released while the key is held.
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

// Smooth moves of the camera: to another pose, and a swing that shows depth by parallax. Time is a
// parameter, in seconds from any origin.

/// Width of the swing, in degrees.
inline constexpr float kSwingDegrees = 20.0F;
/// Duration of a move to a pose, and of a swing, in seconds.
inline constexpr double kMoveSeconds = 0.4;
inline constexpr double kSwingSeconds = 2.0;

/// The pose at a share in [0, 1] of the way: the turn takes the shorter side.
CameraPose poseBetween(const CameraPose& from, const CameraPose& to, double share);
/// The pose at a share in [0, 1] of a swing about the target, which ends where it begins. From
/// above or below the swing tilts, since a turn would only rotate the picture.
CameraPose swungPose(const CameraPose& pose, double share);

class CameraMove {
  public:
    enum class Kind : std::uint8_t {
        None,
        Requested,  ///< By a command: an undo goes back.
        Followed,   ///< By the cursor, while the decision is followed.
        Swing,
    };

    /// Goes from the present pose of `camera` to another one.
    void begin(const Camera& camera, const CameraPose& to, Kind kind);
    /// Swings about the target, or stops a swing where it began.
    void swing(Camera& camera);
    /// Moves `camera` to its pose at `now`; the first call is the beginning. Ends at once if
    /// the camera was moved by something else in between.
    void apply(Camera& camera, double now);
    bool active() const { return kind_ != Kind::None; }
    Kind kind() const { return kind_; }

  private:
    Kind kind_ = Kind::None;
    CameraPose from_;
    CameraPose to_;
    unsigned revision_ = 0;  ///< Of the camera, as last set.
    std::optional<double> began_;
};

}  // namespace se::view
