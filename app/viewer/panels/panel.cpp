#include "panel.h"

#include <algorithm>
#include <array>
#include <cmath>
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
    return std::get<State&>(
        std::tie(ui.alerts, ui.bookmarks, ui.breakpoints, ui.doctor, ui.tab, ui.watch, ui.browsing,
                 ui.click, ui.compare, ui.exported, ui.facts, ui.goTo, ui.growth, ui.lasso,
                 ui.leaving, ui.ledger, ui.lesson, ui.look, ui.mesh, ui.move, ui.navigation,
                 ui.palette, ui.piece, ui.prepare, ui.query, ui.section, ui.startPage,
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
template ExportForm& PanelContext::state() const;
template FactsCache& PanelContext::state() const;
template FileBrowsing& PanelContext::state() const;
template GoToBox& PanelContext::state() const;
template GrowthPage& PanelContext::state() const;
template KeyWalk& PanelContext::state() const;
template Lasso& PanelContext::state() const;
template LeaveQuestion& PanelContext::state() const;
template LedgerPanel& PanelContext::state() const;
template LessonPanel& PanelContext::state() const;
template LookBack& PanelContext::state() const;
template MeshForm& PanelContext::state() const;
template MoveTool& PanelContext::state() const;
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
    {"Steps", PanelGroup::Steps, drawSteps},
    {kLessonTab, PanelGroup::Understand, drawLesson},
    {"Dial", PanelGroup::Understand, drawDial},
    {"Inspect", PanelGroup::Understand, drawInspect},
    {"Paper", PanelGroup::Understand, drawPaper},
    {kSectionTab, PanelGroup::Understand, drawSection},
    {"Layers", PanelGroup::Understand, drawLayerSwitches},
    {"Notes", PanelGroup::Understand, drawNotes},
    {"Rings", PanelGroup::Understand, drawRings},
    {kAlertsTab, PanelGroup::Find, drawAlerts, alertsLine},
    {kLedgerTab, PanelGroup::Find, drawLedger},
    {kQueryTab, PanelGroup::Find, drawQuery},
    {kBreakpointsTab, PanelGroup::Find, drawBreakpoints},
    {kWatchTab, PanelGroup::Find, drawWatch},
    {kChartsTab, PanelGroup::Find, drawCharts},
    {kDoctorTab, PanelGroup::Change, drawDoctor, doctorLine},
    {kRulesTab, PanelGroup::Change, drawRules},
    {kWhatIfTab, PanelGroup::Change, drawWhatIf},
    {kPrepareTab, PanelGroup::Change, drawPrepare},
});

constexpr const char* kHiddenNote =
    "The other panels are hidden until the question is answered, or its answer shown.";

constexpr std::array kAllGroups = {PanelGroup::Steps, PanelGroup::Understand, PanelGroup::Find,
                                   PanelGroup::Change};

/// The column on the left: steps above rings.
void drawLeftColumn(const PanelContext& context) {
    Rect steps = context.rects.left;
    steps.size.y -= context.rects.rings.size.y;
    if (beginRegion("Steps", steps)) drawSteps(context);
    ImGui::End();
    if (context.rects.rings.size.y <= 0.0F) return;
    if (beginRegion("Rings", context.rects.rings)) drawRings(context);
    ImGui::End();
}

/// Learn has the groups on the left.
void drawLearnColumn(const PanelContext& context) {
    if (beginRegion("##learn", context.rects.left))
        drawGroups(context, std::span(kAllGroups).subspan(1));
    ImGui::End();
}

void drawDialColumn(const PanelContext& context) {
    if (beginRegion("##dialColumn", context.rects.dial, ImGuiWindowFlags_NoScrollWithMouse))
        drawDial(context);
    ImGui::End();
}

/// A narrow window has all groups here.
void drawRightColumn(const PanelContext& context) {
    const PanelRects& l = context.rects;
    const std::size_t first = l.narrow ? 0 : 1;
    const std::size_t count = l.groupsApart ? 1 : kAllGroups.size() - first;
    if (beginRegion("##right", l.right))
        drawGroups(context, std::span(kAllGroups).subspan(first, count));
    ImGui::End();
}

/// While a question is open: the lesson at its usual place, and no other panel.
void drawColumnsOfQuestion(const PanelContext& context) {
    const PanelRects& l = context.rects;
    drawMenuBar(context);
    const bool right = l.layoutPreset == LayoutPreset::Debug;
    if (beginRegion(right ? "##right" : "##learn", right ? l.right : l.left)) drawLesson(context);
    ImGui::End();
    if (beginRegion("##hidden", l.drawer)) dimText(kHiddenNote);
    ImGui::End();
}

