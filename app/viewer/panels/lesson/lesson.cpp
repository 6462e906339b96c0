// The panel Lesson: the step that is shown, with its text and question, and the way to the others;
// without a lesson the list of those that the program has.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "document/document.h"
#include "lesson/lesson_panel.h"
#include "lesson/lesson_player.h"
#include "lesson_parts.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "scene/palette.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/base/number_text.h"
#include "teach/lesson_text.h"
#include "teach/practice.h"

namespace se::view {

namespace {

using teach::TextBlock;
using teach::TextBlockKind;
using teach::TextSpan;

// Dear ImGui has one style per line of text: here each word is drawn by itself, at a position of
// our own, so that styles change within a line.

/// A word in one style. Words without a blank before them belong to the word before.
struct Word {
    std::string text;
    const TextSpan* style = nullptr;
    bool blankBefore = false;
};

std::vector<Word> wordsOfSpans(const std::vector<TextSpan>& spans) {
    std::vector<Word> words;
    bool blank = false;
    for (const TextSpan& span : spans) {
        bool inWord = false;
        for (const char sign : span.text) {
            if (sign == ' ' || sign == '\n') {
                blank = true;
                inWord = false;
                continue;
            }
            if (!std::exchange(inWord, true))
                words.push_back({{}, &span, std::exchange(blank, false)});
            words.back().text += sign;
        }
    }
    return words;
}

class BlockDrawing {
  public:
    explicit BlockDrawing(const PanelContext& context)
        : context_(context), line_(ImGui::GetTextLineHeightWithSpacing()) {}

    void draw(const TextBlock& block) {
        const float indent = block.kind == TextBlockKind::Item    ? 1.2F * context_.em
                             : block.kind == TextBlockKind::Quote ? 0.8F * context_.em
                                                                  : 0.0F;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        left_ = at.x + indent;
        right_ = at.x + ImGui::GetContentRegionAvail().x;
        x_ = left_;
        y_ = at.y;
        if (block.kind == TextBlockKind::Item) drawBullet(block.number, at);
        heading_ = block.kind == TextBlockKind::Heading;
        if (block.kind == TextBlockKind::Code) {
            drawCode(block);
        } else {
            drawWords(block);
        }
        ImGui::SetCursorScreenPos({at.x, y_ + line_ + 0.35F * context_.em});
        ImGui::Dummy({0.0F, 0.0F});
    }
    const std::string& clicked() const { return clicked_; }

  private:
    ImFont* fontOf(const TextSpan& style) const {
        const Fonts& fonts = context_.fonts;
        if (style.code) return fonts.mono;
        return style.strong || style.emphasized || heading_ ? fonts.strong : fonts.text;
    }
    ImVec2 extentOf(const Word& word) const {
        ImFont* font = fontOf(*word.style);
        return font->CalcTextSizeA(font->FontSize, 1e9F, 0.0F, word.text.c_str());
    }

    void drawBullet(int number, ImVec2 at) const {
        const std::string sign = number > 0 ? std::to_string(number) + "." : "\xE2\x80\xA2";
        ImGui::GetWindowDrawList()->AddText(at, toU32(context_.palette.textDim), sign.c_str());
    }

    void drawCode(const TextBlock& block) {
        ImGui::PushFont(context_.fonts.mono);
        for (const TextSpan& span : block.spans) wrappedText(span.text, right_ - left_);
        ImGui::PopFont();
        y_ = ImGui::GetCursorScreenPos().y - line_;
    }

    /// Words that belong together, such as one and the full stop after it, share a line.
    void drawWords(const TextBlock& block) {
        const std::vector<Word> words = wordsOfSpans(block.spans);
        const float blank = ImGui::CalcTextSize(" ").x;
        for (std::size_t i = 0; i < words.size();) {
            std::size_t end = i + 1;
            float width = extentOf(words[i]).x;
            for (; end < words.size() && !words[end].blankBefore; ++end)
                width += extentOf(words[end]).x;
            const bool first = x_ == left_;
            if (!first && x_ + blank + width > right_) {
                x_ = left_;
                y_ += line_;
            } else if (!first && words[i].blankBefore) {
                drawGap(words, i, blank);
                x_ += blank;
            }
            for (; i < end; ++i) drawWord(words[i]);
        }
    }

