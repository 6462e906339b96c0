/// Loops over independent items, split over threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace se {

/// Calls work(from, to) for pieces of 0 .. count that lie side by side, one per thread. `threads`
/// 0: as many as the machine has, but none for fewer than `least` items. Results are the same for
/// any number as long as work on one item does not depend on another.
template <typename Work>
void forRanges(std::size_t count, unsigned threads, std::size_t least, Work&& work) {
    const std::size_t asked = threads > 0 ? threads : std::thread::hardware_concurrency();
    const std::size_t pieces = std::max<std::size_t>(1, std::min(asked, count / least));
    std::vector<std::thread> others;
    for (std::size_t i = 1; i < pieces; ++i) {
        others.emplace_back(
            [&work, count, pieces, i] { work(count * i / pieces, count * (i + 1) / pieces); });
    }
    work(std::size_t{0}, count / pieces);
    for (std::thread& other : others) other.join();
}

}  // namespace se
