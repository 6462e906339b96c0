/// Completion of a query line: the terms of the language, and those that match the last word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/replay/decision_query.h"

namespace se::view {

/// The terms that complete the last word of a line; all of them after a space, or if it is none.
std::vector<const QueryTerm*> termsFor(std::string_view line);
/// The line with its last word replaced by the beginning of a term: "stage=sphere mar" and
/// margin<X give "stage=sphere margin<".
std::string completed(std::string_view line, const QueryTerm& term);

}  // namespace se::view
