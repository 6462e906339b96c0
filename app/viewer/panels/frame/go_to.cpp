// The box with the address in the menu bar.
#include <algorithm>

#include "input/go_to_box.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

namespace {

/// The typed text; of a long text the part around the caret.
void drawTyped(const PanelContext& context, const GoToBox& box, ImVec2 at, float room) {
    const float em = context.em;
    const float sign = ImGui::CalcTextSize("0").x;  // all characters have the same width
    const auto fits = static_cast<std::size_t>(std::max(1.0F, room / sign));
    const std::size_t first = box.caret() > fits ? box.caret() - fits : 0;
    const std::string text = box.text().substr(first, fits);
    const float height = ImGui::GetTextLineHeight();
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (box.marked()) {
        const float width = static_cast<float>(text.size()) * sign;
        list->AddRectFilled(at, {at.x + width, at.y + height},
                            toU32(context.palette.accent.withAlpha(0.45F)));
    }
    list->AddText(at, toU32(context.palette.text), text.c_str());
    const float x = at.x + static_cast<float>(box.caret() - first) * sign + 1.0F;
    list->AddLine({x, at.y}, {x, at.y + height}, toU32(context.palette.text),
                  std::max(1.0F, 0.09F * em));
}

}  // namespace

void drawGoTo(const PanelContext& context, float width) {
    GoToBox& box = context.state<GoToBox>();
    const float em = context.em;
    const ImVec2 size(width, ImGui::GetTextLineHeight() + 0.24F * em);
    if (ImGui::InvisibleButton("##goto", size)) box.open();
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsItemHovered()) box.close();
    // A focused text field would get the typed characters as well.
    if (box.active() && ImGui::GetIO().WantTextInput) ImGui::SetWindowFocus(nullptr);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, toU32(context.palette.panelRaised), 0.25F * em);
    if (box.active()) {
        list->AddRect(low, high, toU32(context.palette.accent), 0.25F * em, 0, 0.12F * em);
    }
    ImGui::PushFont(context.fonts.mono);
    const ImVec2 at(low.x + 0.5F * em, 0.5F * (low.y + high.y - ImGui::GetTextLineHeight()));
    if (box.active()) {
        drawTyped(context, box, at, size.x - em);
    } else {
        const std::string text = fitted(addressText(context.session()), size.x - em);
        list->AddText(at, toU32(context.palette.textDim), text.c_str());
    }
    ImGui::PopFont();
    tooltip(withKeys(context, "Go to", "step.goto") +
            ": 137, 137.sphere.3, +10, -10, 50%, or p812 to select a point");
}

}  // namespace se::view
