/// Layouts of the window: with panels, for presenting, for comparing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace se::view {

enum class LayoutPreset : std::uint8_t {
    Debug,    ///< View, column and strip.
    Present,  ///< View, caption and the lanes of the run.
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

/// All layouts; F2 cycles through the first two in this order.
std::span<const LayoutPresetRow> layoutPresets();
const LayoutPresetRow& rowOf(LayoutPreset layoutPreset);
/// The layout of that name; empty if there is none. The layout "learn" of version 0.2 is Debug with
/// the column at Lesson: see opensLessons().
std::optional<LayoutPreset> layoutPresetFromName(std::string_view name);
/// Whether a layout of this name opens the column at Lesson.
inline bool opensLessons(std::string_view name) { return name == "learn"; }
/// The next layout for F2; after the last, and from Compare, the first.
LayoutPreset following(LayoutPreset layoutPreset);

}  // namespace se::view
