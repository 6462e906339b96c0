#include "spiraling_edge/stepper/robust/mesh_tree.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/second_layer.h"
#include "spiraling_edge/geometry/z_curve.h"

namespace se {

void MeshTree::Bounds::add(const Bounds& o) {
    for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], o.low[i]);
        high[i] = std::max(high[i], o.high[i]);
    }
}

bool MeshTree::Bounds::holds(const Bounds& o) const {
    return low[0] <= o.low[0] && low[1] <= o.low[1] && low[2] <= o.low[2] && high[0] >= o.high[0] &&
           high[1] >= o.high[1] && high[2] >= o.high[2];
}

MeshTree::Bounds MeshTree::bounds(const Box& box) const {
    // Far above the rounding of coordinates, which are hardly larger than 1.
    constexpr double kMargin = 1e-6;
    Bounds found;
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        found.low[k] = static_cast<float>((box.low[i] - middle_[i]) * scale_ - kMargin);
        found.high[k] = static_cast<float>((box.high[i] - middle_[i]) * scale_ + kMargin);
    }
    return found;
}

MeshTree::Node::Node() {
    for (std::size_t i = 0; i < kWidth; ++i) setBox(i, {});
}

MeshTree::Bounds MeshTree::Node::box(std::size_t place) const {
    return {{low[0][place], low[1][place], low[2][place]},
            {high[0][place], high[1][place], high[2][place]}};
}

void MeshTree::Node::setBox(std::size_t place, const Bounds& box) {
    for (std::size_t i = 0; i < 3; ++i) {
        low[i][place] = box.low[i];
        high[i][place] = box.high[i];
    }
}

/// Around the boxes of all children.
MeshTree::Bounds MeshTree::Node::all() const {
    static_assert(kWidth == 4);
    // From kFar on, so that a coordinate that is not a number counts for none.
    const auto least = [](const std::array<float, kWidth>& of) {
        return std::min(std::min(std::min(std::min(kFar, of[0]), of[1]), of[2]), of[3]);
    };
    const auto most = [](const std::array<float, kWidth>& of) {
        return std::max(std::max(std::max(std::max(-kFar, of[0]), of[1]), of[2]), of[3]);
    };
    return {{least(low[0]), least(low[1]), least(low[2])},
            {most(high[0]), most(high[1]), most(high[2])}};
}

namespace {

constexpr std::size_t kTrianglesPerThread = 1 << 12;
/// Levels above the leaves, of 2^32 triangles.
constexpr std::size_t kMaxLevels = 16;

/// The triangles of one leaf; kNone for those that it lacks.
using Group = std::array<Index, MeshTree::kWidth>;

/// Runs of up to four consecutive triangles, each of whose first corner belongs to the triangle
/// before it, as in a fan. Runs that are neighbors on a Gray-code curve share a group.
std::vector<Group> groupsOf(const PointSet& points, std::span<const Triangle> triangles) {
    std::vector<Index> firstOf;
    std::vector<Vec3> place;
    for (Index t = 0; t < triangles.size(); ++t) {
        const Index first = triangles[t].a;
        const auto holdsFirst = [&](const Triangle& o) {
            return first == o.a || first == o.b || first == o.c;
        };
        if (t > 0 && t - firstOf.back() < MeshTree::kWidth && holdsFirst(triangles[t - 1]))
            continue;
        firstOf.push_back(t);
        place.push_back(points.position[first]);
    }
    firstOf.push_back(static_cast<Index>(triangles.size()));
    std::vector<Group> groups;
    groups.reserve(triangles.size() / 2);
    std::size_t room = 0;
    for (const Index run : grayCurveOrder(place)) {
        if (firstOf[run + 1] - firstOf[run] > room) {
            groups.emplace_back().fill(kNone);
            room = MeshTree::kWidth;
        }
        for (Index t = firstOf[run]; t < firstOf[run + 1]; ++t)
            groups.back()[MeshTree::kWidth - room--] = t;
    }
    return groups;
}

}  // namespace

