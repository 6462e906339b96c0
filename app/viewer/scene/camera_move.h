/// Smooth moves of the camera: to another pose, and a swing that shows depth by parallax. Time is a
/// parameter, in seconds from any origin.
#pragma once

#include <cstdint>
#include <optional>

#include "camera.h"

namespace se::view {

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
