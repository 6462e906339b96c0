/// Medians and other quantiles of numbers.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace se {

/// The value that this share of the others is not above. Changes the order of `values`. Requires a
/// value.
inline double quantileOf(std::vector<double>& values, double share) {
    assert(!values.empty());
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// The median; the upper one of two. Changes the order of `values`. Requires a value.
inline double medianOf(std::vector<double>& values) {
    assert(!values.empty());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace se
