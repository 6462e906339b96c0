/// Faults by sorted sides and a grid. Edge faults come from the sides of all triangles sorted by
/// edge. For pairs, the boxes of the triangles, wider by the gap that a second layer may have, are
/// put into cells of 1.5 mean sizes; a pair is tested in one of its common cells only, first by
/// boxes, then for a second layer and exactly for an intersection. O(t log t) for t triangles of
/// similar size, bounded by a work limit on tangled meshes.
#include "spiraling_edge/mesh/faults.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/geometry/second_layer.h"
#include "spiraling_edge/mesh/sorted_sides.h"

namespace se {
namespace {

/// A grid cell that a triangle's box touches.
struct Placed {
    std::uint64_t cell;
    Index triangle;
};

/// Triangles in one plane need exact arithmetic, about a hundred times as slow. A flat surface has
/// a few such pairs for each triangle: only those beyond this number count with their full cost.
constexpr std::uint64_t kFlatPairsPerTriangle = 16;
constexpr std::uint64_t kFlatPairWork = 2048;
/// Of a pair whose wider boxes meet: for most only the normals are compared.
constexpr std::uint64_t kLayerTestWork = 4;

/// True if the corners of `b` lie in the plane of `a`, up to rounding.
bool liesFlat(const PointSet& points, const Triangle& a, const Triangle& b) {
    constexpr double kRounding = 1e-12;
    const Vec3 normal = areaVector(points, a);
    const Vec3& origin = points.position[a.a];
    const auto inPlane = [&](Index p) {
        const Vec3 d = points.position[p] - origin;
        return std::abs(glm::dot(normal, d)) <= kRounding * glm::length(normal) * glm::length(d);
    };
    return inPlane(b.a) && inPlane(b.b) && inPlane(b.c);
}

class FaultFinder {
  public:
    FaultFinder(const PointSet& points, std::span<const Triangle> triangles,
                std::span<const TriangleSide> sides)
        : points_(points),
          triangles_(triangles),
          sides_(sides),
          usable_(triangles.size(), true),
          allowed_(kPairWork + kPairWorkPerTriangle * triangles.size()),
          work_(allowed_) {}

    FaultSearch findLocal() {
        findShapes();
        findEdgeFaults();
        return result(false);
    }
    FaultSearch findAll() {
        findShapes();
        findEdgeFaults();
        findPairs();
        return result(!isOver());
    }

  private:
    FaultSearch result(bool complete) {
        std::sort(faults_.begin(), faults_.end(), [](const Fault& a, const Fault& b) {
            return std::tie(a.kind, a.triangle, a.other) < std::tie(b.kind, b.triangle, b.other);
        });
        faults_.erase(std::unique(faults_.begin(), faults_.end()), faults_.end());
        return {std::move(faults_), complete, allowed_ - work_};
    }

    void add(FaultKind kind, Index a, Index b) {
        if (b != kNone && b < a) std::swap(a, b);
        faults_.push_back({kind, a, b});
    }

    void findShapes();
    void findEdgeFaults();
    void findFold(Index a, Index b);
    void findPairs();
    void testCells(const BoxCells& grid, const std::vector<Placed>& placed);
    void testLarge(const std::vector<Index>& large);
    void testPair(Index a, Index b);
    /// True when the search must end: a triangle made 70,000 times, as in a run that was stopped,
    /// makes more than two billion pairs, and even skipping them takes minutes.
    bool isOver() const {
        return intersections_ == kMaxPairs || layers_ == kMaxPairs || work_ == 0;
    }
    void spend(std::uint64_t work) { work_ -= std::min(work, work_); }