    /// The line below a link goes on between its words.
    void drawGap(const std::vector<Word>& words, std::size_t i, float width) const {
        const TextSpan* style = words[i].style;
        if (i > 0 && words[i - 1].style == style && !style->link.empty()) underline(x_, width);
    }

    void underline(float x, float width) const {
        const float y = std::round(y_ + ImGui::GetFontSize() + 0.05F * context_.em);
        ImGui::GetWindowDrawList()->AddLine({x, y}, {x + width, y},
                                            toU32(context_.palette.accent.withAlpha(0.7F)));
    }

    void drawWord(const Word& word) {
        const ImVec2 extent = extentOf(word);
        ImFont* font = fontOf(*word.style);
        const bool link = !word.style->link.empty();
        if (link) {
            ImGui::SetCursorScreenPos({x_, y_});
            ImGui::PushID(id_++);
            if (ImGui::InvisibleButton("##link", {extent.x, ImGui::GetFontSize()}))
                clicked_ = word.style->link;
            nameItem(context_, "link " + word.style->link, word.style->link);
            ImGui::PopID();
            underline(x_, extent.x);
        }
        const Color& color = link ? context_.palette.accent : context_.palette.text;
        ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {x_, y_}, toU32(color),
                                            word.text.c_str());
        x_ += extent.x;
    }

    const PanelContext& context_;
    float line_;
    float left_ = 0.0F;
    float right_ = 0.0F;
    float x_ = 0.0F;
    float y_ = 0.0F;
    bool heading_ = false;
    int id_ = 0;
    std::string clicked_;
};

/// Draws the blocks, as wide as there is room. The target of the link that was clicked; empty if
/// none was.
std::string drawTextBlocks(const PanelContext& context, const std::vector<TextBlock>& blocks) {
    BlockDrawing drawing(context);
    for (const TextBlock& block : blocks) drawing.draw(block);
    return drawing.clicked();
}

constexpr std::string_view kDecisionLink = "se:";

std::string minutesText(double minutes) {
    if (minutes < 1.0) return "1 minute";
    return sixDigits(std::round(2.0 * minutes) / 2.0) + " minutes";
}

/// The lessons of the program.
void drawLessons(const PanelContext& context) {
    const LessonPanel& panel = context.state<LessonPanel>();
    wrappedText("A lesson walks through a run step by step, and asks before it shows.");
    ImGui::Spacing();
    if (!panel.complaint.empty()) wrappedText("! " + panel.complaint, context.palette.rejected);
    for (const LessonEntry& each : lessonEntries()) {
        if (selectable(context, each.title, false, "open " + each.source, each.text))
            context.document().open(each.source);
        dimAtRight(minutesText(each.minutes));
    }
    ImGui::Spacing();
    if (textButton(context, "Practice a pivot", "practice",
                   "Play a pivot yourself: another one each time"))
        context.run("help.practice");
    ImGui::Spacing();
    dimText("Your own are opened by File > Open; docs/lessons.md says how to write one.");
}

/// One piece of a bar for each step: those before, the one that is shown, those after. A click
/// goes there.
void drawStepBar(const PanelContext& context, const LessonWalk& walk) {
    const float em = context.em;
    const std::size_t count = walk.lesson().steps.size();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float gap = std::min(0.15F * em, 0.2F * width / static_cast<float>(count));
    const float piece = (width + gap) / static_cast<float>(count) - gap;
    const float height = 0.35F * em;
    for (std::size_t i = 0; i < count; ++i) {
        const float x = at.x + static_cast<float>(i) * (piece + gap);
        ImGui::SetCursorScreenPos({x, at.y - 0.3F * em});
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::InvisibleButton("##step", {piece, height + 0.6F * em}))
            context.commands.lesson.toStep(i);
        nameItem(context, "lesson step " + std::to_string(i + 1), walk.lesson().steps[i].title);
        ImGui::PopID();
        const Palette& palette = context.palette;
        const Color rest = mix(palette.panel, palette.text, 0.25F);
        const Color& color = i == walk.step()         ? palette.accent
                             : ImGui::IsItemHovered() ? palette.text
                             : i < walk.step()        ? palette.textDim
                                                      : rest;
        fill(ImGui::GetWindowDrawList(), {{x, at.y}, {piece, height}}, color, 0.15F * em);
    }
    ImGui::SetCursorScreenPos({at.x, at.y + height + 0.5F * em});
}

