#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "input/double_click_filter.h"
#include "layers/layer.h"
#include "panel_state/settings.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/camera_mouse.h"
#include "panels/widgets/widgets.h"
#include "scene/camera.h"
#include "scene/motion.h"
#include "scene/picking.h"
#include "session/layout_preset.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

glm::vec2 localMouse(const Rect& view) {
    const ImVec2 mouse = ImGui::GetMousePos();
    return glm::vec2(mouse.x, mouse.y) - view.min;
}

bool isOn(const PanelContext& context, LayerId layer) {
    return shownLayers(context.settings().layers, context.session().stage())
        .test(static_cast<std::size_t>(layer));
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
    return pick(scene, {context.camera().matrices(view.size.x / view.size.y), view.size,
                        localMouse(view), 0.6F * context.em});
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
    if (const auto picked = click.due(ImGui::GetTime())) context.session().select(*picked);
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
                  localMouse(view), 0.6F * context.em);
}

void handleMouse(const PanelContext& context) {
    if (context.session().ready() && handleLasso(context)) return;
    moveCameraByMouse(context);
    if (!context.session().ready()) return;
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) hoverNeighbor(context);
    handleClicks(context);
    handleRightClick(context);
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
        (session.showsBefore() ? "before " : "after ") + toString(session.address());
    const ImVec2 extent = context.fonts.strong->CalcTextSizeA(em, 1e9F, 0.0F, text.c_str());
    const glm::vec2 at(view.min.x + 0.5F * (view.size.x - extent.x), view.min.y + 0.9F * em);
    const glm::vec2 pad(0.6F * em, 0.25F * em);
    const Rect place{at - pad, glm::vec2(extent.x, extent.y) + 2.0F * pad};
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(toVec2(place.min), toVec2(place.max()),
                        toU32(context.palette.panel.withAlpha(0.94F)), 0.3F * em);
    list->AddText(context.fonts.strong, em, toVec2(at), toU32(color), text.c_str());
    return place;
}

/// Overlays of the picture. Each avoids those before it; labels come last, since they find a
/// place anywhere.
void drawOver(const PanelContext& context, const std::optional<PivotArrow>& arrow) {
    std::vector<Rect> taken;
    const auto note = [&](const std::optional<Rect>& place) {
        if (place) taken.push_back(*place);
    };
    if (arrow) note(arrow->rect);
    note(drawShownState(context));
    note(drawAxes(context, taken));
    note(drawColorBar(context, taken));
    // In Compare the column beside the views explains the colors.
    const bool compared = context.rects.layoutPreset == LayoutPreset::Compare;
    if (context.settings().legend && !compared) note(drawLegend(context, taken));
    drawLabels(context, taken);
    if (arrow) drawPivotArrow(context, *arrow);
}

}  // namespace

void drawView(const PanelContext& context) { drawScene(context, "##view"); }

void drawScene(const PanelContext& context, const char* window) {
    const Rect& view = context.rects.view;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, toVec4(context.palette.background));
    const bool open = beginRegion(
        window, view, ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    if (open && view.size.x >= 1.0F && view.size.y >= 1.0F) {
        const auto texture =
            reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(context.viewTexture));
        const std::optional<PivotArrow> arrow = offerPivotArrow(context);
        ImGui::SetCursorScreenPos(toVec2(view.min));
        ImGui::InvisibleButton("##scene", toVec2(view.size),
                               ImGuiButtonFlags_MouseButtonLeft |
                                   ImGuiButtonFlags_MouseButtonRight |
                                   ImGuiButtonFlags_MouseButtonMiddle);
        handleMouse(context);
        ImGui::GetWindowDrawList()->AddImage(texture, toVec2(view.min), toVec2(view.max()), {0, 1},
                                             {1, 0});
        drawOver(context, arrow);
        drawLasso(context);
    }
    ImGui::End();
}

}  // namespace se::view