    const PointSet& points_;
    std::span<const Triangle> triangles_;
    std::span<const TriangleSide> sides_;
    std::vector<bool> usable_;  ///< Has an area: worth a test.
    std::vector<LayerShape> shapes_;
    std::vector<Box> boxes_;
    std::vector<Box> wide_;  ///< The boxes, wider by the reach of a second layer.
    std::vector<Fault> faults_;
    std::size_t intersections_ = 0;
    std::size_t layers_ = 0;
    std::size_t flat_ = 0;  ///< Pairs in one plane so far.
    std::uint64_t allowed_;
    std::uint64_t work_;  ///< Remaining work.
};

void FaultFinder::findShapes() {
    for (Index i = 0; i < triangles_.size(); ++i) {
        if (isDegenerate(points_, triangles_[i])) {
            usable_[i] = false;
            add(FaultKind::Degenerate, i, kNone);
        } else if (isFlipped(points_, triangles_[i])) {
            add(FaultKind::Flipped, i, kNone);
        }
    }
}

void FaultFinder::findFold(Index a, Index b) {
    if (!usable_[a] || !usable_[b]) return;
    if (folded(points_, triangles_[a], triangles_[b])) add(FaultKind::Folded, a, b);
}

void FaultFinder::findEdgeFaults() {
    forEachEdge(sides_, [this](std::span<const TriangleSide> edge) {
        for (std::size_t i = 1; i < edge.size(); ++i) {
            if (edge.size() > 2) {
                add(FaultKind::NonManifoldEdge, edge[0].triangle, edge[i].triangle);
            }
            if (edge[i].ascending == edge[i - 1].ascending) {
                add(FaultKind::InconsistentEdge, edge[i - 1].triangle, edge[i].triangle);
            }
        }
        if (edge.size() == 2 && edge[0].ascending != edge[1].ascending) {
            findFold(edge[0].triangle, edge[1].triangle);
        }
    });
}

void FaultFinder::findPairs() {
    if (triangles_.empty()) return;
    boxes_.reserve(triangles_.size());
    shapes_.reserve(triangles_.size());
    wide_.reserve(triangles_.size());
    double meanSize = 0.0;
    for (const Triangle& t : triangles_) {
        const Box box = boxOf(points_, t);
        const Vec3 d = box.high - box.low;
        meanSize += std::max(d.x, std::max(d.y, d.z));
        boxes_.push_back(box);
        shapes_.push_back(layerShape(points_, t));
        wide_.push_back(box.grown(shapes_.back().reach));
    }
    meanSize /= static_cast<double>(triangles_.size());
    if (!(meanSize > 0.0)) return;
    Vec3 low = wide_[0].low;
    for (const Box& box : wide_) low = glm::min(low, box.low);
    // Of the size of a typical triangle. Triangles over many cells are kept apart.
    const BoxCells grid(low, 1.5 * meanSize);
    std::vector<Placed> placed;
    std::vector<Index> large;
    for (Index i = 0; i < triangles_.size(); ++i) {
        if (!usable_[i]) continue;
        const bool fits = grid.forEachCell(wide_[i].low, wide_[i].high, [&](std::uint64_t cell) {
            placed.push_back({cell, i});
        });
        if (!fits) large.push_back(i);
    }
    std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
        return std::tie(a.cell, a.triangle) < std::tie(b.cell, b.triangle);
    });
    testCells(grid, placed);
    testLarge(large);
}

void FaultFinder::testCells(const BoxCells& grid, const std::vector<Placed>& placed) {
    for (std::size_t i = 0; i < placed.size() && !isOver(); ++i) {
        const std::uint64_t cell = placed[i].cell;
        const Index a = placed[i].triangle;
        for (std::size_t j = i + 1; j < placed.size() && placed[j].cell == cell; ++j) {
            const Index b = placed[j].triangle;
            spend(1);
            if (grid.cellOfPair(wide_[a].low, wide_[b].low) == cell) testPair(a, b);
        }
    }
}

void FaultFinder::testLarge(const std::vector<Index>& large) {
    for (const Index a : large) {
        if (isOver()) return;
        for (Index b = 0; b < triangles_.size(); ++b) {
            spend(1);
            if (a != b && usable_[b]) testPair(a, b);
        }
    }
}

void FaultFinder::testPair(Index a, Index b) {
    if (isOver() || !wide_[a].meets(wide_[b])) return;
    spend(kLayerTestWork);
    if (isSecondLayer(points_, triangles_[a], shapes_[a], triangles_[b], shapes_[b])) {
        add(FaultKind::SecondLayer, a, b);
        ++layers_;
    }
    if (!boxes_[a].meets(boxes_[b])) return;
    spend(kPairTestWork);
    if (liesFlat(points_, triangles_[a], triangles_[b]) &&
        ++flat_ > kFlatPairsPerTriangle * triangles_.size())
        spend(kFlatPairWork);
    if (trianglesShareMore(points_.position, triangles_[a], triangles_[b])) {
        add(FaultKind::Intersecting, a, b);
        ++intersections_;
    }
}

}  // namespace

FaultSearch searchFaults(const PointSet& points, std::span<const Triangle> triangles) {
    return searchFaults(points, triangles, sortedSides(triangles));
}

FaultSearch searchFaults(const PointSet& points, std::span<const Triangle> triangles,
                         std::span<const TriangleSide> sides) {
    assert(cornersBelow(triangles, points.size()) && haveFinitePositions(points, triangles));
    return FaultFinder(points, triangles, sides).findAll();
}

std::vector<Fault> findFaults(const PointSet& points, std::span<const Triangle> triangles) {
    return searchFaults(points, triangles).faults;
}

FaultSearch searchLocalFaults(const PointSet& points, std::span<const Triangle> triangles,
                              std::span<const TriangleSide> sides) {
    return FaultFinder(points, triangles, sides).findLocal();
}

std::array<std::size_t, kFaultKinds> countFaults(std::span<const Fault> faults) {
    std::array<std::size_t, kFaultKinds> counts{};
    for (const Fault& fault : faults) ++counts[static_cast<std::size_t>(fault.kind)];
    return counts;
}

}  // namespace se
