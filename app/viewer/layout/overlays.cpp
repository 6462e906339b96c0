// Greedy placement: labels are placed by rank, each at the cheapest free position among eight
// directions at growing distances from its point. The cost weighs distance, the amount of drawing
// that the label covers (OccupancyGrid), the habit of reading right above a point, and pointing
// toward the pivot. The search of a label ends as soon as distance alone costs more than its best
// position.
#include "overlays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "scene/camera.h"
#include "scene/screen_rect.h"

namespace se::view {

namespace {

/// Maximum distance of a plate from its point, in em.
constexpr std::array kFar = {0.45F, 0.8F, 1.2F, 1.7F, 2.4F, 3.2F, 4.2F, 5.4F, 7.0F, 9.0F, 12.0F};
/// Number of these distances for labels of each rank.
constexpr std::array kReach = {kFar.size(), std::size_t{8}, std::size_t{4}, kFar.size(),
                               kFar.size()};
static_assert(kReach.size() == static_cast<std::size_t>(LabelRank::Given) + 1);
/// Distance from which a line leads to the point, in em.
constexpr float kLeaderFrom = 0.95F;
/// Costs of one em of distance, of covering a cell full of lines, and of pointing to the pivot.
constexpr float kPerEm = 0.4F;
constexpr float kPerInk = 0.16F;
constexpr float kInward = 0.7F;
/// Labels are expected right above their point.
constexpr float kUnusual = 0.12F;
/// Between two plates, in em.
constexpr float kApart = 0.08F;

struct Way {
    glm::vec2 to;
    float unusual;  ///< 0 for the usual positions.
};

constexpr float kDiagonal = 0.70710678F;
constexpr std::array kWays = {
    Way{{kDiagonal, -kDiagonal}, 0.0F},
    Way{{kDiagonal, kDiagonal}, 1.0F},
    Way{{-kDiagonal, -kDiagonal}, 1.0F},
    Way{{-kDiagonal, kDiagonal}, 1.5F},
    Way{{1.0F, 0.0F}, 1.0F},
    Way{{-1.0F, 0.0F}, 1.5F},
    Way{{0.0F, -1.0F}, 1.5F},
    Way{{0.0F, 1.0F}, 2.0F},
};

/// The plate whose side or corner toward `at` is `distance` away from it.
Rect plateAt(glm::vec2 at, glm::vec2 plate, glm::vec2 way, float distance) {
    const glm::vec2 near = at + way * distance;
    const auto part = [](float along) { return along > 0.5F ? 0.0F : along < -0.5F ? 1.0F : 0.5F; };
    return {glm::round(near - plate * glm::vec2(part(way.x), part(way.y))), plate};
}

template <class Others>
bool overlapsAny(const Rect& rect, const Others& others) {
    return std::any_of(others.begin(), others.end(),
                       [&](const auto& other) { return overlap(rect, other); });
}

class Placer {
  public:
    explicit Placer(const LabelRoom& room) : room_(room) {
        taken_.assign(room.taken.begin(), room.taken.end());
    }

    std::optional<PlacedLabel> place(const LabelRequest& label) {
        if (!room_.area.contains(label.at)) return std::nullopt;
        const std::size_t reach = kReach[static_cast<std::size_t>(label.rank)];
        std::optional<PlacedLabel> best;
        float least = std::numeric_limits<float>::max();
        for (std::size_t i = 0; i < reach && kFar[i] * kPerEm < least; ++i) {
            for (const Way& way : kWays) {
                const Rect plate = plateAt(label.at, label.plate, way.to, kFar[i] * room_.em);
                const float price = priceOf(label, way, kFar[i], plate);
                if (price >= least || !isFree(plate)) continue;
                least = price;
                best = PlacedLabel{0, plate, kFar[i] > kLeaderFrom};
            }
        }
        if (best) taken_.push_back(best->plate);
        return best;
    }

  private:
    float priceOf(const LabelRequest& label, const Way& way, float far, const Rect& plate) const {
        const glm::vec2 outward = label.at - room_.middle;
        const float length = glm::length(outward);
        // At the pivot itself every direction leads outward.
        const float turn = length > 0.5F * room_.em ? glm::dot(outward / length, way.to) : 1.0F;
        const float ink = room_.occupancy != nullptr ? room_.occupancy->under(plate) : 0.0F;
        return kPerEm * far + kUnusual * way.unusual + kInward * (1.0F - turn) + kPerInk * ink;
    }

