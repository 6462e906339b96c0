/// The colors of an animation as GIF, which has at most 256: those of the palette, with what light
/// and transparency make of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/palette.h"

namespace se::view {

/// Bytes of the colors of a theme, red, green and blue in turn; fewer than 256 colors, so that one
/// is left for pixels that do not change.
std::vector<std::uint8_t> gifPalette(Theme theme);

/// Finds the nearest color of a palette.
class NearestColor {
  public:
    explicit NearestColor(std::span<const std::uint8_t> palette);

    std::uint8_t of(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

  private:
    std::span<const std::uint8_t> palette_;
    std::vector<std::int16_t> known_;  ///< By the upper six bits of each component; -1: not yet.
};

}  // namespace se::view