MeshTree::MeshTree(const PointSet& points, std::span<const Triangle> triangles)
    : points_(points), placeOf_(triangles.size(), kNone) {
    std::optional<Box> all;
    for (const Vec3& p : points.position) {
        if (!isFinite(p)) continue;
        if (!all) all.emplace(p);
        all->add(p);
    }
    if (all) middle_ = 0.5 * all->low + 0.5 * all->high;
    const Vec3 sides = all ? all->high - all->low : Vec3(0.0);
    const double extent = std::max({sides.x, sides.y, sides.z});
    if (extent > 0.0 && 1.0 / extent < std::numeric_limits<double>::max()) scale_ = 1.0 / extent;
    const std::vector<Group> groups = groupsOf(points, triangles);
    // A level after the other, from the leaves on.
    const std::size_t leaves = std::max<std::size_t>(1, groups.size());
    nodes_.reserve(leaves + leaves / (kWidth - 1) + kMaxLevels);
    nodes_.resize(leaves);
    forEachItem(groups.size(), 0, kTrianglesPerThread / kWidth, [&](std::size_t leaf) {
        for (Index i = 0; i < kWidth && groups[leaf][i] != kNone; ++i)
            set(static_cast<Index>(leaf), i, groups[leaf][i],
                bounds(conflictBox(points, triangles[groups[leaf][i]])));
    });
    Index begin = 0;
    auto end = static_cast<Index>(nodes_.size());
    while (end - begin > 1) {
        for (Index i = begin; i < end; ++i) {
            if ((i - begin) % kWidth == 0) nodes_.emplace_back().isLeaf = false;
            set(static_cast<Index>(nodes_.size() - 1), (i - begin) % kWidth, i, nodes_[i].all());
        }
        begin = std::exchange(end, static_cast<Index>(nodes_.size()));
    }
    root_ = end - 1;
}

void MeshTree::set(Index node, Index place, Index child, const Bounds& box) {
    nodes_[node].setBox(place, box);
    nodes_[node].child[place] = child;
    (nodes_[node].isLeaf ? placeOf_[child] : nodes_[child].parent) = kWidth * node + place;
}

/// Grows the boxes above a node, up to one that holds the box, as do those above it.
void MeshTree::grow(Index node, const Bounds& box) {
    for (Index up = nodes_[node].parent; up != kNone; up = nodes_[up / kWidth].parent) {
        Bounds grown = nodes_[up / kWidth].box(up % kWidth);
        if (grown.holds(box)) return;
        grown.add(box);
        nodes_[up / kWidth].setBox(up % kWidth, grown);
    }
}

Index MeshTree::leafFor(const Bounds& box) const {
    Index at = root_;
    while (!nodes_[at].isLeaf) {
        const Node& node = nodes_[at];
        float least = kFar;
        for (Index i = 0; i < kWidth; ++i) {
            if (node.child[i] == kNone) continue;
            Bounds grown = node.box(i);
            const float before = grown.size();
            grown.add(box);
            // Of boxes that need not grow the smallest.
            const float cost = grown.size() - 0.999F * before;
            if (!(cost < least)) continue;
            least = cost;
            at = node.child[i];
        }
    }
    return at;
}

/// An empty leaf beside a full one; if its parent is full, too, both get a parent of their own.
Index MeshTree::leafBeside(Index leaf) {
    ++added_;
    const auto next = static_cast<Index>(nodes_.size());
    const Index above = nodes_[leaf].parent;
    const Index place = above == kNone ? kWidth : freePlace(above / kWidth);
    if (place != kWidth) {
        nodes_.emplace_back();
        set(above / kWidth, place, next, {});
        return next;
    }
    const Index full = next;
    nodes_.push_back(nodes_[leaf]);
    nodes_.emplace_back();
    for (Index i = 0; i < kWidth; ++i) set(full, i, nodes_[full].child[i], nodes_[full].box(i));
    Node inner;
    inner.parent = above;
    inner.isLeaf = false;
    nodes_[leaf] = inner;
    set(leaf, 0, full, nodes_[full].all());
    set(leaf, 1, full + 1, {});
    return full + 1;
}

/// The first place of a node without a child; kWidth if there is none.
Index MeshTree::freePlace(Index node) const {
    const auto& children = nodes_[node].child;
    return static_cast<Index>(std::find(children.begin(), children.end(), kNone) -
                              children.begin());
}

void MeshTree::put(Index t, const Triangle& corners) {
    if (t >= placeOf_.size()) placeOf_.resize(t + 1, kNone);
    const Bounds box = bounds(conflictBox(points_, corners));
    Index place = placeOf_[t];
    // A triangle that changes mostly stays near.
    if (place == kNone || nodes_[place / kWidth].meeting(box) == 0) {
        remove(t);
        Index leaf = leafFor(box);
        if (freePlace(leaf) == kWidth) leaf = leafBeside(leaf);
        place = kWidth * leaf + freePlace(leaf);
    }
    set(place / kWidth, place % kWidth, t, box);
    grow(place / kWidth, box);
}

void MeshTree::remove(Index t) {
    if (t >= placeOf_.size() || placeOf_[t] == kNone) return;
    const Index place = std::exchange(placeOf_[t], kNone);
    nodes_[place / kWidth].setBox(place % kWidth, {});
    nodes_[place / kWidth].child[place % kWidth] = kNone;
}

}  // namespace se