/// Panels around the view; Present has none of them.
void drawColumns(const PanelContext& context) {
    if (context.rects.layoutPreset == LayoutPreset::Present) return;
    if (context.state<LessonPanel>().hides()) return drawColumnsOfQuestion(context);
    drawMenuBar(context);
    drawTransport(context);
    drawStatusBar(context);
    if (context.rects.layoutPreset == LayoutPreset::Compare) return drawCompareColumn(context);
    openWantedTab(context);
    if (context.rects.dialApart) drawDialColumn(context);
    if (context.rects.layoutPreset == LayoutPreset::Learn) return drawLearnColumn(context);
    if (!context.rects.narrow) drawLeftColumn(context);
    drawRightColumn(context);
    if (context.rects.groupsApart) drawLowerGroups(context);
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
    // The window clips at its padding.
    list->PushClipRectFullScreen();
    const auto horizontal = [&](float y) {
        list->AddRectFilled({0.0F, y}, {l.menu.size.x, y + 1.0F}, color);
    };
    const float top = l.title.size.y > 0.0F ? l.title.min.y : l.view.min.y;
    const float lower = l.groupsApart ? l.find.min.y : l.drawer.min.y;
    const auto vertical = [&](float x, float from, float to) {
        list->AddRectFilled({x, from}, {x + 1.0F, to}, color);
    };
    horizontal(l.transport.max().y);
    horizontal(l.drawer.min.y);
    horizontal(l.status.min.y);
    if (l.left.size.x > 0.0F) vertical(l.left.max().x, top, lower);
    if (l.right.size.x > 0.0F) vertical(l.right.min.x, top, l.drawer.min.y);
    if (l.otherView.min.x > l.view.min.x) {
        // In Present the caption below is that of both views.
        const bool two = l.otherNarration.size.x > 0.0F;
        vertical(l.otherView.min.x, top, two ? lower : l.narration.min.y);
    }
    if (l.groupsApart) vertical(l.change.min.x, lower, l.drawer.min.y);
    const auto above = [&](const Rect& area) {
        list->AddRectFilled(toVec2(area.min), {area.max().x, area.min.y + 1.0F}, color);
    };
    if (l.dialApart) above(l.layoutPreset == LayoutPreset::Learn ? l.dial : l.right);
    if (l.rings.size.y > 0.0F) above(l.rings);
    if (l.groupsApart) above({l.find.min, {l.right.min.x, 0.0F}});
    list->AddRectFilled(toVec2(l.narration.min),
                        {l.narration.max().x + l.otherNarration.size.x, l.narration.min.y + 1.0F},
                        color);
    list->PopClipRect();
    ImGui::End();
}

/// A line between the two views of a picture without panels.
void drawDivider(const PanelContext& context) {
    const PanelRects& l = context.rects;
    if (l.otherView.min.x <= l.view.min.x) return;
    const float wide = std::max(1.0F, std::round(kDividerEms * context.em));
    ImGui::GetForegroundDrawList()->AddRectFilled(toVec2(l.otherTitle.min),
                                                  {l.otherTitle.min.x + wide, l.otherView.max().y},
                                                  toU32(context.palette.border));
}

/// The view of a picture, with what is chosen beside it.
void drawPictureAlone(const PanelContext& context) {
    drawView(context);
    if (context.rects.layoutPreset == LayoutPreset::Compare) {
        drawComparedViews(context);
        drawDivider(context);
    }
    if (context.rects.dialApart) drawDialColumn(context);
    if (context.ui().picture.caption) drawNarration(context);
}

/// Over everything.
void drawBlankScreen(const PanelContext& context) {
    BlankScreen& blank = context.ui().blank;
    if (blank == BlankScreen::None) return;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) blank = BlankScreen::None;
    const ImU32 color = blank == BlankScreen::White ? IM_COL32_WHITE : IM_COL32_BLACK;
    ImGui::GetForegroundDrawList()->AddRectFilled({0.0F, 0.0F}, ImGui::GetIO().DisplaySize, color);
}

}  // namespace

std::span<const SidePanel> sidePanels() { return kSidePanels; }

PanelPlace placeOf(const PanelRects& rects, const SidePanel& panel) {
    const bool debug = rects.layoutPreset == LayoutPreset::Debug;
    const bool apart = (panel.draw == drawDial && rects.dialApart) ||
                       (panel.draw == drawRings && rects.rings.size.y > 0.0F) ||
                       (panel.draw == drawSteps && debug && !rects.narrow);
    if (apart) return PanelPlace::Apart;
    const bool left = panel.draw == drawSteps || panel.draw == drawRings;
    return left && !debug ? PanelPlace::Nowhere : PanelPlace::Tab;
}

void drawPanels(const PanelContext& context) {
    context.state<Navigation>().pointedAt = kNone;
    context.state<VerdictCard>().pointedAt = false;
    context.state<KeyWalk>().begin();
    context.state<Navigation>().pointedRing = kNone;
    context.where() = {
        {"region view", context.rects.view},           {"region left", context.rects.left},
        {"region dial", context.rects.dial},           {"region right", context.rects.right},
        {"region narration", context.rects.narration}, {"region drawer", context.rects.drawer},
        {"region find", context.rects.find},           {"region change", context.rects.change}};
    keepSteps(context);
    if (context.ui().picture.viewAlone) return drawPictureAlone(context);
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
        if (context.rects.otherView.size.x > 0.0F) drawComparedViews(context);
        drawNarration(context);
        if (!context.state<LessonPanel>().hides()) drawDrawer(context);
    }
    if (!startPage && !growth) drawSplitters(context);
    context.session().highlights().hover(context.state<Navigation>().pointedAt);
    context.session().highlights().hoverRing(context.state<Navigation>().pointedRing);
    if (!startPage && !growth && !context.ui().coversView()) drawBorders(context);
    if (!growth && !startPage) drawWhatIfBanner(context);
    if (!growth && !context.state<PieceTool>().on && !context.state<LessonPanel>().hides())
        drawVerdict(context);
    if (!growth && !startPage) drawPieceStrip(context);
    if (!growth) drawNotices(context);
    drawFileBrowser(context);
    drawCheatSheet(context);
    drawHelp(context);
    drawKeyEditor(context);
    drawCommandPalette(context);
    drawSubjectMenu(context);
    drawLeaveQuestion(context);
    drawBlankScreen(context);
}

}  // namespace se::view
