/// The normal section of a decision: the plane through the pivot, its normal and the tested point,
/// with what it cuts there. It shows layers and thin sheets, which the dial flattens. Plain values,
/// no ImGui: the panel draws it, tests read it.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "pivot_dial.h"
#include "run/model.h"

namespace se::view {

/// A place in the section, scene units from the pivot: x along the tangent plane, y along the
/// normal. Distances between places in the plane are true distances.
using SectionPlace = glm::dvec2;

/// A point near the plane, or one that the decision is about.
struct SectionPoint {
    Index point = kNone;
    SectionPlace at{0.0};  ///< Its foot on the plane.
    double off = 0.0;      ///< Signed distance from the plane, scene units.
    DialRole role = DialRole::Neighbor;
    bool listed = false;  ///< In the neighbor list of the pivot, or a point of the decision.
    bool underTest = false;
    bool named = false;  ///< As on the dial.
};

/// The line in which the plane cuts a triangle.
struct SectionCut {
    SectionPlace from{0.0};
    SectionPlace to{0.0};
    bool isNew = false;  ///< A triangle of this pivot.
};

/// The circle in which the plane cuts the tested sphere.
struct SectionCircle {
    SectionPlace center{0.0};
    double radius = 0.0;  ///< Scene units.
};

struct NormalSection {
    Index pivot = kNone;
    Index through = kNone;  ///< The point that the plane goes through without a turn; may be none.
    Vec3 along{0.0};        ///< Unit directions of the plane, in scene space: to the right, and
    Vec3 normal{0.0};       ///< up.
    double reach = 0.0;     ///< Half the side of what is shown, scene units.
    std::vector<SectionCut> cuts;
    std::vector<SectionPoint> points;  ///< Without the pivot.
    std::optional<SectionCircle> circle;
    bool empty() const { return pivot == kNone; }
};

/// The section at the event of the picture, with the plane turned by `turnDegrees`,
/// counterclockwise about the normal. `finished`: triangles of earlier pivots. Empty without a
/// pivot. O(points and triangles of the input).
NormalSection makeSection(const Model& model, const DecisionState& picture,
                          std::span<const Triangle> finished, double turnDegrees);

}  // namespace se::view
