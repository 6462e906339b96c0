/// Actions for comparing.
#pragma once

#include "commands.h"
#include "panel_state/compare_page.h"

namespace se::view::actions {

/// Opens the layout Compare, or returns to Debug.
void toggleCompare(CommandContext& c);
/// Compares with the most informative rule set beside those of the run.
void compareUsual(CommandContext& c);
/// Opens the file dialog.
void compareMesh(CommandContext& c);
/// Requests a step of the comparison; reports if there is no comparison.
void askOfComparison(CommandContext& c, CompareAsk ask);

inline void askForDifference(CommandContext& c) { askOfComparison(c, CompareAsk::FirstDifference); }

template <CompareAsk ask>
void askCompare(CommandContext& c) {
    askOfComparison(c, ask);
}

}  // namespace se::view::actions
