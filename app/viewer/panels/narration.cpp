#include <algorithm>

#include "panel.h"
#include "scene/outcome.h"
#include "widgets.h"

namespace se::view {

namespace {

struct Caption {
    ImFont* font = nullptr;
    std::vector<std::string> lines;
    bool cut = false;  ///< The tooltip has all of it.
};

/// Too long even in the smallest print: whole lines only, and the last one says so.
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

/// In the largest print of the layout that leaves no line out.
Caption fittingCaption(const PanelContext& context, const std::string& sentence) {
    const Fonts& fonts = context.fonts;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    Caption caption;
    for (ImFont* font : {fonts.caption, fonts.large, fonts.text, fonts.small}) {
        if (font == fonts.caption && context.layout.caption <= 1.0F) continue;
        ImGui::PushFont(font);
        caption = {font, wrapped(sentence, room.x), false};
        const float height =
            ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(caption.lines.size());
        ImGui::PopFont();
        if (height <= room.y + ImGui::GetStyle().ItemSpacing.y) return caption;
    }
    shorten(caption, room);
    return caption;
}

/// Where nothing else says where one is.
void drawAddressLine(const PanelContext& context) {
    context.ui().addressLine.clear();
    const Layout& layout = context.layout;
    if (layout.addressLine <= 0.0F || !context.session().ready()) return;
    const std::string text = addressAndSection(context.session());
    const glm::vec2 at = layout.narration.min + glm::vec2(1.2F, 0.42F) * context.em;
    const ImVec2 extent = context.fonts.text->CalcTextSizeA(context.em, 1e9F, 0.0F, text.c_str());
    ImGui::GetWindowDrawList()->AddText(context.fonts.text, context.em, toVec2(at),
                                        toU32(context.palette.textDim), text.c_str());
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + layout.addressLine);
    context.ui().addressLine = text;
    context.ui().where["address line"] = {at, {extent.x, extent.y}};
}

}  // namespace

void drawNarration(const PanelContext& context) { drawSentence(context, "##narration"); }

void drawSentence(const PanelContext& context, const char* window) {
    const Session& session = context.session();
    if (beginRegion(window, context.layout.narration)) {
        const Event* event = session.event();
        std::string sentence;
        Color color = context.palette.accent;
        // What else there is to say stands in the view for a while: see drawNotices().
        if (event != nullptr) {
            sentence = (session.showsBefore() ? "Before this: " : "") + describe(*event);
            color = outcomeColor(context.palette, *event).value_or(color);
            if (!session.noticedHere().empty()) color = context.palette.rejected;
            sentence += session.noticedText();
        } else if (!session.message().empty()) {
            sentence = session.message();
        } else if (session.ready()) {
            sentence = "Nothing has been done yet: all points are UNUSED.";
        }
        const Rect& area = context.layout.narration;
        ImDrawList* list = ImGui::GetWindowDrawList();
        list->PushClipRect(toVec2(area.min), toVec2(area.max()));
        list->AddRectFilled(toVec2(area.min), {area.min.x + 0.3F * context.em, area.max().y},
                            toU32(color));
        list->PopClipRect();
        drawAddressLine(context);
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5F * context.em);
        const float left = ImGui::GetCursorPosX();
        const Caption caption = fittingCaption(context, sentence);
        ImGui::PushFont(caption.font);
        for (const std::string& line : caption.lines) {
            ImGui::SetCursorPosX(left);
            ImGui::TextUnformatted(line.c_str());
        }
        ImGui::PopFont();
        if (caption.cut && ImGui::IsWindowHovered()) showTooltip(sentence);
    }
    ImGui::End();
}

}  // namespace se::view
