/// A link to a failure: the points of the run, reduced to the fewest that still fail, inside it.
#pragma once

#include <string_view>

#include "context.h"

namespace se::view {

inline constexpr std::string_view kNoAlertShown = "Choose an alert first.";

/// Why the alert that is shown has no link of its own; empty: it can have one.
std::string_view reasonAgainstFailureLink(const CommandContext& context);

/// Copies the link, as soon as the points are reduced. Says in a sentence what came out.
void finishFailureLink(CommandContext& context);

namespace actions {

/// Reduces the points of the run to the fewest that still end in the alert that is shown.
void copyFailureLink(CommandContext& c);

}  // namespace actions

}  // namespace se::view
