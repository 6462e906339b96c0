/// The directed edges of the mesh and their triangles: for the rules beyond the paper that examine
/// finished triangles (RobustRules::guard and others).
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Side k of triangle t, 3 t + k: from its corner k to the next one.
using HalfEdge = Index;

/// Half-edges chained per point they leave. Two words per side, side by side since each step of a
/// search reads both; no hashing: a point has few sides, and they were touched recently. Grows with
/// the list of triangles it belongs to, and goes back and forward with it in O(1): triangles that
/// are taken back stay in the chains, before all others.
class EdgeTable {
  public:
    EdgeTable() = default;
    /// Has room for the triangles of a closed surface, two for each point.
    explicit EdgeTable(std::size_t pointCount) : head_(pointCount, kNone) {
        sides_.reserve(6 * pointCount);
    }

    /// Adds the next triangle.
    void add(const Triangle& t) {
        if (end_ < sides_.size()) {
            if (isNext(t)) {
                end_ += 3;
                return;
            }
            forgetTakenBack();
        }
        const auto first = static_cast<HalfEdge>(sides_.size());
        const Index corners[3] = {t.a, t.b, t.c};
        for (Index k = 0; k < 3; ++k) {
            sides_.push_back({head_[corners[k]], corners[(k + 1) % 3]});
            head_[corners[k]] = first + k;
        }
        end_ = sides_.size();
    }
    /// Takes back all triangles but the first `count`, or those that were taken back again up to
    /// it.
    void moveTo(std::size_t count) {
        assert(3 * count <= sides_.size());
        end_ = 3 * count;
    }
    /// The side u -> v, kNone if no triangle has it.
    HalfEdge find(Index u, Index v) const {
        HalfEdge h = firstFrom(u);
        while (h != kNone && sides_[h].target != v) h = sides_[h].next;
        return h;
    }
    bool has(Index u, Index v) const { return find(u, v) != kNone; }
    /// The corner of the side's triangle that is not on the side.
    Index opposite(HalfEdge h) const {
        const Index base = h - h % 3;
        return sides_[base + (h + 1 - base) % 3].target;
    }
    /// Newest side that leaves a point; continue with nextFrom().
    HalfEdge firstFrom(Index point) const {
        HalfEdge h = head_[point];
        while (h != kNone && h >= end_) h = sides_[h].next;
        return h;
    }
    HalfEdge nextFrom(HalfEdge h) const { return sides_[h].next; }
    Index target(HalfEdge h) const { return sides_[h].target; }
    bool empty() const { return head_.empty(); }
    /// Number of sides.
    std::size_t size() const { return end_; }

  private:
    struct Side {
        HalfEdge next;  ///< Of the same point, the next older one.
        Index target;
    };

    /// True if `t` is the first of the triangles that were taken back.
    bool isNext(const Triangle& t) const {
        return target(static_cast<HalfEdge>(end_)) == t.b &&
               target(static_cast<HalfEdge>(end_ + 1)) == t.c &&
               target(static_cast<HalfEdge>(end_ + 2)) == t.a;
    }
    void forgetTakenBack() {
        while (sides_.size() > end_) {
            // A side leaves the point that the side before it leads to; the newest goes first.
            const std::size_t base = sides_.size() - 3;
            head_[sides_[base + 1].target] = sides_[base + 2].next;
            head_[sides_[base].target] = sides_[base + 1].next;
            head_[sides_[base + 2].target] = sides_[base].next;
            sides_.resize(base);
        }
    }

    std::vector<HalfEdge> head_;
    std::vector<Side> sides_;
    std::size_t end_ = 0;  ///< Sides of the present triangles; those from it on are taken back.
};

}  // namespace se
