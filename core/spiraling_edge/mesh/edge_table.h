/// The directed edges of the mesh and their triangles: for the rules beyond the paper that examine
/// finished triangles (RobustRules::guard and others).
#pragma once

#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Side k of triangle t, 3 t + k: from its corner k to the next one.
using HalfEdge = Index;

/// Half-edges chained per point they leave. Two words per side, no hashing: a point has few sides,
/// and they were touched recently. Grows with the list of triangles it belongs to.
class EdgeTable {
  public:
    EdgeTable() = default;
    explicit EdgeTable(std::size_t pointCount) : head_(pointCount, kNone) {}

    /// Adds the next triangle.
    void add(const Triangle& t) {
        const auto first = static_cast<HalfEdge>(next_.size());
        const Index corners[3] = {t.a, t.b, t.c};
        for (Index k = 0; k < 3; ++k) {
            next_.push_back(head_[corners[k]]);
            target_.push_back(corners[(k + 1) % 3]);
            head_[corners[k]] = first + k;
        }
    }
    /// Removes all triangles but the first `count`.
    void cutTo(std::size_t count) {
        while (next_.size() > 3 * count) {
            const auto h = static_cast<HalfEdge>(next_.size() - 1);
            const HalfEdge base = h - h % 3;
            head_[target_[base + (h + 2 - base) % 3]] = next_[h];  // the point that h leaves
            next_.pop_back();
            if (h == base) target_.resize(base);
        }
    }
    /// The side u -> v, kNone if no triangle has it.
    HalfEdge find(Index u, Index v) const {
        HalfEdge h = head_[u];
        while (h != kNone && target_[h] != v) h = next_[h];
        return h;
    }
    bool has(Index u, Index v) const { return find(u, v) != kNone; }
    /// The corner of the side's triangle that is not on the side.
    Index opposite(HalfEdge h) const {
        const Index base = h - h % 3;
        return target_[base + (h + 1 - base) % 3];
    }
    /// Newest side that leaves a point; continue with nextFrom().
    HalfEdge firstFrom(Index point) const { return head_[point]; }
    HalfEdge nextFrom(HalfEdge h) const { return next_[h]; }
    Index target(HalfEdge h) const { return target_[h]; }
    bool empty() const { return head_.empty(); }

  private:
    std::vector<HalfEdge> head_;
    std::vector<HalfEdge> next_;
    std::vector<Index> target_;
};

}  // namespace se
