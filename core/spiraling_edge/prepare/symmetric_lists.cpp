/// The inverse of all lists by a counting sort, then each list merged with its inverse, in parallel
/// by blocks of points. O(list entries log longest list).
#include <algorithm>
#include <numeric>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

namespace {

/// The inverse of the lists: for each point, the points that list it.
NeighborLists turnedRound(const NeighborLists& lists) {
    const std::size_t n = lists.size();
    NeighborLists turned;
    turned.offset.assign(n + 1, 0);
    for (const Index q : lists.ids) ++turned.offset[q + std::size_t{1}];
    std::partial_sum(turned.offset.begin(), turned.offset.end(), turned.offset.begin());
    turned.ids.resize(lists.ids.size());
    std::vector<std::uint32_t> next = turned.offset;
    for (Index p = 0; p < n; ++p) {
        for (const Index q : lists[p]) turned.ids[next[q]++] = p;
    }
    return turned;
}

/// The rows of points from .. to, one list after the other.
struct Piece {
    std::vector<Index> ids;
    std::vector<std::uint32_t> length;
};

/// Merges both lists of p.
class Joiner {
  public:
    Joiner(std::span<const Vec3> position, const NeighborLists& lists,
           const NeighborLists& listedBy)
        : position_(position), lists_(lists), listedBy_(listedBy) {}

    void append(Index p, Piece& piece) {
        row_.clear();
        add(p, lists_[p]);
        add(p, listedBy_[p]);
        std::sort(row_.begin(), row_.end());
        row_.erase(std::unique(row_.begin(), row_.end()), row_.end());
        for (const Neighbor& neighbor : row_) piece.ids.push_back(neighbor.id);
        piece.length.push_back(static_cast<std::uint32_t>(row_.size()));
    }

  private:
    void add(Index p, std::span<const Index> others) {
        for (const Index q : others)
            row_.push_back({distanceSquared(position_[p], position_[q]), q});
    }

    std::span<const Vec3> position_;
    const NeighborLists& lists_;
    const NeighborLists& listedBy_;
    std::vector<Neighbor> row_;
};

}  // namespace

Result<NeighborLists> symmetricLists(std::span<const Vec3> position, const NeighborLists& lists,
                                     unsigned threads, const Progress& progress) {
    const std::size_t n = position.size();
    if (2 * lists.ids.size() >= kNone) {
        return Error{
            "symmetric neighbor lists could hold more than 4294967294 entries in all; "
            "choose a smaller k or radius"};
    }
    const NeighborLists listedBy = turnedRound(lists);
    constexpr std::size_t kPerPiece = 4096;
    std::vector<Piece> piece((n + kPerPiece - 1) / kPerPiece);
    const bool all = forEachWithProgress(piece.size(), threads, 2, progress, [&](std::size_t i) {
        Joiner joiner(position, lists, listedBy);
        for (std::size_t p = i * kPerPiece; p < std::min((i + 1) * kPerPiece, n); ++p)
            joiner.append(static_cast<Index>(p), piece[i]);
    });
    if (!all) return Error{"making neighbor lists symmetric was cancelled"};
    NeighborLists both;
    both.offset.reserve(n + 1);
    std::size_t entries = 0;
    for (const Piece& each : piece) entries += each.ids.size();
    both.ids.reserve(entries);
    for (const Piece& each : piece) {
        both.ids.insert(both.ids.end(), each.ids.begin(), each.ids.end());
        for (const std::uint32_t length : each.length)
            both.offset.push_back(both.offset.back() + length);
    }
    return both;
}

}  // namespace se
