/// Parts of a picture that a change covers. Plain mathematics: independent of OpenGL.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "camera.h"

namespace se::view {

// Convex polygons in a plane.

/// Intersection of `subject` and `window`. Both are convex and counterclockwise, and so is the
/// result; empty if they are disjoint. (Sutherland and Hodgman: one cut along each side of the
/// window.)
std::vector<glm::vec2> clipConvex(std::span<const glm::vec2> subject,
                                  std::span<const glm::vec2> window);

/// Positive if b lies to the left of a.
inline float crossOf(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }
/// Positive if counterclockwise.
float areaOf(std::span<const glm::vec2> polygon);

/// Bounds of positions, in view units; empty at first.
struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{-std::numeric_limits<float>::max()};

    bool empty() const { return low.x > high.x; }
    void add(const glm::vec3& place);
    void add(const Bounds& other);
};

/// Pixels from `min` up to but not including `max`, y up as in OpenGL.
struct PixelRect {
    glm::ivec2 min{0};
    glm::ivec2 max{0};

    bool empty() const { return min.x >= max.x || min.y >= max.y; }
    bool meets(const PixelRect& other) const;
    /// Larger by that number of pixels on every side, within a picture of `size`.
    PixelRect grown(int by, glm::ivec2 size) const;
    /// The smallest one that has the pixels of both.
    PixelRect with(const PixelRect& other) const;
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Pixels of a picture of `size` that contents of the bounds can touch, one pixel of margin
/// included: the whole picture if they reach the eye, none if they are empty or outside.
PixelRect pixelsOf(const CameraMatrices& camera, const Bounds& bounds, glm::ivec2 size);

/// The camera of a part of a picture of `size` pixels, as for a picture of its own.
CameraMatrices croppedTo(const PixelRect& part, const CameraMatrices& camera, glm::ivec2 size);

/// Bounds of items that are drawn in the order of their numbers, block by block.
class BlockBounds {
  public:
    static constexpr std::size_t kBlock = 64;
    /// Numbers of items: from the first up to but not including the second.
    using Range = std::pair<std::size_t, std::size_t>;

    void clear() { blocks_.clear(); }
    /// Extends the bounds of the block of an item.
    void add(std::size_t item, const glm::vec3& place);
    /// Bounds of all blocks with an item of the range.
    Bounds of(Range items) const;
    /// The items up to `count` whose blocks can touch the pixels, as few ranges as possible.
    std::vector<Range> within(const CameraMatrices& camera, glm::ivec2 size, const PixelRect& rect,
                              std::size_t count) const;

  private:
    std::vector<Bounds> blocks_;
};

}  // namespace se::view
