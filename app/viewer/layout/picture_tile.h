/// Tiles of a picture that is larger than what the graphics card draws at once. Plain arithmetic.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "panel_rects.h"
#include "scene/screen_rect.h"

namespace se::view {

/// A part of a picture that is drawn by itself, in pixels from the upper left corner.
struct PictureTile {
    glm::ivec2 min{0};
    glm::ivec2 size{0};
    /// Pixels around it that the view is drawn with: shading, points and lines reach over.
    int margin = 0;
    friend bool operator==(const PictureTile&, const PictureTile&) = default;
};

/// The tiles of a picture of `size` pixels, row by row, such that neither side of what is drawn
/// exceeds `most`; sides are multiples of `multiple`, at the right and lower edge as far as that of
/// the picture is. Empty if the margin leaves nothing.
std::vector<PictureTile> tilesOf(glm::ivec2 size, int most, int margin, int multiple);

/// The part of a view to draw for a tile with its margin, y up from the lower left corner of the
/// view; all of it without a tile. Empty if the tile does not meet the view.
PixelRect partOfView(const Rect& view, const std::optional<PictureTile>& tile);

}  // namespace se::view
