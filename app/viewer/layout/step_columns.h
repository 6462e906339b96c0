/// Positions of the counts in the panel Steps: in columns as wide as the largest of them. Plain
/// values, no ImGui.
#pragma once

#include <algorithm>

namespace se::view {

/// The widths of the largest numbers, in pixels.
struct StepNumberWidths {
    float triangles = 0.0F;
    float tests = 0.0F;
    float refused = 0.0F;  ///< Including the cross before it.
};

/// The columns at the right end of a row; x of their right edges, 0 for one that is left out.
struct StepColumns {
    float triangles = 0.0F;
    float tests = 0.0F;
    float refused = 0.0F;
    float labels = 0.0F;  ///< Maximum right end of the labels.
};

/// The columns of a row from `left`, `room` wide. Triangles are left out if the labels would
/// have too little room.
inline StepColumns placeStepColumns(float left, float room, float em,
                                    const StepNumberWidths& widest) {
    // As wide as the titles, in em.
    constexpr float kTriangles = 3.7F;
    constexpr float kTests = 2.6F;
    constexpr float kRefused = 3.2F;
    constexpr float kGap = 0.6F;
    constexpr float kLabels = 7.6F;
    const auto column = [em](float least, float number) {
        return std::max(least * em, number + kGap * em);
    };
    StepColumns c;
    c.refused = left + room - 0.2F * em;
    c.tests = c.refused - column(kRefused, widest.refused);
    c.labels = c.tests - column(0.0F, widest.tests);
    const float triangles = c.tests - column(kTests, widest.tests);
    const float labels = triangles - column(kTriangles, widest.triangles);
    if (labels - left < kLabels * em) return c;
    c.triangles = triangles;
    c.labels = triangles - column(0.0F, widest.triangles);
    return c;
}

}  // namespace se::view
