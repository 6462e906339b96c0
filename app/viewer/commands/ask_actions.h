/// Actions that ask about the run, or walk through the answer.
#pragma once

#include "commands.h"
#include "run/selection.h"
#include "spiraling_edge/explain/ring_history.h"

namespace se::view {

/// Selects a thing and asks why it is in the mesh, or why not; the answer is in the panel Ledger.
void askWhy(CommandContext& context, const Selection& what);
/// The same for a ring.
void askWhy(CommandContext& context, const RingPlace& ring);
/// What stands in the box of the Ledger; a mistake stays there with a sentence.
void askTyped(CommandContext& context);
/// The decisions that the line of the panel Query asks for; a mistake in it is said there.
void findTyped(CommandContext& context);
/// The same for a line from elsewhere.
void askQuery(CommandContext& context, const std::string& line);

namespace actions {

/// Of the selection; without one the panel waits for a thing to be typed.
void askWhySelected(CommandContext& c);
/// To the next (+1) or previous (-1) line of the ledger.
void toLedgerLine(CommandContext& c, int direction);
/// To the line that settled it.
void toCause(CommandContext& c);
/// The panel Query, its line with the keyboard.
void openQuery(CommandContext& c);
void openClosest(CommandContext& c);
void openCharts(CommandContext& c);
/// To the next (+1) or previous (-1) decision that the query line found.
void toHit(CommandContext& c, int direction);

}  // namespace actions
}  // namespace se::view
