/// Actions that query the run, or step through the answer.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "context.h"
#include "run/selection.h"
#include "spiraling_edge/run/breakpoint.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/why/failure_moments.h"
#include "spiraling_edge/why/ring_history.h"

namespace se::view {

/// Selects a thing and queries why it is in the mesh, or why not; the panel Ledger shows the
/// answer.
void askWhy(CommandContext& context, const Selection& what);
/// Queries why a ring is there.
void askWhy(CommandContext& context, const RingAddress& ring);
/// Selects what stands for a failure and queries why it is there.
void askWhy(CommandContext& context, const RunFailure& failure);
/// The same query, unless it is the last one; the panel Ledger is not shown.
void askInBackground(CommandContext& context, const RunFailure& failure);
/// Runs the query typed into the Ledger; a mistake stays there with a sentence.
void askTyped(CommandContext& context);
/// Finds the decisions that match the line of the panel Query, which reports a mistake in it.
void findTyped(CommandContext& context);
/// Finds the decisions that match a line from elsewhere.
void askQuery(CommandContext& context, const std::string& line);

namespace actions {

/// Query about the alert that is shown, unless another thing is selected, which then is the
/// subject; without both the panel waits for input.
void askWhySelected(CommandContext& c);
/// To the next (+1) or previous (-1) line of the ledger.
void toLedgerLine(CommandContext& c, int direction);
/// To the decisive line.
void toCause(CommandContext& c);
/// Opens the panel Query with the keyboard focus on its line.
void openQuery(CommandContext& c);
/// To the next (+1) or previous (-1) decision that the query line found.
void toHit(CommandContext& c, int direction);

}  // namespace actions

// Actions for breakpoints, and ready-made breakpoint lines: one row for each kind, filled in with
// the selection and the event at the cursor.

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
