// The tool for a piece of a scan: its strip over the view, and the box or lasso that is drawn.

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "document/document.h"
#include "document/piece_actions.h"
#include "document/ui_state.h"
#include "input/view_drag.h"
#include "panel_state/view_tools.h"
#include "panel_state/what_if_offers.h"
#include "panels/widgets/screen_painter.h"
#include "panels/widgets/widgets.h"
#include "scene/picking.h"
#include "session/playback.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

constexpr float kStripWidth = 27.0F;
/// Minimum distance between corners of a lasso, in em.
constexpr float kLineStep = 0.25F;

/// The choice of a shape, as a button that stays pressed.
void drawShapeChoice(const PanelContext& context, PieceTool& tool, PieceShape shape,
                     const char* label, const char* name, const char* tip) {
    if (accentButton(context, tool.shape == shape, label, name, tip)) tool.shape = shape;
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
        tool.line.begin(pointerInWindow(), io.KeyShift ? PieceShape::Lasso : tool.shape);
    if (!tool.line.drawing) return false;
    if (const auto path = followLine(context, tool.line))
        enclosePoints(context.commands, context.rects.view.size, *path);
    return true;
}

std::optional<std::vector<glm::vec2>> followLine(const PanelContext& context, EnclosingLine& line) {
    const Rect& view = context.rects.view;
    line.moveTo(glm::clamp(pointerInWindow(), view.min, view.max()), kLineStep * context.em);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return std::nullopt;
    std::vector<glm::vec2> path = line.finish();
    for (glm::vec2& corner : path) corner -= view.min;
    return path;
}

void drawEnclosingLine(const PanelContext& context, const EnclosingLine& line) {
    if (!line.drawing || line.path.size() < 2) return;
    ImDrawList* list = ImGui::GetWindowDrawList();
    // In the color of text, with a rim of the background color, unlike any ring.
    const auto stroke = [&](const Color& color, float width) {
        if (line.drawn == PieceShape::Box) {
            const glm::vec2 low = glm::min(line.path.front(), line.path.back());
            const glm::vec2 high = glm::max(line.path.front(), line.path.back());
            return list->AddRect(toVec2(low), toVec2(high), toU32(color), 0.0F, 0, width);
        }
        for (const glm::vec2& corner : line.path) list->PathLineTo(toVec2(corner));
        list->PathStroke(toU32(color), ImDrawFlags_Closed, width);
    };
    stroke(context.palette.background, std::max(3.5F, 0.3F * context.em));
    stroke(context.palette.text, std::max(1.5F, 0.12F * context.em));
}

void drawPieceStrip(const PanelContext& context) {
    followRun(context.commands);
    PieceTool& tool = context.state<PieceTool>();
    if (!tool.on || context.ui().coversView()) return;
    // Below the banner of what-ifs.
    const bool banner = !context.session().input().spec().whatIf.empty();
    if (beginOverView(context, "##piece", banner ? 3.2F : 0.6F, kStripWidth, &Palette::accent))
        drawStripContent(context, tool);
    ImGui::End();
}

// A point that is dragged in the view: in its tangent plane, with Shift along its normal. Its way
// is drawn from where it was, with a tick where the verdict at the cursor changes.

namespace {

/// Distance in pixels, as a share of the window's height, from which a press is a drag.
constexpr float kMoveShare = 0.01F;
/// Radius around a point within which a press is on it, in em.
constexpr float kReachOfPress = 0.7F;

bool isOffered(const PanelContext& context) {
    return !context.beside && ImGui::GetFrameCount() - context.state<MoveTool>().offeredIn <= 1;
}

/// The point at a pixel of the window among those that can be dragged: the pivot, its neighbors
/// and the selected one. kNone if there is none.
Index draggableAt(const PanelContext& context, glm::vec2 pixel) {
    const Session& session = context.session();
    const Index pivot = session.picture().pivot;
    if (!session.drag().possible(pivot)) return kNone;
    const auto neighbors = session.shown().points.neighbors[pivot];
    std::vector<Index> points(neighbors.begin(), neighbors.end());
    points.push_back(pivot);
    if (session.selected() != kNone) points.push_back(session.selected());
    const Rect& view = context.rects.view;
    return pickAmong(session.shown(), points, cameraOf(context), view.size, pixel - view.min,
                     kReachOfPress * context.em);
}

void beginMove(const PanelContext& context, MoveTool& tool) {
    Session& session = context.session();
    context.playback().pause();
    context.ui().cameraMove = {};
    session.drag().begin(tool.pressed);
    tool.holds = true;
    session.select(tool.pressed);
    tool.anchor = session.shown().place[tool.pressed];
    const Rect& view = context.rects.view;
    const glm::vec3 at = project(cameraOf(context), tool.anchor, view.size);
    tool.offset = view.min + glm::vec2(at) - context.state<ViewDrag>().pressedAt();
    tool.alongNormal = ImGui::GetIO().KeyShift;
}

void followPointer(const PanelContext& context, MoveTool& tool) {
    PointDrag& drag = context.session().drag();
    const Model& model = drag.model();
    const bool along = ImGui::GetIO().KeyShift;
    if (std::exchange(tool.alongNormal, along) != along) tool.anchor = model.place[drag.point()];
    const Rect& view = context.rects.view;
    const glm::vec2 pixel = pointerInWindow() + tool.offset - view.min;
    const glm::vec3& normal = model.normal[drag.point()];
    const auto place = along
                           ? placeOnLine(cameraOf(context), view.size, pixel, tool.anchor, normal)
                           : placeInPlane(cameraOf(context), view.size, pixel, tool.anchor, normal);
    if (!place) return;
    const double spacing = static_cast<double>(model.spacing) / model.scale;
    Vec3 to = model.center + Vec3(*place) / model.scale;
    for (int i = 0; i < 3; ++i) to[i] = roundedTo(to[i], spacing);
    drag.moveTo(to);
}

void endMove(const PanelContext& context) {
    PointDrag& drag = context.session().drag();
    if (drag.to() == drag.from()) return drag.takeBack();
    context.document().rerun(withWhatIf(context.session().input().rules(), drag.release()));
}

/// "moved by 0.31 spacings; the verdict turns at 0.25"
std::string moveText(const PointDrag& drag) {
    const Model& model = drag.model();
    const double spacing = static_cast<double>(model.spacing) / model.scale;
    const auto spacings = [&](const Vec3& to) {
        return formatted("%.2f", glm::distance(drag.from(), to) / spacing);
    };
    const std::string moved = "moved by " + spacings(drag.to()) + " spacings";
    return drag.turn() ? moved + "; the verdict turns at " + spacings(*drag.turn()) : moved;
}

}  // namespace

