#include "camera.h"

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <vector>

#include "run/model.h"
#include "run/strings.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/points/wall_types.h"

namespace se::view {

// File formats do not record which way is up. Three clues are tried in order of reliability: a
// flat side on which the object rests (at one end of the box far more points with outward normals
// than at any other end), the thin axis of a plate, and the convention of the format. O(points).

namespace {

constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};

/// Points this close to an end of the box, as a share of its side, may lie on a flat side there.
constexpr double kEndShare = 0.02;
/// Cosine between the normal of such a point and the axis.
constexpr double kFacing = 0.9;
/// A flat side has at least this share of all points, and kFlatFactor times the points of any other
/// end.
constexpr double kFlatShare = 0.02;
constexpr double kFlatFactor = 2.0;
/// A plate is at most this thin against its width, and at least this wide against its length.
constexpr double kThin = 0.4;
constexpr double kWide = 0.7;

constexpr int kAxes = 3;

/// Number of points that lie flat at the low and the high end of each axis.
std::array<std::size_t, 2 * kAxes> flatPoints(const PointSet& points, const WallBox& box) {
    std::array<std::size_t, 2 * kAxes> counts{};
    const Vec3 margin = kEndShare * (box.high - box.low);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points.position[i];
        const Vec3& n = points.normal[i];
        for (int axis = 0; axis < kAxes; ++axis) {
            const auto end = 2 * static_cast<std::size_t>(axis);
            if (p[axis] < box.low[axis] + margin[axis] && n[axis] < -kFacing) ++counts[end];
            if (p[axis] > box.high[axis] - margin[axis] && n[axis] > kFacing) ++counts[end + 1];
        }
    }
    return counts;
}

/// The axis with an end that has far more flat points than all other ends.
std::optional<UpAxis> axisOfFlatSide(const PointSet& points, const WallBox& box) {
    auto counts = flatPoints(points, box);
    const auto most = std::max_element(counts.begin(), counts.end());
    const auto axis = static_cast<UpAxis>((most - counts.begin()) / 2);
    const auto count = static_cast<double>(*most);
    *most = 0;
    const auto next = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
    if (count == 0.0 || count < kFlatShare * static_cast<double>(points.size()) ||
        count < kFlatFactor * next)
        return std::nullopt;
    return axis;
}

/// The thin axis of a plate.
std::optional<UpAxis> axisOfPlate(const WallBox& box) {
    const Vec3 sides = box.high - box.low;
    std::array<int, kAxes> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return sides[a] < sides[b]; });
    const double thin = sides[order[0]];
    const double wide = sides[order[1]];
    const double longest = sides[order[2]];
    const bool plate = longest > 0.0 && thin <= kThin * wide && wide >= kWide * longest;
    if (!plate) return std::nullopt;
    return static_cast<UpAxis>(order[0]);
}

/// True if the extension is that of a format for meshes; false for one for points alone.
bool isForMeshes(const std::filesystem::path& path) {
    const PointFormat* points = pointFormatOf(path);
    if (points != nullptr) return points->faces;
    return path.has_extension() && meshFormatOf(path) != nullptr;
}

}  // namespace

std::string_view upAxisName(UpAxis axis) { return kNames[static_cast<std::size_t>(axis)]; }

std::optional<UpAxis> upAxisFromName(std::string_view name) {
    return idNamed<UpAxis>(kNames, name);
}

UpAxis guessUpAxis(const PointSet& points, std::string_view source) {
    const bool made = isScene(source) || isSample(source) || isPractice(source);
    if (made || std::any_of(points.type.begin(), points.type.end(), isOnWall)) return UpAxis::Z;
    const WallBox box = boxAround(points.position);
    if (const auto axis = axisOfFlatSide(points, box)) return *axis;
    if (const auto axis = axisOfPlate(box)) return *axis;
    return isForMeshes(source) ? UpAxis::Y : UpAxis::Z;
}

