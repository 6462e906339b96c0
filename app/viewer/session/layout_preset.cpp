#include "layout_preset.h"

#include <algorithm>
#include <array>

namespace se::view {

namespace {

constexpr std::array<ArrangementRow, 4> kArrangements = {{
    {Arrangement::Debug, "debug", "Debug", "All panels."},
    {Arrangement::Learn, "learn", "Learn",
     "The rule beside a large view, the decision in large type. F2: next layout."},
    {Arrangement::Present, "present", "Present",
     "Only view, caption and run. F2 brings the panels back; all keys work."},
    {Arrangement::Compare, "compare", "Compare",
     "Two views on one timeline. D: first difference. Ctrl+D, F2: back."},
}};

}  // namespace

std::span<const ArrangementRow> arrangements() { return kArrangements; }

const ArrangementRow& rowOf(Arrangement arrangement) {
    return kArrangements[static_cast<std::size_t>(arrangement)];
}

std::optional<Arrangement> arrangementFromName(std::string_view name) {
    const auto found = std::find_if(kArrangements.begin(), kArrangements.end(),
                                    [&](const ArrangementRow& row) { return row.name == name; });
    if (found == kArrangements.end()) return std::nullopt;
    return found->id;
}

Arrangement following(Arrangement arrangement) {
    constexpr std::size_t kOnKey = 3;
    const std::size_t next = static_cast<std::size_t>(arrangement) + 1;
    return kArrangements[next < kOnKey ? next : 0].id;
}

}  // namespace se::view
