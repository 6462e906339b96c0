#include <algorithm>
#include <string>
#include <utility>

#include "panel_state/ui_requests.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"

namespace se::view {

namespace {

constexpr const char* kQuestionTitle = "##leave";

const char* headline(LeaveFor what) {
    switch (what) {
        case LeaveFor::Quit:
            return "Quit without saving?";
        case LeaveFor::Open:
            return "Open another file without saving?";
        case LeaveFor::Reload:
            return "Reload without saving?";
    }
    return "";
}

struct Choice {
    const char* label;
    const char* id;  ///< Name of its rectangle in the state dump.
    LeaveAnswer answer;
    const char* help;
};

constexpr Choice kChoices[] = {
    {"Save session", "leave save", LeaveAnswer::Save, "Save the session, then continue"},
    {"Discard", "leave discard", LeaveAnswer::Discard, "Continue without saving"},
    {"Cancel (Esc)", "leave cancel", LeaveAnswer::Cancel, "Stay here"},
};

/// Beside each other, or below each other where that does not fit.
void drawChoices(const PanelContext& context, LeaveQuestion& question) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = 0.0F;
    for (const Choice& each : kChoices) {
        width += ImGui::CalcTextSize(each.label).x + 2.0F * style.FramePadding.x;
    }
    const bool row = width + 2.0F * style.ItemSpacing.x <= ImGui::GetContentRegionAvail().x;
    for (const Choice& each : kChoices) {
        if (row && each.answer != LeaveAnswer::Save) ImGui::SameLine();
        if (ImGui::Button(each.label, {row ? 0.0F : -1.0F, 0.0F})) question.answer = each.answer;
        context.where()[each.id] = lastItem();
        if (each.answer == LeaveAnswer::Save && std::exchange(question.justAsked, false)) {
            takeKeyboard();
        }
        // Space is Dear ImGui's own key for a button.
        const bool enter = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)) ||
                           ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter));
        if (ImGui::IsItemFocused() && enter) question.answer = each.answer;
        tooltip(each.help);
    }
}

}  // namespace

void drawLeaveQuestion(const PanelContext& context) {
    LeaveQuestion& question = context.state<LeaveQuestion>();
    if (question.asked && !ImGui::IsPopupOpen(kQuestionTitle)) ImGui::OpenPopup(kQuestionTitle);
    const glm::vec2 screen(context.rects.status.size.x, context.rects.status.max().y);
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(26.0F * context.em, screen.x - 2.0F * context.em), 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool open = ImGui::BeginPopupModal(
        kQuestionTitle, nullptr,
        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    if (!open) return;
    heading(context, headline(question.leave.what));
    wrappedText("There are unsaved " + question.atStake + ".");
    ImGui::Spacing();
    drawChoices(context, question);
    if (!question.asked || question.answer != LeaveAnswer::None) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace se::view
