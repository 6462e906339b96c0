/// Pairs by a grid. The boxes of the triangles, wider by the gap that a second layer may have, are
/// put into cells of 1.5 mean sizes; a pair is tested in one of its common cells only, first by
/// boxes, then for lying side by side, for a second layer, and exactly for an intersection. Cells
/// are made for one block of the grid at a time, so that memory holds little more than the block of
/// each triangle. Several blocks are one task; a task that may have ended later than the limits
/// allow, since other tasks ran beside it, is repeated with the work of all tasks before it. O(t
/// log t) for t triangles of similar size, bounded by a work limit on tangled meshes.
#include "spiraling_edge/mesh/fault_pairs.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <glm/geometric.hpp>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/geometry/second_layer.h"
#include "spiraling_edge/geometry/triangle_shape.h"

namespace se {
namespace {

/// Triangles in one plane need exact arithmetic, about a hundred times as slow. A flat surface has
/// a few such pairs for each triangle: only those beyond this number count with their full cost.
constexpr std::uint64_t kFlatPairsPerTriangle = 16;
constexpr std::uint64_t kFlatPairWork = 2048;
/// Of a pair whose wider boxes meet: for most only the normals, or the sides of one triangle, are
/// compared.
constexpr std::uint64_t kLayerTestWork = 4;
/// Triangles of a task, about: milliseconds of work.
constexpr std::size_t kTaskTriangles = 4096;

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

/// Counts of a search so far. They only grow, and add up over its parts.
struct PairCounts {
    std::uint64_t visits = 0;  ///< Work without the extra work of pairs in one plane.
    std::uint64_t flat = 0;    ///< Pairs in one plane.
    std::uint64_t intersections = 0;
    std::uint64_t layers = 0;

    /// These counts, with those of a part that began at `begin` and ended at `end`.
    PairCounts plus(const PairCounts& begin, const PairCounts& end) const {
        return {visits + (end.visits - begin.visits), flat + (end.flat - begin.flat),
                intersections + (end.intersections - begin.intersections),
                layers + (end.layers - begin.layers)};
    }
};

std::uint64_t workOf(const PairCounts& counts, const PairLimits& limits) {
    const std::uint64_t beyond = counts.flat > limits.flat ? counts.flat - limits.flat : 0;
    return std::min(limits.work, counts.visits + kFlatPairWork * beyond);
}

/// True when the search must end: a triangle made 70,000 times, as in a run that was stopped, makes
/// more than two billion pairs, and even skipping them takes minutes.
bool isReached(const PairLimits& limits, const PairCounts& counts) {
    return counts.intersections >= limits.found || counts.layers >= limits.found ||
           workOf(counts, limits) >= limits.work;
}

/// A triangle and a block of the grid that its box touches.
struct InBlock {
    std::uint64_t block;
    Index triangle;
    friend auto operator<=>(const InBlock&, const InBlock&) = default;
};

/// The input of all tasks.
struct PairInput {
    const PointSet& points;
    std::span<const Triangle> triangles;
    std::span<const std::uint8_t> usable;
    PairLimits limits;
    BoxCells grid;
};

/// A triangle with the values that its pairs are tested by.
struct PairCandidate {
    PairCandidate(const PairInput& input, Index number)
        : triangle(number),
          shape(layerShape(input.points, input.triangles[number])),
          box(boxOf(input.points, input.triangles[number])),
          wide(conflictBox(box, shape)) {}

    Index triangle;
    LayerShape shape;
    Box box;
    Box wide;  ///< conflictBox() of the triangle.
};

/// Tests the pairs of one task after the other; its memory is reused.
class PairTester {
  public:
    explicit PairTester(const PairInput& input) : input_(input) {}

    /// The counts that the next task begins with; forgets the faults found.
    void begin(const PairCounts& counts) {
        counts_ = counts;
        faults_.clear();
    }
    const PairCounts& counts() const { return counts_; }
    std::span<const Fault> faults() const { return faults_; }

