#include <imgui.h>

#include <glm/geometric.hpp>

#include "commands/break_commands.h"
#include "input/view_drag.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/widgets.h"
#include "run/strings.h"
#include "scene/camera.h"
#include "scene/lasso.h"
#include "session/playback.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

/// Minimum distance between corners of the line, in em.
constexpr float kLassoStep = 0.25F;

/// Sets a breakpoint on all events of the enclosed points, and marks them.
void close(const PanelContext& context, Lasso& lasso) {
    Session& session = context.session();
    const Rect& view = context.rects.view;
    std::vector<glm::vec2> path = std::exchange(lasso.path, {});
    lasso.drawing = false;
    if (path.size() < 3) return;
    for (glm::vec2& corner : path) corner -= view.min;
    const CameraMatrices camera = context.camera().matrices(view.size.x / view.size.y);
    const std::vector<Index> points = pointsWithin(session.model(), camera, view.size, path);
    if (points.empty())
        return session.messages().say("There is no point inside the lasso that faces this way.");
    addBreakpoint(context.commands,
                  {"lasso, " + grouped(points.size()) + " points", amongLine(points)});
    context.state<OpenTab>().wanted = kBreakpointsTab;
    session.highlights().mark(points);
}

}  // namespace

bool handleLasso(const PanelContext& context) {
    Lasso& lasso = context.state<Lasso>();
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 mouse(io.MousePos.x, io.MousePos.y);
    if (ImGui::IsItemActivated() && io.KeyCtrl && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        lasso = {true, {mouse}};
        context.playback().pause();
    }
    if (!lasso.drawing) return false;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        close(context, lasso);
    } else if (glm::distance(lasso.path.back(), mouse) > kLassoStep * context.em) {
        lasso.path.push_back(mouse);
    }
    return true;
}

void drawLasso(const PanelContext& context) {
    const std::vector<glm::vec2>& path = context.state<Lasso>().path;
    if (path.size() < 2) return;
    ImDrawList* list = ImGui::GetWindowDrawList();
    // In the color of text, with a rim of the background color, unlike any ring.
    const auto stroke = [&](const Color& color, float width) {
        for (const glm::vec2& corner : path) list->PathLineTo(toVec2(corner));
        list->PathStroke(toU32(color), 0, width);
    };
    stroke(context.palette.background, std::max(3.5F, 0.3F * context.em));
    stroke(context.palette.text, std::max(1.5F, 0.12F * context.em));
    list->AddLine(toVec2(path.back()), toVec2(path.front()),
                  toU32(context.palette.text.withAlpha(0.5F)), std::max(1.0F, 0.08F * context.em));
}

}  // namespace se::view
