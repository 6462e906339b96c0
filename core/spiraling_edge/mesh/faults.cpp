/// Faults by sorted sides: edge faults come from the sides of all triangles sorted by edge; for
/// pairs see fault_pairs.cpp.
#include "spiraling_edge/mesh/faults.h"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <tuple>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/mesh/fault_pairs.h"
#include "spiraling_edge/mesh/sorted_sides.h"

namespace se {
namespace {

/// Fewer triangles, or sides, are not worth a thread.
constexpr std::size_t kItemsPerThread = 16384;

/// Collects the faults found by several threads.
class FaultCollection {
  public:
    void add(std::span<const Fault> faults) {
        const std::lock_guard<std::mutex> lock(access_);
        all_.insert(all_.end(), faults.begin(), faults.end());
    }
    /// All faults in order, each once.
    std::vector<Fault> sorted() && {
        std::sort(all_.begin(), all_.end(), [](const Fault& a, const Fault& b) {
            return std::tie(a.kind, a.triangle, a.other) < std::tie(b.kind, b.triangle, b.other);
        });
        all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
        return std::move(all_);
    }

  private:
    std::mutex access_;
    std::vector<Fault> all_;
};

class FaultFinder {
  public:
    FaultFinder(const PointSet& points, std::span<const Triangle> triangles,
                std::span<const TriangleSide> sides, unsigned threads)
        : points_(points),
          triangles_(triangles),
          sides_(sides),
          threads_(threads),
          usable_(triangles.size(), 1) {}

    FaultSearch find(bool withPairs) && {
        findShapes();
        findEdgeFaults();
        FaultSearch found{{}, false, 0};
        if (withPairs) {
            found = searchPairs(points_, triangles_, usable_, PairLimits::ofMesh(triangles_.size()),
                                threads_);
            faults_.add(found.faults);
        }
        found.faults = std::move(faults_).sorted();
        return found;
    }

  private:
    void findShapes();
    void findEdgeFaults();

    const PointSet& points_;
    std::span<const Triangle> triangles_;
    std::span<const TriangleSide> sides_;
    unsigned threads_;
    std::vector<std::uint8_t> usable_;  ///< Has an area: worth a test. Bytes, for several threads.
    FaultCollection faults_;
};

void FaultFinder::findShapes() {
    forRanges(triangles_.size(), threads_, kItemsPerThread,
              [this](std::size_t from, std::size_t to) {
                  std::vector<Fault> found;
                  for (std::size_t i = from; i < to; ++i) {
                      if (isDegenerate(points_, triangles_[i])) {
                          usable_[i] = 0;
                          found.push_back({FaultKind::Degenerate, static_cast<Index>(i), kNone});
                      } else if (isFlipped(points_, triangles_[i])) {
                          found.push_back({FaultKind::Flipped, static_cast<Index>(i), kNone});
                      }
                  }
                  faults_.add(found);
              });
}

void FaultFinder::findEdgeFaults() {
    const auto findAt = [this](std::span<const TriangleSide> edge, std::vector<Fault>& found) {
        const auto add = [&](FaultKind kind, Index a, Index b) {
            found.push_back({kind, std::min(a, b), std::max(a, b)});
        };
        for (std::size_t i = 1; i < edge.size(); ++i) {
            if (edge.size() > 2)
                add(FaultKind::NonManifoldEdge, edge[0].triangle, edge[i].triangle);
            if (edge[i].ascending == edge[i - 1].ascending)
                add(FaultKind::InconsistentEdge, edge[i - 1].triangle, edge[i].triangle);
        }
        if (edge.size() != 2 || edge[0].ascending == edge[1].ascending) return;
        const Index a = edge[0].triangle;
        const Index b = edge[1].triangle;
        if (usable_[a] != 0 && usable_[b] != 0 && folded(points_, triangles_[a], triangles_[b]))
            add(FaultKind::Folded, a, b);
    };
    forRanges(sides_.size(), threads_, kItemsPerThread, [&](std::size_t from, std::size_t to) {
        std::vector<Fault> found;
        forEachEdge(sidesOfRange(sides_, from, to),
                    [&](std::span<const TriangleSide> edge) { findAt(edge, found); });
        faults_.add(found);
    });
}

}  // namespace

FaultSearch searchFaults(const PointSet& points, std::span<const Triangle> triangles) {
    return searchFaults(points, triangles, sortedSides(triangles));
}

FaultSearch searchFaults(const PointSet& points, std::span<const Triangle> triangles,
                         std::span<const TriangleSide> sides, unsigned threads) {
    assert(cornersBelow(triangles, points.size()) && haveFinitePositions(points, triangles));
    return FaultFinder(points, triangles, sides, threads).find(true);
}

std::vector<Fault> findFaults(const PointSet& points, std::span<const Triangle> triangles) {
    return searchFaults(points, triangles).faults;
}

FaultSearch searchLocalFaults(const PointSet& points, std::span<const Triangle> triangles,
                              std::span<const TriangleSide> sides) {
    return FaultFinder(points, triangles, sides, 0).find(false);
}

std::array<std::size_t, kFaultKinds> countFaults(std::span<const Fault> faults) {
    std::array<std::size_t, kFaultKinds> counts{};
    for (const Fault& fault : faults) ++counts[static_cast<std::size_t>(fault.kind)];
    return counts;
}

}  // namespace se
