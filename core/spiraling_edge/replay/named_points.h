/// Which points a line of words names: of a query, a breakpoint or a watch.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace se {

/// A sentence about the first point that `line` names and a set of `points` points has not got;
/// empty if it has them all. Words that do not name points are passed over.
std::string missingPointIn(std::string_view line, std::size_t points);

}  // namespace se
