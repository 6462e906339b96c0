/// Positions of the labels in a view: none covers another, none covers important points, and the
/// fan of the pivot stays visible. Plain arithmetic, in pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "occupancy_grid.h"
#include "panel_rects.h"

namespace se::view {

/// Rank of a label, which decides order and maximum distance.
enum class LabelRank : std::uint8_t {
    Essential,  ///< Names of the pivot, its ends, the point under test and the selection.
    Strong,     ///< Values of the stage at the cursor.
    Minor,      ///< The rest: left out if there is no room nearby.
};

struct LabelWish {
    glm::vec2 at{0.0F};     ///< Position of the labelled thing.
    glm::vec2 plate{0.0F};  ///< Size of the text with its margin.
    LabelRank rank = LabelRank::Minor;
};

/// The mark of a point that must stay visible.
struct LabelMark {
    glm::vec2 at{0.0F};
    float radius = 0.0F;
};

struct LabelRoom {
    Rect area;                      ///< All plates lie within it.
    std::span<const Rect> taken{};  ///< Areas covered by overlays other than labels.
    std::span<const LabelMark> marks{};
    const OccupancyGrid* occupancy = nullptr;  ///< Density of the drawing; null: unknown.
    glm::vec2 middle{0.0F};                    ///< Labels prefer to be away from here: the pivot.
    float em = 16.0F;
};

struct PlacedLabel {
    std::size_t wish = 0;  ///< Its position in the list of requests.
    Rect plate;
    /// From `at` to the plate, if the plate is far from it.
    bool leader = false;
};

/// By rank, and within a rank in the order given. A label whose point is outside of the area, or
/// for which there is no room, is not in the result.
std::vector<PlacedLabel> placeLabels(const LabelRoom& room, std::span<const LabelWish> wishes);

bool overlap(const Rect& a, const Rect& b);
bool overlap(const Rect& rect, const LabelMark& mark);
/// The position of `rect` that is closest to `from`.
glm::vec2 nearestIn(const Rect& rect, glm::vec2 from);

}  // namespace se::view
