#include "selection.h"

#include <algorithm>

namespace se::view {

Selection Selection::ofPoint(Index point) {
    if (point == kNone) return {};
    return {SelectionKind::Point, {point, kNone, kNone}};
}

Selection Selection::ofEdge(Index a, Index b) {
    return {SelectionKind::Edge, {std::min(a, b), std::max(a, b), kNone}};
}

Selection Selection::ofTriangle(const Triangle& triangle) {
    std::array<Index, 3> corners = {triangle.a, triangle.b, triangle.c};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return {SelectionKind::Triangle, corners};
}

Selection Selection::of(std::span<const Index> points) {
    if (points.size() == 1) return ofPoint(points[0]);
    if (points.size() == 2) return ofEdge(points[0], points[1]);
    if (points.size() == 3) return ofTriangle({points[0], points[1], points[2]});
    return {};
}

std::span<const Index> Selection::corners() const {
    return std::span(points).first(static_cast<std::size_t>(kind));
}

std::string_view kindName(SelectionKind kind) {
    constexpr std::array<std::string_view, 4> kNames = {"none", "point", "edge", "triangle"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::string selectionText(const Selection& selection) {
    std::string text(kindName(selection.kind));
    for (const Index p : selection.corners()) {
        text += (p == selection.points[0] ? " " : ", ") + std::to_string(p);
    }
    return text;
}

}  // namespace se::view
