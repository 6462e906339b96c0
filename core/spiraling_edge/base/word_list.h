/// Words in a sentence.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace se {

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
