#include "spiraling_edge/base/word_list.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace se {
namespace {

/// Number of letters to add, remove or change to make one word of the other.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, change});
        }
    }
    return row.back();
}

}  // namespace

std::string_view nearestWord(std::span<const std::string_view> list, std::string_view word) {
    assert(!list.empty());
    constexpr std::size_t kLongestWord = 64;
    const std::string_view cut = word.substr(0, kLongestWord);
    return *std::min_element(list.begin(), list.end(), [&](std::string_view a, std::string_view b) {
        return editDistance(a, cut) < editDistance(b, cut);
    });
}

}  // namespace se
