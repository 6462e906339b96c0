/// A line of query terms to type into (core's decision_query.h), and what is wrong with it.
#pragma once

#include <string>

#include "panels/panel.h"

namespace se::view {

/// As wide as the next item width says. True if the line changed. The field takes any text, and is
/// red where a word is not understood.
bool queryField(const PanelContext& context, const char* id, const char* hint, std::string& line);
/// What is wrong with a line, without the list of all terms; empty if nothing is.
std::string queryComplaint(const PanelContext& context, const std::string& line);
/// A dim "?" that lists all terms with what they mean, while it is pointed at.
void queryHelp(const PanelContext& context);

}  // namespace se::view
