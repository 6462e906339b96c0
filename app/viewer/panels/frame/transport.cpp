// The transport bar: step, play, speed, loop marks, and the box of the address.
#include <algorithm>
#include <array>
#include <optional>

#include "input/go_to_box.h"
#include "layout/bars.h"
#include "panel_state/settings.h"
#include "panels/widgets/widgets.h"
#include "session/playback.h"
#include "session/session.h"

namespace se::view {

namespace {

/// Width of the box with the address, in em.
constexpr float kGoTo = 9.5F;

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

/// "Next pivot (F10, .)": with the user's keys.
std::string withKeys(const PanelContext& context, const std::string& text,
                     std::string_view command) {
    const std::string keys = context.settings().keys.all(*findCommand(command));
    return keys.empty() ? text : text + " (" + keys + ")";
}

template <std::size_t N>
void drawButtons(const PanelContext& context, const std::array<TransportButton, N>& buttons,
                 bool enabled) {
    for (const TransportButton& b : buttons) {
        const std::string help = withKeys(context, b.text, b.command);
        if (iconButton(b.id, b.icon, help.c_str(), enabled, false, context)) context.run(b.command);
        ImGui::SameLine(0.0F, 0.2F * context.em);
    }
}

/// A button that is filled while `on`.
bool filledButton(const PanelContext& context, const std::string& label, bool on,
                  float width = 0.0F) {
    const ImVec4 filled = toVec4(context.palette.accent.withAlpha(0.45F));
    ImGui::PushStyleColor(ImGuiCol_Button, on ? filled : ImGui::GetStyleColorVec4(ImGuiCol_Button));
    const bool clicked = ImGui::Button(label.c_str(), {width, 0.0F});
    ImGui::PopStyleColor();
    return clicked;
}

void drawUnit(const PanelContext& context) {
    Playback& playback = context.playback();
    for (const PlayUnit unit : {PlayUnit::SubStep, PlayUnit::Pivot, PlayUnit::Event}) {
        if (filledButton(context, std::string(unitName(unit)), playback.unit() == unit))
            playback.setUnit(unit);
        tooltip(withKeys(context, "Unit of playback and single steps", "run.unit"));
        ImGui::SameLine(0.0F, 0.15F * context.em);
    }
}

void drawSpeed(const PanelContext& context) {
    const Playback& playback = context.playback();
    if (ImGui::Button("\xE2\x88\x92##slower", {1.6F * context.em, 0})) context.run("run.slower");
    tooltip(withKeys(context, "Slower", "run.slower"));
    ImGui::SameLine(0.0F, 0.0F);
    const std::string shown = playback.unlimited() ? "max" : formatted("%g/s", playback.rate());
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

/// The two marks of the loop: filled where they are set.
void drawLoop(const PanelContext& context) {
    struct Mark {
        const char* title;
        const char* command;
        const char* help;
        const std::optional<Address>& at;
    };
    const PlayLoop& loop = context.playback().loop;
    for (const Mark& mark :
         {Mark{"A", "run.loop.start", "Start of the loop", loop.from},
          Mark{"B", "run.loop.end", "End of the loop, which returns to A", loop.to}}) {
        if (filledButton(context, mark.title, mark.at.has_value(), 1.8F * context.em))
            context.run(mark.command);
        std::string help = withKeys(context, mark.help, mark.command);
        if (mark.at) {
            help += "\nNow at " + toString(*mark.at) + ". " +
                    withKeys(context, "Clear loop", "run.loop.clear");
        }
        tooltip(help);
        ImGui::SameLine(0.0F, 0.15F * context.em);
    }
}

/// The typed text; of a long text the part around the caret.
void drawTyped(const PanelContext& context, const GoToBox& box, ImVec2 at, float room) {
    const float em = context.em;
    const float sign = ImGui::CalcTextSize("0").x;  // all characters have the same width
    const auto fits = static_cast<std::size_t>(std::max(1.0F, room / sign));
    const std::size_t first = box.caret() > fits ? box.caret() - fits : 0;
    const std::string text = box.text().substr(first, fits);
    const float height = ImGui::GetTextLineHeight();
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (box.marked()) {
        const float width = static_cast<float>(text.size()) * sign;
        list->AddRectFilled(at, {at.x + width, at.y + height},
                            toU32(context.palette.accent.withAlpha(0.45F)));
    }
    list->AddText(at, toU32(context.palette.text), text.c_str());
    const float x = at.x + static_cast<float>(box.caret() - first) * sign + 1.0F;
    list->AddLine({x, at.y}, {x, at.y + height}, toU32(context.palette.text),
                  std::max(1.0F, 0.09F * em));
}

void drawGoTo(const PanelContext& context) {
    GoToBox& box = context.state<GoToBox>();
    const float em = context.em;
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("at");
    ImGui::SameLine();
    const ImVec2 size(std::min(kGoTo * em, ImGui::GetContentRegionAvail().x),
                      ImGui::GetFrameHeight());
    if (ImGui::InvisibleButton("##goto", size)) box.open();
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsItemHovered()) box.close();
    // A focused text field would get the typed characters as well.
    if (box.active() && ImGui::GetIO().WantTextInput) ImGui::SetWindowFocus(nullptr);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, toU32(context.palette.panelRaised), 0.25F * em);
    if (box.active()) {
        list->AddRect(low, high, toU32(context.palette.accent), 0.25F * em, 0, 0.12F * em);
    }
    ImGui::PushFont(context.fonts.mono);
    const ImVec2 at(low.x + 0.5F * em, 0.5F * (low.y + high.y - ImGui::GetTextLineHeight()));
    if (box.active()) {
        drawTyped(context, box, at, size.x - em);
    } else {
        const std::string text = fitted(addressText(context.session()), size.x - em);
        list->AddText(at, toU32(context.palette.textDim), text.c_str());
    }
    ImGui::PopFont();
    tooltip(withKeys(context, "Go to", "step.goto") +
            ": 137, 137.sphere.3, +10, -10, 50%, or p812 to select a point");
}

/// If not all units fit: the current one; a click changes to the next.
void drawUnitAlone(const PanelContext& context) {
    const std::string name(unitName(context.playback().unit()));
    if (ImGui::Button((name + "##unit").c_str())) context.run("run.unit");
    tooltip(withKeys(context, "Unit of playback and single steps; click for the next", "run.unit"));
    ImGui::SameLine(0.0F, 0.15F * context.em);
}

TransportWidths widthsOf(const PanelContext& context, float gap) {
    const float em = context.em;
    const float pad = 2.0F * ImGui::GetStyle().FramePadding.x + 0.15F * em;
    const auto button = [&](PlayUnit unit) {
        return ImGui::CalcTextSize(std::string(unitName(unit)).c_str()).x + pad;
    };
    TransportWidths w;
    w.gap = gap;
    w.buttons = (6.0F * 1.9F + 2.6F + 7.0F * 0.2F) * em;
    w.goTo = kGoTo * em + ImGui::CalcTextSize("at").x + ImGui::GetStyle().ItemSpacing.x;
    for (const PlayUnit unit : {PlayUnit::SubStep, PlayUnit::Pivot, PlayUnit::Event}) {
        w.units += button(unit);
        w.unit = std::max(w.unit, button(unit));
    }
    w.speed = (2.0F * 1.6F + 3.4F) * em;
    w.loop = 2.0F * 1.95F * em;
    return w;
}

}  // namespace

void drawTransport(const PanelContext& context) {
    if (beginRegion("##transport", context.rects.transport)) {
        const Session& session = context.session();
        const float wide = context.rects.transport.size.x / context.em;
        const float gap = wide > 50.0F ? 1.4F * context.em : 0.4F * context.em;
        const TransportParts parts =
            fitTransport(ImGui::GetContentRegionAvail().x, widthsOf(context, gap));
        drawButtons(context, kBefore, !session.atStart());
        const bool playing = context.playback().playing();
        if (iconButton("##play", playing ? Icon::Pause : Icon::Play,
                       withKeys(context, playing ? "Pause" : "Play", "run.play").c_str(),
                       session.ready() && !session.atEnd(), true, context)) {
            context.run("run.play");
        }
        ImGui::SameLine(0.0F, 0.2F * context.em);
        drawButtons(context, kAfter, session.ready() && !session.atEnd());
        const auto space = [gap] { ImGui::SameLine(0.0F, gap); };
        space();
        if (parts.unit) parts.units ? drawUnit(context) : drawUnitAlone(context), space();
        if (parts.speed) drawSpeed(context), space();
        if (parts.loop) drawLoop(context), space();
        drawGoTo(context);
    }
    ImGui::End();
}

}  // namespace se::view
