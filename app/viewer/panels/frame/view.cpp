// The view of the scene: the overlays in the order in which they take room, the lasso, and what a
// click or a drag means.
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "document/actions.h"
#include "document/break_actions.h"
#include "document/ui_state.h"
#include "input/view_drag.h"
#include "layers/layer.h"
#include "lesson/lesson_panel.h"
#include "panel_state/piece_tool.h"
#include "panel_state/settings.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/axis_gizmo.h"
#include "panels/widgets/widgets.h"
#include "scene/motion.h"
#include "scene/picking.h"
#include "session/layout_preset.h"
#include "session/playback.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

/// The disc, a large sign of the pivot, and the arrow from its center to the tip, in em.
constexpr float kDisc = 0.85F;
constexpr float kTip = 1.75F;
constexpr float kInset = 2.0F;

/// The arrow to the pivot, if the pivot is outside of the view.
struct PivotArrow {
    EdgeArrow arrow;
    Rect rect;  ///< In pixels of the window.
    bool hovered = false;
};

/// Takes clicks, which frame the pivot. To be called before the scene takes the remaining ones.
std::optional<PivotArrow> offerPivotArrow(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready() || session.picture().pivot == kNone) return std::nullopt;
    const Rect& view = context.rects.view;
    const Index pivot = session.picture().pivot;
    const auto arrow = edgeArrow(context.camera().matrices(view.size.x / view.size.y),
                                 session.shown().place[pivot], view.size, kInset * context.em);
    if (!arrow) return std::nullopt;
    const glm::vec2 half(kTip * context.em);
    PivotArrow found{*arrow, {view.min + arrow->at - half, 2.0F * half}};
    ImGui::SetCursorScreenPos(toVec2(found.rect.min));
    if (ImGui::InvisibleButton("##pivotArrow", toVec2(found.rect.size)))
        context.ui().frame = FrameRequest::Decision;
    found.hovered = ImGui::IsItemHovered();
    tooltip("The pivot, " + nameOf(pivot, session.names()) +
            ", is outside of the view.\nClick to center it.");
    context.where()["pivot arrow"] = found.rect;
    return found;
}

void drawPivotArrow(const PanelContext& context, const PivotArrow& arrow) {
    const float em = context.em;
    const Palette& colors = context.palette;
    const glm::vec2 at = arrow.rect.min + 0.5F * arrow.rect.size;
    const glm::vec2 way = arrow.arrow.way;
    const glm::vec2 across(-way.y, way.x);
    const ImU32 color = toU32(colors.pivot);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const glm::vec2 neck = at + kDisc * 0.55F * em * way;
    list->AddTriangleFilled(toVec2(at + kTip * em * way), toVec2(neck + 0.8F * em * across),
                            toVec2(neck - 0.8F * em * across), color);
    list->AddCircleFilled(toVec2(at), kDisc * em,
                          toU32(arrow.hovered ? colors.panelRaised : colors.background), 32);
    list->AddCircle(toVec2(at), kDisc * em, color, 32, std::max(1.5F, 0.14F * em));
    list->AddCircleFilled(toVec2(at), 0.45F * kDisc * em, color);
}

/// Minimum distance between corners of the line, in em.
constexpr float kLassoStep = 0.25F;

/// Sets a breakpoint on all events of the enclosed points, and marks them.
void closeLasso(const PanelContext& context, Lasso& lasso) {
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
    actions::showPart(context.commands, kBreakpointsPart);
    session.highlights().mark(points);
}

/// Ctrl with a left drag draws a lasso around points; true while it does, and as it ends. To be
/// called right after the scene's own item.
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
        closeLasso(context, lasso);
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

glm::vec2 localMouse(const Rect& view) { return pointerInWindow() - view.min; }

bool isOn(const PanelContext& context, LayerId layer) {
    return shownLayers(context.settings().layers, context.session().stage())
        .test(static_cast<std::size_t>(layer));
}

/// Tolerance of clicks, in em; larger while a question for points is open.
constexpr float kClickEms = 0.6F;
constexpr float kAnswerEms = 1.0F;

/// A question for points is open in this view.
bool asksForPoints(const PanelContext& context) {
    const LessonPanel& panel = context.state<LessonPanel>();
    return !context.beside && panel.walk.isOpen() && panel.walk.takesPoints();
}

/// Only visible things can be picked.
Pick underMouse(const PanelContext& context) {
    const Session& session = context.session();
    const Rect& view = context.rects.view;
    const bool mesh = isOn(context, LayerId::Triangles);
    const bool rings = isOn(context, LayerId::EdgeRing);
    const PickScene scene{
        session.shown(), isOn(context, LayerId::Points),
        mesh ? session.shownTriangles() : std::span<const Triangle>{},
        session.picture().repaired ? nullptr : &session.meshIndex(),
        rings ? std::span<const RingPath>(session.picture().rings) : std::span<const RingPath>{}};
    return pick(scene,
                {context.camera().matrices(view.size.x / view.size.y), view.size, localMouse(view),
                 (asksForPoints(context) ? kAnswerEms : kClickEms) * context.em});
}

