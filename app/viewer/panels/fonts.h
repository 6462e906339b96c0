/// The fonts of the user interface.
#pragma once

#include <string>

struct ImFont;

namespace se::view {

struct Fonts {
    ImFont* text = nullptr;
    ImFont* strong = nullptr;
    ImFont* mono = nullptr;
    ImFont* small = nullptr;    ///< For the legend, and tabs in little room.
    ImFont* large = nullptr;    ///< For the narration line.
    ImFont* caption = nullptr;  ///< For the narration line read from a distance.
    bool symbols = false;       ///< The font has the math signs; otherwise words are written.
};

/// Puts the fonts at `em` pixels into the atlas of the current ImGui context, replacing all others.
Fonts loadFonts(float em);

}  // namespace se::view
