// The sentence below the view: the decision at the cursor, in the largest type in which all of it
// fits. In Compare both sentences have the same type, so that they can be compared as well.
#include <algorithm>

#include "commands/alert_actions.h"
#include "panel_state/ui_state.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "run/number_format.h"
#include "scene/palette.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"
#include "view_parts.h"

namespace se::view {

namespace {

struct Caption {
    ImFont* font = nullptr;
    std::vector<std::string> lines;
    bool cut = false;  ///< The tooltip has all of the text.
};

/// Too long even in the smallest type: whole lines only, and the last one ends in dots.
void shorten(Caption& caption, const ImVec2& room) {
    ImGui::PushFont(caption.font);
    const float lines =
        (room.y + ImGui::GetStyle().ItemSpacing.y) / ImGui::GetTextLineHeightWithSpacing();
    const auto fit = static_cast<std::size_t>(std::max(1.0F, lines));
    if (caption.lines.size() > fit) {
        const std::string next = caption.lines[fit];
        caption.cut = true;
        caption.lines.resize(fit);
        caption.lines.back() = fittedWords(caption.lines.back() + " " + next, room.x);
    }
    ImGui::PopFont();
}

/// In the largest type of the layout that fits all lines, also of the sentence beside it.
Caption fittingCaption(const PanelContext& context, const std::string& sentence,
                       const std::string& beside) {
    const Fonts& fonts = context.fonts;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float high = room.y + ImGui::GetStyle().ItemSpacing.y;
    Caption caption;
    for (ImFont* font : {fonts.caption, fonts.large, fonts.text, fonts.small}) {
        if (font == fonts.caption && context.rects.caption <= 1.0F) continue;
        ImGui::PushFont(font);
        caption = {font, wrapped(sentence, room.x), false};
        const std::size_t lines = std::max(caption.lines.size(), wrapped(beside, room.x).size());
        const float height = ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(lines);
        ImGui::PopFont();
        if (height <= high) return caption;
    }
    shorten(caption, room);
    return caption;
}

/// The decision at the cursor of a run, with all digits; without an event the latest message.
std::string sentenceOf(const Session& session, const PictureLook& look) {
    if (!look.captionText.empty()) return look.captionText;
    if (session.showsEarlierMesh()) return "The finished mesh before the last change of settings.";
    if (const Event* event = session.event(); event != nullptr)
        return (session.showsBefore() ? "Before this: " : "") + describe(*event, session.names()) +
               session.noticedText();
    if (!session.messages().last().empty()) return session.messages().last();
    return session.ready() ? "Nothing has happened yet: all points are UNUSED." : "";
}

/// Shown where no other panel has the address.
void drawAddressLine(const PanelContext& context) {
    context.ui().addressLine.clear();
    const PanelRects& rects = context.rects;
    if (rects.addressLine <= 0.0F || !context.session().ready()) return;
    const std::string text = addressAndSection(context.session());
    const glm::vec2 at = rects.narration.min + glm::vec2(1.2F, 0.42F) * context.em;
    const ImVec2 extent = context.fonts.text->CalcTextSizeA(context.em, 1e9F, 0.0F, text.c_str());
    ImGui::GetWindowDrawList()->AddText(context.fonts.text, context.em, toVec2(at),
                                        toU32(context.palette.textDim), text.c_str());
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + rects.addressLine);
    context.ui().addressLine = text;
    context.where()["address line"] = {at, {extent.x, extent.y}};
}

}  // namespace

void drawNarration(const PanelContext& context, const char* window) {
    const Session& session = context.session();
    if (beginRegion(window, context.rects.narration)) {
        // Other messages are shown in the view for a while: see drawNotices().
        const bool finished =
            showsFinishedMesh(context.commands) && session.alerts().search().done();
        const std::string whole = finished && !session.showsEarlierMesh()
                                      ? verdictSentence(session.alerts())
                                      : sentenceOf(session, context.ui().picture);
        const std::string sentence = withShortNumbers(whole);
        Color color = context.palette.accent;
        if (finished) {
            const bool faulty = !session.alerts().search().sound();
            color = faulty ? context.palette.rejected : context.palette.used;
        } else if (const Event* event = session.event(); event != nullptr) {
            color = outcomeColor(context.palette, *event).value_or(color);
            if (!session.noticedHere().empty()) color = context.palette.rejected;
        }
        const Rect& area = context.rects.narration;
        ImDrawList* list = ImGui::GetWindowDrawList();
        list->PushClipRect(toVec2(area.min), toVec2(area.max()));
        list->AddRectFilled(toVec2(area.min), {area.min.x + 0.3F * context.em, area.max().y},
                            toU32(color));
        list->PopClipRect();
        if (showsLessonCaption(context)) {
            drawLessonCaption(context, sentence);
            ImGui::End();
            return;
        }
        drawAddressLine(context);
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5F * context.em);
        const float left = ImGui::GetCursorPosX();
        const Caption caption = fittingCaption(
            context, sentence,
            context.otherRun != nullptr ? withShortNumbers(sentenceOf(*context.otherRun, {})) : "");
        ImGui::PushFont(caption.font);
        for (const std::string& line : caption.lines) {
            ImGui::SetCursorPosX(left);
            ImGui::TextUnformatted(line.c_str());
        }
        ImGui::PopFont();
        if ((caption.cut || sentence != whole) && ImGui::IsWindowHovered()) showTooltip(whole);
    }
    ImGui::End();
}

}  // namespace se::view
