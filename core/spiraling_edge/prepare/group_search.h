/// The search for the neighbor lists of points that lie near each other.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/geometry/point_blocks.h"
#include "spiraling_edge/prepare/rank_sort.h"
#include "spiraling_edge/prepare/single_search.h"

namespace se {

/// Collects the blocks near a group of points once, and of them, for each point, all points within
/// a guessed distance: most likely a few more than are listed. A guess that was too small is seen
/// from their number. Points whose neighbors are not found so are searched one by one.
class GroupSearch {
  public:
    /// Maximum number of blocks of a group. Few larger ones cost less for each point, and
    /// more smaller ones have fewer blocks near them.
    static constexpr std::size_t kMaxBlocks = 8;

    /// As of SingleSearch.
    GroupSearch(const PointBlocks& blocks, std::span<const Vec3> normal, const ListRule& rule)
        : blocks_(blocks), normal_(normal), rule_(rule), single_(blocks, normal, rule) {}

    /// Appends the lists of the group's points, in the order of slots, and the length of each.
    void find(const PointBlocks::Node& group, std::vector<Index>& ids,
              std::vector<std::uint32_t>& length);

  private:
    static constexpr std::size_t kBoxes = 4;
    /// Boxes of some blocks, for tests of all of them together.
    struct Boxes {
        std::array<std::array<double, kBoxes>, 3> low, high;
        std::array<std::uint32_t, kBoxes> block;
    };

    double bound() const;
    bool collect(const Box& box);
    std::size_t hitBlocks(const Vec3& p, double bound);
    std::size_t gather(const Vec3& p, double bound);
    bool accept(std::size_t slot, std::size_t count);
    std::span<const Neighbor> sortAccepted(double bound);
    bool listWithin(std::size_t slot, double bound, std::vector<Index>& ids);
    void list(std::size_t slot, std::vector<Index>& ids);

    const PointBlocks& blocks_;
    std::span<const Vec3> normal_;
    const ListRule& rule_;
    SingleSearch single_;
    double last_ = 0.0;   // squared distance of the last point of the last full list; 0: none yet
    double reach_ = 0.0;  // squared distance within which blocks were collected
    std::vector<Boxes> near_;         // the blocks that were collected
    std::vector<std::uint32_t> hit_;  // those of them near one point
    // Points of these blocks within the bound, and those of them that may be listed.
    std::vector<double> distance_;
    std::vector<std::uint32_t> slot_;
    std::vector<Neighbor> accepted_;
    std::size_t acceptedCount_ = 0;
    std::array<Neighbor, kMaxRanked> ranked_;
};

}  // namespace se