    /// Tests the pairs in the cells of each block.
    void testBlocks(std::span<const InBlock> placed) {
        while (!placed.empty() && !isOver()) {
            const auto end = std::find_if_not(placed.begin(), placed.end(), [&](const InBlock& p) {
                return p.block == placed.front().block;
            });
            const auto count = static_cast<std::size_t>(end - placed.begin());
            testBlock(placed.first(count));
            placed = placed.subspan(count);
        }
    }
    /// Tests triangles over too many cells with all others.
    void testLarge(std::span<const Index> large) {
        for (const Index each : large) {
            if (isOver()) return;
            const PairCandidate a(input_, each);
            for (Index b = 0; b < input_.triangles.size(); ++b) {
                ++counts_.visits;
                if (b == each || input_.usable[b] == 0) continue;
                if (!mayConflict(a.box, boxOf(input_.points, input_.triangles[b]))) continue;
                const PairCandidate other(input_, b);
                if (a.wide.meets(other.wide)) testPair(a, other);
            }
        }
    }

  private:
    /// A grid cell that the box of a candidate touches.
    struct InCell {
        std::uint64_t cell;
        Index candidate;
        friend auto operator<=>(const InCell&, const InCell&) = default;
    };

    void testBlock(std::span<const InBlock> block);
    void testPair(const PairCandidate& a, const PairCandidate& b);
    void add(FaultKind kind, Index a, Index b) {
        faults_.push_back({kind, std::min(a, b), std::max(a, b)});
    }
    bool isOver() const { return isReached(input_.limits, counts_); }

    const PairInput& input_;
    PairCounts counts_;
    std::vector<Fault> faults_;
    std::vector<PairCandidate> candidates_;  ///< Of one block.
    std::vector<InCell> inCells_;            ///< Of one block.
};

void PairTester::testBlock(std::span<const InBlock> block) {
    candidates_.clear();
    inCells_.clear();
    for (const InBlock& each : block) {
        const auto number = static_cast<Index>(candidates_.size());
        const PairCandidate& candidate = candidates_.emplace_back(input_, each.triangle);
        input_.grid.forEachCell(candidate.wide.low, candidate.wide.high, [&](std::uint64_t cell) {
            if (BoxCells::blockOf(cell) == each.block) inCells_.push_back({cell, number});
        });
    }
    std::sort(inCells_.begin(), inCells_.end());
    for (std::size_t i = 0; i < inCells_.size() && !isOver(); ++i) {
        const std::uint64_t cell = inCells_[i].cell;
        const PairCandidate& a = candidates_[inCells_[i].candidate];
        for (std::size_t j = i + 1; j < inCells_.size() && inCells_[j].cell == cell; ++j) {
            const PairCandidate& b = candidates_[inCells_[j].candidate];
            ++counts_.visits;
            if (a.wide.meets(b.wide) && input_.grid.cellOfPair(a.wide.low, b.wide.low) == cell)
                testPair(a, b);
        }
    }
}

/// Tests a pair whose wider boxes meet.
void PairTester::testPair(const PairCandidate& a, const PairCandidate& b) {
    if (isOver()) return;
    counts_.visits += kLayerTestWork;
    const Triangle& one = input_.triangles[a.triangle];
    const Triangle& other = input_.triangles[b.triangle];
    if (areParallel(a.shape, b.shape) && lieSideBySide(input_.points, one, a.shape, other, b.shape))
        return;
    if (isSecondLayer(input_.points, one, a.shape, other, b.shape)) {
        add(FaultKind::SecondLayer, a.triangle, b.triangle);
        ++counts_.layers;
    }
    if (!a.box.meets(b.box)) return;
    counts_.visits += kPairTestWork;
    if (liesFlat(input_.points, one, other)) ++counts_.flat;
    if (trianglesShareMore(input_.points.position, one, other)) {
        add(FaultKind::Intersecting, a.triangle, b.triangle);
        ++counts_.intersections;
    }
}

/// The pairs found by all tasks so far, as if they had run one after the other.
class PairTasks {
  public:
    PairTasks(const PairInput& input, unsigned threads)
        : input_(input), testers_(threadCount(threads), PairTester(input)) {}

    /// Calls test(task, tester) for each of `count` tasks, several at a time, up to the limits.
    template <typename Test>
    void run(std::size_t count, Test&& test) {
        for (std::size_t task = 0; task < count && !isOver(); task += testers_.size()) {
            const std::size_t width = std::min(testers_.size(), count - task);
            const PairCounts begin = counts_;
            forEachItem(width, static_cast<unsigned>(width), 1, [&](std::size_t i) {
                testers_[i].begin(begin);
                test(task + i, testers_[i]);
            });
            for (std::size_t i = 0; i < width && !isOver(); ++i) {
                PairTester& tester = testers_[i];
                PairCounts end = counts_.plus(begin, tester.counts());
                if (i > 0 && isReached(input_.limits, end)) {
                    tester.begin(counts_);
                    test(task + i, tester);
                    end = tester.counts();
                }
                counts_ = end;
                faults_.insert(faults_.end(), tester.faults().begin(), tester.faults().end());
            }
        }
    }
    FaultSearch result() && {
        return {std::move(faults_), !isOver(), workOf(counts_, input_.limits)};
    }

