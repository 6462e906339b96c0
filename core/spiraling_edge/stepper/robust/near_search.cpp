/// Conflicts are searched among triangles near by place, not by neighbor lists. Most pairs are told
/// apart by the sides of their corners in the planes of one triangle (edge_planes.h), found once
/// per point.
#include <algorithm>
#include <array>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/edge_planes.h"
#include "spiraling_edge/stepper/robust/mesh_tree.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {
namespace {

/// The tree over the present triangles.
const MeshTree& treeOf(const PointSet& points, RepairState& m) {
    MeshIndex& near = m.near;
    if (near.tree == nullptr || near.points != &points || near.tree->isWorn()) {
        const std::vector<Triangle>& triangles = m.triangles;
        near.tree = std::make_shared<MeshTree>(points, triangles);
        near.points = &points;
        near.changed.clear();
    }
    for (const Index t : near.changed) {
        if (t < m.triangles.size()) {
            near.tree->put(t, m.triangles[t]);
        } else {
            near.tree->remove(t);
        }
    }
    near.changed.clear();
    return *near.tree;
}

/// A triangle against those of the mesh.
class ConflictSearch {
  public:
    ConflictSearch(const PointSet& points, const RepairState& m, const MeshTree& tree,
                   const Triangle& mine)
        : points_(points), m_(m), tree_(tree), mine_(points, mine), planes_(points, mine_) {
        point_.fill(kNone);
    }

    /// Calls found(t) for each triangle in conflict with it but those that `leavesOut`, until that
    /// returns true. True if it did.
    template <typename LeavesOut, typename Found>
    bool any(LeavesOut&& leavesOut, Found&& found) {
        return tree_.anyNear(conflictBox(mine_.box, mine_.shape), [&](Index t) {
            if (leavesOut(t)) return false;
            const Triangle& other = m_.triangles[t];
            return !areApart(other) && conflict(points_, mine_, other) && found(t);
        });
    }

  private:
    /// True if the sides of the corners of another triangle show that there is no conflict.
    bool areApart(const Triangle& other) {
        const unsigned common = sidesOf(other.a) & sidesOf(other.b) & sidesOf(other.c);
        return (common & EdgePlanes::kBeyondEdge) != 0 ||
               (EdgePlanes::isOffPlane(common) &&
                encloseWide(mine_.shape.normal, areaVector(points_, other)));
    }
    unsigned sidesOf(Index p) {
        const std::size_t slot = p % point_.size();
        if (std::exchange(point_[slot], p) != p) sides_[slot] = planes_.sidesOf(p);
        return sides_[slot];
    }

    const PointSet& points_;
    const RepairState& m_;
    const MeshTree& tree_;
    ShapedTriangle mine_;
    EdgePlanes planes_;
    // By index of a point; later ones replace earlier ones.
    std::array<Index, 128> point_{};
    std::array<std::uint8_t, 128> sides_{};
};

}  // namespace

Index firstConflict(const PointSet& points, RepairState& m, const Triangle& t,
                    std::span<const Index> gone) {
    Index first = kNone;
    ConflictSearch(points, m, treeOf(points, m), t)
        .any([&](Index i) { return std::find(gone.begin(), gone.end(), i) != gone.end(); },
             [&](Index i) {
                 first = i;
                 return true;
             });
    return first;
}

std::vector<Index> conflictsOf(const PointSet& points, RepairState& m, const Triangle& t) {
    std::vector<Index> list;
    ConflictSearch(points, m, treeOf(points, m), t)
        .any([](Index) { return false; },
             [&](Index i) {
                 list.push_back(i);
                 return false;
             });
    std::sort(list.begin(), list.end());
    return list;
}

int countConflicts(const PointSet& points, RepairState& m, std::span<const Triangle> made,
                   std::array<Index, 2> gone, int most) {
    int count = 0;
    for (const Triangle& t : made) {
        if (count > most) break;
        ConflictSearch(points, m, treeOf(points, m), t)
            .any([&](Index i) { return i == gone[0] || i == gone[1]; },
                 [&](Index) { return ++count > most; });
    }
    return count;
}

bool isRough(const PointSet& points, const RepairState& m, Index t) {
    const Triangle& corners = m.triangles[t];
    return !clearlyFaces(points, corners, kRough) && isSteep(points, corners, kRough);
}

namespace {

void setSound(RepairState& m, Index t) {
    m.sound.resize(std::max(m.sound.size(), m.triangles.size()));
    m.sound.set(t, 1);
}

/// True if the triangle is neither flipped nor in conflict: isSound() without RepairState::sound.
bool hasNoFault(const PointSet& points, const RepairState& m, const MeshTree& tree, Index t) {
    return shapeFaults(points, m.triangles[t]) < kFlippedFault &&
           !ConflictSearch(points, m, tree, m.triangles[t])
                .any([&](Index i) { return i == t; }, [](Index) { return true; });
}

}  // namespace

bool isSound(const PointSet& points, RepairState& m, Index t) {
    if (isKnownAsSound(m, t)) return true;
    if (!hasNoFault(points, m, treeOf(points, m), t)) return false;
    setSound(m, t);
    return true;
}

bool isFaulty(const PointSet& points, RepairState& m, Index t) {
    if (isKnownAsSound(m, t)) return false;
    if (isRough(points, m, t)) return !isSound(points, m, t);
    setSound(m, t);
    return false;
}

void findSound(const PointSet& points, RepairState& m) {
    constexpr std::size_t kPerThread = 1 << 10;
    const std::size_t count = m.triangles.size();
    m.facing = {&points, std::vector<FacingTriangle>(count)};
    std::vector<std::uint8_t> rough(count);
    forEachItem(count, 0, kPerThread, [&](std::size_t t) {
        FacingTriangle& facing = m.facing.at[t];
        facing = facingTriangle(points, m.triangles[t]);
        rough[t] =
            facing.cosine == FacingTriangle::kNotFacing && isSteep(points, m.triangles[t], kRough);
    });
    if (std::find(rough.begin(), rough.end(), 1) == rough.end()) return;
    const MeshTree& tree = treeOf(points, m);
    std::vector<std::uint8_t> sound(count);
    forEachItem(count, 0, kPerThread, [&](std::size_t i) {
        const auto t = static_cast<Index>(i);
        const auto isAcross = [&](HalfEdge other) { return other != kNone && rough[other / 3]; };
        const bool isAsked = rough[t] || isAcross(m.twin[3 * t]) || isAcross(m.twin[3 * t + 1]) ||
                             isAcross(m.twin[3 * t + 2]);
        sound[t] = isKnownAsSound(m, t) || !isAsked || hasNoFault(points, m, tree, t);
    });
    m.sound.assign(sound);
}

}  // namespace se
