/// Signs of TOML that toml++ 3.3 takes for granted: it asserts that no wrong bracket stands where a
/// value or a key of a table begins, and its behavior is undefined for letters beyond ASCII outside
/// of strings and comments. So wrong ones are found before it reads a block.
#pragma once

#include <cstddef>
#include <string_view>

namespace se::teach {

/// A wrong sign outside of strings and comments.
struct StraySign {
    std::size_t line = 0;   ///< From 1; 0: there is none.
    std::string_view what;  ///< What is wrong, for the message.
};
/// The first bracket that closes no bracket of its kind, or that begins the header of a table,
/// which no block of a lesson has; or the first byte beyond ASCII.
StraySign strayTomlSign(std::string_view toml);

}  // namespace se::teach
