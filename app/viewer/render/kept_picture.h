/// The picture of the view in three steps: surfaces (with several samples a pixel), the shaded
/// surfaces, which are kept with their depth, and over a copy of these what changes at every step.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "scene/palette.h"
#include "scene/screen_rect.h"

namespace se::view {

/// Quick while the camera moves; full: with several samples a pixel, which takes half as long
/// again, and with ambient occlusion.
enum class Finish : std::uint8_t { Quick, Full };

class KeptPicture {
  public:
    KeptPicture() = default;
    ~KeptPicture();
    KeptPicture(const KeptPicture&) = delete;
    KeptPicture& operator=(const KeptPicture&) = delete;

    /// Makes room for a picture of `size` pixels, of the background alone. True if nothing is
    /// kept. texture() has the same name ever after: a list of drawing that was made before refers
    /// to the new picture.
    bool resize(glm::ivec2 size, const Color& background);
    glm::ivec2 size() const { return size_; }
    PixelRect whole() const { return {glm::ivec2(0), size_}; }

    /// Remembers the target of drawing, which end() restores.
    void begin();
    /// Makes the surfaces the target, cleared in `rect`; nothing is drawn outside of it.
    void beginSurfaces(const PixelRect& rect, const Color& background, Finish finish);
    /// Completes surfaceColor() and surfaceDepth() in the rectangle of beginSurfaces().
    void endSurfaces();
    /// Makes the kept color the target, without depth.
    void beginShading(const PixelRect& rect);
    /// Makes the kept color the target, with the depth of the surfaces.
    void beginPoints(const PixelRect& rect);
    /// Makes a copy of what is kept the target, with depth.
    void beginOverlay();
    void end();

    unsigned surfaceColor() const { return textures_[0]; }
    unsigned surfaceDepth() const { return textures_[1]; }
    /// The whole picture, for ImGui::Image (upside down, as in OpenGL).
    unsigned texture() const { return textures_[3]; }

  private:
    void allocateSurfaces();
    void allocateTextures();

    glm::ivec2 size_{0};
    PixelRect unresolved_;  ///< Where samples have to be averaged.
    /// Samples; surfaces; kept color; kept color with depth; picture.
    std::array<unsigned, 5> frames_{};
    /// Samples of color and depth; depth of the picture.
    std::array<unsigned, 3> buffers_{};
    /// Color and depth of the surfaces; kept color; color of the picture.
    std::array<unsigned, 4> textures_{};
    int previous_ = 0;
};

}  // namespace se::view
