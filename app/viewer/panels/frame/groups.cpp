// The panels in their groups: Understand in the right column, Find and Change side by side below
// the view. Where that has no room, one column has all of them, with a row that chooses the group.
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "input/tab_order.h"
#include "panel_state/ui_state.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

namespace {

constexpr std::array<const char*, kPanelGroupCount> kGroupNames = {"Steps", "Understand", "Find",
                                                                   "Change"};

using ColumnTabs = std::span<const SidePanel* const>;

std::size_t numberOf(PanelGroup group) { return static_cast<std::size_t>(group); }

/// The panels of a group that are tabs. In Learn the lesson and the rule come first; elsewhere the
/// lesson is there while one is open.
std::vector<const SidePanel*> tabsOf(const PanelContext& context, PanelGroup group) {
    std::vector<const SidePanel*> tabs;
    const bool learn = context.rects.layoutPreset == LayoutPreset::Learn;
    for (const SidePanel& panel : sidePanels()) {
        if (panel.group != group || placeOf(context.rects, panel) != PanelPlace::Tab) continue;
        if (panel.draw == drawLesson && !learn && !context.state<LessonPanel>().walk.isOpen())
            continue;
        const bool rule = learn && panel.draw == drawPaper;
        tabs.insert(rule ? tabs.begin() + 1 : tabs.end(), &panel);
    }
    return tabs;
}

/// Title of the open tab of a group; it differs in Learn.
std::string& openTitle(const PanelContext& context, PanelGroup group) {
    OpenTab& tab = context.state<OpenTab>();
    const bool learn = context.rects.layoutPreset == LayoutPreset::Learn;
    return (learn ? tab.learn : tab.open)[numberOf(group)];
}

const SidePanel* openPanel(const PanelContext& context, PanelGroup group, ColumnTabs tabs) {
    const std::string& title = openTitle(context, group);
    const auto found = std::find_if(tabs.begin(), tabs.end(),
                                    [&](const SidePanel* each) { return each->title == title; });
    if (found != tabs.end()) return *found;
    // Before a tab was chosen: the rule, not the list of lessons.
    const bool list = tabs.front()->draw == drawLesson && tabs.size() > 1;
    return tabs[list ? 1 : 0];
}

/// Opens a tab at the user's request.
void open(const PanelContext& context, const SidePanel& panel) {
    OpenTab& tab = context.state<OpenTab>();
    openTitle(context, panel.group) = tab.title = panel.title;
    tab.group = panel.group;
    tab.asked[numberOf(panel.group)] = true;
    context.settings().panels.folded = false;
}

/// The line of the open panel, if the user did not open it.
std::string quietLine(const PanelContext& context, PanelGroup group, const SidePanel& panel) {
    const bool asked = context.state<OpenTab>().asked[numberOf(group)];
    const bool apart = group == PanelGroup::Find || group == PanelGroup::Change;
    return !apart || asked || panel.line == nullptr ? std::string{} : panel.line(context);
}

bool isQuiet(const PanelContext& context, PanelGroup group) {
    return !quietLine(context, group, *openPanel(context, group, tabsOf(context, group))).empty();
}

KeyStop tabsStop(const PanelContext& context, PanelGroup group) {
    if (!context.rects.groupsApart) return KeyStop::Tabs;
    return group == PanelGroup::Find     ? KeyStop::FindTabs
           : group == PanelGroup::Change ? KeyStop::ChangeTabs
                                         : KeyStop::Tabs;
}

KeyStop contentStop(const PanelContext& context, PanelGroup group) {
    const KeyStop tabs = tabsStop(context, group);
    return tabs == KeyStop::FindTabs     ? KeyStop::Find
           : tabs == KeyStop::ChangeTabs ? KeyStop::Change
                                         : KeyStop::Content;
}

void drawContent(const PanelContext& context, PanelGroup group, const SidePanel& panel) {
    // Each scrolls by itself.
    ImGui::PushID(panel.title);
    if (ImGui::BeginChild("##content", {0, 0}, false)) {
        // Steps and Rings have rows of their own to begin with.
        const bool rows = panel.draw == drawSteps || panel.draw == drawRings;
        if (!rows && context.state<KeyWalk>().offer(contentStop(context, group)))
            takeKeyboardHere();
        panel.draw(context);
    }
    ImGui::EndChild();
    ImGui::PopID();
}

/// The row of tabs, and the content of the open one; a group of one panel has no row.
void drawGroup(const PanelContext& context, PanelGroup group) {
    const std::vector<const SidePanel*> tabs = tabsOf(context, group);
    const SidePanel* panel = openPanel(context, group, tabs);
    OpenTab& tab = context.state<OpenTab>();
    const bool apart = context.rects.groupsApart && group != PanelGroup::Understand;
    if (tab.title.empty() && !apart) tab.title = panel->title;
    if (tabs.size() > 1) {
        std::vector<TabName> names;
        names.reserve(tabs.size());
        for (const SidePanel* each : tabs) names.push_back({each->title, "tab", each == panel});
        const TabRow row{names, tabsStop(context, group), apart ? 2.0F * context.em : 0.0F};
        if (const auto chosen = drawTabRow(context, row)) {
            panel = tabs[*chosen];
            open(context, *panel);
        }
    }
    if (apart && context.settings().panels.folded) return;
    const std::string line = quietLine(context, group, *panel);
    if (line.empty()) return drawContent(context, group, *panel);
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.textDim));
    ImGui::TextUnformatted(fitted(line, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
    nameItem(context, std::string("quiet ") + panel->title, line);
}

/// A chevron that folds Find and Change to their tabs, and unfolds them.
void drawFold(const PanelContext& context) {
    const float em = context.em;
    const bool closed = context.settings().panels.folded || context.ui().panelsQuiet;
    const Rect& area = context.rects.change;
    ImGui::SetCursorScreenPos({area.max().x - 2.0F * em, area.min.y + 0.6F * em});
    if (ImGui::InvisibleButton("##foldGroups", {1.4F * em, 1.4F * em})) context.run("view.groups");
    nameItem(context, "fold groups",
             std::string(closed ? "Unfold" : "Fold") + " Find and Change (" +
                 context.key("view.groups") + ")");
    const bool hovered = ImGui::IsItemHovered();
    drawChevron(context, lastItem(), closed, hovered);
}

}  // namespace

