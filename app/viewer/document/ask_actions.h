/// Actions that query the run, or step through the answer.
#pragma once

#include "context.h"
#include "run/selection.h"
#include "spiraling_edge/why/failure_moments.h"
#include "spiraling_edge/why/ring_history.h"

namespace se::view {

/// Selects a thing and queries why it is in the mesh, or why not; the panel Ledger shows the
/// answer.
void askWhy(CommandContext& context, const Selection& what);
/// Queries why a ring is there.
void askWhy(CommandContext& context, const RingAddress& ring);
/// Queries why a failure is there: a hole by its moments, all else as its subject.
void askWhy(CommandContext& context, const RunFailure& failure);
/// Runs the query typed into the Ledger; a mistake stays there with a sentence.
void askTyped(CommandContext& context);
/// Finds the decisions that match the line of the panel Query, which reports a mistake in it.
void findTyped(CommandContext& context);
/// Finds the decisions that match a line from elsewhere.
void askQuery(CommandContext& context, const std::string& line);

namespace actions {

/// Query about the selection, else about the alert that is shown; without one the panel waits for
/// input.
void askWhySelected(CommandContext& c);
/// To the next (+1) or previous (-1) line of the ledger.
void toLedgerLine(CommandContext& c, int direction);
/// To the decisive line.
void toCause(CommandContext& c);
/// Opens the panel Query with the keyboard focus on its line.
void openQuery(CommandContext& c);
void openClosest(CommandContext& c);
/// To the next (+1) or previous (-1) decision that the query line found.
void toHit(CommandContext& c, int direction);

}  // namespace actions
}  // namespace se::view
