#include "camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace se::view {

namespace {

constexpr float kFieldOfViewDegrees = 32.0F;
constexpr float kSteepestDegrees = 90.0F;
constexpr float kNearest = 0.002F;
constexpr float kFarthestAway = 60.0F;
/// Degrees of turn for a drag over the whole height of the view.
constexpr float kTurnPerHeight = 240.0F;
/// Limits of the steepness with which home looks down.
constexpr float kLowestHomeDegrees = 27.0F;
constexpr float kHighestHomeDegrees = 46.0F;
/// A surface whose normal points this much to the eye is seen from outside.
constexpr float kFacesFrom = 0.15F;
/// Room around the points, as a factor.
constexpr float kHomeMargin = 1.12F;
/// Rounds in which the share of a picture comes within a percent.
constexpr int kFillRounds = 6;
/// Radius of a sphere that everything fits into.
constexpr float kSceneRadius = 1.0F;

float halfTangent() { return std::tan(glm::radians(kFieldOfViewDegrees) * 0.5F); }

}  // namespace

glm::vec3 Camera::direction() const {
    const float yaw = glm::radians(pose_.yawDegrees);
    const float pitch = glm::radians(pose_.pitchDegrees);
    return fromFrame(
        {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)});
}

glm::vec3 Camera::right() const {
    // From the yaw alone, so that it is also known when looking straight down.
    const float yaw = glm::radians(pose_.yawDegrees);
    return fromFrame({-std::sin(yaw), std::cos(yaw), 0.0F});
}

glm::vec3 Camera::upward() const { return glm::cross(direction(), right()); }

glm::vec3 Camera::fromFrame(const glm::vec3& d) const {
    // Rotations: they keep handedness.
    if (pose_.up == UpAxis::X) return {d.z, d.x, d.y};
    return pose_.up == UpAxis::Y ? glm::vec3(d.x, d.z, -d.y) : d;
}

glm::vec3 Camera::inFrame(const glm::vec3& d) const {
    if (pose_.up == UpAxis::X) return {d.y, d.z, d.x};
    return pose_.up == UpAxis::Y ? glm::vec3(d.x, -d.z, d.y) : d;
}

void Camera::setUp(UpAxis up) {
    if (pose_.up == up) return;
    pose_.up = up;
    ++revision_;
}

float Camera::heightAtTarget() const { return 2.0F * pose_.distance * halfTangent(); }

CameraMatrices Camera::matrices(float aspect) const {
    CameraMatrices m;
    const glm::vec3 eye = pose_.target + direction() * pose_.distance;
    const float reach = glm::length(eye) + 1.5F * kSceneRadius;
    m.view = glm::lookAt(eye, pose_.target, upward());
    m.eye = eye;
    m.orthographic = pose_.orthographic;
    if (pose_.orthographic) {
        const float half = 0.5F * heightAtTarget();
        m.projection = glm::ortho(-half * aspect, half * aspect, -half, half, -reach, reach);
    } else {
        const float nearPlane = std::max(pose_.distance * 0.02F, reach * 1e-4F);
        m.projection =
            glm::perspective(glm::radians(kFieldOfViewDegrees), aspect, nearPlane, reach);
    }
    return m;
}

void Camera::setPose(const CameraPose& pose) {
    pose_ = pose;
    pose_.distance = std::clamp(pose.distance, kNearest, kFarthestAway);
    pose_.pitchDegrees = std::clamp(pose.pitchDegrees, -90.0F, 90.0F);
    ++revision_;
}

void Camera::orbit(glm::vec2 pixels, float height) {
    pose_.yawDegrees = std::fmod(pose_.yawDegrees - pixels.x / height * kTurnPerHeight, 360.0F);
    pose_.pitchDegrees = std::clamp(pose_.pitchDegrees + pixels.y / height * kTurnPerHeight,
                                    -kSteepestDegrees, kSteepestDegrees);
    ++revision_;
}

void Camera::pan(glm::vec2 pixels, float height) {
    const float unit = heightAtTarget() / height;
    pose_.target += right() * (-pixels.x * unit) + upward() * (pixels.y * unit);
    ++revision_;
}

void Camera::zoomAt(float notches, glm::vec2 ndc, float aspect) {
    const float before = pose_.distance;
    pose_.distance = std::clamp(pose_.distance * std::pow(0.85F, notches), kNearest, kFarthestAway);
    const float moved = (before - pose_.distance) * halfTangent();
    pose_.target += right() * (ndc.x * aspect * moved) + upward() * (ndc.y * moved);
    ++revision_;
}

void Camera::frame(const glm::vec3& center, float radius) {
    pose_.target = center;
    pose_.distance = std::clamp(1.12F * radius / std::sin(glm::radians(kFieldOfViewDegrees) * 0.5F),
                                kNearest, kFarthestAway);
    ++revision_;
}

void Camera::frameIn(const ViewPart& part, const glm::vec3& center, float radius, float share) {
    frame(glm::vec3(0.0F), kSceneRadius);
    const float whole = pose_.distance;
    const float near = radius * part.height / (share * part.side * halfTangent());
    pose_.distance = std::clamp(near, kNearest, whole);
    pose_.target = center;
    pan(part.offset, part.height);
}

void Camera::face(const glm::vec3& normal) {
    if (glm::dot(direction(), normal) <= kFacesFrom) faceStraight(normal);
}

void Camera::faceStraight(const glm::vec3& normal) {
    const glm::vec3 to = inFrame(normal);
    const float flat = std::hypot(to.x, to.y);
    // Straight from above or below, as in those presets.
    pose_.yawDegrees = flat > 1e-3F ? glm::degrees(std::atan2(to.y, to.x)) : -90.0F;
    pose_.pitchDegrees = glm::degrees(std::atan2(to.z, flat));
    ++revision_;
}

