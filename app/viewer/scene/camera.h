/// An orbit camera with one of the axes up. Plain mathematics: independent of window and OpenGL.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "spiraling_edge/points/point_set.h"

namespace se::view {

// The axis of an input that points up.

enum class UpAxis : std::uint8_t { X, Y, Z };

/// "x", "y", "z": the names in settings and session files.
std::string_view upAxisName(UpAxis axis);
/// Empty if there is no axis of that name.
std::optional<UpAxis> upAxisFromName(std::string_view name);

/// A guess at the up axis of `source`. Scenes, sampled points and points with wall types have z
/// up. Other files lie on their flat side if they have one; otherwise the convention of
/// their format decides: y for formats of meshes, such as PLY, z for all others. O(points).
UpAxis guessUpAxis(const PointSet& points, std::string_view source);

enum class ViewPreset { Front, Back, Right, Left, Top, Bottom };

/// Matrices for the renderer and picking.
struct CameraMatrices {
    glm::mat4 view{1.0F};
    glm::mat4 projection{1.0F};
    glm::vec3 eye{0.0F};
    bool orthographic = false;

    glm::mat4 viewProjection() const { return projection * view; }
    friend bool operator==(const CameraMatrices&, const CameraMatrices&) = default;
};

/// Pose of a camera, as plain numbers: to be stored and restored.
struct CameraPose {
    glm::vec3 target{0.0F};  ///< View space.
    float distance = 3.4F;
    float yawDegrees = -60.0F;
    float pitchDegrees = 24.0F;
    bool orthographic = false;
    UpAxis up = UpAxis::Z;  ///< Axis of yaw and pitch.
    friend bool operator==(const CameraPose&, const CameraPose&) = default;
};

/// The part of a view that nothing covers: from its upper edge down to the caption.
struct ViewPart {
    float aspect = 1.3F;        ///< Of the whole view.
    float coveredBelow = 0.0F;  ///< Share of its height at the lower edge, in [0, 1).
    friend bool operator==(const ViewPart&, const ViewPart&) = default;
};

/// Looks at `target` from `distance`. View space has the input in the unit sphere about the origin.
class Camera {
  public:
    CameraMatrices matrices(float aspect) const;

    /// Turns by a drag of `pixels` in a view of `height` pixels.
    void orbit(glm::vec2 pixels, float height);
    void pan(glm::vec2 pixels, float height);
    /// Zooms by `notches` of the wheel, so that the point under `ndc` (in [-1, 1], y up) stays
    /// there.
    void zoomAt(float notches, glm::vec2 ndc, float aspect);
    /// Brings the picture of positions to the middle of that part of the view. It fills `share` of
    /// the part in one direction, and at most that in the other. The direction of the camera stays.
    /// No effect without positions.
    void fill(std::span<const glm::vec3> places, const ViewPart& part, float share);
    /// Turns to look at a surface with that normal from its outer side; keeps the direction
    /// if it does so already.
    void face(const glm::vec3& normal);
    /// Turns to look straight at a surface with that normal from its outer side.
    void faceStraight(const glm::vec3& normal);
    /// Moves `target` to the middle of the view; later orbits turn about it.
    void lookAt(const glm::vec3& target);
    void set(ViewPreset preset);
    UpAxis up() const { return pose_.up; }
    /// Turns so that this axis points up; yaw, pitch, target and distance stay.
    void setUp(UpAxis up);
    glm::vec3 direction() const;  ///< From the target to the eye.
    glm::vec3 right() const;      ///< In the picture.
    glm::vec3 upward() const;     ///< In the picture.
    /// A direction in the frame of the camera, whose z is up, in which yaw and pitch are measured.
    glm::vec3 inFrame(const glm::vec3& direction) const;
    void toggleOrthographic();
    bool orthographic() const { return pose_.orthographic; }
    const CameraPose& pose() const { return pose_; }
    /// Sets a pose, clamped to its limits.
    void setPose(const CameraPose& pose);
    const glm::vec3& target() const { return pose_.target; }
    float distance() const { return pose_.distance; }
    /// Height of the view at the target, in view units.
    float heightAtTarget() const;
    /// Grows with every change.
    unsigned revision() const { return revision_; }

