// Names of tabs are never cut. If all rows fit into a share of the column's height, all names are
// shown; otherwise as many as fit into fewer rows, and a button lists the rest.

#include <algorithm>
#include <string>
#include <vector>

#include "input/tab_order.h"
#include "panel_state/side_panels.h"
#include "widgets.h"

namespace se::view {

namespace {

constexpr int kMaxRows = 4;
/// Limits as shares of the height of the column: for all names, and for some of them if all do not
/// fit.
constexpr float kMaxOfHeight = 0.3F;
constexpr float kShareOfSome = 0.2F;
constexpr const char* kMorePopup = "##moreTabs";
/// In em: margin beside a name, and distance between tabs.
constexpr float kPad = 0.36F;
constexpr float kGap = 0.12F;

float widthOf(const PanelContext& context, const std::string& title) {
    return textWidth(title) + 2.0F * kPad * context.em;
}

float tabRowHeight(const PanelContext& context) {
    return ImGui::GetTextLineHeight() + 0.5F * context.em;
}

/// Each column remembers its own tab: that of Learn differs from that of Debug.
int& openTabOfColumn() { return *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("##openTab")); }

int idOf(const SidePanel& panel) { return static_cast<int>(ImGui::GetID(panel.title)); }

/// The requested tab, otherwise the open one, otherwise the first.
const SidePanel* openTab(const PanelContext& context, ColumnTabs tabs) {
    std::string& wanted = context.state<OpenTab>().wanted;
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

/// Names side by side in rows that are filled one after the other.
class RowFill {
  public:
    RowFill(const PanelContext& context, float room) : gap_(kGap * context.em), room_(room) {}
    /// True if a name of this width is in the row of the previous one.
    bool add(float width) {
        const bool beside = x_ > 0.0F && x_ + width <= room_;
        if (!beside) {
            ++rows_;
            x_ = 0.0F;
        }
        x_ += width + gap_;
        return beside;
    }
    int rows() const { return rows_; }

  private:
    float gap_;
    float room_;
    float x_ = 0.0F;
    int rows_ = 0;
};

/// The tabs of a column: those with a name in the rows, and those in the list at their end.
struct SortedTabs {
    std::vector<const SidePanel*> shown;
    std::vector<const SidePanel*> more;
};

std::string moreText(std::size_t count) { return std::to_string(count) + " more..."; }

int rowsOf(const PanelContext& context, const SortedTabs& tabs) {
    RowFill fill(context, ImGui::GetContentRegionAvail().x);
    for (const SidePanel* panel : tabs.shown) fill.add(widthOf(context, panel->title));
    if (!tabs.more.empty()) fill.add(widthOf(context, moreText(tabs.more.size())));
    return fill.rows();
}

/// The first `count` have a name in the rows, and the open one.
SortedTabs sortedAt(ColumnTabs tabs, std::size_t count, const SidePanel& open) {
    SortedTabs sorted;
    for (std::size_t i = 0; i < tabs.size(); ++i) {
        (i < count || tabs[i] == &open ? sorted.shown : sorted.more).push_back(tabs[i]);
    }
    return sorted;
}

/// All in the rows if there is room, otherwise as many as fit: no name is ever cut.
SortedTabs sorted(const PanelContext& context, ColumnTabs tabs, const SidePanel& open) {
    const float height = ImGui::GetContentRegionAvail().y;
    SortedTabs all = sortedAt(tabs, tabs.size(), open);
    const int needed = rowsOf(context, all);
    if (needed <= kMaxRows &&
        static_cast<float>(needed) * tabRowHeight(context) <= kMaxOfHeight * height)
        return all;
    const int rows = std::max(1, static_cast<int>(kShareOfSome * height / tabRowHeight(context)));
    std::size_t count = tabs.size();
    while (count > 0 && rowsOf(context, sortedAt(tabs, count, open)) > rows) --count;
    return sortedAt(tabs, count, open);
}

/// A name; true if it was clicked. `lit`: the name of the open tab.
bool drawName(const PanelContext& context, const std::string& title, bool lit) {
    const Palette& palette = context.palette;
    ImGui::PushStyleColor(ImGuiCol_Button,
                          toVec4(lit ? palette.panelRaised : palette.panel.withAlpha(0.0F)));
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(lit ? palette.text : palette.textDim));
    const bool clicked =
        ImGui::Button(title.c_str(), {widthOf(context, title), tabRowHeight(context)});
    ImGui::PopStyleColor(2);
    return clicked;
}

/// The names that do not fit, in a list.
void drawMore(const PanelContext& context, const std::vector<const SidePanel*>& more,
              const SidePanel*& chosen) {
    if (drawName(context, moreText(more.size()), false)) ImGui::OpenPopup(kMorePopup);
    nameItem(context, "more tabs", "Panels that do not fit here");
    ImGui::PushFont(context.fonts.text);
    if (ImGui::BeginPopup(kMorePopup)) {
        for (const SidePanel* panel : more) {
            if (ImGui::MenuItem(panel->title)) chosen = panel;
            nameItem(context, std::string("more ") + panel->title);
        }
        ImGui::EndPopup();
    }
    ImGui::PopFont();
}

void drawTabs(const PanelContext& context, const SortedTabs& tabs, const SidePanel*& chosen) {
    const SidePanel* open = chosen;
    RowFill fill(context, ImGui::GetContentRegionAvail().x);
    for (const SidePanel* panel : tabs.shown) {
        if (fill.add(widthOf(context, panel->title))) ImGui::SameLine();
        if (drawName(context, panel->title, panel == open)) chosen = panel;
        const Rect place = lastItem();
        context.where()[std::string("tab ") + panel->title] = place;
        if (panel != open) continue;
        ImGui::GetWindowDrawList()->AddRectFilled({place.min.x, place.max().y - 0.12F * context.em},
                                                  toVec2(place.max()),
                                                  toU32(context.palette.accent));
        if (context.state<KeyWalk>().offer(KeyStop::Tabs)) takeKeyboard();
    }
    if (tabs.more.empty()) return;
    if (fill.add(widthOf(context, moreText(tabs.more.size())))) ImGui::SameLine();
    drawMore(context, tabs.more, chosen);
}

}  // namespace

const SidePanel* drawTabRows(const PanelContext& context, ColumnTabs tabs) {
    const SidePanel* chosen = openTab(context, tabs);
    ImGui::PushFont(context.fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap * context.em, 0.0F});
    const float room = ImGui::GetContentRegionAvail().x;
    drawTabs(context, sorted(context, tabs, *chosen), chosen);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    const ImVec2 end = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine({end.x, end.y}, {end.x + room, end.y},
                                        toU32(context.palette.border));
    ImGui::Dummy({0.0F, 0.1F * context.em});
    openTabOfColumn() = idOf(*chosen);
    context.state<OpenTab>().title = chosen->title;
    return chosen;
}

}  // namespace se::view
