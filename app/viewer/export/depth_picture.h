/// The nearest triangle at each pixel of a view: for lines and points that triangles hide, where no
/// graphics card draws. Plain arithmetic.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "scene/camera.h"

namespace se::view {

/// Positions of a view as pixels (y down) and depth (-1 near to 1 far).
class ScreenSpace {
  public:
    ScreenSpace(const CameraMatrices& camera, glm::vec2 size);

    /// Empty if the position is behind the eye. `bias`: view units toward the eye.
    std::optional<glm::vec3> at(const glm::vec3& position, float bias = 0.0F) const;
    /// The unit direction to the eye.
    glm::vec3 toEye(const glm::vec3& position) const;
    const CameraMatrices& camera() const { return camera_; }
    glm::vec2 size() const { return size_; }
    glm::vec3 right() const;
    glm::vec3 up() const;

  private:
    CameraMatrices camera_;
    glm::mat4 toClip_;
    glm::vec2 size_;
};

/// Depth and number of the nearest triangle, pixel by pixel.
class DepthPicture {
  public:
    /// Of a view of that size; larger ones have fewer pixels than the view.
    explicit DepthPicture(glm::vec2 size);

    /// Adds a triangle by its corners in screen space.
    void add(const std::array<glm::vec3, 3>& corners, std::uint32_t number);
    /// Whether a triangle lies before that place of the screen space.
    bool hides(const glm::vec3& place) const;
    /// The numbers of the triangles that are nearest at one pixel or more, ascending.
    std::vector<std::uint32_t> visible() const;

  private:
    float scale_;
    glm::ivec2 size_;
    std::vector<float> depth_;
    std::vector<std::uint32_t> number_;
};

}  // namespace se::view
