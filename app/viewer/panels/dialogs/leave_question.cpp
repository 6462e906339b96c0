// The question before unsaved annotations are left: save, discard or cancel.
#include <array>
#include <optional>
#include <utility>

#include "document/document.h"
#include "document/ui_state.h"
#include "panels/widgets/widgets.h"

namespace se::view {

namespace {

constexpr const char* kQuestionTitle = "##leave";

/// By LeaveFor.
constexpr std::array kHeadlines = {"Quit without saving?", "Open another file without saving?",
                                   "Reload without saving?"};
static_assert(kHeadlines.size() == static_cast<std::size_t>(LeaveFor::Reload) + 1);

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

/// Beside each other, or below each other where that does not fit. Returns the one that was chosen.
std::optional<LeaveAnswer> drawChoices(const PanelContext& context, LeaveQuestion& question) {
    const bool row = buttonsWidth({kChoices[0].label, kChoices[1].label, kChoices[2].label}) <=
                     ImGui::GetContentRegionAvail().x;
    std::optional<LeaveAnswer> answer;
    for (const Choice& each : kChoices) {
        if (row && each.answer != LeaveAnswer::Save) ImGui::SameLine();
        if (textButton(context, each.label, each.id, each.help, row ? 0.0F : -1.0F))
            answer = each.answer;
        if (each.answer == LeaveAnswer::Save && std::exchange(question.justAsked, false)) {
            takeKeyboard();
        }
        if (ImGui::IsItemFocused() && enterPressed()) answer = each.answer;
    }
    return answer;
}

}  // namespace

void drawLeaveQuestion(const PanelContext& context) {
    LeaveQuestion& question = context.state<LeaveQuestion>();
    if (question.asked && !ImGui::IsPopupOpen(kQuestionTitle)) ImGui::OpenPopup(kQuestionTitle);
    placeDialog(context, {26.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool open = ImGui::BeginPopupModal(
        kQuestionTitle, nullptr,
        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    if (!open) return;
    heading(context, kHeadlines[static_cast<std::size_t>(question.leave.what)]);
    wrappedText("There are unsaved " + question.atStake + ".");
    ImGui::Spacing();
    if (const auto answer = drawChoices(context, question))
        context.commands.document.answer(*answer);
    if (!question.asked) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace se::view
