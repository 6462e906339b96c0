/// Numbers with their nouns.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace se {

/// "1 edge", "2 edges"; "3 vertices" with a plural of its own.
inline std::string counted(std::size_t count, std::string_view noun, std::string_view plural = {}) {
    std::string text = std::to_string(count) + " ";
    text += count == 1 || plural.empty() ? noun : plural;
    return count == 1 || !plural.empty() ? text : text + "s";
}

}  // namespace se
