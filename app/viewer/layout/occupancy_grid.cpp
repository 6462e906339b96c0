// A summed-area table (Crow 1984): shapes add their weight to the cells of a grid, finish() turns
// the cells into prefix sums, and the weight under a rectangle is then four look-ups.
#include "occupancy_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/clip.h"

namespace se::view {

namespace {

/// The part of a line from `from` to `to` within an interval on one axis, as shares of it.
void clipAxis(float from, float way, float low, float high, float& begin, float& end) {
    if (std::abs(way) < 1e-6F) {
        if (from < low || from > high) end = begin;
        return;
    }
    const float a = (low - from) / way;
    const float b = (high - from) / way;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
}

}  // namespace

OccupancyGrid::OccupancyGrid(const Rect& area, float cell)
    : area_(area),
      cell_(cell),
      size_(glm::max(glm::ivec2(glm::ceil(area.size / cell)), 1)),
      sums_(static_cast<std::size_t>(size_.x + 1) * static_cast<std::size_t>(size_.y + 1)) {}

glm::ivec2 OccupancyGrid::cellAt(glm::vec2 place) const {
    const glm::vec2 cell = glm::floor((place - area_.min) / cell_);
    return glm::ivec2(glm::clamp(cell, glm::vec2(0.0F), glm::vec2(size_ - 1)));
}

glm::vec2 OccupancyGrid::middle(int x, int y) const {
    return area_.min + cell_ * (glm::vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5F);
}

float& OccupancyGrid::at(int x, int y) {
    // The first row and column stay zero.
    const auto line = static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(size_.x + 1);
    return sums_[line + static_cast<std::size_t>(x + 1)];
}

void OccupancyGrid::addLine(glm::vec2 from, glm::vec2 to, float weight) {
    const glm::vec2 way = to - from;
    float begin = 0.0F;
    float end = 1.0F;
    clipAxis(from.x, way.x, area_.min.x, area_.max().x, begin, end);
    clipAxis(from.y, way.y, area_.min.y, area_.max().y, begin, end);
    const float length = glm::length(way) * (end - begin);
    if (!(length > 0.0F)) return;
    const int steps = std::max(1, static_cast<int>(std::ceil(2.0F * length / cell_)));
    const float each = weight * length / cell_ / static_cast<float>(steps);
    for (int i = 0; i < steps; ++i) {
        const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(steps);
        const glm::ivec2 cell = cellAt(from + (begin + (end - begin) * share) * way);
        at(cell.x, cell.y) += each;
    }
}

void OccupancyGrid::addSpot(glm::vec2 center, float radius, float weight) {
    if (!area_.contains(center)) return;
    const glm::ivec2 own = cellAt(center);
    const glm::ivec2 first = cellAt(center - radius);
    const glm::ivec2 last = cellAt(center + radius);
    at(own.x, own.y) += weight;
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            if (glm::ivec2(x, y) != own && glm::distance(middle(x, y), center) <= radius)
                at(x, y) += weight;
        }
    }
}

void OccupancyGrid::addTriangle(glm::vec2 a, glm::vec2 b, glm::vec2 c, float weight) {
    const float turn = crossOf(b - a, c - a);
    if (turn == 0.0F) return;
    const glm::vec2 low = glm::min(a, glm::min(b, c));
    const glm::vec2 high = glm::max(a, glm::max(b, c));
    if (high.x < area_.min.x || high.y < area_.min.y || low.x >= area_.max().x ||
        low.y >= area_.max().y) {
        return;
    }
    const glm::ivec2 first = cellAt(low);
    const glm::ivec2 last = cellAt(high);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            const glm::vec2 m = middle(x, y);
            const std::array sides = {crossOf(b - a, m - a), crossOf(c - b, m - b),
                                      crossOf(a - c, m - c)};
            const bool inside = std::all_of(sides.begin(), sides.end(),
                                            [&](float side) { return side * turn >= 0.0F; });
            if (inside) at(x, y) += weight;
        }
    }
}

void OccupancyGrid::finish() {
    for (int y = 0; y < size_.y; ++y) {
        for (int x = 0; x < size_.x; ++x) {
            at(x, y) += at(x - 1, y) + at(x, y - 1) - at(x - 1, y - 1);
        }
    }
}

float OccupancyGrid::under(const Rect& rect) const {
    const glm::vec2 low = glm::max(rect.min, area_.min);
    const glm::vec2 high = glm::min(rect.max(), area_.max());
    if (!(low.x < high.x && low.y < high.y)) return 0.0F;
    const auto sum = [&](int x, int y) {
        return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x + 1) +
                     static_cast<std::size_t>(x)];
    };
    // A rectangle that ends at the border of a cell does not touch the next.
    const glm::ivec2 from = cellAt(low);
    const glm::ivec2 to =
        cellAt({std::nextafter(high.x, low.x), std::nextafter(high.y, low.y)}) + 1;
    return sum(to.x, to.y) - sum(from.x, to.y) - sum(to.x, from.y) + sum(from.x, from.y);
}

}  // namespace se::view
