/// An input line of query terms (core's decision_query.h), and its errors.
#pragma once

#include <string>

#include "panels/panel.h"

namespace se::view {

/// As wide as the next item width. True if the line changed. The field takes any text, and is
/// red where a word is not understood.
bool queryField(const PanelContext& context, const char* id, const char* hint, std::string& line);
/// Error of a line, without the list of all terms; empty if there is none.
std::string queryComplaint(const PanelContext& context, const std::string& line);
/// A dim "?" with a tooltip that explains all terms.
void queryHelp(const PanelContext& context);

}  // namespace se::view
