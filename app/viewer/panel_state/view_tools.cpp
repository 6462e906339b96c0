#include "view_tools.h"

#include <glm/geometric.hpp>
#include <utility>

namespace se::view {

void EnclosingLine::moveTo(glm::vec2 pointer, float step) {
    if (drawn == PieceShape::Box) {
        path.back() = pointer;
    } else if (glm::distance(path.back(), pointer) >= step) {
        path.push_back(pointer);
    }
}

std::vector<glm::vec2> EnclosingLine::finish() {
    drawing = false;
    std::vector<glm::vec2> line = std::exchange(path, {});
    if (drawn == PieceShape::Lasso) {
        if (line.size() < 3) line.clear();
        return line;
    }
    const glm::vec2 a = line.front();
    const glm::vec2 b = line.back();
    if (a.x == b.x || a.y == b.y) return {};
    return {a, {b.x, a.y}, b, {a.x, b.y}};
}

}  // namespace se::view
