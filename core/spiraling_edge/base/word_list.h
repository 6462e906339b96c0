/// Words in a sentence.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace se {

/// The word of a list that is nearest to one that was typed: by the fewest letters to add, remove
/// or change. Requires a list that is not empty.
std::string_view nearestWord(std::span<const std::string_view> list, std::string_view word);
/// Of rows with a `name` the nearest of their names.
template <typename Rows>
std::string nearestName(const Rows& rows, std::string_view word) {
    std::vector<std::string_view> names;
    for (const auto& row : rows) names.push_back(row.name);
    return std::string(nearestWord(names, word));
}

/// A to Z in lower case, in every locale; all other bytes as they are.
inline std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}
/// The words as the beginning of a sentence: with a capital letter first.
inline std::string capitalized(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

/// The items, or their texts, with `between` between two.
template <typename Items, typename TextOf = std::identity>
std::string joined(const Items& items, std::string_view between, TextOf textOf = {}) {
    std::string text;
    for (const auto& item : items) {
        if (!text.empty()) text += between;
        text += textOf(item);
    }
    return text;
}
/// Whole numbers as joined().
template <typename Numbers>
std::string joinedNumbers(const Numbers& numbers, std::string_view between = ", ") {
    return joined(numbers, between, [](auto number) { return std::to_string(number); });
}
/// The first of a list of whole numbers: "1, 2, 3, ... (70)".
template <typename Numbers>
std::string firstNumbers(const Numbers& numbers, std::size_t limit) {
    const std::string text =
        joinedNumbers(std::span(numbers).first(std::min(limit, numbers.size())));
    return numbers.size() <= limit ? text : text + ", ... (" + std::to_string(numbers.size()) + ")";
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
