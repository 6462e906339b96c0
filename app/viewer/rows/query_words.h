/// Help while a query line is typed: which words there are, and what the last one may become.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/replay/decision_query.h"

namespace se::view {

/// The terms that the last word of a line may become; all of them behind a blank, or if it is none.
std::vector<const QueryTerm*> termsFor(std::string_view line);
/// The line with its last word replaced by the beginning of a term: "stage=sphere mar" and
/// margin<X give "stage=sphere margin<".
std::string completed(std::string_view line, const QueryTerm& term);

}  // namespace se::view
