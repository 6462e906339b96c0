/// A view as pixels without a graphics card: places, the nearest triangle, light.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "scene/camera.h"

namespace se::view {

// The nearest triangle at each pixel of a view: for lines and points that triangles hide, where no
// graphics card draws. Plain arithmetic.

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
    /// A number of no triangle.
    static constexpr std::uint32_t kNobody = 0xffffffffU;

    /// Of a view of that size; one over `most` pixels wide or high has fewer pixels than the view.
    explicit DepthPicture(glm::vec2 size, float most = 2048.0F);

    /// Adds a triangle by its corners in screen space.
    void add(const std::array<glm::vec3, 3>& corners, std::uint32_t number);
    /// Whether a triangle lies before that place of the screen space.
    bool hides(const glm::vec3& place) const;
    /// The numbers of the triangles that are nearest at one pixel or more, ascending.
    std::vector<std::uint32_t> visible() const;
    /// Number of the nearest triangle at each pixel, row by row from the top; kNobody: none.
    std::span<const std::uint32_t> numbers() const { return number_; }

  private:
    float scale_;
    glm::ivec2 size_;
    std::vector<float> depth_;
    std::vector<std::uint32_t> number_;
};

/// The light of shaders/mesh.frag on a surface whose unit normal faces the eye, as a factor of its
/// color.
float lightOn(const glm::vec3& normal, const glm::vec3& toEye, const ScreenSpace& screen);

}  // namespace se::view
