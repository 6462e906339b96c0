/// The corner of a view in which a plate hides least. Plain arithmetic, in pixels.
#pragma once

#include <optional>
#include <span>

#include "labels.h"

namespace se::view {

enum class Corner : std::uint8_t { TopRight, TopLeft, BottomRight, BottomLeft };

/// A plate of `size` in a corner of `view`, at `margin` from its sides.
Rect cornerRect(const Rect& view, glm::vec2 size, float margin, Corner corner);

/// Things that a plate in a corner must not cover.
struct CornerRoom {
    Rect view;
    float margin = 0.0F;
    std::span<const Rect> taken{};       ///< Areas covered by other overlays.
    std::span<const LabelMark> marks{};  ///< Points that must stay visible.
};

/// The first of `corners` where the plate covers none of them; empty if there is none, or if the
/// view is too small for it.
std::optional<Rect> freeCorner(const CornerRoom& room, glm::vec2 size,
                               std::span<const Corner> corners);

}  // namespace se::view