void Camera::lookAt(const glm::vec3& target) {
    pose_.target = target;
    ++revision_;
}

void Camera::toggleOrthographic() {
    pose_.orthographic = !pose_.orthographic;
    ++revision_;
}

void Camera::set(ViewPreset preset) {
    struct Direction {
        float yaw;
        float pitch;
    };
    constexpr Direction kDirections[] = {{-90, 0}, {90, 0},   {0, 0},
                                         {180, 0}, {-90, 90}, {-90, -90}};
    const auto& [yaw, pitch] = kDirections[static_cast<std::size_t>(preset)];
    pose_.yawDegrees = yaw;
    pose_.pitchDegrees = pitch;
    ++revision_;
}

void Camera::fit(std::span<const glm::vec3> sample, float aspect) {
    glm::vec2 low(std::numeric_limits<float>::max());
    glm::vec2 high(-low);
    for (const glm::vec3& p : sample) {
        const glm::vec2 seen(glm::dot(p, right()), glm::dot(p, upward()));
        low = glm::min(low, seen);
        high = glm::max(high, seen);
    }
    const glm::vec2 middle = 0.5F * (low + high);
    pose_.target = right() * middle.x + upward() * middle.y;
    const float t = halfTangent();
    pose_.distance = kNearest;
    for (const glm::vec3& p : sample) {
        const float x = std::abs(glm::dot(p, right()) - middle.x);
        const float y = std::abs(glm::dot(p, upward()) - middle.y);
        const float depth = glm::dot(p, direction());
        pose_.distance =
            std::max(pose_.distance, depth + kHomeMargin * std::max(x / (t * aspect), y / t));
    }
}

void Camera::enclose(std::span<const glm::vec3> places, float aspect, glm::vec2 share) {
    if (places.empty()) return;
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(-low);
    const auto seen = [&](const glm::vec3& p) {
        return glm::vec3(glm::dot(p, right()), glm::dot(p, upward()), glm::dot(p, direction()));
    };
    for (const glm::vec3& p : places) {
        low = glm::min(low, seen(p));
        high = glm::max(high, seen(p));
    }
    const glm::vec3 middle = 0.5F * (low + high);
    pose_.target = right() * middle.x + upward() * middle.y + direction() * middle.z;
    const glm::vec2 half = halfTangent() * share * glm::vec2(aspect, 1.0F);
    float distance = kNearest;
    for (const glm::vec3& p : places) {
        const glm::vec3 off = seen(p) - middle;
        distance = std::max(distance,
                            off.z + std::max(std::abs(off.x) / half.x, std::abs(off.y) / half.y));
    }
    pose_.distance = std::min(distance, kFarthestAway);
    ++revision_;
}

void Camera::fill(std::span<const glm::vec3> places, float aspect, float share) {
    if (places.empty()) return;
    enclose(places, aspect, glm::vec2(share));
    // What is nearer looks larger: neither the middle nor the size is that of the box around all.
    for (int round = 0; round < kFillRounds; ++round) {
        const glm::mat4 toClip = matrices(aspect).viewProjection();
        glm::vec2 low(std::numeric_limits<float>::max());
        glm::vec2 high(-low);
        for (const glm::vec3& p : places) {
            const glm::vec4 clip = toClip * glm::vec4(p, 1.0F);
            const glm::vec2 at = glm::vec2(clip) / std::max(clip.w, 1e-4F);
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        const glm::vec2 middle = 0.25F * (low + high) * heightAtTarget();
        pose_.target += right() * (middle.x * aspect) + upward() * middle.y;
        const glm::vec2 filled = 0.5F * (high - low);
        pose_.distance = std::clamp(pose_.distance * std::max(filled.x, filled.y) / share, kNearest,
                                    kFarthestAway);
    }
    ++revision_;
}

void Camera::home(const glm::vec3& beginning, std::span<const glm::vec3> sample, float aspect) {
    const glm::vec3 from = inFrame(beginning);
    const float flat = std::hypot(from.x, from.y);
    if (flat > 1e-3F) pose_.yawDegrees = glm::degrees(std::atan2(from.y, from.x)) - 35.0F;
    const float elevation = glm::degrees(std::atan2(from.z, flat));
    pose_.pitchDegrees = std::clamp(elevation - 15.0F, kLowestHomeDegrees, kHighestHomeDegrees);
    frame(glm::vec3(0.0F), kSceneRadius);
    if (!sample.empty()) fit(sample, aspect);
}

Ray rayThrough(const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel) {
    const glm::mat4 back = glm::inverse(camera.viewProjection());
    const glm::vec2 ndc(2.0F * pixel.x / size.x - 1.0F, 1.0F - 2.0F * pixel.y / size.y);
    const glm::vec4 low = back * glm::vec4(ndc, -1.0F, 1.0F);
    const glm::vec4 high = back * glm::vec4(ndc, 1.0F, 1.0F);
    const glm::vec3 from = glm::vec3(low) / low.w;
    return {from, glm::normalize(glm::vec3(high) / high.w - from)};
}

glm::vec3 project(const CameraMatrices& camera, const glm::vec3& position, glm::vec2 size) {
    const glm::vec4 clip = camera.viewProjection() * glm::vec4(position, 1.0F);
    if (clip.w <= 0.0F) return {0.0F, 0.0F, -1.0F};
    const glm::vec3 ndc = glm::vec3(clip) / clip.w;
    return {(ndc.x * 0.5F + 0.5F) * size.x, (0.5F - ndc.y * 0.5F) * size.y,
            -(camera.view * glm::vec4(position, 1.0F)).z + (camera.orthographic ? 100.0F : 0.0F)};
}

}  // namespace se::view
