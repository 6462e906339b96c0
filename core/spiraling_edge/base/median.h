/// The median of numbers.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace se {

/// The median; the upper one of two. Changes the order of `values`. Requires a value.
inline double medianOf(std::vector<double>& values) {
    assert(!values.empty());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace se
