#include "export/formats.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace se::view;

namespace {

/// Greatest difference of a component between a color and the nearest one of the palette.
int awayFrom(const std::vector<std::uint8_t>& palette, NearestColor& nearest, const Color& color) {
    const std::uint8_t rgb[3] = {static_cast<std::uint8_t>(std::lround(255.0F * color.r)),
                                 static_cast<std::uint8_t>(std::lround(255.0F * color.g)),
                                 static_cast<std::uint8_t>(std::lround(255.0F * color.b))};
    const std::size_t found = nearest.of(rgb[0], rgb[1], rgb[2]);
    int most = 0;
    for (std::size_t i = 0; i < 3; ++i)
        most = std::max(most, std::abs(int{palette[3 * found + i]} - int{rgb[i]}));
    return most;
}

}  // namespace

TEST_CASE("An animation has the colors of the theme exactly, and leaves one for what stays") {
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        const std::vector<std::uint8_t> palette = gifPalette(theme);
        CHECK(palette.size() / 3 < 256);
        NearestColor nearest(palette);
        const Palette& p = paletteOf(theme);
        for (const Color& each : {p.background, p.pivot, p.used, p.first, p.last, p.test,
                                  p.rejected, p.unused, p.done, p.text})
            CHECK(awayFrom(palette, nearest, each) <= 3);
        for (int i = 3; i <= 10; ++i) {
            const float light = static_cast<float>(i) / 10.0F;
            CHECK(awayFrom(palette, nearest,
                           {p.mesh.r * light, p.mesh.g * light, p.mesh.b * light}) <= 4);
        }
    }
}
