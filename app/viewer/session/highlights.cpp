#include "highlights.h"

#include <utility>

namespace se::view {

void Highlights::hover(Index point) {
    if (point == hovered_) return;
    hovered_ = point;
    ++revision_;
}

void Highlights::mark(std::vector<Index> points, std::vector<EvidenceLine> lines) {
    if (marked_ == points && lines_ == lines) return;
    marked_ = std::move(points);
    lines_ = std::move(lines);
    ++revision_;
}

void Highlights::label(std::vector<Index> points) {
    if (labeled_ == points) return;
    labeled_ = std::move(points);
    ++revision_;
}

void Highlights::chooseRing(Index ring) {
    chosenRing_ = chosenRing_ == ring ? kNone : ring;
    ++revision_;
}

void Highlights::hoverRing(Index ring) {
    if (ring == hoveredRing_) return;
    hoveredRing_ = ring;
    ++revision_;
}

}  // namespace se::view
