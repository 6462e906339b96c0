/// The sides of all triangles, grouped by edge: for the checks of a finished mesh, which need not
/// be a manifold.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// One side of a triangle, named by its points in ascending order.
struct TriangleSide {
    Index low, high;
    Index triangle : 31;  ///< Enough: all sides are numbered by an Index.
    Index ascending : 1;  ///< Passed from low to high. A bit: a mesh has millions of sides.

    bool sameEdge(const TriangleSide& other) const {
        return low == other.low && high == other.high;
    }
};

/// All sides, sorted by edge and then by triangle. `threads` 0: as many as the machine has; the
/// result is the same for any number.
std::vector<TriangleSide> sortedSides(std::span<const Triangle> triangles, unsigned threads = 0);

/// The sides of the edges that begin at the positions `from` to `to`, without `to`.
inline std::span<const TriangleSide> sidesOfRange(std::span<const TriangleSide> sides,
                                                  std::size_t from, std::size_t to) {
    const auto edgeFrom = [&](std::size_t i) {
        while (i > 0 && i < sides.size() && sides[i].sameEdge(sides[i - 1])) ++i;
        return i;
    };
    from = edgeFrom(from);
    return sides.subspan(from, edgeFrom(to) - from);
}

/// Calls visit(sides of an edge) for each edge in turn.
template <typename Visit>
void forEachEdge(std::span<const TriangleSide> sides, Visit&& visit) {
    while (!sides.empty()) {
        const auto end = std::find_if_not(sides.begin(), sides.end(), [&](const TriangleSide& s) {
            return s.sameEdge(sides.front());
        });
        const auto count = static_cast<std::size_t>(end - sides.begin());
        visit(sides.first(count));
        sides = sides.subspan(count);
    }
}

/// True if two sides of the edge pass it in the same direction.
inline bool isInconsistent(std::span<const TriangleSide> edge) {
    const auto ascending =
        std::count_if(edge.begin(), edge.end(), [](const TriangleSide& s) { return s.ascending; });
    return ascending > 1 || static_cast<std::ptrdiff_t>(edge.size()) - ascending > 1;
}

/// Points whose triangles form more than one fan, ascending: they are not connected by edges at
/// that point. `sides` are those of the triangles.
std::vector<Index> nonManifoldPoints(std::span<const Triangle> triangles,
                                     std::span<const TriangleSide> sides, std::size_t points);

}  // namespace se