/// While a question for points is open, a click marks a point.
bool answerByClick(const PanelContext& context, const Selection& picked) {
    LessonPanel& panel = context.state<LessonPanel>();
    if (!asksForPoints(context)) return false;
    if (picked.kind == SelectionKind::Point && !panel.countsRoom())
        panel.walk.toggle(picked.points[0]);
    return true;
}

/// A click selects, a double click centers the orbit and selects nothing. So a click
/// counts only when it can no longer become a double click.
void handleClicks(const PanelContext& context) {
    DoubleClickFilter& click = context.state<DoubleClickFilter>();
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        click.takeBack();
        const Pick found = underMouse(context);
        if (found.what.kind != SelectionKind::None) context.camera().lookAt(found.place);
        return;
    }
    const bool single = io.MouseClickedLastCount[ImGuiMouseButton_Left] == 1;
    if (isClick(context, ImGuiMouseButton_Left) && single) {
        // Counted from the press, like a double click.
        const double until =
            io.MouseClickedTime[ImGuiMouseButton_Left] + double{io.MouseDoubleClickTime};
        click.begin(underMouse(context).what, until);
    }
    const auto picked = click.due(ImGui::GetTime());
    if (picked && !answerByClick(context, *picked)) context.session().select(*picked);
}

/// A right click that was no drag opens the context menu.
void handleRightClick(const PanelContext& context) {
    if (!isClick(context, ImGuiMouseButton_Right)) return;
    const Selection what = underMouse(context).what;
    SubjectMenu& menu = context.state<SubjectMenu>();
    if (!context.beside) return menu.open(what);
    if (what.kind != SelectionKind::None) menu.openBeside(what);
}

/// Highlights the neighbor of the pivot under the pointer, here and on the dial. Only neighbors: a
/// search of all points in every frame would take too long.
void hoverNeighbor(const PanelContext& context) {
    const Session& session = context.session();
    const Index pivot = session.picture().pivot;
    if (pivot == kNone) return;
    const Rect& view = context.rects.view;
    const CameraMatrices camera = context.camera().matrices(view.size.x / view.size.y);
    context.state<Navigation>().pointedAt =
        pickAmong(session.shown(), session.shown().points.neighbors[pivot], camera, view.size,
                  localMouse(view), (asksForPoints(context) ? kAnswerEms : kClickEms) * context.em);
}

void handleMouse(const PanelContext& context) {
    const bool piece = context.state<PieceTool>().on && !context.beside;
    if (context.session().ready() && (piece ? handlePieceTool : handleLasso)(context)) return;
    if (context.session().ready() && !piece && handleMoveTool(context)) return;
    moveCameraByMouse(context);
    if (!context.session().ready()) return;
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) hoverNeighbor(context);
    handleClicks(context);
    if (!context.state<LessonPanel>().hides()) handleRightClick(context);
}

/// The name of the shown state, while the user looks back.
std::optional<Rect> drawShownState(const PanelContext& context) {
    const Session& session = context.session();
    if (!context.state<LookBack>().on() || !session.ready() || session.event() == nullptr) {
        return std::nullopt;
    }
    const Rect& view = context.rects.view;
    const float em = context.em;
    const Color& color = session.showsBefore() ? context.palette.textDim : context.palette.test;
    const std::string text =
        session.showsEarlierMesh()
            ? "before the change"
            : (session.showsBefore() ? "before " : "after ") + toString(session.address());
    const ImVec2 extent = context.fonts.strong->CalcTextSizeA(em, 1e9F, 0.0F, text.c_str());
    const glm::vec2 at(view.min.x + 0.5F * (view.size.x - extent.x), view.min.y + 0.9F * em);
    const glm::vec2 pad(0.6F * em, 0.25F * em);
    const Rect place{at - pad, glm::vec2(extent.x, extent.y) + 2.0F * pad};
    ImDrawList* list = ImGui::GetWindowDrawList();
    fill(list, place, context.palette.panel.withAlpha(0.94F), 0.3F * em);
    list->AddText(context.fonts.strong, em, toVec2(at), toU32(color), text.c_str());
    return place;
}

/// The caption, where it lies in the view; framing knows how much of the view it covers.
std::optional<Rect> drawOwnCaption(const PanelContext& context) {
    if (!context.beside) context.ui().coveredBelow = 0.0F;
    const PictureLook& look = context.ui().picture;
    const bool wanted = !look.viewAlone || look.caption;
    if (!wanted || !context.rects.captionInView()) return std::nullopt;
    const std::optional<Rect> plate = drawCaption(context);
    const Rect& view = context.rects.view;
    if (plate && !context.beside)
        context.ui().coveredBelow = (view.max().y - plate->min.y) / view.size.y;
    return plate;
}

