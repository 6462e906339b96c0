#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "panel.h"
#include "scene/picking.h"
#include "widgets.h"

namespace se::view {

namespace {

/// A press that moves by more than this share of the window's height is a drag.
constexpr float kClickShare = 0.01F;

glm::vec2 localMouse(const Rect& view) {
    const ImVec2 mouse = ImGui::GetMousePos();
    return glm::vec2(mouse.x, mouse.y) - view.min;
}

bool isOn(const PanelContext& context, LayerId layer) {
    return shownLayers(context.ui().settings.layers, context.session().stage())
        .test(static_cast<std::size_t>(layer));
}

/// Only what is drawn can be picked.
Pick underMouse(const PanelContext& context) {
    const Session& session = context.session();
    const Rect& view = context.layout.view;
    const bool mesh = isOn(context, LayerId::Triangles);
    const bool rings = isOn(context, LayerId::EdgeRing);
    const PickScene scene{
        session.model(), isOn(context, LayerId::Points),
        mesh ? session.shownTriangles() : std::span<const Triangle>{},
        session.picture().mended ? nullptr : &session.meshIndex(),
        rings ? std::span<const RingPath>(session.picture().rings) : std::span<const RingPath>{}};
    return pick(scene, {context.camera().matrices(view.size.x / view.size.y), view.size,
                        localMouse(view), 0.6F * context.em});
}

/// A click picks, a double click turns the view about what is there and picks nothing. So a click
/// counts only when no second one can follow.
void handleClicks(const PanelContext& context) {
    ClickWait& click = context.ui().click;
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        click.takeBack();
        const Pick found = underMouse(context);
        if (found.what.kind != SelectionKind::None) context.camera().lookAt(found.place);
        return;
    }
    const float limit = kClickShare * io.DisplaySize.y;
    const bool still = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < limit * limit;
    const bool single = io.MouseClickedLastCount[ImGuiMouseButton_Left] == 1;
    if (ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) && still &&
        single) {
        // Counted from the press, as that of a double click is.
        const double until =
            io.MouseClickedTime[ImGuiMouseButton_Left] + double{io.MouseDoubleClickTime};
        click.begin(underMouse(context).what, until);
    }
    if (const auto picked = click.due(ImGui::GetTime())) context.session().select(*picked);
}

/// Lights up the neighbor of the pivot that the pointer is on, here and on the dial. Only those: to
/// look at all points in every frame would take too long.
void hoverNeighbor(const PanelContext& context) {
    const Session& session = context.session();
    const Index pivot = session.picture().pivot;
    if (pivot == kNone) return;
    const Rect& view = context.layout.view;
    const CameraMatrices camera = context.camera().matrices(view.size.x / view.size.y);
    context.ui().pointedAt = pickAmong(session.model(), session.model().points.neighbors[pivot],
                                       camera, view.size, localMouse(view), 0.6F * context.em);
}

void dragWith(const PanelContext& context) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (moved.x == 0.0F && moved.y == 0.0F) return;
    const glm::vec2 pixels(moved.x, moved.y);
    const float height = context.layout.view.size.y;
    const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (left && !ImGui::GetIO().KeyShift) {
        context.camera().orbit(pixels, height);
    } else {
        context.camera().pan(pixels, height);
    }
}

void handleMouse(const PanelContext& context) {
    const Rect& view = context.layout.view;
    if (ImGui::IsItemActive()) dragWith(context);
    const float wheel = ImGui::GetIO().MouseWheel;
    if (ImGui::IsItemHovered() && wheel != 0.0F) {
        const glm::vec2 at = localMouse(view) / view.size;
        context.camera().zoomAt(wheel, {2.0F * at.x - 1.0F, 1.0F - 2.0F * at.y},
                                view.size.x / view.size.y);
    }
    if (!context.session().ready()) return;
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) hoverNeighbor(context);
    handleClicks(context);
}

/// Puts labels beside their points so that none covers another.
class LabelPlacer {
  public:
    LabelPlacer(const PanelContext& context, ImDrawList* list)
        : context_(context),
          list_(list),
          camera_(
              context.camera().matrices(context.layout.view.size.x / context.layout.view.size.y)) {}

    void draw(const Label& label) {
        const Rect& view = context_.layout.view;
        const glm::vec3 at = project(camera_, label.position, view.size);
        if (at.z <= 0.0F || !Rect{{0, 0}, view.size}.contains(glm::vec2(at))) return;
        const float em = context_.em;
        ImFont* font = label.strong ? context_.fonts.strong : context_.fonts.text;
        const float size = label.strong ? em : 0.88F * em;
        const ImVec2 extent = font->CalcTextSizeA(size, 1e9F, 0.0F, label.text.c_str());
        const glm::vec2 plate(extent.x + 0.44F * em, extent.y + 0.04F * em);
        const std::optional<Rect> place = freePlace(view.min + glm::vec2(at), plate, label.strong);
        if (!place) return;
        taken_.push_back(*place);
        list_->AddRectFilled(toVec2(place->min), toVec2(place->max()),
                             toU32(context_.palette.background.withAlpha(0.78F)), 0.2F * em);
        list_->AddText(font, size, {place->min.x + 0.22F * em, place->min.y + 0.02F * em},
                       toU32(label.color), label.text.c_str());
    }