  private:
    bool isOver() const { return isReached(input_.limits, counts_); }

    const PairInput& input_;
    std::vector<PairTester> testers_;
    PairCounts counts_;
    std::vector<Fault> faults_;
};

/// The grid for the boxes of all triangles.
BoxCells gridFor(const PointSet& points, std::span<const Triangle> triangles) {
    double meanSize = 0.0;
    Vec3 low = points.position[triangles.front().a];
    for (const Triangle& t : triangles) {
        const Box box = boxOf(points, t);
        const Vec3 d = box.high - box.low;
        meanSize += std::max(d.x, std::max(d.y, d.z));
        low = glm::min(low, box.low);
    }
    meanSize /= static_cast<double>(triangles.size());
    // Of the size of a typical triangle. Triangles over many cells are kept apart.
    return {low, meanSize > 0.0 ? 1.5 * meanSize : 1.0};
}

/// The triangles of a mesh by block, and those over too many cells.
struct TrianglesByBlock {
    std::vector<InBlock> inBlocks;  ///< By block, then by triangle.
    std::vector<Index> large;       ///< Ascending.
};

void addToBlocks(const PairInput& input, Index triangle, TrianglesByBlock& placed) {
    if (input.usable[triangle] == 0) return;
    const Triangle& t = input.triangles[triangle];
    const Box wide = conflictBox(input.points, t);
    const bool fits = input.grid.forEachBlock(wide.low, wide.high, [&](std::uint64_t block) {
        placed.inBlocks.push_back({block, triangle});
    });
    if (!fits) placed.large.push_back(triangle);
}

TrianglesByBlock trianglesByBlock(const PairInput& input) {
    TrianglesByBlock placed;
    placed.inBlocks.reserve(input.triangles.size() + input.triangles.size() / 2);
    for (Index i = 0; i < input.triangles.size(); ++i) addToBlocks(input, i, placed);
    std::sort(placed.inBlocks.begin(), placed.inBlocks.end());
    return placed;
}

/// Consecutive entries of whole blocks, enough for a task each.
std::vector<std::span<const InBlock>> tasksOf(std::span<const InBlock> placed) {
    std::vector<std::span<const InBlock>> tasks;
    std::size_t begin = 0;
    for (std::size_t end = 1; end <= placed.size(); ++end) {
        const bool isWhole = end == placed.size() || placed[end].block != placed[end - 1].block;
        if (!isWhole || (end < placed.size() && end - begin < kTaskTriangles)) continue;
        tasks.push_back(placed.subspan(begin, end - begin));
        begin = end;
    }
    return tasks;
}

}  // namespace

PairLimits PairLimits::ofMesh(std::size_t triangles) {
    return {kPairWork + kPairWorkPerTriangle * triangles, kFlatPairsPerTriangle * triangles,
            kMaxPairs};
}

FaultSearch searchPairs(const PointSet& points, std::span<const Triangle> triangles,
                        std::span<const std::uint8_t> usable, const PairLimits& limits,
                        unsigned threads) {
    if (triangles.empty()) return {};
    const PairInput input{points, triangles, usable, limits, gridFor(points, triangles)};
    const TrianglesByBlock placed = trianglesByBlock(input);
    PairTasks tasks(input, threads);
    const auto blocks = tasksOf(placed.inBlocks);
    tasks.run(blocks.size(),
              [&](std::size_t i, PairTester& tester) { tester.testBlocks(blocks[i]); });
    const std::size_t ofTask = std::max<std::size_t>(1, kTaskTriangles / triangles.size());
    const std::span<const Index> large(placed.large);
    tasks.run((large.size() + ofTask - 1) / ofTask, [&](std::size_t i, PairTester& tester) {
        const std::size_t begin = i * ofTask;
        tester.testLarge(large.subspan(begin, std::min(ofTask, large.size() - begin)));
    });
    return std::move(tasks).result();
}

}  // namespace se
