/// The amount of drawing under a rectangle, used to find empty places in a view. Summed on a grid,
/// so that a query costs the same regardless of the amount of drawing.
#pragma once

#include <vector>

#include "panel_rects.h"

namespace se::view {

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

}  // namespace se::view
