// The command palette: all commands, filtered by the typed words.
#include <algorithm>

#include "commands/commands.h"
#include "document/ui_state.h"
#include "input/key_routing.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"

namespace se::view {

namespace {

bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

/// The arrows move through the matches; returns true if Enter was pressed.
bool moveChoice(CommandPalette& palette, std::size_t matches) {
    const auto last = static_cast<int>(matches) - 1;
    if (pressed(ImGuiKey_DownArrow)) ++palette.chosen;
    if (pressed(ImGuiKey_UpArrow)) --palette.chosen;
    palette.chosen = std::clamp(palette.chosen, 0, std::max(0, last));
    return enterPressed();
}

/// One row: title, group, keys. True if it was clicked.
bool drawMatch(const PanelContext& context, const PaletteEntry& entry, bool chosen) {
    const std::string label =
        std::string(entry.title) + "##" + std::string(entry.note) + std::string(entry.id);
    const bool clicked = ImGui::Selectable(label.c_str(), chosen);
    if (ImGui::IsItemVisible()) context.where()["found " + std::string(entry.id)] = lastItem();
    const bool action = entry.kind == PaletteEntry::Kind::Action;
    const std::string keys = action ? context.key(entry.id) : std::string{};
    const std::string note = std::string(entry.note) + (keys.empty() ? "" : "   " + keys);
    dimAtRight(note, 0.3F * context.em);
    if (chosen) ImGui::SetScrollHereY(0.5F);
    return clicked;
}

std::vector<PaletteEntry> matchesNow(const CommandPalette& palette) {
    return matchingEntries(paletteEntries(), palette.filter.data());
}

}  // namespace

void drawCommandPalette(const PanelContext& context) {
    CommandPalette& palette = context.state<CommandPalette>();
    if (!palette.open) return;
    const float em = context.em;
    const glm::vec2 screen = context.rects.window;
    const float width = std::min(36.0F * em, screen.x - 2.0F * em);
    ImGui::SetNextWindowPos({0.5F * screen.x, context.rects.view.min.y + em}, ImGuiCond_Always,
                            {0.5F, 0.0F});
    ImGui::SetNextWindowSize({width, std::min(22.0F * em, 0.7F * screen.y)});
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool shown =
        ImGui::Begin("##palette", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNavInputs);
    ImGui::PopStyleVar();
    if (shown) {
        if (palette.justOpened) ImGui::SetKeyboardFocusHere();
        // After a click beside the line it gets the keyboard focus back.
        palette.justOpened = ImGui::IsMouseReleased(ImGuiMouseButton_Left);
        ImGui::SetNextItemWidth(-1.0F);
        if (ImGui::InputTextWithHint("##filter", "Type an action, a panel or a scene",
                                     palette.filter.data(), palette.filter.size()))
            palette.chosen = 0;
        if (ImGui::IsItemActive()) context.state<TypingWait>().takesKeys();
        const std::vector<PaletteEntry> matches = matchesNow(palette);
        const bool enter = moveChoice(palette, matches.size());
        const PaletteEntry* picked = nullptr;
        if (ImGui::BeginChild("##matches", {0, 0}, false, ImGuiWindowFlags_NoNavInputs)) {
            for (std::size_t i = 0; i < matches.size(); ++i) {
                const bool chosen = static_cast<int>(i) == palette.chosen;
                if (drawMatch(context, matches[i], chosen) || (chosen && enter))
                    picked = &matches[i];
            }
            if (matches.empty()) ImGui::TextDisabled("No matches. Esc closes.");
        }
        ImGui::EndChild();
        if (picked != nullptr) {
            palette.open = false;
            context.ui().closesPopups = true;
            choose(*picked, context.commands);
        }
    }
    ImGui::End();
}

}  // namespace se::view
