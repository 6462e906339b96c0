#include "draw_list.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace se::view {

void DrawList::clear() {
    DrawList fresh;
    std::swap(fresh.cloudStyleOf, cloudStyleOf);
    std::swap(fresh.cloudMadeOf, cloudMadeOf);
    fresh.cloudTintMadeOf = cloudTintMadeOf;
    *this = std::move(fresh);
}

void DrawList::circle(const glm::vec3& center, const glm::vec3& u, const glm::vec3& v, float radius,
                      const Color& color, float width, Depth depth, int segments) {
    const auto at = [&](int i) {
        const float angle =
            2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(segments);
        return center + radius * (std::cos(angle) * u + std::sin(angle) * v);
    };
    for (int i = 0; i < segments; ++i) line(at(i), at(i + 1), color, width, depth);
}

void DrawList::arrow(const glm::vec3& from, const glm::vec3& to, const Color& color, float width,
                     float head) {
    // Heads are at the middle of a line: the last quarter is a line of its own.
    const glm::vec3 neck = from + 0.72F * (to - from);
    line(from, neck, color, width, Depth::OnTop);
    lines.push_back({neck, to, color, width, 0.0F, head, Depth::OnTop});
}

void DrawList::hatch(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const Color& color,
                     int stripes) {
    for (int i = 0; i < stripes; ++i) {
        const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(stripes);
        line(a + share * (c - a), b + share * (c - b), color, 0.06F, Depth::OnTop);
    }
}

}  // namespace se::view
