/// Where the labels of a view go: none covers another, none covers what matters, and the fan of the
/// pivot stays in sight. Plain arithmetic, in pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "occupancy_grid.h"
#include "panel_rects.h"

namespace se::view {

/// Who gets a place first, and goes how far for it.
enum class LabelRank : std::uint8_t {
    Essential,  ///< Names of the pivot, its ends, what is under test and what is selected.
    Strong,     ///< What the stage at the cursor says.
    Minor,      ///< The rest: left out where there is no room close by.
};

struct LabelWish {
    glm::vec2 at{0.0F};     ///< What it belongs to.
    glm::vec2 plate{0.0F};  ///< Size of the text with its margin.
    LabelRank rank = LabelRank::Minor;
};

/// The mark of a point that must stay in sight.
struct LabelMark {
    glm::vec2 at{0.0F};
    float radius = 0.0F;
};

struct LabelRoom {
    Rect area;                      ///< All plates lie within it.
    std::span<const Rect> taken{};  ///< By other things than labels.
    std::span<const LabelMark> marks{};
    const Clutter* clutter = nullptr;  ///< What is drawn; null: not known.
    glm::vec2 middle{0.0F};            ///< Labels rather go away from here: the pivot.
    float em = 16.0F;
};

struct PlacedLabel {
    std::size_t wish = 0;  ///< Its place in the list of wishes.
    Rect plate;
    /// From `at` to the plate, where it stands too far off to be understood without.
    bool leader = false;
};

/// By rank, and within a rank in the order given. A label whose point is outside of the area, or
/// for which there is no place, is not in the result.
std::vector<PlacedLabel> placeLabels(const LabelRoom& room, std::span<const LabelWish> wishes);

bool overlap(const Rect& a, const Rect& b);
bool overlap(const Rect& rect, const LabelMark& mark);
/// The place of `rect` that is nearest to `from`.
glm::vec2 nearestIn(const Rect& rect, glm::vec2 from);

}  // namespace se::view
