/// The best split of numbers in two heaps: tells two layers of heights from one that is spread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace se {

/// Two heaps of numbers, the lower one up to a number of them.
struct TwoHeaps {
    /// Share of the variance that the distance of the heaps explains: 0.64 for Gaussian noise, 0.75
    /// for numbers that are equally likely in a range, 1 for two thin layers.
    double share = 0.0;
    double apart = 0.0;     ///< Distance of their means.
    double within = 0.0;    ///< Standard deviation of each, as of one.
    double cut = 0.0;       ///< The least number of the upper heap.
    std::size_t lower = 0;  ///< Numbers in the lower heap.
};

/// The split with the least variance within the heaps, or nothing but zeros if all numbers are the
/// same. Sorts them. O(n log n).
inline TwoHeaps twoHeapsOf(std::span<double> numbers) {
    std::sort(numbers.begin(), numbers.end());
    const auto count = static_cast<double>(numbers.size());
    double sum = 0.0;
    for (const double x : numbers) sum += x;
    const double mean = sum / count;
    double variance = 0.0;
    for (const double x : numbers) variance += (x - mean) * (x - mean) / count;
    TwoHeaps best;
    double below = 0.0;
    for (std::size_t i = 1; i < numbers.size() && variance > 0.0; ++i) {
        below += numbers[i - 1] - mean;
        const auto lower = static_cast<double>(i);
        const double apart = -below / (count - lower) - below / lower;
        const double share = lower * (count - lower) / (count * count) * apart * apart / variance;
        if (share <= best.share) continue;
        best = {share, apart, 0.0, numbers[i], i};
    }
    best.within = std::sqrt(variance * std::max(0.0, 1.0 - best.share));
    return best;
}

}  // namespace se
