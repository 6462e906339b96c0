// The sentence about the decision at the cursor: on a plate in the view, or below the view, in the
// largest type in which all of it fits. In Compare both sentences have the same type, so that they
// can be compared as well.

#include <algorithm>
#include <string>
#include <vector>

#include "document/alert_actions.h"
#include "document/ui_state.h"
#include "lesson/lesson_walk.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "run/strings.h"
#include "scene/palette.h"
#include "session/layout_preset.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"
#include "teach/lesson_text.h"
#include "view_parts.h"

namespace se::view {

// In Present the step of a lesson is the caption: title, text and options in the largest type in
// which all of it fits, and small below them the keys of an open question, or the decision.

namespace {

/// Room above and below the text, and between two on one line, in em.
constexpr float kAroundText = 1.2F;
constexpr float kBetweenOptions = 1.8F;

struct Paragraph {
    /// Options share a line if all of them fit on it, and a note follows what is before it there.
    enum class Kind { Text, Option, Note };

    std::string text;
    Color color;
    Kind kind = Kind::Text;
};
using ParagraphKind = Paragraph::Kind;

/// The text without line breaks and blanks at its end.
std::string withoutLastBreaks(std::string text) {
    text.erase(text.find_last_not_of(" \t\n") + 1);
    return trimmed(text);
}

void addText(std::vector<Paragraph>& all, const std::string& markdown, const Color& color) {
    for (const teach::TextBlock& block : teach::textBlocks(markdown))
        all.push_back({withoutLastBreaks(teach::plainTextOf({block})), color});
}

/// The options, or what is typed. Requires a question.
void addOptions(std::vector<Paragraph>& all, const LessonWalk& walk, const Palette& palette) {
    const teach::Question& question = *walk.question();
    const auto right =
        walk.asks() ? std::nullopt
                    : teach::rightOption({question, walk.setting().names}, walk.right().answer);
    for (std::size_t i = 0; i < question.options.size(); ++i) {
        const bool chosen = walk.asks() && walk.chosen() == i;
        all.push_back({(chosen ? "> " : "") + teach::optionLetter(i) + "   " + question.options[i],
                       chosen       ? palette.accent
                       : right == i ? palette.used
                                    : palette.text,
                       ParagraphKind::Option});
    }
    if (walk.asks() && question.options.empty())
        all.push_back({"Your answer: " + walk.state().typed, palette.accent});
    if (!walk.asks() && !right) all.push_back({"Answer: " + walk.right().text, palette.used});
}

/// The grade of the last try. Requires a question.
void addGrade(std::vector<Paragraph>& all, const LessonWalk& walk, const Palette& palette) {
    const auto& grade = walk.state().grade;
    if (walk.asks()) {
        const std::string wrong = walk.tryText();
        if (!wrong.empty()) all.push_back({wrong, palette.last, ParagraphKind::Note});
    } else if (grade) {
        all.push_back({grade->right ? "Right." : "Yours was not right.",
                       grade->right ? palette.used : palette.last, ParagraphKind::Note});
    }
}

/// Title, text, which at the first step begins with that of the lesson, and the question.
std::vector<Paragraph> paragraphsOf(const PanelContext& context, const LessonWalk& walk) {
    const Palette& palette = context.palette;
    std::vector<Paragraph> all{{walk.shownStep().title, palette.accent}};
    if (walk.step() == 0) addText(all, walk.lesson().text, palette.text);
    addText(all, walk.shownStep().text, palette.text);
    if (walk.question() == nullptr) return all;
    addOptions(all, walk, palette);
    addGrade(all, walk, palette);
    return all;
}

/// The keys that answer an open question. Requires one.
std::string keysOfAnswer(const PanelContext& context, const LessonPanel& panel) {
    if (!panel.hides()) return "F5 returns to the question.";
    const teach::Question& question = *panel.walk.question();
    const std::string shows = context.key("lesson.next") + " shows the answer.";
    if (panel.countsHands || question.kind == "play") return shows;
    std::string way = "Click the points";
    if (question.kind == "number") {
        way = "Type the number";
    } else if (!question.options.empty()) {
        way = "A to " + teach::optionLetter(question.options.size() - 1);
    } else if (question.kind == "point") {
        way = "Click the point";
    }
    return way + ", then Enter; " + shows;
}

/// Whether each paragraph begins a line of its own, in the current type.
std::vector<bool> lineStarts(const std::vector<Paragraph>& all, float width, float gap) {
    float options = 0.0F;
    for (const Paragraph& each : all) {
        if (each.kind == ParagraphKind::Option) options += textWidth(each.text) + gap;
    }
    const bool inRow = options <= width;
    std::vector<bool> starts;
    float end = width;
    ParagraphKind before = ParagraphKind::Text;
    for (const Paragraph& each : all) {
        const float wide = textWidth(each.text);
        const bool follows = each.kind == ParagraphKind::Option
                                 ? before == ParagraphKind::Option && inRow
                                 : each.kind == ParagraphKind::Note && end + gap + wide <= width;
        starts.push_back(!follows);
        end = (follows ? end + gap : 0.0F) + wide;
        if (each.kind == ParagraphKind::Option && !inRow) end = width;
        before = each.kind;
    }
    return starts;
}

float heightOf(const std::vector<Paragraph>& paragraphs, float width, float gap) {
    const std::vector<bool> starts = lineStarts(paragraphs, width, gap);
    float height = 0.0F;
    for (std::size_t i = 0; i < paragraphs.size(); ++i) {
        if (!starts[i]) continue;
        const auto lines = static_cast<float>(wrapped(paragraphs[i].text, width).size());
        height += lines * ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y;
    }
    return height;
}

void drawParagraphs(const std::vector<Paragraph>& paragraphs, float width, float gap) {
    const std::vector<bool> starts = lineStarts(paragraphs, width, gap);
    for (std::size_t i = 0; i < paragraphs.size(); ++i) {
        if (!starts[i]) ImGui::SameLine(0.0F, gap);
        wrappedText(paragraphs[i].text, paragraphs[i].color);
    }
}

/// True where the step of a lesson is the caption.
bool showsLessonCaption(const PanelContext& context) {
    return context.rects.layoutPreset == LayoutPreset::Present &&
           context.state<LessonPanel>().walk.isOpen();
}

/// Draws the step, and below it the keys of its question or the decision at the cursor. Requires
/// showsLessonCaption().
void drawLessonCaption(const PanelContext& context, const std::string& decision) {
    LessonPanel& panel = context.state<LessonPanel>();
    const LessonWalk& walk = panel.walk;
    const std::vector<Paragraph> paragraphs = paragraphsOf(context, walk);
    const float em = context.em;
    const float indent = 0.8F * em;
    const float left = ImGui::GetCursorPosX() + indent;
    const float width = ImGui::GetContentRegionAvail().x - 2.0F * indent;
    const float gap = kBetweenOptions * em;
    const Fonts& fonts = context.fonts;
    const float most = kLargestLessonShare * context.rects.window.y;
    ImFont* chosen = fonts.small;
    for (ImFont* font : {fonts.caption, fonts.large, fonts.text, fonts.small}) {
        chosen = font;
        ImGui::PushFont(font);
        const float height = heightOf(paragraphs, width, gap) + kAroundText * em +
                             fonts.small->FontSize + ImGui::GetStyle().ItemSpacing.y;
        ImGui::PopFont();
        // The next frame has that room.
        panel.captionEms = height / em;
        if (height <= most) break;
    }
    ImGui::SetCursorPosX(left);
    ImGui::BeginGroup();
    ImGui::PushFont(chosen);
    drawParagraphs(paragraphs, width, gap);
    ImGui::PopFont();
    ImGui::PushFont(fonts.small);
    dimText(fitted(walk.asks() ? keysOfAnswer(context, panel) : decision, width));
    ImGui::PopFont();
    ImGui::EndGroup();
    nameItem(context, "lesson caption");
}

struct Caption {
    ImFont* font = nullptr;
    std::vector<std::string> lines;
    bool cut = false;  ///< The tooltip has all of the text.
};

/// Cuts a caption that is too long even in the smallest type: whole lines only, the last one ends
/// in dots.
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

/// The caption in the largest type of the layout that fits all lines, also of the sentence beside
/// it.
Caption fittingCaption(const PanelContext& context, const std::string& sentence,
                       const std::string& beside, const ImVec2& room) {
    const Fonts& fonts = context.fonts;
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
    // At the start a message has the place of the decision, for a while.
    if (!session.ready() || !session.messages().notice().empty()) return session.messages().last();
    return "Nothing has happened yet: all points are UNUSED.";
}

/// The line with the address, shown where no other panel has it.
void drawAddressLine(const PanelContext& context) {
    const PanelRects& rects = context.rects;
    if (rects.addressLine <= 0.0F || !context.session().ready()) return;
    const std::string text = addressAndSection(context.session());
    const glm::vec2 at = rects.narration.min + glm::vec2(1.2F, 0.42F) * context.em;
    const ImVec2 extent = context.fonts.text->CalcTextSizeA(context.em, 1e9F, 0.0F, text.c_str());
    ImGui::GetWindowDrawList()->AddText(context.fonts.text, context.em, toVec2(at),
                                        toU32(context.palette.textDim), text.c_str());
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + rects.addressLine);
    context.where()["address line"] = {at, {extent.x, extent.y}};
}

/// The sentence, and its color.
struct Said {
    std::string whole;
    std::string text;  ///< With short numbers.
    Color color;
};

Said saidIn(const PanelContext& context) {
    const Session& session = context.session();
    const bool finished = showsFinishedMesh(context.commands) && session.alerts().done();
    Said said;
    said.whole = finished && !session.showsEarlierMesh()
                     ? verdictSentence(session.alerts())
                     : sentenceOf(session, context.ui().picture);
    said.text = withShortNumbers(said.whole);
    said.color = context.palette.accent;
    if (finished) {
        const bool faulty = !session.alerts().sound();
        said.color = faulty ? context.palette.rejected : context.palette.used;
    } else if (const Event* event = session.event(); event != nullptr) {
        said.color = outcomeColor(context.palette, *event).value_or(said.color);
        if (!session.noticedHere().empty()) said.color = context.palette.rejected;
    }
    return said;
}

/// The sentence beside this one.
std::string besideOf(const PanelContext& context) {
    return context.otherRun != nullptr ? withShortNumbers(sentenceOf(*context.otherRun, {})) : "";
}

/// The plate: its margins and its text's, and how wide and high the text is at most.
constexpr float kPlateMargin = 0.8F;
constexpr float kPlatePad = 0.7F;
/// The address below the text is small.
constexpr float kSmall = 0.84F;
constexpr float kPlateWidest = 46.0F;
constexpr float kPlateLines = 3.4F;
constexpr float kAxes = 6.0F;
constexpr float kWithAxes = 18.0F;

}  // namespace

