/// Parts and size of a picture of the program, as the command line chooses them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "layout/picture_tile.h"
#include "scene/palette.h"

namespace se::view {

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
