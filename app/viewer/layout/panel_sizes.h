/// Sizes of panels that the user sets by dragging the splitters between them. Plain values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace se::view {

/// Splitters by the part that they resize; LearnColumn and LearnDial are those of the layout Learn.
enum class Splitter : std::uint8_t {
    Left,
    Right,
    Dial,
    Lower,
    Find,
    Rings,
    LearnColumn,
    LearnDial
};
inline constexpr std::size_t kSplitterCount = 8;

/// Names in the settings.
inline constexpr std::array<std::string_view, kSplitterCount> kSplitterNames = {
    "left", "right", "dial", "lower", "find", "rings", "learnColumn", "learnDial"};

struct PanelSizes {
    /// Width or height in em; 0: automatic; LearnDial negative: no dial of its own.
    std::array<float, kSplitterCount> ems{};
    bool folded = false;   ///< Find and Change show their tabs alone.
    bool quiet = false;    ///< Find and Change show a line each below their tabs.
    bool lesson = false;   ///< In Present: the text of a lesson is the caption, without the drawer.
    float caption = 0.0F;  ///< Height of the caption in em, within limits; 0: the usual one.
    bool beside = false;   ///< In Present: a second view beside the first.

    float& of(Splitter splitter) { return ems[static_cast<std::size_t>(splitter)]; }
    float of(Splitter splitter) const { return ems[static_cast<std::size_t>(splitter)]; }
    /// The user's size, otherwise the automatic one, within limits.
    float within(Splitter splitter, float automatic, float least, float most) const {
        const float wanted = of(splitter) > 0.0F ? of(splitter) : automatic;
        return wanted < least ? least : wanted > most && most > least ? most : wanted;
    }
    friend bool operator==(const PanelSizes&, const PanelSizes&) = default;
};

}  // namespace se::view
