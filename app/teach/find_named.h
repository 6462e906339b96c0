/// Rows of a table by their names.
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

namespace se::teach {

/// The row with that `name`; null if there is none.
template <typename Rows>
auto findNamed(const Rows& rows, std::string_view name) -> decltype(&*std::begin(rows)) {
    const auto found = std::find_if(std::begin(rows), std::end(rows),
                                    [&](const auto& each) { return each.name == name; });
    return found == std::end(rows) ? nullptr : &*found;
}

}  // namespace se::teach
