/// All actions, in one table that feeds keys, menus, the cheat sheet and --list-actions.
#pragma once

#include <string>
#include <string_view>

#include "document/context.h"
#include "input/key_map.h"

namespace se::view {

/// One line per action: id, keys, help.
std::string listActions();

/// Why a command cannot act now, for rows of menus that are gray: a sentence; empty if it can act,
/// or if only trying tells.
std::string_view whyUnavailable(const Command& command, const CommandContext& context);

/// Runs a command, from a key, a menu or the list of actions.
void runCommand(const Command& command, CommandContext& context);

/// Carries out the meaning of `command` on that page. False: it has its usual meaning.
bool runOnGrowthPage(const Command& command, CommandContext& context);

}  // namespace se::view
