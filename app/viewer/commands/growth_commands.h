/// What actions mean while new points spread.
#pragma once

#include "commands.h"

namespace se::view {

/// Opens the page with the last form, of a shape or of a volume.
void openGrowthPage(CommandContext& context, GrowthSource from);
/// Carries out what `command` means on that page. False: what it means everywhere.
bool runOnGrowthPage(const Command& command, CommandContext& context);
/// Runs a command, from a key, a menu or the list of actions.
void runCommand(const Command& command, CommandContext& context);

}  // namespace se::view
