// Mouse control of the camera, and clicks as opposed to drags.

#include <algorithm>
#include <glm/geometric.hpp>

#include "input/view_drag.h"
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

}  // namespace se::view