    bool isFree(const Rect& plate) const {
        const glm::vec2 apart(kApart * room_.em);
        const Rect wide{plate.min - apart, plate.size + 2.0F * apart};
        return within(plate, room_.area) && !overlapsAny(wide, taken_) &&
               !overlapsAny(wide, room_.marks);
    }

    const LabelRoom& room_;
    std::vector<Rect> taken_;
};

/// The part of a line from `from` to `to` within an interval on one axis, as shares of it.
void clipAxis(float from, float way, float low, float high, float& begin, float& end) {
    if (std::abs(way) < 1e-6F) {
        if (from < low || from > high) end = begin;
        return;
    }
    const float a = (low - from) / way;
    const float b = (high - from) / way;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
}

}  // namespace

bool within(const Rect& rect, const Rect& area, float slack) {
    return rect.min.x >= area.min.x - slack && rect.min.y >= area.min.y - slack &&
           rect.max().x <= area.max().x + slack && rect.max().y <= area.max().y + slack;
}

bool overlap(const Rect& a, const Rect& b) {
    return a.min.x < b.max().x && b.min.x < a.max().x && a.min.y < b.max().y && b.min.y < a.max().y;
}

glm::vec2 nearestIn(const Rect& rect, glm::vec2 from) {
    return glm::clamp(from, rect.min, rect.max());
}

bool overlap(const Rect& rect, const LabelMark& mark) {
    return glm::distance(nearestIn(rect, mark.at), mark.at) < mark.radius;
}

std::vector<PlacedLabel> placeLabels(const LabelRoom& room, std::span<const LabelRequest> labels) {
    Placer placer(room);
    std::vector<PlacedLabel> placed;
    std::size_t counted = 0;
    for (const LabelRank rank : {LabelRank::Essential, LabelRank::Given, LabelRank::Strong,
                                 LabelRank::Minor, LabelRank::Asked}) {
        const bool counts = rank != LabelRank::Given && rank != LabelRank::Asked;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (labels[i].rank != rank) continue;
            if (counts && counted == kMaxLabels) break;
            std::optional<PlacedLabel> found = placer.place(labels[i]);
            if (!found) continue;
            found->index = i;
            placed.push_back(*found);
            if (counts) ++counted;
        }
    }
    return placed;
}

Rect cornerRect(const Rect& view, glm::vec2 size, float margin, Corner corner) {
    const bool left = corner == Corner::TopLeft || corner == Corner::BottomLeft;
    const bool top = corner == Corner::TopLeft || corner == Corner::TopRight;
    return {{left ? view.min.x + margin : view.max().x - margin - size.x,
             top ? view.min.y + margin : view.max().y - margin - size.y},
            size};
}

std::optional<Rect> freeCorner(const CornerRoom& room, glm::vec2 size,
                               std::span<const Corner> corners) {
    const glm::vec2 whole = size + glm::vec2(2.0F * room.margin);
    if (whole.x > room.view.size.x || whole.y > room.view.size.y) return std::nullopt;
    for (const Corner corner : corners) {
        const Rect rect = cornerRect(room.view, size, room.margin, corner);
        if (!overlapsAny(rect, room.taken) && !overlapsAny(rect, room.marks)) return rect;
    }
    return std::nullopt;
}

std::optional<EdgeArrow> edgeArrow(const CameraMatrices& camera, const glm::vec3& place,
                                   glm::vec2 size, float inset) {
    const glm::vec2 half = 0.5F * size - glm::vec2(inset);
    if (!(half.x > 0.0F && half.y > 0.0F)) return std::nullopt;
    const glm::vec4 clip = camera.viewProjection() * glm::vec4(place, 1.0F);
    const bool inside = clip.w > 0.0F && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
    if (inside) return std::nullopt;
    // Not divided by w: a point behind the eye would appear on the wrong side.
    const glm::vec2 off(clip.x * size.x, -clip.y * size.y);
    const float length = glm::length(off);
    // Directly behind the eye every direction is equally good.
    const glm::vec2 way = length > 0.0F ? off / length : glm::vec2(0.0F, 1.0F);
    constexpr float kNever = std::numeric_limits<float>::max();
    const float reach = std::min(way.x != 0.0F ? half.x / std::abs(way.x) : kNever,
                                 way.y != 0.0F ? half.y / std::abs(way.y) : kNever);
    return EdgeArrow{0.5F * size + reach * way, way};
}

// A summed-area table (Crow 1984): shapes add their weight to the cells of a grid, finish() turns
// the cells into prefix sums, and the weight under a rectangle is then four look-ups.