constexpr const char* kLayersTitle = "Layers";

/// A button over the picture: it is offered before the picture, and drawn after it.
struct OverButton {
    Rect place;
    bool hovered = false;
};

/// The menu of the layers, in a corner of the view.
std::optional<OverButton> offerLayersMenu(const PanelContext& context) {
    const bool none = context.beside || context.ui().picture.viewAlone ||
                      context.rects.layoutPreset == LayoutPreset::Present;
    if (none || !context.session().ready()) return std::nullopt;
    const float em = context.em;
    const Rect& view = context.rects.view;
    const Rect place{view.min + glm::vec2(0.7F, 0.6F) * em,
                     {textWidth(kLayersTitle) + 1.2F * em, 1.6F * em}};
    ImGui::SetCursorScreenPos(toVec2(place.min));
    // On a phone the menu has it.
    const bool phone = context.rects.phone;
    const bool clicked = !phone && ImGui::InvisibleButton("##layersButton", toVec2(place.size));
    if (!phone) nameItem(context, "layers menu", "What the view draws, and when");
    const OverButton button{place, !phone && ImGui::IsItemHovered()};
    if (std::exchange(context.state<Navigation>().opensLayers, false) || clicked)
        ImGui::OpenPopup("##layers");
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.7F * em, 0.55F * em));
    ImGui::SetNextWindowPos({place.min.x, place.max().y + 0.2F * em});
    if (ImGui::BeginPopup("##layers")) {
        drawLayerSwitches(context);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
    return phone ? std::nullopt : std::optional(button);
}

void drawLayersButton(const PanelContext& context, const OverButton& button) {
    const Palette& colors = context.palette;
    ImDrawList* list = ImGui::GetWindowDrawList();
    fill(list, button.place, (button.hovered ? colors.panelRaised : colors.panel).withAlpha(0.9F),
         0.3F * context.em);
    list->AddText({button.place.min.x + 0.6F * context.em, button.place.min.y + 0.25F * context.em},
                  toU32(button.hovered ? colors.text : colors.textDim), kLayersTitle);
}

/// Overlays of the picture. Each avoids those before it; labels come last, since they find a
/// place anywhere.
void drawOver(const PanelContext& context, const std::optional<PivotArrow>& arrow,
              const std::optional<AxisGizmo>& axes, const std::optional<OverButton>& layers) {
    std::vector<Rect> taken;
    const auto note = [&](const std::optional<Rect>& place) {
        if (place) taken.push_back(*place);
    };
    if (arrow) note(arrow->rect);
    if (layers) taken.push_back(layers->place);
    if (layers) drawLayersButton(context, *layers);
    note(drawOwnCaption(context));
    note(drawShownState(context));
    if (axes) taken.push_back(axes->plate);
    if (axes) drawAxes(context, *axes);
    note(drawColorBar(context, taken));
    // In Compare the column beside the views explains the colors.
    const bool compared = context.beside || context.rects.otherView.size.x > 0.0F;
    const bool legend =
        context.rects.phone ? context.state<Navigation>().phoneLegend : context.settings().legend;
    if (legend && !compared) note(drawLegend(context, taken));
    drawLabels(context, taken);
    if (arrow) drawPivotArrow(context, *arrow);
}

void drawWithOverlays(const PanelContext& context) {
    const std::optional<PivotArrow> arrow = offerPivotArrow(context);
    std::vector<Rect> taken;
    if (arrow) taken.push_back(arrow->rect);
    const std::optional<AxisGizmo> axes = offerAxes(context, taken);
    const std::vector<FaultPin> pins = offerFaultPins(context);
    const std::optional<OverButton> layers = offerLayersMenu(context);
    offerView(context);
    handleMouse(context);
    drawViewPicture(context);
    drawFaultPins(context, pins);
    drawForAudience(context);
    drawOver(context, arrow, axes, layers);
    drawLasso(context);
    drawSectionPlane(context);
    drawMoveWay(context);
    if (!context.beside) drawPieceLine(context);
}

}  // namespace

void drawView(const PanelContext& context, const char* window) {
    if (beginView(context, window)) {
        const PictureLook& look = context.ui().picture;
        if (look.labels && !look.pointLabels) {
            drawWithOverlays(context);
        } else {
            offerView(context);
            handleMouse(context);
            drawViewPicture(context);
            if (look.labels) drawLabels(context, {});
            drawOwnCaption(context);
        }
    }
    ImGui::End();
}

}  // namespace se::view
