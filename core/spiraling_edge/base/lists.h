/// Questions to lists and tables.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
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

/// Puts the values in order, each once.
template <typename Value>
void sortUnique(std::vector<Value>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace se