OccupancyGrid::OccupancyGrid(const Rect& area, float cell)
    : area_(area),
      cell_(cell),
      size_(glm::max(glm::ivec2(glm::ceil(area.size / cell)), 1)),
      sums_(static_cast<std::size_t>(size_.x + 1) * static_cast<std::size_t>(size_.y + 1)) {}

glm::ivec2 OccupancyGrid::cellAt(glm::vec2 place) const {
    const glm::vec2 cell = glm::floor((place - area_.min) / cell_);
    return glm::ivec2(glm::clamp(cell, glm::vec2(0.0F), glm::vec2(size_ - 1)));
}

glm::vec2 OccupancyGrid::middle(int x, int y) const {
    return area_.min + cell_ * (glm::vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5F);
}

float& OccupancyGrid::at(int x, int y) {
    // The first row and column stay zero.
    const auto line = static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(size_.x + 1);
    return sums_[line + static_cast<std::size_t>(x + 1)];
}

void OccupancyGrid::addLine(glm::vec2 from, glm::vec2 to, float weight) {
    const glm::vec2 way = to - from;
    float begin = 0.0F;
    float end = 1.0F;
    clipAxis(from.x, way.x, area_.min.x, area_.max().x, begin, end);
    clipAxis(from.y, way.y, area_.min.y, area_.max().y, begin, end);
    const float length = glm::length(way) * (end - begin);
    if (!(length > 0.0F)) return;
    const int steps = std::max(1, static_cast<int>(std::ceil(2.0F * length / cell_)));
    const float each = weight * length / cell_ / static_cast<float>(steps);
    for (int i = 0; i < steps; ++i) {
        const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(steps);
        const glm::ivec2 cell = cellAt(from + (begin + (end - begin) * share) * way);
        at(cell.x, cell.y) += each;
    }
}

void OccupancyGrid::addSpot(glm::vec2 center, float radius, float weight) {
    if (!area_.contains(center)) return;
    const glm::ivec2 own = cellAt(center);
    const glm::ivec2 first = cellAt(center - radius);
    const glm::ivec2 last = cellAt(center + radius);
    at(own.x, own.y) += weight;
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            if (glm::ivec2(x, y) != own && glm::distance(middle(x, y), center) <= radius)
                at(x, y) += weight;
        }
    }
}

void OccupancyGrid::addTriangle(glm::vec2 a, glm::vec2 b, glm::vec2 c, float weight) {
    const float turn = crossOf(b - a, c - a);
    if (turn == 0.0F) return;
    const glm::vec2 low = glm::min(a, glm::min(b, c));
    const glm::vec2 high = glm::max(a, glm::max(b, c));
    if (high.x < area_.min.x || high.y < area_.min.y || low.x >= area_.max().x ||
        low.y >= area_.max().y) {
        return;
    }
    const glm::ivec2 first = cellAt(low);
    const glm::ivec2 last = cellAt(high);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            const glm::vec2 m = middle(x, y);
            const std::array sides = {crossOf(b - a, m - a), crossOf(c - b, m - b),
                                      crossOf(a - c, m - c)};
            const bool inside = std::all_of(sides.begin(), sides.end(),
                                            [&](float side) { return side * turn >= 0.0F; });
            if (inside) at(x, y) += weight;
        }
    }
}

void OccupancyGrid::finish() {
    for (int y = 0; y < size_.y; ++y) {
        for (int x = 0; x < size_.x; ++x) {
            at(x, y) += at(x - 1, y) + at(x, y - 1) - at(x - 1, y - 1);
        }
    }
}

float OccupancyGrid::under(const Rect& rect) const {
    const glm::vec2 low = glm::max(rect.min, area_.min);
    const glm::vec2 high = glm::min(rect.max(), area_.max());
    if (!(low.x < high.x && low.y < high.y)) return 0.0F;
    const auto sum = [&](int x, int y) {
        return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x + 1) +
                     static_cast<std::size_t>(x)];
    };
    // A rectangle that ends at the border of a cell does not touch the next.
    const glm::ivec2 from = cellAt(low);
    const glm::ivec2 to =
        cellAt({std::nextafter(high.x, low.x), std::nextafter(high.y, low.y)}) + 1;
    return sum(to.x, to.y) - sum(from.x, to.y) - sum(to.x, from.y) + sum(from.x, from.y);
}

// Greedy clusters by severity, found by a grid of cells of the size of a cluster: a founder is in
// one of the nine cells about a place.

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
