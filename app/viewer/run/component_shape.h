/// A complete component: its triangles, its position and its boundary. Computed once, by the thread
/// that makes the overview, because a pass over all its triangles takes longer than a frame.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model.h"

namespace se::view {

struct ComponentShape {
    std::uint32_t pivot = 0;  ///< Pivot at whose end the component was complete.
    std::size_t begin = 0;    ///< Number of its first triangle.
    std::size_t end = 0;      ///< Number after its last triangle.
    glm::vec3 middle{0.0F};   ///< View space.
    std::vector<std::array<Index, 2>>
        rim;                 ///< Directed edges that have a triangle on one side only.
    std::size_t points = 0;  ///< Number of points that its triangles use.
    std::size_t loops = 0;   ///< Number of connected pieces of the rim.
    double seconds = 0.0;    ///< Seconds from the start of the overview's run.
};

/// The component that consists of `triangles`; `begin` is the number of the first.
ComponentShape shapeOf(const Model& model, std::span<const Triangle> triangles, std::size_t begin);

/// The component that was complete at the end of `pivot`; null if unknown. `shapes` are in order.
const ComponentShape* shapeAt(std::span<const ComponentShape> shapes, std::uint32_t pivot);

}  // namespace se::view
