/// Actions while new points spread.
#pragma once

#include "commands.h"
#include "panel_state/growth_page.h"

namespace se::view {

/// Opens the page with the last form, of a shape or of a volume.
void openGrowthPage(CommandContext& context, GrowthSource from);
/// Carries out the meaning of `command` on that page. False: it has its usual meaning.
bool runOnGrowthPage(const Command& command, CommandContext& context);

}  // namespace se::view
