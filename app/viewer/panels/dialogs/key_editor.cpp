#include <algorithm>

#include "input/key_map.h"
#include "panel_state/ui_state.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"

namespace se::view {

namespace {

/// One action: its title, its keys (a click changes them), and a button to reset them.
void drawRow(const PanelContext& context, const Command& command) {
    UiState& ui = context.ui();
    KeyMap& keys = ui.settings.keys;
    const bool asked = ui.keyCapture.command() == command.id;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(std::string(command.title).c_str());
    tooltip(std::string(command.id) + ": " + std::string(command.help));
    ImGui::TableNextColumn();
    const std::string shown = asked ? "press a key..." : keys.all(command);
    ImGui::PushFont(context.fonts.mono);
    const std::string label = (shown.empty() ? std::string("none") : shown) + "##key";
    if (ImGui::Selectable(label.c_str(), asked)) ui.keyCapture.begin(command.id);
    ui.where["key " + std::string(command.id)] = lastItem();
    ImGui::PopFont();
    ImGui::TableNextColumn();
    if (!keys.isChanged(command)) return;
    const std::string first(command.keys);
    if (ImGui::SmallButton("reset")) keys.reset(command);
    tooltip(first.empty() ? "Reset to no key" : "Reset to " + first);
}

void drawRows(const PanelContext& context) {
    constexpr int kFlags =
        ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH;
    if (!ImGui::BeginTable("##actions", 3, kFlags)) return;
    // As shares: in its first frame the window has no size yet.
    ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthStretch, 0.55F);
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthStretch, 0.35F);
    ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthStretch, 0.1F);
    std::string_view group;
    for (const Command& command : commands()) {
        if (command.id == "help.leave") continue;  // Esc cannot be changed.
        if (command.group != group) {
            group = command.group;
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", std::string(group).c_str());
        }
        ImGui::PushID(command.id.data());
        drawRow(context, command);
        ImGui::PopID();
    }
    ImGui::EndTable();
}

/// Of constant height: rows must not move under the pointer.
void drawHead(const PanelContext& context) {
    UiState& ui = context.ui();
    const std::string& note = ui.keyCapture.note();
    const float lines = ImGui::GetFrameHeight() + ImGui::GetTextLineHeightWithSpacing();
    if (ImGui::BeginChild("##note", {-9.0F * context.em, lines}, false)) {
        ImGui::AlignTextToFramePadding();
        wrappedText(note.empty() ? "Click the keys of an action, then press the new one." : note);
    }
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginDisabled(ui.settings.keys.changes().empty());
    if (ImGui::Button("Reset all keys")) ui.settings.keys.resetAll();
    ImGui::EndDisabled();
}

}  // namespace

void drawKeyEditor(const PanelContext& context) {
    UiState& ui = context.ui();
    if (!ui.keyEditor) {
        ui.keyCapture.cancel();
        return;
    }
    const float em = context.em;
    const PanelRects& l = context.rects;
    const glm::vec2 screen(l.drawer.size.x, std::max(l.status.max().y, l.drawer.max().y));
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(
        {std::min(40.0F * em, screen.x - 2.0F * em), std::min(40.0F * em, screen.y - 2.0F * em)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool shown =
        ImGui::Begin("Change keys", &ui.keyEditor,
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    if (shown) {
        drawHead(context);
        drawRows(context);
    }
    ImGui::End();
}

}  // namespace se::view
