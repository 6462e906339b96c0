// The tool for a piece of a scan: its strip over the view, and the box or lasso that is drawn.
#include <algorithm>
#include <glm/common.hpp>

#include "document/piece_actions.h"
#include "document/ui_state.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

constexpr float kStripWidth = 27.0F;
/// Minimum distance between corners of a lasso, in em.
constexpr float kPieceStep = 0.25F;

void finishPiece(const PanelContext& context, PieceTool& tool) {
    const Rect& view = context.rects.view;
    std::vector<glm::vec2> path = tool.finish();
    for (glm::vec2& corner : path) corner -= view.min;
    enclosePoints(context.commands, view.size, path);
}

/// The choice of a shape, as a button that stays pressed.
void drawShapeChoice(const PanelContext& context, PieceTool& tool, PieceShape shape,
                     const char* label, const char* name, const char* tip) {
    const bool on = tool.shape == shape;
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, toVec4(context.palette.accent.withAlpha(0.5F)));
    if (textButton(context, label, name, tip)) tool.shape = shape;
    if (on) ImGui::PopStyleColor();
    ImGui::SameLine();
}

std::string stripTitle(const PieceTool& tool) {
    if (!tool.inside.empty()) return insideText(tool.inside.size());
    return tool.shape == PieceShape::Box ? "Drag a box around points" : "Draw a line around points";
}

void drawStripContent(const PanelContext& context, PieceTool& tool) {
    textIn(context.fonts.strong, stripTitle(tool));
    context.where()["piece title"] = lastItem();
    dimText(
        "Enter keeps the points inside, Delete leaves them out, Esc ends. Shift draws a line, "
        "Ctrl turns the view.");
    drawShapeChoice(context, tool, PieceShape::Box, "Box", "piece box", "Drag a box");
    drawShapeChoice(context, tool, PieceShape::Lasso, "Lasso", "piece lasso",
                    "Draw a line; or hold Shift");
    ImGui::BeginDisabled(tool.inside.empty());
    if (textButton(context, "Keep", "piece keep", "Run with these points alone (Enter)"))
        keepEnclosed(context.commands);
    ImGui::SameLine();
    if (textButton(context, "Leave out", "piece leave out", "Run without these points (Delete)"))
        leaveOutEnclosed(context.commands);
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (textButton(context, "Close", "piece close", "Esc")) endPieceTool(context.commands);
}

}  // namespace

bool handlePieceTool(const PanelContext& context) {
    PieceTool& tool = context.state<PieceTool>();
    const ImGuiIO& io = ImGui::GetIO();
    // The camera does not follow a drag that began here, even if Esc ends the tool meanwhile.
    if (ImGui::IsItemActivated()) context.state<ViewDrag>().begin();
    if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left) && !io.KeyCtrl)
        tool.begin(pointerInWindow(), io.KeyShift ? PieceShape::Lasso : tool.shape);
    if (!tool.drawing) return false;
    const Rect& view = context.rects.view;
    tool.moveTo(glm::clamp(pointerInWindow(), view.min, view.max()), kPieceStep * context.em);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) finishPiece(context, tool);
    return true;
}

void drawPieceLine(const PanelContext& context) {
    const PieceTool& tool = context.state<PieceTool>();
    if (!tool.drawing || tool.path.size() < 2) return;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const auto stroke = [&](const Color& color, float width) {
        if (tool.drawn == PieceShape::Box) {
            const glm::vec2 low = glm::min(tool.path.front(), tool.path.back());
            const glm::vec2 high = glm::max(tool.path.front(), tool.path.back());
            return list->AddRect(toVec2(low), toVec2(high), toU32(color), 0.0F, 0, width);
        }
        for (const glm::vec2& corner : tool.path) list->PathLineTo(toVec2(corner));
        list->PathStroke(toU32(color), ImDrawFlags_Closed, width);
    };
    stroke(context.palette.background, std::max(3.5F, 0.3F * context.em));
    stroke(context.palette.text, std::max(1.5F, 0.12F * context.em));
}

void drawPieceStrip(const PanelContext& context) {
    followRun(context.commands);
    PieceTool& tool = context.state<PieceTool>();
    if (!tool.on || context.ui().coversView()) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleColor(ImGuiCol_Border, toVec4(context.palette.accent));
    // Below the banner of what-ifs.
    const bool banner = !context.session().input().spec().whatIf.empty();
    if (beginOverView(context, "##piece", banner ? 3.2F : 0.6F, kStripWidth))
        drawStripContent(context, tool);
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

}  // namespace se::view
