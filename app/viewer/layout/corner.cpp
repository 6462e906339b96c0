#include "corner.h"

#include <algorithm>

namespace se::view {

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
        const bool free = std::none_of(room.taken.begin(), room.taken.end(),
                                       [&](const Rect& other) { return overlap(rect, other); }) &&
                          std::none_of(room.marks.begin(), room.marks.end(),
                                       [&](const LabelMark& mark) { return overlap(rect, mark); });
        if (free) return rect;
    }
    return std::nullopt;
}

}  // namespace se::view
