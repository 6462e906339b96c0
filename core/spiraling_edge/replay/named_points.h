/// The points that a query, a breakpoint or a watch names.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace se {

/// A sentence about the first point that `line` names and that is not below `points`; empty if
/// there is none. Words that do not name points are ignored.
std::string missingPointIn(std::string_view line, std::size_t points);

}  // namespace se
