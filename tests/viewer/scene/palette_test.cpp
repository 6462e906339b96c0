#include "scene/palette.h"

#include <doctest/doctest.h>

#include <string>

#include "contrast.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

TEST_CASE("Every color with a meaning contrasts with the background") {
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        const Palette& c = paletteOf(theme);
        CAPTURE(std::string(themeName(theme)));
        for (const Color& color :
             {c.pivot, c.used, c.first, c.last, c.test, c.rejected, c.unused, c.done}) {
            CHECK(contrast(color, c.background) >= 3.0);
        }
    }
}

TEST_CASE("Surfaces are lighter than the background, and colors contrast with light ones") {
    const Palette& dark = paletteOf(Theme::Dark);
    CHECK(contrast(dark.mesh, dark.background) >= 4.5);
    const Palette& light = paletteOf(Theme::Light);
    CHECK(luminance(light.mesh) > luminance(light.background) + 0.1);
    for (const Color& color : {light.pivot, light.used, light.first, light.last, light.test,
                               light.rejected, light.unused, light.done}) {
        CHECK(contrast(color, light.mesh) >= 3.0);
    }
}

TEST_CASE("Text contrasts with its background") {
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        const Palette& c = paletteOf(theme);
        CAPTURE(std::string(themeName(theme)));
        const Color hovered = mix(c.panelRaised, c.text, kHoverShare);
        const Color selected = mix(c.panel, c.accent, kSelectedShare);
        for (const Color& under : {c.panel, c.panelRaised, c.background, hovered, selected}) {
            CHECK(contrast(c.text, under) >= 7.0);
            CHECK(contrast(c.textDim, under) >= 4.5);
        }
        CHECK(contrast(c.accentText, c.accent) >= 3.0);
    }
}

TEST_CASE("Contrast is that of WCAG") {
    CHECK(contrast(fromHex(0x000000), fromHex(0xFFFFFF)) == doctest::Approx(21.0));
    CHECK(contrast(fromHex(0x777777), fromHex(0xFFFFFF)) == doctest::Approx(4.478).epsilon(0.001));
    CHECK(contrast(fromHex(0x123456), fromHex(0x123456)) == doctest::Approx(1.0));
}

TEST_CASE("Themes have names") {
    CHECK(themeFromName("dark") == Theme::Dark);
    CHECK(themeFromName("light") == Theme::Light);
    CHECK_FALSE(themeFromName("blue").has_value());
}

namespace {

std::optional<Color> colorOf(Stage stage, const Evidence& evidence) {
    return outcomeColor(paletteOf(Theme::Dark), {{1, stage, 1}, evidence});
}

}  // namespace

TEST_CASE("An event without an outcome has no color of one") {
    CHECK_FALSE(colorOf(Stage::Emit, EmitEvidence{0, {0, 1, 2}}));
    CHECK_FALSE(colorOf(Stage::Advance, AdvanceEvidence{1, 0, false}));
    CHECK_FALSE(colorOf(Stage::Flip, FlipEvidence{0, 1, 2, 3, true}));
    CHECK_FALSE(colorOf(Stage::Pivot, PivotEvidence{0, 1, 2, 3, 180.0}));
}

TEST_CASE("Kept, refused, moved and alarming things have a color each") {
    const Palette& c = paletteOf(Theme::Dark);
    CHECK(colorOf(Stage::TwoPoint, TwoPointEvidence{90.0, Verdict::Hole}) == c.used);
    CHECK(colorOf(Stage::TwoPoint, TwoPointEvidence{190.0, Verdict::Discarded}) == c.rejected);
    LimitEvidence limit{Side::Start, 1, 2, 0.1, 0.0, 20.0, Verdict::Moved};
    CHECK(colorOf(Stage::Limits, limit) == c.test);
    limit.verdict = Verdict::NotListed;
    CHECK(colorOf(Stage::Limits, limit) == c.textDim);
    CHECK(colorOf(Stage::Done, AlertEvidence{AlertKind::Hole, 3}) == c.rejected);
}
