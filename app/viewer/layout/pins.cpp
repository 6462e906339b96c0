// Greedy clusters by severity, found by a grid of cells of the size of a cluster: a founder is in
// one of the nine cells about a place.
#include "pins.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace se::view {

namespace {

/// Places within this distance of the most severe one share its pin, in em.
constexpr float kClusterReach = 3.2F;
/// A pin fades between this radius and kSeenFrom, in em.
constexpr float kFadesFrom = 0.5F;
/// Of the head: radius without and with a text, margin of the text, height above the tip, in em.
constexpr float kBareHead = 0.42F;
constexpr float kHead = 0.78F;
constexpr float kTextMargin = 0.42F;
constexpr float kStem = 1.1F;

float strengthOf(float radius, float em) {
    return std::clamp((kSeenFrom - radius / em) / (kSeenFrom - kFadesFrom), 0.0F, 1.0F);
}

class Clusters {
  public:
    Clusters(const Rect& area, float reach)
        : area_(area),
          reach_(reach),
          size_(glm::max(glm::ivec2(area.size / reach) + 1, 1)),
          cells_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y)) {}

    /// The nearest pin within reach; null if there is none.
    Pin* near(glm::vec2 at) {
        const glm::ivec2 cell = cellAt(at);
        Pin* best = nullptr;
        float least = reach_;
        for (int y = std::max(cell.y - 1, 0); y <= std::min(cell.y + 1, size_.y - 1); ++y) {
            for (int x = std::max(cell.x - 1, 0); x <= std::min(cell.x + 1, size_.x - 1); ++x) {
                for (const std::size_t i : cells_[indexOf({x, y})]) {
                    const float distance = glm::distance(pins_[i].tip, at);
                    if (distance >= least) continue;
                    least = distance;
                    best = &pins_[i];
                }
            }
        }
        return best;
    }
    void add(const Pin& pin) {
        cells_[indexOf(cellAt(pin.tip))].push_back(pins_.size());
        pins_.push_back(pin);
    }
    std::vector<Pin> take() { return std::move(pins_); }

  private:
    glm::ivec2 cellAt(glm::vec2 at) const {
        return glm::clamp(glm::ivec2((at - area_.min) / reach_), glm::ivec2(0), size_ - 1);
    }
    std::size_t indexOf(glm::ivec2 cell) const {
        return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(size_.x) +
               static_cast<std::size_t>(cell.x);
    }

    Rect area_;
    float reach_;
    glm::ivec2 size_;
    std::vector<std::vector<std::size_t>> cells_;
    std::vector<Pin> pins_;
};

}  // namespace

std::vector<Pin> pinsOf(std::span<const PinPlace> places, const Rect& area, float em) {
    Clusters clusters(area, kClusterReach * em);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const PinPlace& each = places[i];
        const float strength = strengthOf(each.radius, em);
        if (strength <= 0.0F || !area.contains(each.at)) continue;
        if (Pin* pin = clusters.near(each.at)) {
            ++pin->count;
            pin->strength = std::max(pin->strength, strength);
        } else {
            clusters.add({i, 1, each.at, strength});
        }
    }
    return clusters.take();
}

Rect headOf(const Pin& pin, float textWidth, const Rect& area, float em) {
    const float half = (textWidth > 0.0F ? kHead : kBareHead) * em;
    const glm::vec2 size(std::max(2.0F * half, textWidth + 2.0F * kTextMargin * em), 2.0F * half);
    const float above = pin.tip.y - kStem * em - size.y;
    const float top = above < area.min.y ? pin.tip.y + kStem * em : above;
    const float left = std::clamp(pin.tip.x - 0.5F * size.x, area.min.x,
                                  std::max(area.min.x, area.max().x - size.x));
    return {{left, top}, size};
}

}  // namespace se::view
