/// Words in a sentence.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace se {

/// "1 point", "2 points".
inline std::string countText(std::size_t count, std::string_view noun) {
    return (std::to_string(count) + ' ').append(noun).append(count == 1 ? "" : "s");
}

/// "PLY, OBJ or OFF" of three words and "or"; with commas alone if `conjunction` is empty.
template <typename Words>
std::string wordList(const Words& words, std::string_view conjunction) {
    std::string text;
    std::size_t left = words.size();
    for (const auto& word : words) {
        if (!text.empty() && (left > 1 || conjunction.empty())) {
            text += ", ";
        } else if (!text.empty()) {
            text.append(" ").append(conjunction).append(" ");
        }
        text += word;
        --left;
    }
    return text;
}

}  // namespace se
