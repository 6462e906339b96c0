/// Layouts of the window: for debugging, for learning, for presenting, for comparing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace se::view {

enum class LayoutPreset : std::uint8_t {
    Debug,    ///< Everything.
    Learn,    ///< The paper's rule on the left, a large view and a large caption.
    Present,  ///< View, caption and the strip of the run.
    Compare,  ///< Two runs, or a run and a mesh, side by side; F2 skips it.
};

/// One row of the table of layouts.
struct LayoutPresetRow {
    LayoutPreset id;
    std::string_view name;   ///< Name for --layout.
    std::string_view title;  ///< Name for the user.
    std::string_view help;   ///< Content of the layout, and how to leave it.
    bool follows = false;    ///< The camera follows the decision unless that is turned off.
};

/// All layouts; F2 cycles through the first three in this order.
std::span<const LayoutPresetRow> layoutPresets();
const LayoutPresetRow& rowOf(LayoutPreset layoutPreset);
/// Empty if there is none of that name.
std::optional<LayoutPreset> layoutPresetFromName(std::string_view name);
/// The next layout for F2; after the last, and from Compare, the first.
LayoutPreset following(LayoutPreset layoutPreset);

}  // namespace se::view
