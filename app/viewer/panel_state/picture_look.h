/// Parts and size of a picture of the program, as the command line chooses them.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "layout/panel_rects.h"
#include "scene/palette.h"
#include "scene/screen_rect.h"

namespace se::view {

// Tiles of a picture that is larger than what the graphics card draws at once. Plain arithmetic.

/// A part of a picture that is drawn by itself, in pixels from the upper left corner.
struct PictureTile {
    glm::ivec2 min{0};
    glm::ivec2 size{0};
    /// Pixels around it that the view is drawn with: shading, points and lines reach over.
    int margin = 0;
    friend bool operator==(const PictureTile&, const PictureTile&) = default;
};
/// The tile of frames of which only the layout is needed: a pixel of all.
inline constexpr PictureTile kLayoutAlone{glm::ivec2(0), glm::ivec2(1), 0};

/// The tiles of a picture of `size` pixels, row by row, such that neither side of what is drawn
/// exceeds `most`; sides are multiples of `multiple`, at the right and lower edge as far as that of
/// the picture is. Empty if the margin leaves nothing.
std::vector<PictureTile> tilesOf(glm::ivec2 size, int most, int margin, int multiple);

/// The part of a view to draw for a tile with its margin, y up from the lower left corner of the
/// view; all of it without a tile. Empty if the tile does not meet the view.
PixelRect partOfView(const Rect& view, const std::optional<PictureTile>& tile);

/// Cover of the window while the audience looks at the speaker.
enum class BlankScreen : std::uint8_t { None, Black, White };

struct PictureLook {
    bool viewAlone = false;        ///< Without panels.
    bool cutOut = false;           ///< On a transparent background.
    bool caption = false;          ///< With `viewAlone`: the sentence below the view.
    bool dial = false;             ///< With `viewAlone`: the dial of the pivot beside the view.
    std::string captionText = {};  ///< Text instead of that sentence; empty: the sentence.
    bool labels = true;            ///< Text, axes, pins and legends over the view.
    bool pointLabels = false;      ///< Of these, labels alone.
    /// For tests: frames that pass before a view of another size has its picture.
    std::uint8_t lateFrames = 0;
    std::optional<Color> background;  ///< Instead of that of the theme.
    double scale = 1.0;               ///< Pixels for each one of the size, in each direction.
    int supersample = 1;              ///< Pixels drawn for each one, in each direction.
    std::optional<PictureTile> tile;  ///< The only part to draw; empty: all of it.
};

}  // namespace se::view
