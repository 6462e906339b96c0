/// Why a command cannot act now, for rows of menus that are gray.
#pragma once

#include <string_view>

#include "commands.h"

namespace se::view {

/// A sentence; empty if the command can act, or if only trying tells.
std::string_view whyUnavailable(const Command& command, const CommandContext& context);

}  // namespace se::view
