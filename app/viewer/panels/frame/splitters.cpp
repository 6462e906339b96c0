// The handles between areas. Each is a window of its own above the regions, so that neither of its
// neighbors gets the mouse.
#include <algorithm>
#include <string>

#include "panel_state/ui_state.h"
#include "panels/widgets/widgets.h"

namespace se::view {

namespace {

constexpr int kHandleFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                             ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                             ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

/// The size at the pointer, in em; a size below that of the tabs folds Find and Change.
void resize(const PanelContext& context, Splitter splitter, const SplitterPlace& place) {
    PanelSizes& sizes = context.settings().panels;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        sizes.of(splitter) = 0.0F;
        return;
    }
    // A press alone moves nothing.
    if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0F)) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float size = place.sign * ((place.sideways ? mouse.x : mouse.y) - place.from);
    const float ems = std::max(1.0F, size / context.em);
    if (splitter == Splitter::Lower) sizes.folded = ems < 4.0F;
    if (splitter != Splitter::Lower || !sizes.folded) sizes.of(splitter) = ems;
}

void drawSplitter(const PanelContext& context, Splitter splitter, const SplitterPlace& place) {
    const std::string name(kSplitterNames[static_cast<std::size_t>(splitter)]);
    ImGui::SetNextWindowPos(toVec2(place.handle.min));
    ImGui::SetNextWindowSize(toVec2(place.handle.size));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0F, 1.0F});
    if (ImGui::Begin(("##splitter " + name).c_str(), nullptr, kHandleFlags)) {
        ImGui::InvisibleButton("##handle", toVec2(place.handle.size));
        context.where()["splitter " + name] = place.handle;
        const bool active = ImGui::IsItemActive();
        if (active || ImGui::IsItemHovered()) {
            ImGui::SetMouseCursor(place.sideways ? ImGuiMouseCursor_ResizeEW
                                                 : ImGuiMouseCursor_ResizeNS);
            const float thin = std::max(1.0F, 0.15F * context.em);
            Rect line = place.handle;
            float& at = place.sideways ? line.min.x : line.min.y;
            float& size = place.sideways ? line.size.x : line.size.y;
            at += 0.5F * (size - thin);
            size = thin;
            fill(ImGui::GetWindowDrawList(), line, context.palette.accent);
        }
        if (active) resize(context, splitter, place);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace

void drawSplitters(const PanelContext& context) {
    if (context.ui().coversView()) return;
    for (std::size_t i = 0; i < kSplitterCount; ++i) {
        const SplitterPlace& place = context.rects.splitters[i];
        if (place.handle.size.x > 0.0F && place.handle.size.y > 0.0F)
            drawSplitter(context, static_cast<Splitter>(i), place);
    }
}

}  // namespace se::view
