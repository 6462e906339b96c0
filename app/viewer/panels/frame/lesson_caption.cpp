// In Present the step of a lesson is the caption: title, text and options in the largest type in
// which all of it fits, and small below them the decision.
#include <algorithm>
#include <string>
#include <vector>

#include "lesson/lesson_panel.h"
#include "panels/widgets/widgets.h"
#include "run/number_format.h"
#include "session/layout_preset.h"
#include "teach/lesson_text.h"
#include "view_parts.h"

namespace se::view {

namespace {

/// Room above and below the text, in em.
constexpr float kAroundText = 1.2F;

struct Paragraph {
    std::string text;
    Color color;
};

/// Without line breaks and blanks at the end.
std::string withoutLastBreaks(std::string text) {
    text.erase(text.find_last_not_of(" \t\n") + 1);
    return trimmed(text);
}

/// Title, text, and of a question the options or the answer.
std::vector<Paragraph> paragraphsOf(const PanelContext& context, const LessonWalk& walk) {
    const Palette& palette = context.palette;
    const teach::LessonStep& step = walk.shownStep();
    std::vector<Paragraph> all{{step.title, palette.accent}};
    for (const teach::TextBlock& block : teach::textBlocks(step.text))
        all.push_back({withoutLastBreaks(teach::plainTextOf({block})), palette.text});
    const teach::Question* question = walk.question();
    if (question == nullptr) return all;
    const auto right =
        walk.asks() ? std::nullopt
                    : teach::rightOption({*question, walk.setting().names}, walk.right().answer);
    for (std::size_t i = 0; i < question->options.size(); ++i) {
        const bool chosen = walk.asks() && walk.chosen() == i;
        all.push_back({(chosen ? "> " : "") + teach::optionLetter(i) + "   " + question->options[i],
                       chosen       ? palette.accent
                       : right == i ? palette.used
                                    : palette.text});
    }
    if (walk.asks() && question->options.empty() && !walk.state().typed.empty())
        all.push_back({"Your answer: " + walk.state().typed, palette.accent});
    if (const std::string wrong = walk.asks() ? walk.tryText() : ""; !wrong.empty())
        all.push_back({wrong, palette.last});
    if (!walk.asks() && !right) all.push_back({"Answer: " + walk.right().text, palette.used});
    return all;
}

float heightOf(const std::vector<Paragraph>& paragraphs, float width) {
    std::size_t lines = 0;
    for (const Paragraph& each : paragraphs) lines += wrapped(each.text, width).size();
    return static_cast<float>(lines) * ImGui::GetTextLineHeight() +
           static_cast<float>(paragraphs.size()) * ImGui::GetStyle().ItemSpacing.y;
}

}  // namespace

bool showsLessonCaption(const PanelContext& context) {
    return context.rects.layoutPreset == LayoutPreset::Present &&
           context.state<LessonPanel>().walk.isOpen();
}

void drawLessonCaption(const PanelContext& context, const std::string& decision) {
    LessonPanel& panel = context.state<LessonPanel>();
    const LessonWalk& walk = panel.walk;
    const std::vector<Paragraph> paragraphs = paragraphsOf(context, walk);
    const float indent = 0.8F * context.em;
    const float left = ImGui::GetCursorPosX() + indent;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    // Of the decision, which is shown after the question.
    const float below = walk.asks() ? 0.0F : ImGui::GetTextLineHeightWithSpacing();
    const float width = room.x - 2.0F * indent;
    const Fonts& fonts = context.fonts;
    ImFont* chosen = fonts.small;
    for (ImFont* font : {fonts.caption, fonts.large, fonts.text}) {
        ImGui::PushFont(font);
        const float height = heightOf(paragraphs, width);
        const bool fits = height <= room.y - below;
        if (font == fonts.caption)
            panel.captionEms = (height + below + kAroundText * context.em) / context.em;
        ImGui::PopFont();
        if (fits) chosen = font;
        if (fits) break;
    }
    ImGui::SetCursorPosX(left);
    ImGui::BeginGroup();
    ImGui::PushFont(chosen);
    for (const Paragraph& each : paragraphs) wrappedText(each.text, each.color);
    ImGui::PopFont();
    // The question comes first, and the text of the step is never smaller than the decision.
    ImGui::PushFont(fonts.small);
    if (!walk.asks() && ImGui::GetContentRegionAvail().y >= ImGui::GetTextLineHeight())
        dimText(fitted(decision, width));
    ImGui::PopFont();
    ImGui::EndGroup();
    nameItem(context, "lesson caption");
}

}  // namespace se::view
