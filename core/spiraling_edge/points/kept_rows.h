/// Removal of points from a PointFile: the columns that lose rows, and the new indices.
#pragma once

#include <vector>

#include "spiraling_edge/points/point_file.h"

namespace se {

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

/// Keeps the marked rows of all columns; neighbor lists and faces stay as they are.
inline void keepColumns(PointFile& file, const std::vector<bool>& keep) {
    keepRows(file.position, keep);
    keepRows(file.normal, keep);
    keepRows(file.type, keep);
    for (Attribute& attribute : file.attributes) keepRows(attribute.values, keep);
}

/// The index of each kept point among those kept, kNone for the others.
inline std::vector<Index> keptNumbers(const std::vector<bool>& keep) {
    std::vector<Index> number(keep.size(), kNone);
    Index next = 0;
    for (std::size_t p = 0; p < keep.size(); ++p) {
        if (keep[p]) number[p] = next++;
    }
    return number;
}

}  // namespace se
