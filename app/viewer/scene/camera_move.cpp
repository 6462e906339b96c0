#include "camera_move.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace se::view {

namespace {

/// Steeper than this, a turn about the up axis is hardly more than a rotation of the picture.
constexpr float kSteepFrom = 55.0F;

/// Slow at both ends.
float smooth(double share) {
    const double s = std::clamp(share, 0.0, 1.0);
    return static_cast<float>(s * s * (3.0 - 2.0 * s));
}

}  // namespace

CameraPose poseBetween(const CameraPose& from, const CameraPose& to, double share) {
    if (share >= 1.0) return to;
    const float s = smooth(share);
    CameraPose pose = to;
    pose.target = glm::mix(from.target, to.target, s);
    // By ratio, so that things on the screen grow evenly.
    pose.distance = from.distance * std::pow(to.distance / from.distance, s);
    pose.yawDegrees = from.yawDegrees + s * std::remainder(to.yawDegrees - from.yawDegrees, 360.0F);
    pose.pitchDegrees = glm::mix(from.pitchDegrees, to.pitchDegrees, s);
    return pose;
}

CameraPose swungPose(const CameraPose& pose, double share) {
    CameraPose swung = pose;
    if (share <= 0.0 || share >= 1.0) return swung;
    const double turn = std::numbers::pi * share;
    if (std::abs(pose.pitchDegrees) < kSteepFrom) {
        swung.yawDegrees += 0.5F * kSwingDegrees * static_cast<float>(std::sin(2.0 * turn));
    } else {
        const auto tilt = static_cast<float>(std::sin(turn) * std::sin(turn));
        swung.pitchDegrees -= std::copysign(kSwingDegrees * tilt, pose.pitchDegrees);
    }
    return swung;
}

void CameraMove::begin(const Camera& camera, const CameraPose& to, Kind kind) {
    from_ = camera.pose();
    to_ = to;
    kind_ = kind;
    revision_ = camera.revision();
    began_.reset();
}

void CameraMove::swing(Camera& camera) {
    if (kind_ == Kind::Swing) {
        camera.setPose(to_);
        kind_ = Kind::None;
        return;
    }
    begin(camera, active() ? to_ : camera.pose(), Kind::Swing);
}

void CameraMove::apply(Camera& camera, double now) {
    if (!active()) return;
    if (camera.revision() != revision_) {
        kind_ = Kind::None;
        return;
    }
    if (!began_) began_ = now;
    const bool swings = kind_ == Kind::Swing;
    const double share = (now - *began_) / (swings ? kSwingSeconds : kMoveSeconds);
    camera.setPose(swings ? swungPose(to_, share) : poseBetween(from_, to_, share));
    revision_ = camera.revision();
    if (share >= 1.0) kind_ = Kind::None;
}

}  // namespace se::view
