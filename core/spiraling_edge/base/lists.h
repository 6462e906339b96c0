/// Functions on lists and tables.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

namespace se {

/// True if the list holds `value`.
template <typename Value, typename List>
bool isAmong(const Value& value, const List& list) {
    return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

/// The number of values that pass the test.
template <typename List, typename Test>
std::size_t countWhere(const List& list, Test&& test) {
    return static_cast<std::size_t>(std::count_if(std::begin(list), std::end(list), test));
}

/// The first row of a table that passes the test; null if none does.
template <typename Rows, typename Test>
auto rowWhere(const Rows& rows, Test&& test) -> decltype(&*std::begin(rows)) {
    const auto found = std::find_if(std::begin(rows), std::end(rows), test);
    return found == std::end(rows) ? nullptr : &*found;
}

/// The row with that `name`; null if there is none.
template <typename Rows>
auto findNamed(const Rows& rows, std::string_view name) -> decltype(&*std::begin(rows)) {
    return rowWhere(rows, [&](const auto& row) { return row.name == name; });
}

/// The value of an enumeration by its name, of all names in order; nothing for another name.
template <typename Id, typename Names>
std::optional<Id> idNamed(const Names& names, std::string_view name) {
    const auto found = std::find(std::begin(names), std::end(names), name);
    if (found == std::end(names)) return std::nullopt;
    return static_cast<Id>(found - std::begin(names));
}

/// Puts the values in order, each once.
template <typename Value>
void sortUnique(std::vector<Value>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Empties the list and frees its memory, which `list = {}` keeps.
template <typename Value>
void freeList(std::vector<Value>& list) {
    list = std::vector<Value>();
}

}  // namespace se