void drawHead(const PanelContext& context, const LessonWalk& walk) {
    const std::string place =
        std::to_string(walk.step() + 1) + " of " + std::to_string(walk.lesson().steps.size());
    const float room = ImGui::GetContentRegionAvail().x - textWidth(place) - context.em;
    ImGui::TextDisabled("%s", fittedName(walk.lesson().title, room).c_str());
    nameItem(context, "lesson title",
             walk.lesson().title + ", " + minutesText(walk.lesson().minutes()));
    dimAtRight(place);
    drawStepBar(context, walk);
    ImGui::PushFont(context.fonts.large);
    wrappedText(walk.shownStep().title);
    ImGui::PopFont();
    ImGui::Spacing();
}

/// A link leads to a decision, or its address is copied.
void followLink(const PanelContext& context, const std::string& link) {
    if (link.empty()) return;
    if (link.starts_with(kDecisionLink)) {
        context.commands.lesson.follow(link.substr(kDecisionLink.size()));
    } else {
        context.ui().clipboard.copy(link);
        context.session().messages().say("Copied: " + link);
    }
}

void drawText(const PanelContext& context, const LessonWalk& walk) {
    // The text before the first step belongs to it.
    if (walk.step() == 0) {
        const auto blocks = teach::textBlocks(walk.lesson().text);
        followLink(context, drawTextBlocks(context, blocks));
    }
    followLink(context, drawTextBlocks(context, teach::textBlocks(walk.shownStep().text)));
}

/// The way on, at the lower end of the panel.
void drawFoot(const PanelContext& context, const LessonWalk& walk) {
    const LessonPanel& panel = context.state<LessonPanel>();
    LessonPlayer& lesson = context.commands.lesson;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    const bool plays = context.playback().playing();
    const bool hasPlay = walk.question() == nullptr && !walk.shownStep().until.empty();
    if (panel.away && !plays) {
        if (textButton(context, "Back to the step", "lesson return",
                       "Position, rules and view of this step", -1.0F))
            lesson.returnToStep();
    } else if (hasPlay) {
        if (textButton(context, "Play", "lesson play", "Play to " + walk.setting().answerPlace,
                       -1.0F))
            lesson.play();
    } else {
        ImGui::Dummy({0.0F, ImGui::GetFrameHeight()});
    }
    const bool last = walk.step() + 1 == walk.lesson().steps.size();
    ImGui::BeginDisabled(walk.step() == 0);
    if (textButton(context, "Back", "lesson previous",
                   "The step before (" + context.key("lesson.previous") + ")", half))
        lesson.previous();
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (last && teach::practiceSeed(walk.source())) {
        if (textButton(context, "Another", "lesson another", "Another pivot to play", half))
            context.run("help.practice");
    } else if (last) {
        if (textButton(context, "Close", "lesson close", "Close the lesson; the run stays open",
                       half))
            lesson.close();
    } else {
        const bool primary = !walk.asks();
        if (primary) ImGui::PushStyleColor(ImGuiCol_Button, toVec4(context.palette.accent));
        if (primary) ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.accentText));
        if (textButton(context, primary ? "Next" : "Skip", "lesson next",
                       (primary ? "The next step (" : "The next step, without an answer (") +
                           context.key("lesson.next") + ")",
                       half))
            lesson.next();
        if (primary) ImGui::PopStyleColor(2);
    }
}

}  // namespace

void drawLesson(const PanelContext& context) {
    const LessonPanel& panel = context.state<LessonPanel>();
    if (panel.opening) {
        ImGui::ProgressBar(static_cast<float>(panel.share), {-1.0F, 0.0F}, "Opening the lesson");
    }
    const LessonWalk& walk = panel.walk;
    if (!walk.isOpen()) return drawLessons(context);
    if (!panel.complaint.empty()) wrappedText("! " + panel.complaint, context.palette.rejected);
    drawHead(context, walk);
    const float foot = 2.0F * ImGui::GetFrameHeightWithSpacing();
    ImGui::PushID(static_cast<int>(walk.step()));
    if (ImGui::BeginChild("##text", {0.0F, std::max(4.0F * context.em,
                                                    ImGui::GetContentRegionAvail().y - foot)})) {
        drawText(context, walk);
        if (walk.question() != nullptr) drawQuestion(context);
    }
    ImGui::EndChild();
    ImGui::PopID();
    drawFoot(context, walk);
}

}  // namespace se::view
