/// Brackets of TOML. toml++ 3.3 asserts that no wrong bracket stands where a value or a key of a
/// table begins, so wrong ones are found before it reads a block.
#pragma once

#include <cstddef>
#include <string_view>

namespace se::teach {

/// Line, from 1, of the first bracket outside of strings and comments that closes no bracket of its
/// kind, or that begins the header of a table, which no block of a lesson has; 0 if there is none.
std::size_t lineOfStrayBracket(std::string_view toml);

}  // namespace se::teach
