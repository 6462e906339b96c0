#include "spiraling_edge/mesh/fresh_triangles.h"

#include <algorithm>
#include <array>
#include <set>

namespace se {

std::vector<Triangle> freshTriangles(const std::vector<Triangle>& before,
                                     const std::vector<Triangle>& after) {
    const auto corners = [](const Triangle& t) {
        std::array<Index, 3> c = {t.a, t.b, t.c};
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        return c;
    };
    // The steps change a few entries of a long list, so only those are compared with each other.
    const std::size_t common = std::min(before.size(), after.size());
    std::set<std::array<Index, 3>> old;
    std::vector<Triangle> fresh;
    for (std::size_t i = 0; i < common; ++i) {
        if (before[i] == after[i]) continue;
        old.insert(corners(before[i]));
        fresh.push_back(after[i]);
    }
    for (std::size_t i = common; i < before.size(); ++i) old.insert(corners(before[i]));
    for (std::size_t i = common; i < after.size(); ++i) fresh.push_back(after[i]);
    std::erase_if(fresh, [&](const Triangle& t) { return old.contains(corners(t)); });
    return fresh;
}

}  // namespace se