  private:
    /// Right above, right below, left above, left below; strong labels give way least, and go
    /// farther off.
    std::optional<Rect> freePlace(glm::vec2 at, glm::vec2 plate, bool strong) const {
        const float gap = 0.5F * context_.em;
        std::optional<Rect> first;
        for (const float far : {1.0F, 3.0F, 5.0F, 7.0F}) {
            for (const glm::vec2 way : {glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, -1),
                                        glm::vec2(-1, 1), glm::vec2(1, 0), glm::vec2(-1, 0)}) {
                const Rect rect = plateAt(at + way * (far * gap), plate, way);
                if (!first) first = rect;
                if (isFree(rect)) return rect;
            }
            if (!strong) return std::nullopt;
        }
        return first;
    }

    static Rect plateAt(glm::vec2 corner, glm::vec2 plate, glm::vec2 way) {
        if (way.x < 0.0F) corner.x -= plate.x;
        corner.y += 0.5F * plate.y * (way.y - 1.0F);
        return {glm::round(corner), plate};
    }

    bool isFree(const Rect& rect) const {
        const Rect& view = context_.layout.view;
        const bool inside = rect.min.x >= view.min.x && rect.min.y >= view.min.y &&
                            rect.max().x <= view.max().x && rect.max().y <= view.max().y;
        return inside && std::none_of(taken_.begin(), taken_.end(), [&](const Rect& other) {
                   return rect.min.x < other.max().x && other.min.x < rect.max().x &&
                          rect.min.y < other.max().y && other.min.y < rect.max().y;
               });
    }

    const PanelContext& context_;
    ImDrawList* list_;
    CameraMatrices camera_;
    std::vector<Rect> taken_;
};

void drawLabels(const PanelContext& context, ImDrawList* list) {
    LabelPlacer placer(context, list);
    for (const bool strong : {true, false}) {
        for (const Label& label : context.drawList.labels) {
            if (label.strong == strong) placer.draw(label);
        }
    }
}

void drawAxes(const PanelContext& context, ImDrawList* list) {
    const Rect& view = context.layout.view;
    const float em = context.em;
    const CameraMatrices camera = context.camera().matrices(1.0F);
    const glm::vec2 origin(view.min.x + 2.6F * em, view.max().y - 2.6F * em);
    constexpr std::array kNames = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
        glm::vec4 axis(0.0F);
        axis[i] = 1.0F;
        const glm::vec4 seen = camera.view * axis;
        const glm::vec2 way(seen.x, -seen.y);
        const glm::vec2 tip = origin + way * (1.35F * em);
        const float alpha = 0.55F + 0.45F * std::clamp(seen.z + 0.5F, 0.0F, 1.0F);
        const ImU32 color = toU32(context.palette.textDim.withAlpha(alpha));
        list->AddLine(toVec2(origin), toVec2(tip), color, std::max(1.0F, 0.11F * em));
        if (glm::length(way) < 0.25F) continue;
        const glm::vec2 place =
            origin + glm::normalize(way) * (1.35F * em * glm::length(way) + 0.55F * em);
        const ImVec2 extent = ImGui::CalcTextSize(kNames[static_cast<std::size_t>(i)]);
        list->AddText({place.x - 0.5F * extent.x, place.y - 0.5F * extent.y}, color,
                      kNames[static_cast<std::size_t>(i)]);
    }
}

/// Which of the two states it is, where somebody looks back.
void drawShownState(const PanelContext& context, ImDrawList* list) {
    const Session& session = context.session();
    if (!context.ui().look.on() || !session.ready() || session.event() == nullptr) return;
    const Rect& view = context.layout.view;
    const float em = context.em;
    const Color& color = session.showsBefore() ? context.palette.textDim : context.palette.test;
    const std::string text =
        (session.showsBefore() ? "before " : "after ") + toString(session.address());
    const ImVec2 extent = context.fonts.strong->CalcTextSizeA(em, 1e9F, 0.0F, text.c_str());
    const glm::vec2 at(view.min.x + 0.5F * (view.size.x - extent.x), view.min.y + 0.9F * em);
    list->AddRectFilled({at.x - 0.6F * em, at.y - 0.25F * em},
                        {at.x + extent.x + 0.6F * em, at.y + extent.y + 0.25F * em},
                        toU32(context.palette.panel.withAlpha(0.94F)), 0.3F * em);
    list->AddText(context.fonts.strong, em, toVec2(at), toU32(color), text.c_str());
}

}  // namespace

void drawView(const PanelContext& context) {
    const Rect& view = context.layout.view;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, toVec4(context.palette.background));
    const bool open = beginRegion(
        "##view", view, ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    if (open && view.size.x >= 1.0F && view.size.y >= 1.0F) {
        const auto texture =
            reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(context.viewTexture));
        ImGui::SetCursorScreenPos(toVec2(view.min));
        ImGui::InvisibleButton("##scene", toVec2(view.size),
                               ImGuiButtonFlags_MouseButtonLeft |
                                   ImGuiButtonFlags_MouseButtonRight |
                                   ImGuiButtonFlags_MouseButtonMiddle);
        handleMouse(context);
        ImDrawList* list = ImGui::GetWindowDrawList();
        list->AddImage(texture, toVec2(view.min), toVec2(view.max()), {0, 1}, {1, 0});
        drawLabels(context, list);
        drawAxes(context, list);
        drawShownState(context, list);
        if (context.ui().settings.legend) drawLegend(context);
        drawColorBar(context);
    }
    ImGui::End();
}

}  // namespace se::view