void openWantedTab(const PanelContext& context) {
    std::string& wanted = context.state<OpenTab>().wanted;
    const bool byFinding = std::exchange(context.state<OpenTab>().byFinding, false);
    if (wanted.empty()) return;
    const auto all = sidePanels();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const SidePanel& p) { return p.title == wanted; });
    wanted.clear();
    if (found == all.end() || placeOf(context.rects, *found) != PanelPlace::Tab) return;
    if (byFinding && context.rects.groupsApart) {
        openTitle(context, found->group) = context.state<OpenTab>().title = found->title;
    } else {
        open(context, *found);
    }
}

bool groupsAreQuiet(const PanelContext& context) {
    return isQuiet(context, PanelGroup::Find) && isQuiet(context, PanelGroup::Change);
}

void drawGroups(const PanelContext& context, std::span<const PanelGroup> groups) {
    if (groups.size() == 1) return drawGroup(context, groups.front());
    OpenTab& tab = context.state<OpenTab>();
    if (std::find(groups.begin(), groups.end(), tab.group) == groups.end()) tab.group = groups[0];
    std::vector<TabName> names;
    names.reserve(groups.size());
    for (const PanelGroup each : groups)
        names.push_back({kGroupNames[numberOf(each)], "group", each == tab.group});
    if (const auto chosen = drawTabRow(context, {names, std::nullopt, 0.0F})) {
        tab.group = groups[*chosen];
        const std::vector<const SidePanel*> tabs = tabsOf(context, tab.group);
        tab.title = openPanel(context, tab.group, tabs)->title;
    }
    drawGroup(context, tab.group);
}

void drawLowerGroups(const PanelContext& context) {
    if (beginRegion("##find", context.rects.find)) drawGroup(context, PanelGroup::Find);
    ImGui::End();
    if (beginRegion("##change", context.rects.change)) {
        drawFold(context);
        ImGui::SetCursorScreenPos({context.rects.change.min.x + ImGui::GetStyle().WindowPadding.x,
                                   context.rects.change.min.y + ImGui::GetStyle().WindowPadding.y});
        drawGroup(context, PanelGroup::Change);
    }
    ImGui::End();
    // For the layout of the next frame.
    context.ui().panelsQuiet = groupsAreQuiet(context);
}

}  // namespace se::view
