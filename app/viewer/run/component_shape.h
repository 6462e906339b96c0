/// A component that is complete: which triangles it has, where it is, where it ends. Found once,
/// by the thread that makes the overview: to look at all its triangles takes longer than a frame.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model.h"

namespace se::view {

struct ComponentShape {
    std::uint32_t pivot = 0;  ///< At whose end it was complete.
    std::size_t begin = 0;    ///< Its first triangle,
    std::size_t end = 0;      ///< and the one after its last.
    glm::vec3 middle{0.0F};   ///< View space.
    std::vector<std::array<Index, 2>>
        rim;                 ///< Directed edges that have a triangle on one side only.
    std::size_t points = 0;  ///< That its triangles use.
    std::size_t loops = 0;   ///< Pieces of the rim that hang together.
    double seconds = 0.0;    ///< From the beginning of the run that the overview was made with.
};

/// The component that consists of `triangles`; `begin` is the number of the first.
ComponentShape shapeOf(const Model& model, std::span<const Triangle> triangles, std::size_t begin);

/// The one that was complete at the end of `pivot`; null if it is not known. `shapes` are in order.
const ComponentShape* shapeAt(std::span<const ComponentShape> shapes, std::uint32_t pivot);

}  // namespace se::view
