/// In which corner of a view a plate hides least. Plain arithmetic, in pixels.
#pragma once

#include <optional>
#include <span>

#include "labels.h"

namespace se::view {

enum class Corner : std::uint8_t { TopRight, TopLeft, BottomRight, BottomLeft };

/// A plate of `size` in a corner of `view`, at `margin` from its sides.
Rect cornerRect(const Rect& view, glm::vec2 size, float margin, Corner corner);

/// What a plate in a corner must leave alone.
struct CornerRoom {
    Rect view;
    float margin = 0.0F;
    std::span<const Rect> taken{};       ///< By other things.
    std::span<const LabelMark> marks{};  ///< What must stay in sight.
};

/// The first of `corners` where it covers nothing of that; nothing if there is none, or if the view
/// is too small for it.
std::optional<Rect> freeCorner(const CornerRoom& room, glm::vec2 size,
                               std::span<const Corner> corners);

}  // namespace se::view
