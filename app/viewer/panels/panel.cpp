#include "panel.h"

#include <array>
#include <tuple>
#include <vector>

#include "input/tab_order.h"
#include "panel_state/growth_page.h"
#include "panel_state/side_panels.h"
#include "panel_state/ui_state.h"
#include "panels/widgets/widgets.h"
#include "session/layout_preset.h"
#include "session/session.h"

namespace se::view {

// ---- the context ----------------------------------------------------------------------------

template <class State>
State& PanelContext::state() const {
    UiState& ui = commands.ui;
    return std::get<State&>(std::tie(
        ui.alerts, ui.bookmarks, ui.breakpoints, ui.doctor, ui.tab, ui.watch, ui.browsing, ui.click,
        ui.compare, ui.facts, ui.goTo, ui.growth, ui.lasso, ui.leaving, ui.ledger, ui.look, ui.mesh,
        ui.navigation, ui.palette, ui.piece, ui.prepare, ui.query, ui.section, ui.startPage,
        ui.subjectMenu, ui.typing, ui.verdict, ui.viewDrag, ui.walk, ui.whatIf));
}

template AlertsPanel& PanelContext::state() const;
template Bookmarks& PanelContext::state() const;
template DoctorPanel& PanelContext::state() const;
template OpenTab& PanelContext::state() const;
template WatchPanel& PanelContext::state() const;
template std::vector<Breakpoint>& PanelContext::state() const;
template CommandPalette& PanelContext::state() const;
template ComparePage& PanelContext::state() const;
template DoubleClickFilter& PanelContext::state() const;
template FactsCache& PanelContext::state() const;
template FileBrowsing& PanelContext::state() const;
template GoToBox& PanelContext::state() const;
template GrowthPage& PanelContext::state() const;
template KeyWalk& PanelContext::state() const;
template Lasso& PanelContext::state() const;
template LeaveQuestion& PanelContext::state() const;
template LedgerPanel& PanelContext::state() const;
template LookBack& PanelContext::state() const;
template MeshForm& PanelContext::state() const;
template Navigation& PanelContext::state() const;
template PieceTool& PanelContext::state() const;
template PrepareForm& PanelContext::state() const;
template QueryPanel& PanelContext::state() const;
template SectionPanel& PanelContext::state() const;
template StartPage& PanelContext::state() const;
template SubjectMenu& PanelContext::state() const;
template TypingWait& PanelContext::state() const;
template VerdictCard& PanelContext::state() const;
template ViewDrag& PanelContext::state() const;
template WhatIfForm& PanelContext::state() const;

ViewSettings& PanelContext::settings() const { return commands.ui.settings; }

UiRequests& PanelContext::requests() const { return commands.ui.requests; }

std::map<std::string, Rect>& PanelContext::where() const { return commands.ui.where; }

std::string PanelContext::key(const Command& command) const {
    return commands.ui.settings.keys.first(command);
}

// ---- the window -----------------------------------------------------------------------------

namespace {

constexpr auto kSidePanels = std::to_array<SidePanel>({
    {"Steps", true, 0.66F, drawSteps},
    {"Rings", true, 0.34F, drawRings},
    {"Dial", false, 0.0F, drawDial},
    {"Inspect", false, 0.0F, drawInspect},
    {"Paper", false, 0.0F, drawPaper},
    {kSectionTab, false, 0.0F, drawSection},
    {kRulesTab, false, 0.0F, drawRules},
    {kWhatIfTab, false, 0.0F, drawWhatIf},
    {"Counts", false, 0.0F, drawCounters},
    {"Layers", false, 0.0F, drawLayerSwitches},
    {"Notes", false, 0.0F, drawNotes},
    {kAlertsTab, false, 0.0F, drawAlerts},
    {kBreakpointsTab, false, 0.0F, drawBreakpoints},
    {kWatchTab, false, 0.0F, drawWatch},
    {kDoctorTab, false, 0.0F, drawDoctor},
    {kLedgerTab, false, 0.0F, drawLedger},
    {kQueryTab, false, 0.0F, drawQuery},
    {kChartsTab, false, 0.0F, drawCharts},
});

/// Marks a panel as shown; a panel that is no tab needs no opening.
void markShown(const PanelContext& context, std::string_view title) {
    if (context.ui().tab.wanted == title) context.ui().tab.wanted.clear();
}

void drawLeftColumn(const PanelContext& context) {
    Rect rest = context.rects.left;
    for (const SidePanel& panel : kSidePanels) {
        if (!panel.left) continue;
        Rect area = rest;
        area.size.y = panel.share * context.rects.left.size.y;
        rest.min.y += area.size.y;
        markShown(context, panel.title);
        if (beginRegion(panel.title, area)) {
            if (area.min.y > context.rects.left.min.y) {
                ImGui::GetWindowDrawList()->AddLine(toVec2(area.min), {area.max().x, area.min.y},
                                                    toU32(context.palette.border));
            }
            panel.draw(context);
        }
        ImGui::End();
    }
}

/// In a narrow window all panels are tabs of the right column.
bool isTab(const PanelContext& context, const SidePanel& panel) {
    if (panel.left) return context.rects.narrow;
    return panel.draw != drawDial || !context.rects.dialApart;
}

/// Whether the names of the right column's tabs fit beside each other in the current type.
bool tabNamesFit(const PanelContext& context) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float margins = 2.0F * style.FramePadding.x + style.ItemInnerSpacing.x;
    float width = 0.0F;
    for (const SidePanel& panel : kSidePanels)
        width += isTab(context, panel) ? textWidth(panel.title) + margins : 0.0F;
    return width <= ImGui::GetContentRegionAvail().x;
}

/// Opens the requested tab, once.
ImGuiTabItemFlags wantedFlag(const PanelContext& context, const SidePanel& panel) {
    if (context.ui().tab.wanted != panel.title) return ImGuiTabItemFlags_None;
    context.ui().tab.wanted.clear();
    return ImGuiTabItemFlags_SetSelected;
}

void drawContent(const PanelContext& context, const SidePanel& panel) {
    if (ImGui::BeginChild("##content", {0, 0}, false)) {
        // Steps and Rings have rows of their own to begin with.
        if (!panel.left && context.state<KeyWalk>().offer(KeyStop::Content)) takeKeyboardHere();
        panel.draw(context);
    }
    ImGui::EndChild();
}

void drawTabs(const PanelContext& context) {
    for (const SidePanel& panel : kSidePanels) {
        if (!isTab(context, panel)) continue;
        const bool open = ImGui::BeginTabItem(panel.title, nullptr, wantedFlag(context, panel));
        nameItem(context, std::string("tab ") + panel.title);
        if (!open) continue;
        // The tab that is open, whose content can have the keyboard focus.
        if (context.state<KeyWalk>().offer(KeyStop::Tabs)) takeKeyboard();
        context.ui().tab.title = panel.title;
        ImGui::PushFont(context.fonts.text);
        drawContent(context, panel);
        ImGui::PopFont();
        ImGui::EndTabItem();
    }
}

/// The tabs in rows, and the content of the open one. In Learn the rule comes first, and there is
/// no list of steps.
void drawRowsOfTabs(const PanelContext& context, bool learn) {
    std::vector<const SidePanel*> tabs;
    for (const SidePanel& panel : kSidePanels) {
        if (learn ? panel.left : !isTab(context, panel)) continue;
        tabs.insert(learn && panel.draw == drawPaper ? tabs.begin() : tabs.end(), &panel);
    }
    const SidePanel* open = drawTabRows(context, tabs);
    // Each scrolls by itself.
    ImGui::PushID(open->title);
    drawContent(context, *open);
    ImGui::PopID();
}

/// Learn has the panels as tabs on the left.
void drawLearnColumn(const PanelContext& context) {
    if (beginRegion("##learn", context.rects.left)) drawRowsOfTabs(context, true);
    ImGui::End();
}

void drawDialColumn(const PanelContext& context) {
    if (beginRegion("##dialColumn", context.rects.dial, ImGuiWindowFlags_NoScrollWithMouse)) {
        markShown(context, "Dial");
        drawDial(context);
    }
    ImGui::End();
}

void drawRightColumn(const PanelContext& context) {
    if (beginRegion("##right", context.rects.right)) {
        if (!tabNamesFit(context)) {
            drawRowsOfTabs(context, false);
        } else if (ImGui::BeginTabBar("##tabs")) {
            drawTabs(context);
            ImGui::EndTabBar();
        }
    }
    ImGui::End();
}

/// Panels around the view; Present has none of them.
void drawColumns(const PanelContext& context) {
    if (context.rects.layoutPreset == LayoutPreset::Present) return;
    drawMenuBar(context);
    drawTransport(context);
    drawStatusBar(context);
    if (context.rects.layoutPreset == LayoutPreset::Learn) return drawLearnColumn(context);
    if (context.rects.layoutPreset == LayoutPreset::Compare) return drawCompareColumn(context);
    if (!context.rects.narrow) drawLeftColumn(context);
    if (context.rects.dialApart) drawDialColumn(context);
    drawRightColumn(context);
}

/// A window above those of the regions and below menus and tooltips, which takes no input.
ImDrawList* beginOverRegions(const PanelContext& context) {
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize({context.rects.menu.size.x, context.rects.status.max().y});
    ImGui::Begin("##borders", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    return ImGui::GetWindowDrawList();
}

/// Hairlines between the regions.
void drawBorders(const PanelContext& context) {
    const PanelRects& l = context.rects;
    const ImU32 color = toU32(context.palette.border);
    ImDrawList* list = beginOverRegions(context);
    const auto horizontal = [&](float y) {
        list->AddRectFilled({0.0F, y}, {l.menu.size.x, y + 1.0F}, color);
    };
    const float top = l.title.size.y > 0.0F ? l.title.min.y : l.view.min.y;
    const auto vertical = [&](float x) {
        list->AddRectFilled({x, top}, {x + 1.0F, l.drawer.min.y}, color);
    };
    horizontal(l.transport.max().y);
    horizontal(l.drawer.min.y);
    horizontal(l.status.min.y);
    if (l.left.size.x > 0.0F) vertical(l.left.max().x);
    if (l.right.size.x > 0.0F) vertical(l.right.min.x);
    if (l.otherView.min.x > l.view.min.x) vertical(l.otherView.min.x);
    if (l.dialApart) {
        list->AddRectFilled(toVec2(l.right.min), {l.right.max().x, l.right.min.y + 1.0F}, color);
    }
    list->AddRectFilled(toVec2(l.narration.min),
                        {l.narration.max().x + l.otherNarration.size.x, l.narration.min.y + 1.0F},
                        color);
    ImGui::End();
}

}  // namespace

std::span<const SidePanel> sidePanels() { return kSidePanels; }

void drawPanels(const PanelContext& context) {
    context.state<Navigation>().pointedAt = kNone;
    context.state<KeyWalk>().begin();
    context.state<Navigation>().pointedRing = kNone;
    context.where() = {
        {"region view", context.rects.view},           {"region left", context.rects.left},
        {"region dial", context.rects.dial},           {"region right", context.rects.right},
        {"region narration", context.rects.narration}, {"region drawer", context.rects.drawer}};
    keepSteps(context);
    if (context.ui().picture.viewAlone) return drawView(context);
    const bool growth = context.state<GrowthPage>().open;
    const bool startPage = context.session().startPage() && !growth;
    if (growth) {
        drawMenuBar(context);
        drawGrowthPage(context);
    } else if (startPage) {
        drawMenuBar(context);
        drawStartPage(context);
    } else {
        drawColumns(context);
        drawView(context);
        if (context.rects.layoutPreset == LayoutPreset::Compare) drawComparedViews(context);
        drawNarration(context);
        drawDrawer(context);
    }
    context.session().highlights().hover(context.state<Navigation>().pointedAt);
    context.session().highlights().hoverRing(context.state<Navigation>().pointedRing);
    if (!startPage && !growth && !context.ui().coversView()) drawBorders(context);
    if (!growth && !startPage) drawWhatIfBanner(context);
    if (!growth && !context.state<PieceTool>().on) drawVerdict(context);
    if (!growth && !startPage) drawPieceStrip(context);
    if (!growth) drawNotices(context);
    drawFileBrowser(context);
    drawCheatSheet(context);
    drawKeyEditor(context);
    drawCommandPalette(context);
    drawPrepareDialog(context);
    drawSubjectMenu(context);
    drawLeaveQuestion(context);
}

}  // namespace se::view
