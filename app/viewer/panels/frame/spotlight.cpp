// For an audience: a halo at the pointer, and a spotlight on the neighborhood of the pivot, beyond
// which the picture keeps a quarter of its strength.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "document/ui_state.h"
#include "panels/widgets/screen_painter.h"
#include "scene/palette.h"
#include "view_parts.h"

namespace se::view {

namespace {

constexpr float kStrengthBeyond = 0.25F;
/// Radius of the halo, and the least one of the spotlight, in em.
constexpr float kHalo = 1.4F;
constexpr float kLeastSpot = 4.0F;
constexpr float kMarginOfSpot = 1.5F;

/// The circle around marks, in pixels.
struct SpotCircle {
    glm::vec2 center{0.0F};
    float radius = 0.0F;
};

SpotCircle circleAround(const std::vector<LabelMark>& marks) {
    glm::vec2 low = marks.front().at;
    glm::vec2 high = low;
    for (const LabelMark& each : marks) {
        low = glm::min(low, each.at);
        high = glm::max(high, each.at);
    }
    SpotCircle circle{0.5F * (low + high), 0.0F};
    for (const LabelMark& each : marks)
        circle.radius = std::max(circle.radius, glm::distance(circle.center, each.at));
    return circle;
}

void drawSpotlight(const PanelContext& context) {
    const std::vector<LabelMark> marks = ScreenProjection(context).neighborhood();
    if (marks.empty()) return;
    const SpotCircle spot = circleAround(marks);
    const float em = context.em;
    const float radius = std::max(kLeastSpot * em, spot.radius + kMarginOfSpot * em);
    // A ring that is wide enough to cover the rest of the view.
    const glm::vec2& size = context.rects.view.size;
    const float width = 2.0F * (size.x + size.y) + radius;
    ScreenPainter painter(context);
    painter.circle(spot.center, radius + 0.5F * width,
                   painter.ink(&Palette::background, 1.0F - kStrengthBeyond).line(width));
}

void drawHalo(const PanelContext& context) {
    const glm::vec2 pointer = pointerInWindow();
    if (!context.rects.view.contains(pointer)) return;
    const float radius = kHalo * context.em;
    ScreenPainter painter(context);
    painter.circle(pointer, radius, painter.ink(&Palette::pivot, 0.15F));
    painter.circle(pointer, radius,
                   painter.ink(&Palette::pivot, 0.8F).line(std::max(1.5F, 0.12F * context.em)));
}

}  // namespace

void drawForAudience(const PanelContext& context) {
    if (context.rects.layoutPreset != LayoutPreset::Present || context.beside) return;
    if (context.ui().spotlight) drawSpotlight(context);
    drawHalo(context);
}

}  // namespace se::view
