/// Neighbor lists by a k-d tree (nanoflann) over points packed along a Z-curve. The tree only
/// proposes: distances are compared exactly, ties by index, so that lists do not depend on the
/// tree, on threads or on a translation without rounding. Ranges of leaves are searched in
/// parallel. O(n log n) for n points and short lists.
#include "spiraling_edge/prepare/neighbor_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <numeric>
#include <string>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/z_curve.h"

namespace se {
namespace {

/// Choice: where many normals around a point oppose its own, as around a flipped normal, only this
/// many of the nearest points are examined. Without a bound such a point searches the whole set in
/// vain, and some percent of flipped normals make the search quadratic.
std::size_t mostExamined(std::size_t k) { return 8 * k + 64; }
/// Number of points that are searched as one range.
constexpr std::size_t kPerRange = 1024;
/// Least number of ranges per thread.
constexpr std::size_t kRangesPerThread = 4;

/// The tree prunes by sums that it updates step by step and compares with `<`. Its bound is widened
/// by more than their rounding error, so that it never hides a point: which points count is decided
/// here, by exact comparison. The smallest double is for bounds that are 0 by underflow.
double widened(double bound) { return bound * (1.0 + 1e-9) + std::numeric_limits<double>::min(); }

/// The usable points, packed along a Z-curve, in the form that nanoflann requires.
class Cloud {
  public:
    /// `normal` may be empty; then normal() must not be called.
    Cloud(std::span<const Vec3> position, std::span<const Vec3> normal,
          const std::vector<bool>& usable) {
        for (const Index p : zCurveOrder(position)) {
            if (!usable[p]) continue;
            id_.push_back(p);
            position_.push_back(position[p]);
            if (!normal.empty()) normal_.push_back(normal[p]);
        }
    }

    std::size_t size() const { return id_.size(); }
    const Vec3& position(Index i) const { return position_[i]; }
    const Vec3& normal(Index i) const { return normal_[i]; }
    /// The index of packed point i in the whole set.
    Index id(Index i) const { return id_[i]; }

    // NOLINTBEGIN(readability-identifier-naming): names that nanoflann calls
    std::size_t kdtree_get_point_count() const { return size(); }
    double kdtree_get_pt(Index i, std::size_t axis) const {
        return position_[i][static_cast<Vec3::length_type>(axis)];
    }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const {
        return false;  // nanoflann computes it
    }
    // NOLINTEND(readability-identifier-naming)

  private:
    std::vector<Vec3> position_;
    std::vector<Vec3> normal_;
    std::vector<Index> id_;
};

/// The metric for nanoflann: exactly that by which lists are ordered.
struct Distance {
    using ElementType = double;
    using DistanceType = double;

    explicit Distance(const Cloud& points) : cloud(points) {}
    double evalMetric(const double* here, Index i, std::size_t) const {
        return distanceSquared({here[0], here[1], here[2]}, cloud.position(i));
    }
    // NOLINTNEXTLINE(readability-identifier-naming): called by nanoflann
    double accum_dist(double a, double b, int) const { return (a - b) * (a - b); }

    const Cloud& cloud;
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<Distance, Cloud, 3, Index>;

/// A point that was found. Ordered as lists are, see Neighbor.
struct Found {
    Neighbor neighbor;  ///< By its index in the whole set.
    Index packed;       ///< Its index in the Cloud.
    friend bool operator<(const Found& a, const Found& b) { return a.neighbor < b.neighbor; }
};

/// Collects candidates for the list of one point while the tree is searched: its nearest points, or
/// all within a radius. Points at the position of the point itself do not count.
class Candidates {
  public:
    explicit Candidates(const Cloud& cloud) : cloud_(cloud) {}

    struct Limits {
        std::size_t capacity = 0;  ///< Maximum length of the list, at least 1.
        double reachSquared = std::numeric_limits<double>::max();
        bool dropOpposing = false;
        std::size_t mostDropped = 0;  ///< Beyond it the search ends without a result.
    };

    void start(Index point, const Limits& limits) {
        found_.clear();
        point_ = point;
        limits_ = limits;
        bound_ = widened(limits.reachSquared);
        dropped_ = 0;
    }
    bool gaveUp() const { return dropped_ > limits_.mostDropped; }
    /// Ends the search and returns what was found, nearest first.
    const std::vector<Found>& sorted() {
        if (!full()) std::sort(found_.begin(), found_.end());
        return found_;
    }

    // The interface of a result set of nanoflann.
    double worstDist() const { return bound_; }
    std::size_t size() const { return found_.size(); }
    bool full() const { return found_.size() == limits_.capacity; }
    bool addPoint(double distance, Index i) {
        if (distance > limits_.reachSquared) return true;
        // Only points at the same place are at distance 0, or so near that its square is.
        if (distance == 0.0 && cloud_.position(i) == cloud_.position(point_)) return true;
        const Found candidate{{distance, cloud_.id(i)}, i};
        if (full() && !(candidate < found_.back())) return true;
        if (limits_.dropOpposing && normalsOppose(cloud_.normal(point_), cloud_.normal(i))) {
            ++dropped_;
            return !gaveUp();
        }
        insert(candidate);
        return true;
    }

