// The dialogs Guide, the page docs/viewer.md up to its list of keys, and About.
#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>
#include <string_view>

#include "document/ui_state.h"
#include "panels/widgets/widgets.h"
#include "run/embedded_files.h"

namespace se::view {

namespace {

void drawGuide(const PanelContext& context) {
    const std::string_view page = embeddedFile("viewer.md");
    std::vector<teach::TextBlock> blocks = teach::textBlocks(page.substr(0, page.find("## Keys")));
    // Links lead to other pages, which the program does not have.
    for (teach::TextBlock& block : blocks) {
        for (teach::TextSpan& span : block.spans) span.link.clear();
    }
    drawTextBlocks(context, blocks);
}

void drawAbout(const PanelContext& context) {
    textIn(context.fonts.large, "Spiraling Edge " SE_VERSION);
    ImGui::Spacing();
    wrappedText(
        "Surface reconstruction from points with normals, and every decision on the way, after P. "
        "Crossno and E. Angel, Spiraling Edge: Fast Surface Reconstruction from Partially "
        "Organized Sample Points, IEEE Visualization 1999.");
    ImGui::Spacing();
    dimText("MIT license. Made with Dear ImGui, GLFW, GLM and OpenGL.");
}

}  // namespace

void drawHelp(const PanelContext& context) {
    UiState& ui = context.ui();
    const bool guide = ui.help == HelpPage::Guide;
    if (!guide && ui.help != HelpPage::About) return;
    placeDialog(context, guide ? glm::vec2(48.0F, 46.0F) : glm::vec2(30.0F, 13.0F));
    bool open = true;
    if (beginDialog(guide ? "Guide" : "About", &open)) {
        context.where()[guide ? "help guide" : "help about"] = {
            {ImGui::GetWindowPos().x, ImGui::GetWindowPos().y},
            {ImGui::GetWindowWidth(), ImGui::GetWindowHeight()}};
        guide ? drawGuide(context) : drawAbout(context);
    }
    ImGui::End();
    if (!open) ui.help = HelpPage::None;
}

// The sheet of all keys, in which they can be changed.

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

bool changes(const PanelContext& context) { return context.ui().help == HelpPage::ChangeKeys; }

void keyRow(const PanelContext& context, const std::string& keys, const std::string& what) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    wrappedIn(context.fonts.mono, keys);
    ImGui::TableNextColumn();
    wrappedText(what);
}

/// An action whose keys a click changes, with a button to reset them.
void changeableRow(const PanelContext& context, const Command& command) {
    UiState& ui = context.ui();
    KeyMap& keys = ui.settings.keys;
    const bool asked = ui.keyCapture.command() == command.id;
    const std::string shown = asked ? "press a key" : keys.all(command);
    ImGui::PushID(command.id.data());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(context.fonts.mono);
    const std::string label = (shown.empty() ? std::string("none") : shown) + "##key";
    if (selectable(context, label, asked, "key " + std::string(command.id)))
        ui.keyCapture.begin(command.id);
    ImGui::PopFont();
    ImGui::TableNextColumn();
    wrappedText(std::string(command.title));
    tooltip(std::string(command.id) + ": " + std::string(command.help));
    if (keys.isChanged(command)) {
        if (ImGui::SmallButton("reset")) keys.reset(command);
        tooltip(command.keys.empty() ? "Reset to no key" : "Reset to " + std::string(command.keys));
    }
    ImGui::PopID();
}

/// Width of the keys, in em.
constexpr float kKeysWidth = 8.5F;

/// The ten keys of bookmarks are one row, unless one of them was changed.
bool bookmarksAreOneRow(const KeyMap& keys) {
    return std::none_of(commands().begin(), commands().end(), [&](const Command& command) {
        return command.id.starts_with("notes.go.") && keys.isChanged(command);
    });
}

void drawKeysOf(const PanelContext& context, const Command& command, bool oneRow) {
    // Esc cannot be changed.
    if (changes(context) && command.id != "help.leave") return changeableRow(context, command);
    const std::string keys = context.settings().keys.all(command);
    if (keys.empty()) return;
    const bool bookmark = oneRow && command.id.starts_with("notes.go.");
    if (!bookmark) keyRow(context, keys, std::string(command.title));
    if (bookmark && command.id == "notes.go.1")
        keyRow(context, "Ctrl+1 ... Ctrl+0", "Go to bookmark 1 ... 10");
}

void drawGroup(const PanelContext& context, std::string_view group) {
    heading(context, std::string(group).c_str());
    if (!beginValues(std::string(group).c_str(), context, kKeysWidth)) return;
    const bool oneRow = bookmarksAreOneRow(context.settings().keys);
    for (const Command& command : commands())
        if (command.group == group) drawKeysOf(context, command, oneRow);
    ImGui::EndTable();
    ImGui::Spacing();
}

void drawMouseGroup(const PanelContext& context) {
    heading(context, "Mouse");
    if (!beginValues("mouse", context, kKeysWidth)) return;
    for (const MouseLine& line : kMouse) keyRow(context, line.action, line.what);
    ImGui::EndTable();
}

void drawColumn(const PanelContext& context, std::initializer_list<const char*> groups) {
    ImGui::TableNextColumn();
    for (const char* group : groups) drawGroup(context, group);
}

/// As many columns as fit: in four, all of it fits a window of 1280x800.
void drawColumns(const PanelContext& context, int columns) {
    if (!ImGui::BeginTable("##columns", columns, ImGuiTableFlags_SizingStretchSame)) return;
    if (columns == 4) {
        drawColumn(context, {"Step", "Notes"});
        drawColumn(context, {"Run", "Ask", "Edit"});
        drawColumn(context, {"View", "Layers"});
        drawColumn(context, {"File", "Help"});
    } else {
        drawColumn(context, {"Step", "Run", "File", "Edit", "Layers"});
        drawColumn(context, {"View", "Ask", "Notes", "Help"});
    }
    drawMouseGroup(context);
    ImGui::EndTable();
}

/// The head, of constant height: rows must not move under the pointer.
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

void drawKeySheet(const PanelContext& context) {
    UiState& ui = context.ui();
    const bool changing = changes(context);
    if (!changing) ui.keyCapture.cancel();
    if (!changing && ui.help != HelpPage::Keys) return;
    const float ems = placeDialog(context, {84.0F, 50.0F}).x / context.em;
    bool open = true;
    if (beginDialog("Keys and mouse", &open, ImGuiWindowFlags_NoFocusOnAppearing)) {
        if (changing) {
            drawHead(context);
            // It stays in sight while the rows scroll.
            ImGui::BeginChild("##rows");
        } else if (ImGui::Button("Change keys...")) {
            ui.help = HelpPage::ChangeKeys;
        }
        drawColumns(context, ems > 66.0F ? 4 : ems > 40.0F ? 2 : 1);
        if (changing) ImGui::EndChild();
    }
    ImGui::End();
    if (!open) ui.help = HelpPage::None;
}

}  // namespace se::view
