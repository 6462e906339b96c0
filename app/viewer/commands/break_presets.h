/// Lines for breakpoints that need not be typed: one row for each kind, with what is selected and
/// what the cursor stands on filled in.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "run/selection.h"
#include "spiraling_edge/stepper/event.h"

namespace se::view {

/// What a line may be about.
struct BreakSubject {
    Selection selected;
    const Event* event = nullptr;  ///< At the cursor.
    Index pivot = kNone;           ///< The point that is the pivot there.

    /// The selected point; else the pivot.
    Index point() const;
};

struct BreakPreset {
    std::string_view title;  ///< "Point becomes USED"
    std::string_view needs;  ///< What has to be selected; empty: nothing.
    /// The line; nothing if what it needs is not there.
    std::optional<std::string> (*line)(const BreakSubject& subject);
};
std::span<const BreakPreset> breakPresets();

/// The line for "break here": what is selected, else this kind of decision. Nothing at the start of
/// the run.
std::optional<std::string> lineHere(const BreakSubject& subject);

/// "among=3..6,40"; `points` ascending.
std::string amongLine(std::span<const Index> points);

}  // namespace se::view
