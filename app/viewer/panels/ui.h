/// Lifetime, style and fonts of Dear ImGui.
#pragma once

#include <optional>
#include <string>

#include "panel_state/picture_look.h"
#include "scene/palette.h"

struct ImFont;

namespace se::view {

struct Fonts {
    ImFont* text = nullptr;
    ImFont* strong = nullptr;
    ImFont* mono = nullptr;
    ImFont* small = nullptr;    ///< For the legend, and captions in little room.
    ImFont* large = nullptr;    ///< For the narration line.
    ImFont* caption = nullptr;  ///< For the narration line read from a distance.
};

/// Pixels of an em at scale 1.
inline constexpr float kEmPixels = 16.0F;

class Ui {
  public:
    /// In the current OpenGL context. The platform side is handled by the window.
    Ui();
    ~Ui();
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    /// Sets fonts, sizes and colors; cheap if nothing changed.
    void setLooks(float scale, Theme theme);
    const Fonts& fonts() const { return fonts_; }
    /// Pixels of an em, the height of a line of text.
    float em() const { return em_; }

    void beginFrame();
    /// Ends the frame without drawing it. True if its draw data differs from the frame before.
    bool endFrame();
    /// Draws the ended frame, or a tile of it.
    void draw(const std::optional<PictureTile>& tile) const;

  private:
    std::string content_;  ///< Draw data of the last frame, without the pixels of textures.
    Fonts fonts_;
    float scale_ = 0.0F;
    float em_ = 16.0F;
    Theme theme_ = Theme::Dark;
    bool looksSet_ = false;
};

}  // namespace se::view
