/// How much of the picture lies under a rectangle: for whoever looks for an empty place in a view.
/// Plain arithmetic on a grid, so that a question costs the same however much is drawn.
#pragma once

#include <vector>

#include "panel_rects.h"

namespace se::view {

class Clutter {
  public:
    /// Nothing in it yet. `cell`: size of a cell of the grid, in pixels, above 0.
    Clutter(const Rect& area, float cell);

    /// A line of `weight` per length of a cell. What is outside of the area does not count.
    void addLine(glm::vec2 from, glm::vec2 to, float weight);
    /// A disc of `weight` per area of a cell; at least one cell gets it.
    void addSpot(glm::vec2 at, float radius, float weight);
    /// A filled triangle of `weight` per area of a cell.
    void addTriangle(glm::vec2 a, glm::vec2 b, glm::vec2 c, float weight);
    /// To be called after the last of them, and before under().
    void finish();

    /// The sum over all cells that `rect` touches.
    float under(const Rect& rect) const;

  private:
    int column(float x) const;
    int row(float y) const;
    glm::vec2 middle(int x, int y) const;
    float& at(int x, int y);

    Rect area_;
    float cell_;
    int width_;
    int height_;
    /// One row and one column more than cells: after finish() the sums of all before.
    std::vector<float> sums_;
};

}  // namespace se::view
