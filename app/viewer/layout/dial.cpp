// Names are placed in the order of their importance. Each tries its own angle, then angles to both
// sides in growing steps, then the same in a second row outward; the first free position is taken.
#include "dial.h"

#include <algorithm>
#include <glm/common.hpp>
#include <optional>

#include "overlays.h"

namespace se::view {

namespace {

/// Disc and names about the origin.
Rect boundsOf(float radius, std::span<const DialName> names, float gap, float margin) {
    glm::vec2 low(-radius - margin);
    glm::vec2 high(radius + margin);
    for (const DialName& name : names) {
        const glm::vec2 corner = nameCorner(DialCircle{{}, radius}.at(name.degrees), name, gap);
        low = glm::min(low, corner);
        high = glm::max(high, corner + name.extent);
    }
    return {low, high - low};
}

/// Limit and step of moving a name along the rim, in degrees.
constexpr int kFarthest = 48;
constexpr int kStep = 2;
/// Distance from which a line leads back to the rim.
constexpr int kLeaderFromRow = 5;
/// Maximum reach of the corner of a name over the rim, as a share of the gap.
constexpr float kTouch = 0.4F;

class NamePlacer {
  public:
    NamePlacer(const DialCircle& disc, const NameRoom& room) : disc_(disc), room_(room) {
        taken_.assign(room.taken.begin(), room.taken.end());
    }

    std::optional<PlacedName> place(const DialName& name) {
        for (int row = 0; row < 2; ++row) {
            for (int off = 0; off <= kFarthest; off += kStep) {
                for (const int side : {1, -1}) {
                    const std::optional<Rect> rect = freeAt(name, side * off, row);
                    if (!rect) continue;
                    taken_.push_back(*rect);
                    return PlacedName{0, *rect, row > 0 || off >= kLeaderFromRow};
                }
            }
        }
        return std::nullopt;
    }

  private:
    std::optional<Rect> freeAt(const DialName& name, int off, int row) const {
        const double degrees = name.degrees + off;
        const float gap = room_.gap + static_cast<float>(row) * room_.line;
        const Rect rect{nameCorner(disc_.at(degrees), {degrees, name.extent}, gap), name.extent};
        // Half a pixel: the disc was made as large as the names allow.
        const bool inside = within(rect, room_.area, 0.5F);
        // Moved along the rim a long name may reach into the disc; its corner touches it anyway.
        const LabelMark filled{disc_.center, disc_.radius - kTouch * room_.gap};
        if (!inside || overlap(rect, filled)) return std::nullopt;
        for (const Rect& other : taken_) {
            if (overlap(rect, other)) return std::nullopt;
        }
        return rect;
    }

    const DialCircle& disc_;
    const NameRoom& room_;
    std::vector<Rect> taken_;
};

}  // namespace

glm::vec2 nameCorner(glm::vec2 rim, const DialName& name, float gap) {
    const float a = glm::radians(static_cast<float>(name.degrees));
    return {rim.x + gap * std::cos(a) + 0.5F * name.extent.x * (std::cos(a) - 1.0F),
            rim.y - gap * std::sin(a) - 0.5F * name.extent.y * (std::sin(a) + 1.0F)};
}

DialCircle fitDial(const Rect& room, std::span<const DialName> names, float gap, float margin) {
    float least = 0.0F;
    float most = 0.5F * std::min(room.size.x, room.size.y);
    // The bounds grow with the radius.
    for (int i = 0; i < 12; ++i) {
        const float radius = 0.5F * (least + most);
        const Rect bounds = boundsOf(radius, names, gap, margin);
        const bool fits = bounds.size.x <= room.size.x && bounds.size.y <= room.size.y;
        (fits ? least : most) = radius;
    }
    const Rect bounds = boundsOf(least, names, gap, margin);
    return {room.min + 0.5F * (room.size - bounds.size) - bounds.min, least};
}

std::vector<PlacedName> placeNames(const DialCircle& disc, const NameRoom& room,
                                   std::span<const DialName> names) {
    NamePlacer placer(disc, room);
    std::vector<PlacedName> placed;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::optional<PlacedName> found = placer.place(names[i]);
        if (!found) continue;
        found->name = i;
        placed.push_back(*found);
    }
    return placed;
}

}  // namespace se::view