void drawNarration(const PanelContext& context) {
    const Rect& area = context.rects.narration;
    if (area.size.y <= 0.0F) return;
    if (beginRegion("##narration", area)) {
        const Said said = saidIn(context);
        ImDrawList* list = ImGui::GetWindowDrawList();
        list->PushClipRect(toVec2(area.min), toVec2(area.max()));
        list->AddRectFilled(toVec2(area.min), {area.min.x + 0.3F * context.em, area.max().y},
                            toU32(said.color));
        list->PopClipRect();
        if (showsLessonCaption(context)) {
            drawLessonCaption(context, said.text);
            ImGui::End();
            return;
        }
        drawAddressLine(context);
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5F * context.em);
        const float left = ImGui::GetCursorPosX();
        const Caption caption =
            fittingCaption(context, said.text, besideOf(context), ImGui::GetContentRegionAvail());
        ImGui::PushFont(caption.font);
        for (const std::string& line : caption.lines) {
            ImGui::SetCursorPosX(left);
            ImGui::TextUnformatted(line.c_str());
        }
        ImGui::PopFont();
        if ((caption.cut || said.text != said.whole) && ImGui::IsWindowHovered())
            showTooltipAbove(area, said.whole);
    }
    ImGui::End();
}

Rect drawPlate(const PanelContext& context, const PlateText& text) {
    const Rect& view = context.rects.view;
    const float em = context.em;
    ImGui::PushFont(text.font);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    float widest = text.place.empty() ? 0.0F : 10.0F * em;
    for (const std::string& each : text.lines) widest = std::max(widest, textWidth(each));
    ImGui::PopFont();
    const float below = text.place.empty() ? 0.0F : 1.2F * kSmall * em;
    const glm::vec2 size(widest + 2.0F * kPlatePad * em,
                         line * static_cast<float>(text.lines.size()) + below + 0.7F * em);
    const Rect plate{{view.min.x + kPlateMargin * em, view.max().y - kPlateMargin * em - size.y},
                     size};
    ImDrawList* list = ImGui::GetWindowDrawList();
    fill(list, plate, context.palette.panel.withAlpha(0.94F), 0.3F * em);
    list->AddRectFilled(toVec2(plate.min), {plate.min.x + 0.25F * em, plate.max().y},
                        toU32(text.bar), 0.3F * em, ImDrawFlags_RoundCornersLeft);
    glm::vec2 at = plate.min + glm::vec2(kPlatePad, 0.35F) * em;
    for (const std::string& each : text.lines) {
        list->AddText(text.font, text.font->FontSize, toVec2(at), toU32(text.ink), each.c_str());
        at.y += line;
    }
    if (!text.place.empty())
        list->AddText(context.fonts.small, context.fonts.small->FontSize, toVec2(at),
                      toU32(context.palette.textDim), text.place.c_str());
    return plate;
}

std::optional<Rect> drawCaption(const PanelContext& context) {
    const Said said = saidIn(context);
    const Rect& view = context.rects.view;
    const float em = context.em;
    // The axes have the other lower corner.
    const bool axes = view.size.x > kWithAxes * em;
    const float width =
        std::min(kPlateWidest * em,
                 view.size.x - 2.0F * (kPlateMargin + kPlatePad) * em - (axes ? kAxes * em : 0.0F));
    if (said.text.empty() || width < 8.0F * em || view.size.y < 8.0F * em) return std::nullopt;
    const Caption caption =
        fittingCaption(context, said.text, besideOf(context), {width, kPlateLines * em});
    // The address is a line of its own, in small type.
    const std::string place =
        context.session().event() != nullptr ? addressAndSection(context.session()) : std::string{};
    const Rect plate =
        drawPlate(context, {caption.font, caption.lines, place, said.color, context.palette.text});
    context.where()[context.beside ? "other caption" : "caption"] = plate;
    if ((caption.cut || said.text != said.whole) && ImGui::IsWindowHovered() &&
        ImGui::IsMouseHoveringRect(toVec2(plate.min), toVec2(plate.max())))
        showTooltipAbove(plate, said.whole);
    return plate;
}

}  // namespace se::view
