/// What the commands about comparing do.
#pragma once

#include "commands.h"

namespace se::view::actions {

/// To the layout Compare, or back to Debug.
void toggleCompare(CommandContext& c);
/// With the rules that say most beside those of the run.
void compareUsual(CommandContext& c);
/// Asks for a file.
void compareMesh(CommandContext& c);
/// Says so if there is nothing that could be carried out.
void askOfComparison(CommandContext& c, CompareAsk ask);

inline void askForDifference(CommandContext& c) { askOfComparison(c, CompareAsk::FirstDifference); }

template <CompareAsk ask>
void askCompare(CommandContext& c) {
    askOfComparison(c, ask);
}

}  // namespace se::view::actions
