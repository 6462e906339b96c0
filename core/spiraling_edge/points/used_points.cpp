#include "spiraling_edge/points/used_points.h"

#include <algorithm>
#include <cassert>


namespace se {
namespace {

/// Keeps the rows of a column that are marked; an empty column stays empty.
template <typename T>
void keepRows(std::vector<T>& column, const std::vector<bool>& keep) {
    if (column.empty()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < keep.size(); ++i) {
        if (keep[i]) column[kept++] = column[i];
    }
    column.resize(kept);
}

/// The lists of the points that have a number, in their order, renumbered.
NeighborLists keptLists(const NeighborLists& lists, const std::vector<Index>& number) {
    NeighborLists kept;
    std::vector<Index> list;
    for (Index p = 0; p < number.size(); ++p) {
        if (number[p] == kNone) continue;
        list.clear();
        for (const Index q : lists[p]) {
            if (q < number.size() && number[q] != kNone) list.push_back(number[q]);
        }
        kept.append(list);
    }
    return kept;
}

}  // namespace

std::vector<bool> usedPoints(std::size_t points, std::span<const Triangle> triangles) {
    assert(cornersBelow(triangles, points));
    std::vector<bool> used(points, false);
    for (const Triangle& t : triangles) used[t.a] = used[t.b] = used[t.c] = true;
    return used;
}

void keepColumns(PointFile& file, const std::vector<bool>& keep) {
    keepRows(file.position, keep);
    keepRows(file.normal, keep);
    keepRows(file.type, keep);
    for (Attribute& attribute : file.attributes) keepRows(attribute.values, keep);
}

std::vector<Index> keptNumbers(const std::vector<bool>& keep) {
    std::vector<Index> number(keep.size(), kNone);
    Index next = 0;
    for (std::size_t p = 0; p < keep.size(); ++p) {
        if (keep[p]) number[p] = next++;
    }
    return number;
}

PointFile withUsedPoints(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkColumns(points).ok());
    const std::vector<bool> used = usedPoints(points.position.size(), triangles);
    const std::vector<Index> number = keptNumbers(used);
    PointFile made = points;
    if (points.hasNeighbors()) made.neighbors = keptLists(points.neighbors, number);
    keepColumns(made, used);
    made.faces.clear();
    made.faces.reserve(triangles.size());
    for (const Triangle& t : triangles) {
        made.faces.push_back({number[t.a], number[t.b], number[t.c]});
    }
    return made;
}

std::size_t countUsedPoints(std::size_t points, std::span<const Triangle> triangles) {
    const std::vector<bool> used = usedPoints(points, triangles);
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

}  // namespace se