namespace {

constexpr float kFieldOfViewDegrees = 32.0F;
constexpr float kSteepestDegrees = 90.0F;
constexpr float kNearest = 0.002F;
constexpr float kFarthestAway = 60.0F;
/// Degrees of turn for a drag over the whole height of the view.
constexpr float kTurnPerHeight = 240.0F;
/// A surface whose normal points this much to the eye is seen from outside.
constexpr float kFacesFrom = 0.15F;
/// Least distance of the eye, over that of the nearest position, from the middle of all.
constexpr float kBeforeEye = 1.25F;
/// Halvings that center a picture to a fraction of a pixel.
constexpr int kHalvings = 16;
/// Radius of a sphere that everything fits into.
constexpr float kSceneRadius = 1.0F;

float halfTangent() { return std::tan(glm::radians(kFieldOfViewDegrees) * 0.5F); }

/// Two planes through the eye, in one direction of the picture: across per depth, up or to the
/// right.
struct Wedge {
    float low;
    float high;
};

/// An eye, in one direction of the picture: across, and its distance from the middle.
struct Apex {
    float across;
    float distance;
};

/// The nearest eye from which positions, across and towards the eye, lie between the two planes.
/// Then one of them lies on each.
Apex apexOf(std::span<const glm::vec2> places, const Wedge& wedge) {
    float high = std::numeric_limits<float>::lowest();
    float low = std::numeric_limits<float>::max();
    for (const glm::vec2& p : places) {
        high = std::max(high, p.x + p.y * wedge.high);
        low = std::min(low, p.x + p.y * wedge.low);
    }
    const float distance = (high - low) / (wedge.high - wedge.low);
    return {high - distance * wedge.high, distance};
}

/// Position across of the eye that, from that distance, sees the positions in the middle of the
/// part about `center`; they span at most `half` to either side.
float centeredAt(std::span<const glm::vec2> places, float center, float half, float distance) {
    float least = 0.0F;
    for (int i = 0; i < kHalvings; ++i) {
        const float middle = 0.5F * (least + half);
        const bool fits = apexOf(places, {center - middle, center + middle}).distance <= distance;
        (fits ? half : least) = middle;
    }
    return apexOf(places, {center - half, center + half}).across;
}

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

void Camera::fill(std::span<const glm::vec3> places, const ViewPart& part, float share) {
    if (places.empty()) return;
    const std::array axes = {right(), upward(), direction()};
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(-low);
    const auto seen = [&](const glm::vec3& p) {
        return glm::vec3(glm::dot(p, axes[0]), glm::dot(p, axes[1]), glm::dot(p, axes[2]));
    };
    for (const glm::vec3& p : places) {
        low = glm::min(low, seen(p));
        high = glm::max(high, seen(p));
    }
    const glm::vec3 middle = 0.5F * (low + high);
    std::array<std::vector<glm::vec2>, 2> across;
    for (const glm::vec3& p : places) {
        const glm::vec3 off = seen(p) - middle;
        // In an orthographic view nothing is larger by being nearer.
        const float depth = pose_.orthographic ? 0.0F : off.z;
        across[0].emplace_back(off.x, depth);
        across[1].emplace_back(off.y, depth);
    }
    const float free = 1.0F - part.coveredBelow;
    const glm::vec2 half = halfTangent() * share * glm::vec2(part.aspect, free);
    const glm::vec2 center(0.0F, halfTangent() * part.coveredBelow);
    // The nearest of them lies well before the eye.
    const float depth = pose_.orthographic ? 0.0F : high.z - middle.z;
    pose_.distance = std::max(kNearest, kBeforeEye * depth);
    for (int i = 0; i < 2; ++i) {
        const Wedge wedge{center[i] - half[i], center[i] + half[i]};
        pose_.distance = std::max(pose_.distance, apexOf(across[i], wedge).distance);
    }
    pose_.distance = std::min(pose_.distance, kFarthestAway);
    pose_.target = middle.z * axes[2];
    for (int i = 0; i < 2; ++i)
        pose_.target +=
            (middle[i] + centeredAt(across[i], center[i], half[i], pose_.distance)) * axes[i];
    ++revision_;
}

Ray rayThrough(const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel) {
    const glm::mat4 back = glm::inverse(camera.viewProjection());
    const glm::vec2 ndc(2.0F * pixel.x / size.x - 1.0F, 1.0F - 2.0F * pixel.y / size.y);
    const glm::vec4 low = back * glm::vec4(ndc, -1.0F, 1.0F);
    const glm::vec4 high = back * glm::vec4(ndc, 1.0F, 1.0F);
    const glm::vec3 from = glm::vec3(low) / low.w;
    return {from, glm::normalize(glm::vec3(high) / high.w - from)};
}

}  // namespace se::view
