/// The user's selection, by point indices: it survives every move.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "spiraling_edge/points/point_set.h"

namespace se::view {

enum class SelectionKind : std::uint8_t { None, Point, Edge, Triangle };

struct Selection {
    SelectionKind kind = SelectionKind::None;
    std::array<Index, 3> points{kNone, kNone, kNone};

    static Selection ofPoint(Index point);
    /// Equality without regard to the direction.
    static Selection ofEdge(Index a, Index b);
    /// Equality without regard to the first corner, but with regard to the orientation.
    static Selection ofTriangle(const Triangle& triangle);

    /// One point, an edge of two or a triangle of three; nothing of any other number.
    static Selection of(std::span<const Index> points);

    /// Number of points of a kind.
    std::span<const Index> corners() const;
    Triangle triangle() const { return {points[0], points[1], points[2]}; }
    friend bool operator==(const Selection&, const Selection&) = default;
};

/// "none", "point", "edge", "triangle".
std::string_view kindName(SelectionKind kind);
/// "point 7", "edge 3, 7".
std::string selectionText(const Selection& selection);

}  // namespace se::view
