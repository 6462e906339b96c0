#include "draw_list.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace se::view {

void DrawList::clear() {
    DrawList fresh;
    std::swap(fresh.cloudStyleOf, cloudStyleOf);
    std::swap(fresh.cloudMadeOf, cloudMadeOf);
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

}  // namespace se::view
