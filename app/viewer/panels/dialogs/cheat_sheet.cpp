#include <algorithm>
#include <array>
#include <initializer_list>

#include "input/key_map.h"
#include "panel_state/settings.h"
#include "panel_state/ui_state.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"

namespace se::view {

namespace {

struct MouseLine {
    const char* action;
    const char* what;
};

constexpr std::array kMouse = {
    MouseLine{"left drag", "Orbit"},
    MouseLine{"right, middle or Shift+left drag", "Pan"},
    MouseLine{"Ctrl+left drag", "Break on the enclosed points"},
    MouseLine{"wheel", "Zoom to the pointer"},
    MouseLine{"click", "Select a point, edge or triangle, or clear"},
    MouseLine{"double click", "Center the orbit on a point"},
    MouseLine{"drop a file", "Open points or a session"},
};

void keyRow(const PanelContext& context, const std::string& keys, const std::string& what) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(context.fonts.mono);
    wrappedText(keys);
    ImGui::PopFont();
    ImGui::TableNextColumn();
    wrappedText(what);
}

bool beginKeys(const char* id, const PanelContext& context) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchProp)) return false;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 8.5F * context.em);
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    return true;
}

/// The ten keys of bookmarks are one row, unless one of them was changed.
bool bookmarksAreOneRow(const KeyMap& keys) {
    return std::none_of(commands().begin(), commands().end(), [&](const Command& command) {
        return command.id.starts_with("notes.go.") && keys.isChanged(command);
    });
}

void drawGroup(const PanelContext& context, std::string_view group) {
    heading(context, std::string(group).c_str());
    if (!beginKeys(std::string(group).c_str(), context)) return;
    const bool oneRow = bookmarksAreOneRow(context.settings().keys);
    for (const Command& command : commands()) {
        const std::string keys = context.settings().keys.all(command);
        if (command.group != group || keys.empty()) continue;
        const bool bookmark = oneRow && command.id.starts_with("notes.go.");
        if (!bookmark) keyRow(context, keys, std::string(command.title));
        if (bookmark && command.id == "notes.go.1")
            keyRow(context, "Ctrl+1 ... Ctrl+0", "Go to bookmark 1 ... 10");
    }
    ImGui::EndTable();
    ImGui::Spacing();
}

void drawMouseGroup(const PanelContext& context) {
    heading(context, "Mouse");
    if (!beginKeys("mouse", context)) return;
    for (const MouseLine& line : kMouse) keyRow(context, line.action, line.what);
    ImGui::EndTable();
}

void drawColumn(const PanelContext& context, std::initializer_list<const char*> groups) {
    ImGui::TableNextColumn();
    for (const char* group : groups) drawGroup(context, group);
}

/// As many columns as fit, to minimize scrolling.
void drawColumns(const PanelContext& context, int columns) {
    if (!ImGui::BeginTable("##columns", columns, ImGuiTableFlags_SizingStretchSame)) return;
    if (columns == 3) {
        drawColumn(context, {"Step", "Run"});
        drawColumn(context, {"File", "Edit", "Layers", "Notes", "Help"});
        drawColumn(context, {"View"});
    } else {
        drawColumn(context, {"Step", "Run", "File", "Edit", "Layers"});
        drawColumn(context, {"View", "Notes", "Help"});
    }
    drawMouseGroup(context);
    ImGui::EndTable();
}

}  // namespace

void drawCheatSheet(const PanelContext& context) {
    bool& open = context.ui().cheatSheet;
    if (!open) return;
    const float em = context.em;
    const PanelRects& l = context.rects;
    const glm::vec2 screen(l.status.size.x, l.status.max().y);
    const float width = std::min(84.0F * em, screen.x - 2.0F * em);
    const float height = std::min(50.0F * em, screen.y - 2.0F * em);
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({width, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool shown = ImGui::Begin(
        "Keys and mouse", &open,
        ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar();
    if (shown) {
        if (ImGui::Button("Change keys...")) {
            open = false;
            context.ui().keyEditor = true;
        }
        drawColumns(context, width > 66.0F * em ? 3 : width > 40.0F * em ? 2 : 1);
    }
    ImGui::End();
}

}  // namespace se::view
