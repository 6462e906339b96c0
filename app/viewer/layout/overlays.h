/// Positions of what is drawn over a view: labels, of which none covers another or an important
/// point, so that the fan of the pivot stays visible; plates in the corner in which they hide
/// least; the arrow to something outside of the view. Plain arithmetic, in pixels.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "panel_rects.h"

namespace se::view {

struct CameraMatrices;

/// The amount of drawing under a rectangle, used to find empty places in a view. Summed on a grid,
/// so that a query costs the same regardless of the amount of drawing.
class OccupancyGrid {
  public:
    /// An empty grid. `cell`: size of a cell of the grid, in pixels, > 0.
    OccupancyGrid(const Rect& area, float cell);

    /// Adds a line of `weight` per length of a cell. Parts outside of the area do not count.
    void addLine(glm::vec2 from, glm::vec2 to, float weight);
    /// Adds a disc of `weight` per area of a cell; at least one cell gets it.
    void addSpot(glm::vec2 at, float radius, float weight);
    /// Adds a filled triangle of `weight` per area of a cell.
    void addTriangle(glm::vec2 a, glm::vec2 b, glm::vec2 c, float weight);
    /// To be called after the last shape, and before under().
    void finish();

    /// The sum over all cells that `rect` touches.
    float under(const Rect& rect) const;

  private:
    /// The cell of a place, or the one closest to it.
    glm::ivec2 cellAt(glm::vec2 place) const;
    glm::vec2 middle(int x, int y) const;
    float& at(int x, int y);

    Rect area_;
    float cell_;
    glm::ivec2 size_;  ///< In cells.
    /// One row and one column more than cells: after finish() the sums of all before.
    std::vector<float> sums_;
};

/// Rank of a label, which decides order and maximum distance.
enum class LabelRank : std::uint8_t {
    Essential,  ///< Names of the pivot, of its ends and of the points of the test.
    Strong,     ///< Values of the stage at the cursor.
    Minor,      ///< The rest: left out if there is no room nearby.
    Asked,      ///< What the user points at or chooses from, beside the number of the others.
    Given,      ///< Other names of a lesson or a figure: before values, beside their number.
};

/// Maximum number of labels in a view, without those that are given or asked for.
inline constexpr std::size_t kMaxLabels = 7;

struct LabelRequest {
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
    std::size_t index = 0;  ///< Into the list of requests.
    Rect plate;
    /// From `at` to the plate, if the plate is far from it.
    bool leader = false;
};

/// By rank, and within a rank in the order given, up to kMaxLabels and those that are given or
/// asked for. A label whose point is outside of the area, or for which there is no room, is not in
/// the result.
std::vector<PlacedLabel> placeLabels(const LabelRoom& room, std::span<const LabelRequest> labels);

/// True if `rect` lies within the area, up to `slack`.
bool within(const Rect& rect, const Rect& area, float slack = 0.0F);
bool overlap(const Rect& a, const Rect& b);
bool overlap(const Rect& rect, const LabelMark& mark);
/// The position of `rect` that is closest to `from`.
glm::vec2 nearestIn(const Rect& rect, glm::vec2 from);

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

struct EdgeArrow {
    glm::vec2 at{0.0F};   ///< In pixels of the view, y down.
    glm::vec2 way{0.0F};  ///< Unit direction to the target.
};

/// Position of an arrow to `place` in a view of `size`, at `inset` from its edge. Empty if the
/// place is within the view, or the view too small for an arrow.
std::optional<EdgeArrow> edgeArrow(const CameraMatrices& camera, const glm::vec3& place,
                                   glm::vec2 size, float inset);

// Pins over the finished mesh: places with faults that are too small on the screen to be seen, as
// clusters with the number of their places. Plain arithmetic, in pixels.

/// Radius, in em, from which on a place is seen at its size and needs no pin.
inline constexpr float kSeenFrom = 0.9F;

/// A place on the screen.
struct PinPlace {
    glm::vec2 at{0.0F};
    float radius = 0.0F;
};

struct Pin {
    std::size_t place = 0;  ///< The most severe place of the cluster, in the list of places.
    std::size_t count = 0;  ///< Number of places of the cluster.
    glm::vec2 tip{0.0F};    ///< That of `place`.
    float strength = 1.0F;  ///< In (0, 1]: less where its places can nearly be seen.
};

/// The pins of those of `places` (the most severe first) that lie within `area` and have a radius
/// below kSeenFrom. Each pin is at the most severe place that no pin stands for yet, and stands for
/// all places near it, so that heads do not overlap. Equal input gives equal pins. About O(places).
std::vector<Pin> pinsOf(std::span<const PinPlace> places, const Rect& area, float em);

/// The head of a pin with a text of that width (0: no text): above its tip, or below it at the
/// upper edge of the area; it never covers the tip.
Rect headOf(const Pin& pin, float textWidth, const Rect& area, float em);

}  // namespace se::view
