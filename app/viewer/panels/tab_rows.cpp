#include "tab_rows.h"

#include <algorithm>

#include "widgets.h"

namespace se::view {

namespace {

constexpr int kMostRows = 3;
/// Of the height of the column.
constexpr float kMostShare = 0.3F;
/// In em: beside a name, and from one tab to the next.
constexpr float kPad = 0.36F;
constexpr float kGap = 0.12F;

float widthOf(const PanelContext& context, const SidePanel& panel) {
    return ImGui::CalcTextSize(panel.title).x + 2.0F * kPad * context.em;
}

float rowHeight(const PanelContext& context) {
    return ImGui::GetTextLineHeight() + 0.5F * context.em;
}

/// Each column remembers its own: Learn's is another than that of Debug.
int& openTabOfColumn() { return *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("##openTab")); }

int idOf(const SidePanel& panel) { return static_cast<int>(ImGui::GetID(panel.title)); }

/// The tab that was asked for, else the one that is open, else the first.
const SidePanel* openTab(const PanelContext& context, ColumnTabs tabs) {
    std::string& wanted = context.ui().wantedTab;
    for (const SidePanel* panel : tabs) {
        if (wanted != panel->title) continue;
        wanted.clear();
        return panel;
    }
    const int id = openTabOfColumn();
    const auto found = std::find_if(tabs.begin(), tabs.end(),
                                    [&](const SidePanel* each) { return idOf(*each) == id; });
    return found == tabs.end() ? tabs.front() : *found;
}

}  // namespace

bool tabRowsFit(const PanelContext& context, ColumnTabs tabs) {
    ImGui::PushFont(context.fonts.small);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    int rows = 1;
    float x = 0.0F;
    for (const SidePanel* panel : tabs) {
        const float width = widthOf(context, *panel);
        if (x > 0.0F && x + width > room.x) {
            ++rows;
            x = 0.0F;
        }
        x += width + kGap * context.em;
    }
    const float height = static_cast<float>(rows) * rowHeight(context);
    ImGui::PopFont();
    return rows <= kMostRows && height <= kMostShare * room.y;
}

const SidePanel* drawTabRows(const PanelContext& context, ColumnTabs tabs) {
    const SidePanel* open = openTab(context, tabs);
    const SidePanel* chosen = open;
    ImGui::PushFont(context.fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap * context.em, 0.0F});
    const float room = ImGui::GetContentRegionAvail().x;
    float x = 0.0F;
    for (const SidePanel* panel : tabs) {
        const float width = widthOf(context, *panel);
        if (x > 0.0F && x + width <= room) ImGui::SameLine();
        if (x + width > room) x = 0.0F;
        x += width + kGap * context.em;
        const bool on = panel == open;
        ImGui::PushStyleColor(ImGuiCol_Button, toVec4(on ? context.palette.panelRaised
                                                         : context.palette.panel.withAlpha(0.0F)));
        ImGui::PushStyleColor(ImGuiCol_Text,
                              toVec4(on ? context.palette.text : context.palette.textDim));
        if (ImGui::Button(panel->title, {width, rowHeight(context)})) chosen = panel;
        ImGui::PopStyleColor(2);
        const Rect place = lastItem();
        context.ui().where[std::string("tab ") + panel->title] = place;
        if (on) {
            ImGui::GetWindowDrawList()->AddRectFilled(
                {place.min.x, place.max().y - 0.12F * context.em}, toVec2(place.max()),
                toU32(context.palette.accent));
            if (context.ui().walk.offer(KeyStop::Tabs)) takeKeyboard();
        }
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    const ImVec2 end = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine({end.x, end.y}, {end.x + room, end.y},
                                        toU32(context.palette.border));
    ImGui::Dummy({0.0F, 0.1F * context.em});
    openTabOfColumn() = idOf(*chosen);
    context.ui().openTab = chosen->title;
    return chosen;
}

}  // namespace se::view
