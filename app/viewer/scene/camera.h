/// An orbit camera with one of the axes up. Plain mathematics: independent of window and OpenGL.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "up_axis.h"

namespace se::view {

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

/// A part of a view, in pixels.
struct ViewPart {
    float height = 1.0F;     ///< Of the whole view.
    glm::vec2 offset{0.0F};  ///< From the middle of the view to that of the part, y down.
    float side = 1.0F;       ///< The smaller side of the part.
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
    /// Centers a sphere and makes it fill the view. The direction stays.
    void frame(const glm::vec3& center, float radius);
    /// Brings a sphere to the middle of a part of the view, with a diameter of that share of its
    /// smaller side; no farther away than frame() is for everything. The direction stays.
    void frameIn(const ViewPart& part, const glm::vec3& center, float radius, float share);
    /// Centers positions, and comes as close as keeps them within a share of a view of
    /// that aspect, horizontally and vertically, each in (0, 1]. The direction stays. No effect
    /// without positions.
    void enclose(std::span<const glm::vec3> places, float aspect, glm::vec2 share);
    /// Centers the picture of positions, and makes it fill that share of a view of that aspect in
    /// one direction, at most in the other. The direction stays. No effect without positions.
    void fill(std::span<const glm::vec3> places, float aspect, float share);
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
    /// A direction in the frame of the camera, whose z is up, in which yaw and pitch are measured.
    glm::vec3 inFrame(const glm::vec3& direction) const;
    void toggleOrthographic();
    bool orthographic() const { return pose_.orthographic; }
    /// View of everything from beside the direction `beginning`.
    /// With `sample` points of the input, it fills a view of that aspect as well as it can.
    void home(const glm::vec3& beginning = {0.5F, -0.87F, 0.4F},
              std::span<const glm::vec3> sample = {}, float aspect = 1.3F);

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
    void fit(std::span<const glm::vec3> sample, float aspect);
    glm::vec3 direction() const;  ///< From the target to the eye.
    glm::vec3 right() const;
    glm::vec3 upward() const;  ///< In the picture.
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

/// Pixel position (y down) and depth of a point; depth <= 0 means behind the camera.
glm::vec3 project(const CameraMatrices& camera, const glm::vec3& position, glm::vec2 size);

}  // namespace se::view