  private:
    void insert(const Found& candidate) {
        if (full()) {
            auto place = found_.end() - 1;  // that of the farthest, which is removed
            for (; place != found_.begin() && candidate < *(place - 1); --place) {
                *place = *(place - 1);
            }
            *place = candidate;
        } else {
            found_.push_back(candidate);
            if (full()) std::sort(found_.begin(), found_.end());
        }
        if (full()) bound_ = std::min(bound_, widened(found_.back().neighbor.distanceSquared));
    }

    const Cloud& cloud_;
    std::vector<Found> found_;  // sorted as soon as it is full
    Index point_ = kNone;
    Limits limits_;
    double bound_ = 0.0;
    std::size_t dropped_ = 0;
};

/// Finds the lists of a range of points in the order of the tree's leaves: consecutive searches
/// touch mostly the same points, which are still in the cache.
class RangeSearch {
  public:
    RangeSearch(const Cloud& cloud, const Tree& tree, const NeighborOptions& options,
                std::size_t from, std::size_t to)
        : cloud_(cloud), tree_(tree), options_(options), candidates_(cloud), from_(from), to_(to) {}

    void run() {
        length_.reserve(to_ - from_);
        for (std::size_t i = from_; i < to_; ++i) {
            const std::size_t before = found_.size();
            search(tree_.vAcc[i]);
            length_.push_back(static_cast<std::uint32_t>(found_.size() - before));
        }
    }

    std::size_t entries() const { return found_.size(); }
    /// Writes the length of each list one position after its point, for partial sums.
    void writeLengths(std::vector<std::uint32_t>& offset) const {
        for (std::size_t i = from_; i < to_; ++i) {
            offset[cloud_.id(tree_.vAcc[i]) + std::size_t{1}] = length_[i - from_];
        }
    }
    /// Copies the lists to the positions in `lists.offset`.
    void writeLists(NeighborLists& lists) const {
        auto from = found_.begin();
        for (std::size_t i = from_; i < to_; ++i) {
            const auto to = from + length_[i - from_];
            std::copy(from, to, lists.ids.begin() + lists.offset[cloud_.id(tree_.vAcc[i])]);
            from = to;
        }
    }

  private:
    void search(Index point) {
        const std::size_t others = cloud_.size() - 1;
        if (others == 0) return;
        Candidates::Limits limits;
        limits.capacity = others;
        limits.dropOpposing = options_.dropOpposingNormals;
        limits.mostDropped = others;
        if (const auto* reach = std::get_if<WithinRadius>(&options_.reach)) {
            limits.reachSquared = reach->radius * reach->radius;
            query(point, limits);
            return take(point, others);
        }
        const std::size_t k = std::min(std::get<KNearest>(options_.reach).k, others);
        limits.capacity = k;
        limits.mostDropped = mostExamined(k) - k;
        query(point, limits);
        if (candidates_.gaveUp()) {
            limits.capacity = std::min(mostExamined(k), others);
            limits.dropOpposing = false;
            query(point, limits);
        }
        // A search that did not end early dropped so few points that all it found are among the
        // nearest mostExamined(k): both methods give the same list wherever both apply.
        take(point, k);
    }

    void query(Index point, const Candidates::Limits& limits) {
        candidates_.start(point, limits);
        tree_.findNeighbors(candidates_, &cloud_.position(point).x, nanoflann::SearchParams());
    }

    /// Appends the first `limit` candidates that pass the filter.
    void take(Index point, std::size_t limit) {
        const std::size_t end = found_.size() + limit;
        for (const Found& candidate : candidates_.sorted()) {
            if (found_.size() == end) return;
            if (options_.dropOpposingNormals &&
                normalsOppose(cloud_.normal(point), cloud_.normal(candidate.packed))) {
                continue;
            }
            found_.push_back(candidate.neighbor.id);
        }
    }

    const Cloud& cloud_;
    const Tree& tree_;
    const NeighborOptions& options_;
    Candidates candidates_;
    std::size_t from_, to_;
    std::vector<Index> found_;           // all lists, in leaf order
    std::vector<std::uint32_t> length_;  // of each
};

/// Splits the points into ranges, and these over threads. Every list is found independently, so
/// that the number of threads affects only the time.
class NeighborSearch {
  public:
    NeighborSearch(std::span<const Vec3> position, std::span<const Vec3> normal,
                   const std::vector<bool>& usable, const NeighborOptions& options)
        : total_(position.size()),
          options_(options),
          cloud_(position, normal, usable),
          tree_(3, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize)) {}

