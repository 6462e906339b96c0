/// One color per meaning, for the dark and the light theme. State is never shown by color alone:
/// shapes and letters show it as well.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "spiraling_edge/stepper/event.h"

namespace se::view {

/// sRGB, components in [0, 1].
struct Color {
    float r = 0.0F;
    float g = 0.0F;
    float b = 0.0F;
    float a = 1.0F;

    constexpr Color withAlpha(float alpha) const { return {r, g, b, alpha}; }
    friend bool operator==(const Color&, const Color&) = default;
};

/// Mixes in sRGB: 0 gives a, 1 gives b.
constexpr Color mix(const Color& a, const Color& b, float share) {
    return {a.r + (b.r - a.r) * share, a.g + (b.g - a.g) * share, a.b + (b.b - a.b) * share,
            a.a + (b.a - a.a) * share};
}
constexpr Color fromHex(std::uint32_t rgb) {
    return {static_cast<float>((rgb >> 16U) & 255U) / 255.0F,
            static_cast<float>((rgb >> 8U) & 255U) / 255.0F,
            static_cast<float>(rgb & 255U) / 255.0F, 1.0F};
}

/// Shares of accent below a selected row, and of text below a button with the pointer: dimmed text
/// stays readable on both.
inline constexpr float kSelectedShare = 0.3F;
inline constexpr float kHoverShare = 0.08F;

enum class Theme : std::uint8_t { Dark, Light };
std::optional<Theme> themeFromName(std::string_view name);
std::string_view themeName(Theme theme);

/// Shapes of points. The same numbers are in shaders/point.frag.
enum class Shape : std::uint8_t {
    Hidden = 0,
    Dot = 1,
    Disc = 2,
    Circle = 3,  ///< Open.
    Square = 4,
    OpenSquare = 5,
    Diamond = 6,
    OpenDiamond = 7,
    RingedDisc = 8,
    Forward = 9,  ///< Triangle pointing right.
    Back = 10,    ///< Triangle pointing left.
    Cross = 11,
    Plus = 12,
};

struct Palette {
    // Meanings in the view.
    Color background;
    Color pivot;
    Color used;      ///< USED points, the active ring, kept.
    Color first;     ///< First and start.
    Color last;      ///< Last and end.
    Color test;      ///< Under test; new triangles.
    Color rejected;  ///< Rejected; errors.
    Color unused;
    Color done;  ///< DONE points.
    Color mesh;  ///< Faces of finished triangles.
    Color meshEdge;
    // The panels.
    Color panel;
    Color panelRaised;  ///< Headers, bars, fields.
    Color border;
    Color text;
    Color textDim;
    Color accent;
    Color accentText;  ///< On accent.
};

const Palette& paletteOf(Theme theme);
inline Theme otherTheme(Theme theme) { return theme == Theme::Dark ? Theme::Light : Theme::Dark; }

/// The scale of numbers: from dark violet (0) over green to yellow (1), with increasing lightness,
/// so that it can be read without colors.
Color viridis(float share);

/// Kept, rejected, moved, or without effect; for an alert that of errors. Empty for an event that
/// has no outcome, such as a new triangle or the next pivot: callers choose the color of those.
std::optional<Color> outcomeColor(const Palette& palette, const Event& event);

}  // namespace se::view
