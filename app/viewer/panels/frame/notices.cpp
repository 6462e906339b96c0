// Notices over the view: progress of long work, errors of the opening, the latest message.
#include <algorithm>
#include <array>
#include <cmath>

#include "document/actions.h"
#include "document/alert_actions.h"
#include "document/ui_state.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

namespace {

/// Width of a notice in the middle of the view, in em.
constexpr float kNotice = 26.0F;

/// By LoadPart.
constexpr std::array kPartNames = {"reading the points", "spreading the points",
                                   "finding neighbors", "preparing the view", "starting the run"};
static_assert(kPartNames.size() == static_cast<std::size_t>(LoadPart::Beginning) + 1);

void drawLoading(const PanelContext& context) {
    Session& session = context.session();
    if (beginOverView(context, "##loading", std::nullopt, kNotice)) {
        const std::string& source = session.input().opening().source;
        heading(context, session.input().isRerunning() ? "Re-running" : "Opening",
                fittedName(source, 16.0F * context.em));
        ImGui::ProgressBar(static_cast<float>(session.input().loadShare()), {-1.0F, 0.0F},
                           kPartNames[static_cast<std::size_t>(session.input().loadPart())]);
        if (textButton(context, "Cancel", "cancel opening")) session.cancelOpening();
    }
    ImGui::End();
}

void drawError(const PanelContext& context) {
    Session& session = context.session();
    if (beginOverView(context, "##error", std::nullopt, kNotice)) {
        ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.rejected));
        heading(context, "Could not open");
        ImGui::PopStyleColor();
        wrappedText(session.input().error());
        ImGui::Spacing();
        if (ImGui::Button("Open another..."))
            actions::openBrowser(context.commands, context.ui().browser);
        ImGui::SameLine();
        if (textButton(context, session.ready() ? "Continue" : "Start page", "go on"))
            session.dismissError();
    }
    ImGui::End();
}

struct Progressed {
    std::string text;
    float share = 0.0F;
};

/// Progress of the runner thread on its way to another pivot.
Progressed moved(const Session& session) {
    const RunOverview& run = session.overview();
    const std::uint32_t at = session.moves().runnerPosition();
    const std::uint32_t end =
        std::max(1U, run.complete ? std::min(session.moves().runnerTarget(), run.lastPivot)
                                  : session.moves().runnerTarget());
    if (end == 0xffffffffU) return {"pivot " + grouped(at), 0.0F};
    return {"pivot " + grouped(at) + " of " + grouped(end),
            static_cast<float>(at) / static_cast<float>(end)};
}

/// What is known of the run so far.
Progressed goneThrough(const Session& session) {
    return {"pivot " + grouped(session.overview().lastPivot),
            static_cast<float>(session.madeShare())};
}

/// Progress of a move that takes a while; others are over before this is drawn.
void drawMove(const PanelContext& context) {
    Session& session = context.session();
    if (beginOverView(context, "##move", 1.0F, 22.0F)) {
        const auto hits = static_cast<float>(session.hits().share());
        const Progressed move = session.moves().awaitsStop()     ? Progressed{"hits", hits}
                                : session.moves().awaitsLength() ? goneThrough(session)
                                                                 : moved(session);
        if (session.moves().awaitsStop()) ImGui::TextDisabled("Searching for the breakpoint ...");
        if (session.moves().awaitsLength())
            ImGui::TextDisabled("Running once to find the length of the run ...");
        if (progressAndStop(context, std::min(1.0F, move.share), move.text.c_str(), "stop move",
                            4.5F))
            session.moves().cancel();
        tooltip("Stop (Esc)");
    }
    ImGui::End();
}

/// The latest message, above the sentence of the decision and never instead of it.
void drawSaid(const PanelContext& context) {
    const std::string text = context.session().messages().notice();
    const Rect& view = context.rects.view;
    const float em = context.em;
    const float room = view.size.x - 4.0F * em;
    if (text.empty() || room < 6.0F * em) return;
    const ImVec2 pad(0.7F * em, 0.35F * em);
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str(), nullptr, false, room);
    const ImVec2 low(std::round(view.min.x + 0.5F * (view.size.x - extent.x) - pad.x),
                     std::round(view.max().y - context.ui().coveredBelow * view.size.y - extent.y -
                                2.0F * pad.y - 0.4F * em));
    const ImVec2 high(low.x + extent.x + 2.0F * pad.x, low.y + extent.y + 2.0F * pad.y);
    ImDrawList* list = ImGui::GetForegroundDrawList();
    list->AddRectFilled(low, high, toU32(context.palette.panelRaised), 0.3F * em);
    list->AddRect(low, high, toU32(context.palette.accent), 0.3F * em, 0,
                  std::max(1.0F, 0.08F * em));
    list->AddText(context.fonts.text, em, {low.x + pad.x, low.y + pad.y},
                  toU32(context.palette.text), text.c_str(), nullptr, room);
}

}  // namespace

void drawNotices(const PanelContext& context) {
    const Session& session = context.session();
    // A re-run usually ends before this could be read.
    const bool soon = session.input().isRerunning() && session.input().rerunSeconds() < kLongMove;
    if (session.input().phase() == SessionPhase::Loading && !soon) drawLoading(context);
    if (session.input().phase() == SessionPhase::Failed) drawError(context);
    if (session.input().phase() == SessionPhase::Ready && session.moves().busySeconds() > kLongMove)
        drawMove(context);
    // At the start the caption shows the message permanently: there is no decision.
    // A dialog covers the view.
    const bool narrated = showsFinishedMesh(context.commands) && session.alerts().done() &&
                          session.messages().last() == verdictSentence(session.alerts());
    if (session.ready() && session.event() != nullptr && !context.ui().coversView() && !narrated)
        drawSaid(context);
}

}  // namespace se::view
