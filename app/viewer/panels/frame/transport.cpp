// The transport: step, play, unit and speed.
#include <algorithm>
#include <array>

#include "panel_state/settings.h"
#include "panels/widgets/widgets.h"
#include "session/playback.h"
#include "session/session.h"
#include "strips.h"

namespace se::view {

namespace {

/// Width from which unit and speed are there, in em.
constexpr float kWithSpeed = 20.0F;

struct TransportButton {
    const char* id;
    Icon icon;
    const char* command;
    const char* text;
};

constexpr std::array kBefore = {
    TransportButton{"##start", Icon::SkipStart, "run.start", "To the start"},
    TransportButton{"##pivotBack", Icon::Back, "step.pivot.previous", "Previous pivot"},
    TransportButton{"##back", Icon::StepBack, "step.event.previous", "Previous sub-step"}};
constexpr std::array kAfter = {
    TransportButton{"##on", Icon::StepForward, "step.event.next", "Next sub-step"},
    TransportButton{"##pivotOn", Icon::Forward, "step.pivot.next", "Next pivot"},
    TransportButton{"##end", Icon::SkipEnd, "run.end", "Run to the end"}};

template <std::size_t N>
void drawButtons(const PanelContext& context, const std::array<TransportButton, N>& buttons,
                 bool enabled) {
    for (const TransportButton& b : buttons) {
        const std::string help = withKeys(context, b.text, b.command);
        if (iconButton(b.id, b.icon, help.c_str(), enabled, false, context)) context.run(b.command);
        ImGui::SameLine(0.0F, 0.2F * context.em);
    }
}

void drawSpeed(const PanelContext& context) {
    const Playback& playback = context.playback();
    if (ImGui::Button("\xE2\x88\x92##slower", {1.6F * context.em, 0})) context.run("run.slower");
    tooltip(withKeys(context, "Slower", "run.slower"));
    ImGui::SameLine(0.0F, 0.0F);
    const std::string shown = playback.unlimited() ? "max" : formatted("%.3g/s", playback.rate());
    const float width = 3.4F * context.em;
    const float pad = 0.5F * (width - ImGui::CalcTextSize(shown.c_str()).x);
    const float x = ImGui::GetCursorPosX();
    ImGui::SetCursorPosX(x + pad);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shown.c_str());
    ImGui::SameLine(x + width);
    if (ImGui::Button("+##faster", {1.6F * context.em, 0})) context.run("run.faster");
    tooltip(withKeys(context, "Faster; above 60 a second, as fast as drawn", "run.faster"));
}

/// The unit of playback: a click changes to the next. As wide as the longest name, so that nothing
/// moves.
void drawUnit(const PanelContext& context) {
    float widest = 0.0F;
    for (const PlayUnit unit : {PlayUnit::SubStep, PlayUnit::Pivot, PlayUnit::Event})
        widest = std::max(widest, textWidth(std::string(unitName(unit))));
    const std::string name(unitName(context.playback().unit()));
    const float width = widest + 2.0F * ImGui::GetStyle().FramePadding.x;
    if (ImGui::Button((name + "##unit").c_str(), {width, 0.0F})) context.run("run.unit");
    tooltip(withKeys(context, "Unit of playback and single steps; click for the next", "run.unit"));
}

/// The five buttons that a finger needs, over the whole width.
void drawLarge(const PanelContext& context, const Rect& area) {
    const Session& session = context.session();
    const bool on = session.ready() && !session.atEnd();
    const bool playing = context.playback().playing();
    const std::array<TransportButton, 5> buttons = {
        kBefore[1], kBefore[2],
        TransportButton{"##play", playing ? Icon::Pause : Icon::Play, "run.play",
                        playing ? "Pause" : "Play"},
        kAfter[0], kAfter[1]};
    const float gap = 0.4F * context.em;
    const float width = (area.size.x - 6.0F * gap) / 5.0F;
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        ImGui::SetCursorScreenPos({area.min.x + gap + static_cast<float>(i) * (width + gap),
                                   area.min.y + 0.4F * context.em});
        const TransportButton& each = buttons[i];
        const bool enabled = i < 2 ? !session.atStart() : on;
        if (iconButton(each.id, each.icon, withKeys(context, each.text, each.command).c_str(),
                       enabled, i == 2, context, {width, area.size.y - 0.8F * context.em}))
            context.run(each.command);
    }
}

}  // namespace

void drawTransport(const PanelContext& context, const Rect& area) {
    if (context.rects.phone) return drawLarge(context, area);
    const Session& session = context.session();
    const float em = context.em;
    const float high = ImGui::GetFrameHeight();
    ImGui::SetCursorScreenPos({area.min.x + 0.7F * em, area.min.y + 0.5F * (area.size.y - high)});
    ImGui::BeginGroup();
    drawButtons(context, kBefore, !session.atStart());
    const bool playing = context.playback().playing();
    if (iconButton("##play", playing ? Icon::Pause : Icon::Play,
                   withKeys(context, playing ? "Pause" : "Play", "run.play").c_str(),
                   session.ready() && !session.atEnd(), true, context)) {
        context.run("run.play");
    }
    ImGui::SameLine(0.0F, 0.2F * em);
    drawButtons(context, kAfter, session.ready() && !session.atEnd());
    if (area.size.x > kWithSpeed * em) {
        ImGui::SameLine(0.0F, 0.7F * em);
        drawUnit(context);
        ImGui::SameLine(0.0F, 0.5F * em);
        drawSpeed(context);
    }
    ImGui::EndGroup();
}

}  // namespace se::view