    friend bool operator==(const Camera&, const Camera&) = default;

  private:
    /// The inverse of inFrame().
    glm::vec3 fromFrame(const glm::vec3& direction) const;

    CameraPose pose_;
    unsigned revision_ = 0;
};

/// A line of sight; the direction has unit length.
struct Ray {
    glm::vec3 from{0.0F};
    glm::vec3 way{0.0F};

    glm::vec3 at(float distance) const { return from + distance * way; }
};

/// The line of sight through a pixel (y down) of a view of `size` pixels, from the near plane on.
Ray rayThrough(const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel);

/// Projection from positions to pixels, with all constant parts computed once.
class Projector {
  public:
    Projector(const CameraMatrices& camera, glm::vec2 size)
        : camera_(camera), size_(size), toClip_(camera.viewProjection()) {}

    /// Pixel (y down) and depth; depth <= 0 means behind the camera.
    glm::vec3 operator()(const glm::vec3& place) const {
        const glm::vec4 clip = toClip_ * glm::vec4(place, 1.0F);
        if (clip.w <= 0.0F) return {0.0F, 0.0F, -1.0F};
        const float depth =
            camera_.orthographic ? 100.0F - (camera_.view * glm::vec4(place, 1.0F)).z : clip.w;
        return {(0.5F * clip.x / clip.w + 0.5F) * size_.x,
                (0.5F - 0.5F * clip.y / clip.w) * size_.y, depth};
    }
    /// From the position toward the eye, of unspecified length.
    glm::vec3 toEye(const glm::vec3& place) const {
        if (!camera_.orthographic) return camera_.eye - place;
        return {camera_.view[0][2], camera_.view[1][2], camera_.view[2][2]};
    }

  private:
    CameraMatrices camera_;
    glm::vec2 size_;
    glm::mat4 toClip_;
};

/// The pixel (y down) and depth of a position, as of a Projector.
inline glm::vec3 project(const CameraMatrices& camera, const glm::vec3& place, glm::vec2 size) {
    return Projector(camera, size)(place);
}

/// From 0 at `low` to 1 at `high`, slow at both ends.
inline float smoothStep(float low, float high, float value) {
    const float share = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
    return share * share * (3.0F - 2.0F * share);
}

// Detail that has room on the screen, from the distance of the points there.

/// Pixels from which marks of single points are shown, and from which they have full strength.
inline constexpr float kMarksFrom = 10.0F;
inline constexpr float kMarksFull = 20.0F;
/// Pixels below which shapes of points cannot be told apart.
inline constexpr float kShapesFrom = 10.0F;

/// Distance of the points in pixels of a view of `height`, at the near side of the middle of the
/// scene. `spacing`: their distance in view units.
inline float spacingInPixels(const CameraMatrices& camera, float height, float spacing) {
    const float depth =
        camera.orthographic ? 1.0F : std::max(0.01F, glm::length(camera.eye) - 0.7F);
    return 0.5F * height * camera.projection[1][1] * spacing / depth;
}

/// Strength, from 0 to 1, of marks on the mesh where points are that many pixels apart: closer
/// together they would cover it, and make patterns.
inline float markStrength(float pixels) { return smoothStep(kMarksFrom, kMarksFull, pixels); }

/// Whether points that many pixels apart are drawn as solid dots with depth, instead of shapes.
inline bool drawnSolid(float pixels) { return pixels < kShapesFrom; }
/// Diameter of solid dots, as a share of their distance.
inline constexpr float kSolidShare = 0.8F;
/// Strength below which marks are left out.
inline constexpr float kFaintest = 0.02F;

/// The most by which single marks and lines grow.
inline constexpr float kMaxMarkZoom = 1.15F;
/// Growth of single marks and lines where points are that many pixels apart.
inline float markZoom(float pixels, float em) {
    return std::clamp(pixels / em / 1.5F, 0.72F, kMaxMarkZoom);
}

}  // namespace se::view
