/// Actions for breakpoints, and ready-made breakpoint lines: one row for each kind, filled in with
/// the selection and the event at the cursor.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "context.h"
#include "run/selection.h"
#include "spiraling_edge/run/breakpoint.h"
#include "spiraling_edge/stepper/event.h"

namespace se::view {

/// Subject of a breakpoint line.
struct BreakSubject {
    Selection selected;
    const Event* event = nullptr;  ///< At the cursor.
    Index pivot = kNone;           ///< The pivot point at the cursor.

    /// The selected point, otherwise the pivot.
    Index point() const;
};

struct BreakPreset {
    std::string_view title;  ///< "Point becomes USED"
    std::string_view needs;  ///< Selection that it needs; empty: none.
    /// The line; empty if the selection that it needs is missing.
    std::optional<std::string> (*line)(const BreakSubject& subject);
};
std::span<const BreakPreset> breakPresets();

/// The line for "break here": the selection, otherwise this kind of decision. Empty at the start of
/// the run.
std::optional<std::string> lineHere(const BreakSubject& subject);

/// "among=3..6,40"; `points` ascending.
std::string amongLine(std::span<const Index> points);

/// Subject of a breakpoint set now.
BreakSubject breakSubject(const CommandContext& context);
/// Adds a breakpoint and reports it; one with the same line is not added twice, but enabled.
void addBreakpoint(CommandContext& context, Breakpoint breakpoint);
/// Makes `count` steps of playback: goes to the first stop among them and pauses, or waits
/// until it is known whether there is one. False: there is no stop among them.
bool heldByBreakpoint(CommandContext& context, int count);

namespace actions {

void continueBy(CommandContext& c, int direction);
void toggleBreakpointHere(CommandContext& c);

}  // namespace actions

}  // namespace se::view
