// Mouse control of the camera, and clicks as opposed to drags.

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "input/view_drag.h"
#include "layout/overlays.h"
#include "scene/camera.h"
#include "widgets.h"

namespace se::view {

namespace {

/// A press that moves by this share of the window's height is a drag.
constexpr float kDragShare = 0.01F;

}  // namespace

bool isClick(const PanelContext& context, ImGuiMouseButton button) {
    return ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(button) &&
           !context.state<ViewDrag>().drags();
}

void moveCameraByMouse(const PanelContext& context) {
    const Rect& view = context.rects.view;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 pointer(io.MousePos.x, io.MousePos.y);
    ViewDrag& drag = context.state<ViewDrag>();
    if (ImGui::IsItemActivated()) drag.begin();
    if (ImGui::IsItemActive() && ImGui::IsMousePosValid()) {
        const glm::vec2 moved = drag.move(pointer, kDragShare * io.DisplaySize.y);
        const bool turns = ImGui::IsMouseDown(ImGuiMouseButton_Left) && !io.KeyShift;
        if (moved != glm::vec2(0.0F))
            turns ? context.camera().orbit(moved, view.size.y)
                  : context.camera().pan(moved, view.size.y);
    }
    if (!ImGui::IsItemHovered() || io.MouseWheel == 0.0F) return;
    const glm::vec2 at = (pointer - view.min) / view.size;
    context.camera().zoomAt(io.MouseWheel, {2.0F * at.x - 1.0F, 1.0F - 2.0F * at.y},
                            view.size.x / view.size.y);
}

std::optional<Rect> drawAxes(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    constexpr std::array kCorners = {Corner::BottomLeft, Corner::BottomRight, Corner::TopLeft};
    const std::optional<Rect> place =
        freeCorner({context.rects.view, 0.4F * em, taken, {}}, glm::vec2(4.4F * em), kCorners);
    if (!place) return std::nullopt;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const CameraMatrices camera = context.camera().matrices(1.0F);
    const glm::vec2 origin = place->min + 0.5F * place->size;
    constexpr std::array kNames = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
        const glm::vec4 seen = camera.view[i];
        const glm::vec2 way(seen.x, -seen.y);
        const glm::vec2 tip = origin + way * (1.35F * em);
        const float alpha = 0.55F + 0.45F * std::clamp(seen.z + 0.5F, 0.0F, 1.0F);
        const ImU32 color = toU32(context.palette.textDim.withAlpha(alpha));
        list->AddLine(toVec2(origin), toVec2(tip), color, std::max(1.0F, 0.11F * em));
        if (glm::length(way) < 0.25F) continue;
        const glm::vec2 letter =
            origin + glm::normalize(way) * (1.35F * em * glm::length(way) + 0.55F * em);
        const ImVec2 extent = ImGui::CalcTextSize(kNames[static_cast<std::size_t>(i)]);
        list->AddText({letter.x - 0.5F * extent.x, letter.y - 0.5F * extent.y}, color,
                      kNames[static_cast<std::size_t>(i)]);
    }
    return place;
}

}  // namespace se::view
