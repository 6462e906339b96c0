// Greedy placement: labels are placed by rank, each at the cheapest free position among eight
// directions at growing distances from its point. The cost weighs distance, the amount of drawing
// that the label covers (occupancy_grid.h), the habit of reading right above a point, and pointing
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

namespace se::view {

namespace {

/// Maximum distance of a plate from its point, in em.
constexpr std::array kFar = {0.45F, 0.8F, 1.2F, 1.7F, 2.4F, 3.2F, 4.2F, 5.4F, 7.0F, 9.0F, 12.0F};
/// Number of these distances for labels of each rank.
constexpr std::array kReach = {kFar.size(), std::size_t{8}, std::size_t{4}, kFar.size()};
static_assert(kReach.size() == static_cast<std::size_t>(LabelRank::Asked) + 1);
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
    for (const LabelRank rank :
         {LabelRank::Essential, LabelRank::Strong, LabelRank::Minor, LabelRank::Asked}) {
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (labels[i].rank != rank) continue;
            if (rank != LabelRank::Asked && placed.size() == kMaxLabels) break;
            std::optional<PlacedLabel> found = placer.place(labels[i]);
            if (!found) continue;
            found->index = i;
            placed.push_back(*found);
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

}  // namespace se::view
