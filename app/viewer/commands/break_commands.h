/// What the actions about breakpoints do.
#pragma once

#include "break_presets.h"
#include "commands.h"

namespace se::view {

/// What a breakpoint set now would be about.
BreakSubject breakSubject(const CommandContext& context);
/// Adds a breakpoint, and says so; one with the same line is not added twice, but put on.
void addBreakpoint(CommandContext& context, Breakpoint breakpoint);
/// Of `count` steps of the unit of playing: goes to the first stop among them and pauses, or waits
/// until it is known whether there is one. False: nothing is in the way.
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
