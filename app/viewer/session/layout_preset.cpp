#include "layout_preset.h"

#include <array>

#include "spiraling_edge/base/lists.h"

namespace se::view {

namespace {

constexpr std::array<LayoutPresetRow, 3> kLayoutPresets = {{
    {LayoutPreset::Debug, "debug", "Debug", "View, column and strip."},
    {LayoutPreset::Present, "present", "Present",
     "Only view, caption and run. F2 brings the panels back; all keys work.", true},
    {LayoutPreset::Compare, "compare", "Compare",
     "Two views on one timeline. D: first difference. Ctrl+D, F2: back."},
}};

}  // namespace

std::span<const LayoutPresetRow> layoutPresets() { return kLayoutPresets; }

const LayoutPresetRow& rowOf(LayoutPreset layoutPreset) {
    return kLayoutPresets[static_cast<std::size_t>(layoutPreset)];
}

std::optional<LayoutPreset> layoutPresetFromName(std::string_view name) {
    if (opensLessons(name)) return LayoutPreset::Debug;
    const LayoutPresetRow* row = findNamed(kLayoutPresets, name);
    return row != nullptr ? std::optional(row->id) : std::nullopt;
}

LayoutPreset following(LayoutPreset layoutPreset) {
    constexpr std::size_t kOnKey = 2;
    const std::size_t next = static_cast<std::size_t>(layoutPreset) + 1;
    return kLayoutPresets[next < kOnKey ? next : 0].id;
}

}  // namespace se::view
