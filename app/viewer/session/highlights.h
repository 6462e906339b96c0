/// Highlights beside the selection: the item under the pointer, the points of a finding,
/// and a ring.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/base/types.h"
#include "spiraling_edge/doctor/doctor.h"

namespace se::view {

class Highlights {
  public:
    /// The point under the pointer, in the view or on the dial; highlighted in both.
    Index hovered() const { return hovered_; }
    void hover(Index point);
    /// Points that are highlighted, such as those of a finding; none by default.
    std::span<const Index> marked() const { return marked_; }
    void mark(std::vector<Index> points, std::vector<EvidenceLine> lines = {});
    /// Lines that are highlighted with them.
    std::span<const EvidenceLine> lines() const { return lines_; }
    bool any() const { return !marked_.empty() || !lines_.empty(); }
    /// Points that show their names, such as the possible answers to a question; none by default.
    std::span<const Index> labeled() const { return labeled_; }
    void label(std::vector<Index> points);
    Index chosenRing() const { return chosenRing_; }
    /// Chooses a ring; none if it was chosen already.
    void chooseRing(Index ring);
    /// Sets the ring under the pointer, which is highlighted.
    void hoverRing(Index ring);
    /// The ring to highlight: the one under the pointer, otherwise the chosen one.
    Index litRing() const { return hoveredRing_ != kNone ? hoveredRing_ : chosenRing_; }
    void clearRings() { chosenRing_ = hoveredRing_ = kNone; }
    /// Grows with every change.
    std::uint32_t revision() const { return revision_; }

  private:
    Index hovered_ = kNone;
    Index chosenRing_ = kNone;
    Index hoveredRing_ = kNone;
    std::vector<Index> marked_;
    std::vector<EvidenceLine> lines_;
    std::vector<Index> labeled_;
    std::uint32_t revision_ = 0;
};

}  // namespace se::view
