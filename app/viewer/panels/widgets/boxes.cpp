// Windows: dialogs, plates over the view, and the view itself.
#include "document/ui_state.h"
#include "widgets.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace se::view {

glm::vec2 placeDialog(const PanelContext& context, glm::vec2 ems, glm::vec2 margin) {
    const glm::vec2 screen = context.rects.window;
    const glm::vec2 size = glm::min(ems * context.em, screen - margin * context.em);
    ImGui::SetNextWindowPos(toVec2(0.5F * screen), ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(toVec2(size));
    return size;
}

bool beginDialog(const char* title, bool* open, int extraFlags) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool shown = ImGui::Begin(title, open,
                                    ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoCollapse |
                                        ImGuiWindowFlags_NoSavedSettings | extraFlags);
    ImGui::PopStyleVar();
    return shown;
}

bool beginOverView(const PanelContext& context, const char* name, std::optional<float> top,
                   std::optional<float> width) {
    const Rect& view = context.rects.view;
    const float y = top ? *top * context.em : 0.5F * view.size.y;
    ImGui::SetNextWindowPos({view.min.x + 0.5F * view.size.x, view.min.y + y}, ImGuiCond_Always,
                            {0.5F, top ? 0.0F : 0.5F});
    if (width) ImGui::SetNextWindowSize({std::min(*width * context.em, 0.9F * view.size.x), 0.0F});
    return ImGui::Begin(name, nullptr,
                        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                            ImGuiWindowFlags_AlwaysAutoResize);
}

bool beginView(const PanelContext& context, const char* name) {
    const Rect& view = context.rects.view;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, toVec4(context.palette.background));
    const bool open =
        beginRegion(name, view, ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return open && view.size.x >= 1.0F && view.size.y >= 1.0F;
}

void offerView(const PanelContext& context) {
    ImGui::SetCursorScreenPos(toVec2(context.rects.view.min));
    ImGui::InvisibleButton("##scene", toVec2(context.rects.view.size),
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
}

void drawViewPicture(const PanelContext& context) {
    const Rect& view = context.rects.view;
    const auto texture =
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(context.viewTexture));
    const auto& tile = context.ui().picture.tile;
    if (!tile)
        return ImGui::GetWindowDrawList()->AddImage(texture, toVec2(view.min), toVec2(view.max()),
                                                    {0, 1}, {1, 0});
    const PixelRect part = partOfView(view, tile);
    const float bottom = view.min.y + std::floor(view.size.y);
    ImGui::GetWindowDrawList()->AddImage(
        texture,
        {view.min.x + static_cast<float>(part.min.x), bottom - static_cast<float>(part.max.y)},
        {view.min.x + static_cast<float>(part.max.x), bottom - static_cast<float>(part.min.y)},
        {0, 1}, {1, 0});
}

}  // namespace se::view