bool handleMoveTool(const PanelContext& context) {
    MoveTool& tool = context.state<MoveTool>();
    PointDrag& drag = context.session().drag();
    const bool down = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    ViewDrag& motion = context.state<ViewDrag>();
    if (tool.holds) {
        // If the move was taken back meanwhile, the rest of the motion has no effect.
        if (drag.held() && ImGui::IsMousePosValid()) followPointer(context, tool);
        if (drag.held() && !down) endMove(context);
        tool.holds = down;
        return true;
    }
    if (tool.pressed != kNone) {
        motion.move(pointerInWindow(), kMoveShare * ImGui::GetIO().DisplaySize.y);
        if (down && motion.drags() && drag.possible(tool.pressed)) beginMove(context, tool);
        if (!down || motion.drags()) tool.pressed = kNone;
        return down;
    }
    if (!isOffered(context)) return false;
    const bool pressed = ImGui::IsItemActivated() && down && !ImGui::GetIO().KeyCtrl;
    if (pressed) tool.pressed = draggableAt(context, motion.pressedAt());
    if (tool.pressed != kNone) motion.begin();
    const bool hovers = ImGui::IsItemHovered() && !ImGui::IsItemActive();
    if (hovers && draggableAt(context, pointerInWindow()) != kNone)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return tool.pressed != kNone;
}

void drawMoveWay(const PanelContext& context) {
    const PointDrag& drag = context.session().drag();
    if (context.beside || !drag.active()) return;
    const ScreenProjection screen(context);
    const Model& model = drag.model();
    const auto from = screen.at(model.toView(drag.from()));
    const auto to = screen.at(model.toView(drag.to()));
    if (!from || !to) return;
    const float em = context.em;
    ScreenPainter p(context);
    const float width = std::max(1.5F, 0.12F * em);
    const Ink ink = p.ink(&Palette::text);
    p.line(*from, *to, ink.line(width));
    p.circle(*from, 0.35F * em, ink.line(width));
    if (const auto turn = drag.turn() ? screen.at(model.toView(*drag.turn())) : std::nullopt) {
        const glm::vec2 way = *turn - *from;
        const float length = glm::length(way);
        const glm::vec2 along = length > 0.0F ? way / length : glm::vec2(1.0F, 0.0F);
        const glm::vec2 across = 0.7F * em * glm::vec2(-along.y, along.x);
        p.line(*to, *turn, ink.withAlpha(0.4F).line(width));
        p.line(*turn - across, *turn + across, p.ink(&Palette::background).line(4.0F * width));
        p.line(*turn - across, *turn + across, ink.line(2.0F * width));
        context.where()["move turn"] = {*turn, glm::vec2(1.0F)};
    }
    context.where()["move way"] = {glm::min(*from, *to), glm::abs(*to - *from)};
    const std::string text = moveText(drag);
    const Rect& view = context.rects.view;
    const glm::vec2 size = p.textSize(text, {em}) + glm::vec2(0.8F, 0.3F) * em;
    const glm::vec2 corner =
        glm::clamp(*to + glm::vec2(1.2F, 1.2F) * em, view.min, view.max() - size);
    p.box({corner, size}, p.ink(&Palette::panel, 0.92F), 0.3F * em);
    p.text(corner + glm::vec2(0.4F, 0.15F) * em, text, ink, {em});
}

}  // namespace se::view
