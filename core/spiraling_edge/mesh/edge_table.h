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

/// Half-edges chained per point they leave. Two words per side, no hashing: a point has few sides,
/// and they were touched recently. Grows with the list of triangles it belongs to, and goes back
/// and forward with it in O(1): triangles that are taken back stay in the chains, before all
/// others.
class EdgeTable {
  public:
    EdgeTable() = default;
    /// Has room for the triangles of a closed surface, two for each point.
    explicit EdgeTable(std::size_t pointCount) : head_(pointCount, kNone) {
        next_.reserve(6 * pointCount);
        target_.reserve(6 * pointCount);
    }

    /// Adds the next triangle.
    void add(const Triangle& t) {
        if (end_ < next_.size()) {
            if (isNext(t)) {
                end_ += 3;
                return;
            }
            forgetTakenBack();
        }
        const auto first = static_cast<HalfEdge>(next_.size());
        const Index corners[3] = {t.a, t.b, t.c};
        for (Index k = 0; k < 3; ++k) {
            next_.push_back(head_[corners[k]]);
            target_.push_back(corners[(k + 1) % 3]);
            head_[corners[k]] = first + k;
        }
        end_ = next_.size();
    }
    /// Takes back all triangles but the first `count`, or those that were taken back again up to
    /// it.
    void moveTo(std::size_t count) {
        assert(3 * count <= next_.size());
        end_ = 3 * count;
    }
    /// The side u -> v, kNone if no triangle has it.
    HalfEdge find(Index u, Index v) const {
        HalfEdge h = firstFrom(u);
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
    HalfEdge firstFrom(Index point) const {
        HalfEdge h = head_[point];
        while (h != kNone && h >= end_) h = next_[h];
        return h;
    }
    HalfEdge nextFrom(HalfEdge h) const { return next_[h]; }
    Index target(HalfEdge h) const { return target_[h]; }
    bool empty() const { return head_.empty(); }

  private:
    /// True if `t` is the first of the triangles that were taken back.
    bool isNext(const Triangle& t) const {
        return target_[end_] == t.b && target_[end_ + 1] == t.c && target_[end_ + 2] == t.a;
    }
    void forgetTakenBack() {
        while (next_.size() > end_) {
            const auto h = static_cast<HalfEdge>(next_.size() - 1);
            const HalfEdge base = h - h % 3;
            head_[target_[base + (h + 2 - base) % 3]] = next_[h];  // the point that h leaves
            next_.pop_back();
            if (h == base) target_.resize(base);
        }
    }

    std::vector<HalfEdge> head_;
    std::vector<HalfEdge> next_;
    std::vector<Index> target_;
    std::size_t end_ = 0;  ///< Sides of the present triangles; those from it on are taken back.
};

}  // namespace se
