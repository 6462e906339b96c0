/// Actions for breakpoints.
#pragma once

#include "break_presets.h"
#include "commands.h"
#include "spiraling_edge/replay/breakpoint.h"

namespace se::view {

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

template <int direction>
void continueRun(CommandContext& c) {
    continueBy(c, direction);
}

}  // namespace actions

}  // namespace se::view
