/// Pixels of a picture, and what is computed from them.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace se::view {

/// Rows from the bottom up, as OpenGL has them.
struct Picture {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgba;  ///< Four bytes a pixel; the color is not multiplied by alpha.
};

/// The picture without its background, from the same picture before black and before white: what
/// the two have in common is opaque. Requires equal sizes.
Picture cutOut(const Picture& onBlack, const Picture& onWhite);

/// Copies `part` into `whole`, to that place of its lower left corner. Requires that it fits.
void copyInto(Picture& whole, glm::ivec2 at, const Picture& part);

/// The averages of squares of `factor` by `factor` pixels. Requires a size that is a multiple.
Picture reduced(const Picture& picture, int factor);

}  // namespace se::view