    Result<NeighborLists> run(const Progress& progress) {
        for (std::size_t from = 0; from < cloud_.size(); from += kPerRange) {
            ranges_.emplace_back(cloud_, tree_, options_, from,
                                 std::min(from + kPerRange, cloud_.size()));
        }
        if (!forEachWithProgress(ranges_.size(), options_.threads, kRangesPerThread, progress,
                                 [this](std::size_t i) { ranges_[i].run(); })) {
            return Error{"the search for neighbors was cancelled"};
        }
        std::size_t entries = 0;
        for (const RangeSearch& range : ranges_) entries += range.entries();
        if (entries >= kNone) {
            return Error{
                "the neighbor lists would hold more than 4294967294 entries in all; "
                "choose a smaller k or radius"};
        }
        if (progress) progress(1.0);
        return inOrderOfIndex(entries);
    }

  private:
    static constexpr std::size_t kLeafSize = 10;
    NeighborLists inOrderOfIndex(std::size_t entries) const {
        NeighborLists lists;
        lists.offset.assign(total_ + 1, 0);
        for (const RangeSearch& range : ranges_) range.writeLengths(lists.offset);
        std::partial_sum(lists.offset.begin(), lists.offset.end(), lists.offset.begin());
        lists.ids.resize(entries);
        for (const RangeSearch& range : ranges_) range.writeLists(lists);
        return lists;
    }

    std::size_t total_;
    const NeighborOptions& options_;
    Cloud cloud_;
    Tree tree_;
    std::vector<RangeSearch> ranges_;
};

[[maybe_unused]] bool areFinite(std::span<const Vec3> position, const std::vector<bool>& usable) {
    for (std::size_t p = 0; p < position.size(); ++p) {
        if (usable[p] && !isFinite(position[p])) return false;
    }
    return true;
}

/// Mean distance to the nearest point; 1 if no point has one: then no radius finds any.
double meanSpacing(std::span<const Vec3> position, const NeighborLists& nearest) {
    double sum = 0.0;
    std::size_t count = 0;
    for (Index p = 0; p < nearest.size(); ++p) {
        if (nearest[p].empty()) continue;
        sum += std::sqrt(distanceSquared(position[p], position[nearest[p].front()]));
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : 1.0;
}

/// Searches the nearest point of each first, for the spacing.
Result<NeighborLists> withinSpacings(double spacings, std::span<const Vec3> position,
                                     std::span<const Vec3> normal, const std::vector<bool>& usable,
                                     NeighborOptions options, const Progress& progress) {
    constexpr double kNearestShare = 0.3;
    options.reach = KNearest{1};
    const Result<NeighborLists> nearest =
        NeighborSearch(position, normal, usable, options).run(partOf(progress, 0.0, kNearestShare));
    if (!nearest) return nearest.error();
    options.reach = WithinRadius{spacings * meanSpacing(position, nearest.value())};
    return NeighborSearch(position, normal, usable, options)
        .run(partOf(progress, kNearestShare, 1.0));
}

}  // namespace

void sortNearestFirst(std::span<const Vec3> position, Index p, std::vector<Index>& list) {
    std::vector<Neighbor> neighbors;
    neighbors.reserve(list.size());
    assert(list.empty() || isFinite(position[p]));
    for (const Index q : list) {
        assert(isFinite(position[q]));
        neighbors.push_back({distanceSquared(position[p], position[q]), q});
    }
    std::sort(neighbors.begin(), neighbors.end());
    // Repeated entries have the same distance and are now adjacent.
    neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
    list.clear();
    for (const Neighbor& neighbor : neighbors) list.push_back(neighbor.id);
}

Status checkReach(const NeighborOptions& options) {
    if (const auto* reach = std::get_if<WithinRadius>(&options.reach)) {
        if (reach->radius > 0.0) return success();
        return Error{"the radius of neighbor lists must be positive, but is " +
                     std::to_string(reach->radius)};
    }
    if (const auto* reach = std::get_if<WithinSpacings>(&options.reach)) {
        if (reach->spacings > 0.0) return success();
        return Error{"the reach of neighbor lists must be positive, but is " +
                     std::to_string(reach->spacings) + " spacings"};
    }
    if (std::get<KNearest>(options.reach).k > 0) return success();
    return Error{"the number of neighbors per point must be positive, but is 0"};
}

Result<NeighborLists> findNeighbors(std::span<const Vec3> position, std::span<const Vec3> normal,
                                    const std::vector<bool>& usable, const NeighborOptions& options,
                                    const Progress& progress) {
    if (Status status = checkReach(options); !status) return status.error();
    const std::size_t n = position.size();
    if (n >= kNone)
        return Error{"there are " + std::to_string(n) + " points; at most 4294967294 are possible"};
    if (usable.size() != n || (options.dropOpposingNormals && normal.size() != n)) {
        return Error{"there are " + std::to_string(n) + " positions, but " +
                     std::to_string(normal.size()) + " normals and " +
                     std::to_string(usable.size()) + " marks of usable points"};
    }
    assert(areFinite(position, usable));
    if (!options.dropOpposingNormals) normal = {};
    if (const auto* reach = std::get_if<WithinSpacings>(&options.reach))
        return withinSpacings(reach->spacings, position, normal, usable, options, progress);
    return NeighborSearch(position, normal, usable, options).run(progress);
}

}  // namespace se
