// The Bookmarks panel: addresses with the user's notes.
#include <imgui.h>

#include <algorithm>

#include "document/ui_state.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "session/annotations.h"
#include "session/playback.h"
#include "session/session.h"

namespace se::view {

namespace {

/// The key of a bookmark, empty beyond the tenth.
std::string keyOf(const PanelContext& context, std::size_t place) {
    if (place >= kBookmarkKeys) return {};
    const Command* command = findCommand("notes.go." + std::to_string(place + 1));
    return command != nullptr ? context.key(*command) : std::string{};
}

/// One bookmark: its address (a link), the user's note, and a cross that removes it.
/// True if it is to be removed.
bool drawBookmark(const PanelContext& context, Bookmark& mark, std::size_t place) {
    Session& session = context.session();
    const bool here =
        session.ready() && session.event() != nullptr && session.address() == mark.address;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string name = toString(mark.address);
    ImGui::PushFont(context.fonts.mono);
    ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0F, 0.5F});
    const bool chosen = ImGui::Selectable(name.c_str(), here, 0, {0.0F, ImGui::GetFrameHeight()});
    ImGui::PopStyleVar();
    if (chosen) {
        context.playback().pause();
        session.moves().goTo(mark.address);
    }
    ImGui::PopFont();
    const std::string key = keyOf(context, place);
    tooltip("Go to " + name + (key.empty() ? "" : " (" + key + ")"));
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0F);
    textField("##note", "note", mark.note);
    ImGui::TableNextColumn();
    const bool gone = ImGui::SmallButton("x");
    tooltip("Remove this bookmark");
    return gone;
}

void drawBookmarks(const PanelContext& context) {
    Bookmarks& marks = context.state<Bookmarks>();
    heading(context, "Bookmarks", marks.empty() ? "" : std::to_string(marks.size()));
    if (marks.empty()) {
        const std::string key = context.key("notes.bookmark");
        dimText(key + " sets or removes a bookmark at this decision.");
        return;
    }
    if (!ImGui::BeginTable("##marks", 3, ImGuiTableFlags_SizingStretchSame)) return;
    ImGui::TableSetupColumn("address", ImGuiTableColumnFlags_WidthFixed, 7.5F * context.em);
    ImGui::TableSetupColumn("note", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("away", ImGuiTableColumnFlags_WidthFixed, 1.4F * context.em);
    drawRemovable(marks,
                  [&](Bookmark& mark, std::size_t i) { return drawBookmark(context, mark, i); });
    ImGui::EndTable();
}

}  // namespace

void drawNotes(const PanelContext& context) {
    if (!context.session().ready()) return ImGui::TextDisabled("Nothing is open.");
    drawBookmarks(context);
    ImGui::Spacing();
    heading(context, "Notes");
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 size(room.x, std::max(6.0F * context.em, room.y - 2.0F * context.em));
    textArea("##notes", context.ui().notes, size);
    nameItem(context, "field notes");
    const std::string key = context.key("file.save");
    ImGui::TextDisabled("%s saves them in a session file.", key.c_str());
}

}  // namespace se::view
