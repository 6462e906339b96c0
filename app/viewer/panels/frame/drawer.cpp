// The drawer below the view: the strips RUN, PIVOT and STAGE.
#include <algorithm>

#include "session/session.h"
#include "strips.h"

namespace se::view {

namespace {

/// Width of the names left of the bars, and of the margin right of them.
constexpr float kGutter = 4.4F;
constexpr float kDrawerMargin = 0.9F;

void drawFoldButton(const PanelContext& context) {
    const float em = context.em;
    const Rect& run = context.rects.runStrip;
    const bool folded = context.rects.drawerFolded;
    const ImVec2 at(run.min.x + 0.4F * em, run.max().y - 1.6F * em);
    ImGui::SetCursorScreenPos(at);
    const float side = 1.3F * em;
    if (ImGui::InvisibleButton("##fold", {side, side})) context.run("view.drawer");
    tooltip(folded ? "Show the strips PIVOT and STAGE as well (Ctrl+J)"
                   : "Fold the drawer to the strip RUN (Ctrl+J)");
    drawChevron(context, lastItem(), folded, ImGui::IsItemHovered());
}

}  // namespace

Rect beginStrip(const PanelContext& context, const char* name, const Rect& strip, float height,
                float top) {
    const float left = kGutter * context.em;
    const float right = kDrawerMargin * context.em;
    const Rect bars{{strip.min.x + left, strip.min.y + top},
                    {std::max(1.0F, strip.size.x - left - right), std::max(1.0F, height)}};
    const float size = 0.85F * context.em;
    const float y = bars.min.y + 0.5F * (std::min(bars.size.y, 1.6F * context.em) - size);
    ImGui::GetWindowDrawList()->AddText(context.fonts.strong, size,
                                        {0.7F * context.em, y - 0.1F * size},
                                        toU32(context.palette.textDim), name);
    context.where()["strip " + lowerCase(name)] = bars;
    return bars;
}

void keepSteps(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready()) return;
    context.state<Navigation>().steps.update(session.overview(), session.generation(),
                                             session.record(), session.cursor());
}

void drawDrawer(const PanelContext& context) {
    if (context.rects.drawer.size.y <= 0.0F) return;
    if (beginRegion("##drawer", context.rects.drawer,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
        drawRunStrip(context, context.rects.runStrip);
        if (!context.rects.drawerFolded) {
            drawPivotStrip(context, context.rects.pivotStrip);
            drawStageStrip(context, context.rects.stageStrip);
        }
        drawFoldButton(context);
    }
    ImGui::End();
}

}  // namespace se::view
