// Animations are functions of the time since the last step, without state of their own, so that a
// picture can be drawn for any moment and tests need no clock. Motion only detects the step; what
// moves, and for how long, follows from the picture.
#include "motion.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace se::view {

namespace {

constexpr double kBlinkSeconds = 0.6;
/// The share of its time that a blink is fully lit; then it fades.
constexpr double kLitShare = 0.6;
constexpr double kFadeSeconds = 0.5;
/// Size of a thing when it pops up, and the time it takes to settle.
constexpr double kPopSize = 1.8;
constexpr double kPopSeconds = 0.2;
/// Strength in a saved picture of something that fades.
constexpr float kPaperShare = 0.5F;

/// Eases out: 0 to 1.
double eased(double share) {
    const double rest = 1.0 - std::clamp(share, 0.0, 1.0);
    return 1.0 - rest * rest;
}

}  // namespace

float blinkStrength(const Moment& moment) {
    if (moment.kind == Moment::Kind::Rest) return 0.0F;
    if (moment.kind == Moment::Kind::Paper) return 1.0F;
    const double lit = kLitShare * kBlinkSeconds;
    const double dying = (moment.seconds - lit) / (kBlinkSeconds - lit);
    return static_cast<float>(1.0 - std::clamp(dying, 0.0, 1.0));
}

float fadeStrength(const Moment& moment, float rest) {
    if (moment.kind == Moment::Kind::Rest) return rest;
    if (moment.kind == Moment::Kind::Paper) return std::max(rest, kPaperShare);
    return 1.0F + (rest - 1.0F) * static_cast<float>(eased(moment.seconds / kFadeSeconds));
}

float popSize(const Moment& moment, std::size_t i, std::size_t count) {
    if (moment.kind != Moment::Kind::Moving) return 1.0F;
    if (moment.single && i + 1 < count) return 1.0F;
    // The last one must have settled when the motion ends.
    const double turn = moment.single || count < 2
                            ? 0.0
                            : (kFadeSeconds - kPopSeconds) * static_cast<double>(i) /
                                  static_cast<double>(count - 1);
    if (moment.seconds < turn) return 0.0F;
    const double settled = eased((moment.seconds - turn) / kPopSeconds);
    return static_cast<float>(kPopSize + (1.0 - kPopSize) * settled);
}

double motionSeconds(const DecisionState& picture) {
    if (!picture.event) return 0.0;
    const Stage stage = picture.event->address.stage;
    if (stage == Stage::Seed) return kBlinkSeconds;
    const bool fan = stage == Stage::Emit || picture.complete;
    if (fan && !picture.newTriangles.empty() && !picture.repaired) return kFadeSeconds;
    return stage == Stage::Ring ? kFadeSeconds : 0.0;
}

const Moment& Motion::look(const Instant& place, double seconds, double now) {
    if (!(place == place_)) {
        moment_.single = place == Instant{place_.generation, place_.pivot, place_.cursor + 1};
        place_ = place;
        if (seconds > 0.0) ++count_;
        began_ = now;
        seconds_ = seconds;
    }
    seconds_ = std::min(seconds_, seconds);
    const double age = now - began_;
    return moment_ = age < seconds_ ? Moment{Moment::Kind::Moving, age, moment_.single} : Moment{};
}

void LookBack::begin(Mode mode, int key, double now) {
    mode_ = mode;
    key_ = key;
    since_ = now;
}

void LookBack::toggle(Mode mode, double now) { begin(mode_ == mode ? Mode::Off : mode, 0, now); }

void LookBack::shift(bool down, double now) {
    if (mode_ == Mode::Off || key_ == 0) return;
    begin(down ? Mode::Blink : Mode::Before, key_, now);
}

void LookBack::released(int key) {
    if (key != 0 && key == key_) *this = {};
}

bool LookBack::showsBefore(double now) const {
    if (mode_ != Mode::Blink) return mode_ == Mode::Before;
    return static_cast<long>(std::floor((now - since_) / kHalfSeconds)) % 2 == 0;
}

namespace {

/// Steeper than this, a turn about the up axis is hardly more than a rotation of the picture.
constexpr float kSteepFrom = 55.0F;

}  // namespace

CameraPose poseBetween(const CameraPose& from, const CameraPose& to, double share) {
    if (share >= 1.0) return to;
    const float s = smoothStep(0.0F, 1.0F, static_cast<float>(share));
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
