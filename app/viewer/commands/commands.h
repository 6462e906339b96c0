/// All actions, in one table that feeds keys, menus, the cheat sheet and --list-actions.
#pragma once

#include <string>

#include "command_context.h"
#include "input/command.h"

namespace se::view {

/// First key of a command, for menus; empty if it has none.
std::string firstKey(const Command& command);
/// All keys, joined by ", ".
std::string allKeys(const Command& command);
/// One line per action: id, keys, help.
std::string listActions();

/// Moves by `count` playback units, at most to the end of the loop; back if it is
/// negative.
void playSteps(CommandContext& context, int count);
/// Centers the pivot and its neighbors, or the selection, in the view.
void frameFocus(CommandContext& context);
/// Centers the pivot regardless of the selection; no effect without a pivot.
void framePivot(CommandContext& context);

/// Runs a command, from a key, a menu or the list of actions.
void runCommand(const Command& command, CommandContext& context);

}  // namespace se::view
