#include "panel.h"

#include <algorithm>
#include <cmath>

#include "document/ui_state.h"
#include "input/key_routing.h"
#include "panel_state/forms.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/widgets.h"
#include "session/layout_preset.h"
#include "session/playback.h"
#include "session/session.h"

namespace se::view {

// ---- the context ----------------------------------------------------------------------------

Moves& PanelContext::pausedMoves() const {
    playback().pause();
    return session().moves();
}

PanelStates& PanelContext::states() const { return commands.ui.states; }

ViewSettings& PanelContext::settings() const { return commands.ui.settings; }

std::map<std::string, Rect>& PanelContext::where() const { return commands.ui.where; }

std::string PanelContext::key(const Command& command) const {
    return commands.ui.settings.keys.first(command);
}

// ---- the window -----------------------------------------------------------------------------

namespace {

constexpr const char* kHiddenNote =
    "The other panels are hidden until the question is answered, or its answer shown.";

/// Panels around the view; Present has the strip alone, and during a question there is none but the
/// lesson.
void drawAround(const PanelContext& context) {
    if (context.rects.layoutPreset == LayoutPreset::Present) return drawStrip(context);
    drawMenuBar(context);
    drawColumn(context);
    if (!context.state<LessonPanel>().hides()) {
        drawRail(context);
        return drawStrip(context);
    }
    if (context.rects.phone) return;
    beginRegion("##rail", context.rects.rail);
    ImGui::End();
    if (beginRegion("##strip", context.rects.strip)) dimText(kHiddenNote);
    ImGui::End();
}

/// A window above those of the regions and below menus and tooltips, which takes no input.
ImDrawList* beginOverRegions(const PanelContext& context) {
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(toVec2(context.rects.window));
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
    const auto horizontal = [&](float y, float from, float to) {
        list->AddRectFilled({from, y}, {to, y + 1.0F}, color);
    };
    const auto vertical = [&](float x, float from, float to) {
        list->AddRectFilled({x, from}, {x + 1.0F, to}, color);
    };
    const float width = l.window.x;
    horizontal(l.menu.max().y, 0.0F, width);
    for (const Rect& each : {l.strip, l.narration})
        if (each.size.y > 0.0F) horizontal(each.min.y, each.min.x, each.max().x);
    if (l.phone) {
        for (const Rect& each : {l.rail, l.column})
            if (each.size.y > 0.0F) horizontal(each.min.y, 0.0F, width);
    } else {
        for (const Rect& each : {l.column, l.rail})
            if (each.size.x > 0.0F) vertical(each.min.x, each.min.y, each.max().y);
    }
    if (l.otherView.min.x > l.view.min.x)
        vertical(l.otherView.min.x, l.viewsTop(), l.otherView.max().y);
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

/// The dial beside the view of a picture.
void drawDialBeside(const PanelContext& context) {
    const bool open =
        beginRegion("##dialColumn", context.rects.dial, ImGuiWindowFlags_NoScrollWithMouse);
    if (open && context.session().ready()) drawDial(context);
    ImGui::End();
}

/// The view of a picture, with what is chosen beside it.
void drawPictureAlone(const PanelContext& context) {
    drawView(context);
    if (context.rects.layoutPreset == LayoutPreset::Compare) {
        drawComparedViews(context);
        drawDivider(context);
    }
    if (context.rects.dial.size.x > 0.0F) drawDialBeside(context);
    drawNarration(context);
}

/// Covers everything while the screen is blanked.
void drawBlankScreen(const PanelContext& context) {
    BlankScreen& blank = context.ui().blank;
    if (blank == BlankScreen::None) return;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) blank = BlankScreen::None;
    const ImU32 color = blank == BlankScreen::White ? IM_COL32_WHITE : IM_COL32_BLACK;
    ImGui::GetForegroundDrawList()->AddRectFilled({0.0F, 0.0F}, ImGui::GetIO().DisplaySize, color);
}

void drawAll(const PanelContext& context) {
    context.state<Navigation>().pointedAt = kNone;
    context.state<VerdictPart>().pointedAt = false;
    context.state<KeyWalk>().begin();
    context.state<Navigation>().pointedRing = kNone;
    context.where() = {
        {"region view", context.rects.view},           {"region column", context.rects.column},
        {"region rail", context.rects.rail},           {"region strip", context.rects.strip},
        {"region narration", context.rects.narration}, {"region left", context.rects.left}};
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
        drawAround(context);
        drawView(context);
        if (context.rects.otherView.size.x > 0.0F) drawComparedViews(context);
        drawNarration(context);
        drawSplitter(context);
    }
    context.session().highlights().hover(context.state<Navigation>().pointedAt);
    context.session().highlights().hoverRing(context.state<Navigation>().pointedRing);
    if (!startPage && !growth && !context.ui().coversView()) drawBorders(context);
    if (!growth && !startPage) drawWhatIfBanner(context);
    if (!growth && !startPage) drawPieceStrip(context);
    if (!growth) drawNotices(context);
    drawFileBrowser(context);
    drawHelp(context);
    drawKeySheet(context);
    drawCommandPalette(context);
    drawSubjectMenu(context);
    drawLeaveQuestion(context);
    drawBlankScreen(context);
}

}  // namespace

void drawPanels(const PanelContext& context) {
    // In a phone's shape buttons and fields are as high as a finger needs.
    const float usual = ImGui::GetStyle().FramePadding.y;
    const float finger = 0.5F * (kFinger * context.em - ImGui::GetTextLineHeight());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        {ImGui::GetStyle().FramePadding.x, context.rects.phone ? finger : usual});
    drawAll(context);
    ImGui::PopStyleVar();
}

}  // namespace se::view
