#include "clip.h"

namespace se::view {

namespace {

/// Keeps the part to the left of the line through a and b.
std::vector<glm::vec2> leftOf(const std::vector<glm::vec2>& polygon, const glm::vec2& a,
                              const glm::vec2& b) {
    std::vector<glm::vec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::vec2& here = polygon[i];
        const glm::vec2& next = polygon[(i + 1) % polygon.size()];
        const float sideHere = crossOf(b - a, here - a);
        const float sideNext = crossOf(b - a, next - a);
        if (sideHere >= 0.0F) kept.push_back(here);
        if ((sideHere > 0.0F && sideNext < 0.0F) || (sideHere < 0.0F && sideNext > 0.0F)) {
            kept.push_back(here + sideHere / (sideHere - sideNext) * (next - here));
        }
    }
    return kept;
}

}  // namespace

std::vector<glm::vec2> clipConvex(std::span<const glm::vec2> subject,
                                  std::span<const glm::vec2> window) {
    std::vector<glm::vec2> rest(subject.begin(), subject.end());
    for (std::size_t i = 0; i < window.size() && !rest.empty(); ++i) {
        rest = leftOf(rest, window[i], window[(i + 1) % window.size()]);
    }
    // A common corner or side is no area.
    if (rest.size() < 3 || !(areaOf(rest) > 0.0F)) rest.clear();
    return rest;
}

float areaOf(std::span<const glm::vec2> polygon) {
    float twice = 0.0F;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        // Relative to the first corner, so that no digits are lost far from the origin.
        twice += crossOf(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    }
    return 0.5F * twice;
}

}  // namespace se::view
