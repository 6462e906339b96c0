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
      width_(std::max(1, static_cast<int>(std::ceil(area.size.x / cell)))),
      height_(std::max(1, static_cast<int>(std::ceil(area.size.y / cell)))),
      sums_(static_cast<std::size_t>(width_ + 1) * static_cast<std::size_t>(height_ + 1)) {}

int OccupancyGrid::column(float x) const {
    const float place = std::floor((x - area_.min.x) / cell_);
    return static_cast<int>(std::clamp(place, 0.0F, static_cast<float>(width_ - 1)));
}

int OccupancyGrid::row(float y) const {
    const float place = std::floor((y - area_.min.y) / cell_);
    return static_cast<int>(std::clamp(place, 0.0F, static_cast<float>(height_ - 1)));
}

glm::vec2 OccupancyGrid::middle(int x, int y) const {
    return area_.min + cell_ * (glm::vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5F);
}

float& OccupancyGrid::at(int x, int y) {
    // The first row and column stay zero.
    const auto line = static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(width_ + 1);
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
        const glm::vec2 place = from + (begin + (end - begin) * share) * way;
        at(column(place.x), row(place.y)) += each;
    }
}

void OccupancyGrid::addSpot(glm::vec2 center, float radius, float weight) {
    if (!area_.contains(center)) return;
    at(column(center.x), row(center.y)) += weight;
    for (int y = row(center.y - radius); y <= row(center.y + radius); ++y) {
        for (int x = column(center.x - radius); x <= column(center.x + radius); ++x) {
            const bool own = x == column(center.x) && y == row(center.y);
            if (!own && glm::distance(middle(x, y), center) <= radius) at(x, y) += weight;
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
    for (int y = row(low.y); y <= row(high.y); ++y) {
        for (int x = column(low.x); x <= column(high.x); ++x) {
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
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            at(x, y) += at(x - 1, y) + at(x, y - 1) - at(x - 1, y - 1);
        }
    }
}

float OccupancyGrid::under(const Rect& rect) const {
    const glm::vec2 low = glm::max(rect.min, area_.min);
    const glm::vec2 high = glm::min(rect.max(), area_.max());
    if (!(low.x < high.x && low.y < high.y)) return 0.0F;
    const auto sum = [&](int x, int y) {
        return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1) +
                     static_cast<std::size_t>(x)];
    };
    // A rectangle that ends at the border of a cell does not touch the next.
    const int right = column(std::nextafter(high.x, low.x)) + 1;
    const int bottom = row(std::nextafter(high.y, low.y)) + 1;
    const int left = column(low.x);
    const int top = row(low.y);
    return sum(right, bottom) - sum(left, bottom) - sum(right, top) + sum(left, top);
}

}  // namespace se::view
