#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

/// One menu from all commands of a group.
void drawGroup(const PanelContext& context, std::string_view group) {
    if (!ImGui::BeginMenu(std::string(group).c_str())) return;
    for (const Command& command : commands()) {
        if (command.group != group) continue;
        const std::string key = firstKey(command);
        if (ImGui::MenuItem(std::string(command.title).c_str(), key.c_str())) {
            command.run(context.commands);
        }
    }
    ImGui::EndMenu();
}

std::string fileNote(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready()) return {};
    return session.model().name + "   " + grouped(session.model().points.size()) + " points   " +
           session.spec().rules + " rules";
}

}  // namespace

void drawMenuBar(const PanelContext& context) {
    if (!ImGui::BeginMainMenuBar()) return;
    std::string_view last;
    for (const Command& command : commands()) {
        if (command.group == last) continue;
        last = command.group;
        drawGroup(context, last);
    }
    const float room = ImGui::GetContentRegionAvail().x - context.em;
    const std::string note = fitted(fileNote(context), room);
    const float width = ImGui::CalcTextSize(note.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
    ImGui::TextDisabled("%s", note.c_str());
    ImGui::EndMainMenuBar();
}

}  // namespace se::view
