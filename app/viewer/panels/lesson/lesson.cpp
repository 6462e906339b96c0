// The panel Lesson: the step that is shown, with its text and question, and the way to the others;
// without a lesson the list of those that the program has.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "document/document.h"
#include "lesson/lesson_player.h"
#include "lesson/lesson_walk.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "run/strings.h"
#include "scene/palette.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/run/event_text.h"
#include "teach/lesson_text.h"
#include "teach/play_moves.h"
#include "teach/practice.h"

namespace se::view {

namespace {

constexpr std::string_view kDecisionLink = "se:";

std::string minutesText(double minutes) {
    if (minutes < 1.0) return "1 minute";
    return sixDigits(std::round(2.0 * minutes) / 2.0) + " minutes";
}

/// The lessons of the program.
void drawLessons(const PanelContext& context) {
    wrappedText("A lesson walks through a run step by step, and asks before it shows.");
    ImGui::Spacing();
    complain(context, context.commands.lesson.opening().complaint());
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
    ImGui::TextDisabled("%s", fittedWords(walk.lesson().title, room).c_str());
    nameItem(context, "lesson title",
             walk.lesson().title + ", " + minutesText(walk.lesson().minutes()));
    dimAtRight(place);
    drawStepBar(context, walk);
    wrappedIn(context.fonts.large, walk.shownStep().title);
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

/// The run is not at the step.
bool isAway(const PanelContext& context) {
    return context.state<LessonPanel>().away && !context.playback().playing();
}

bool hasPlay(const LessonWalk& walk) {
    return walk.question() == nullptr && !walk.shownStep().until.empty();
}

/// Rows of drawFoot().
float footRows(const PanelContext& context, const LessonWalk& walk) {
    return isAway(context) || hasPlay(walk) ? 2.0F : 1.0F;
}

/// The way on, at the lower end of the panel.
void drawFoot(const PanelContext& context, const LessonWalk& walk) {
    LessonPlayer& lesson = context.commands.lesson;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    if (isAway(context)) {
        if (textButton(context, "Back to the step", "lesson return",
                       "Position, rules and view of this step", -1.0F))
            lesson.returnToStep();
    } else if (hasPlay(walk)) {
        if (textButton(context, "Play", "lesson play", "Play to " + walk.setting().answerPlace,
                       -1.0F))
            lesson.play();
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
        if (accentButton(context, primary, primary ? "Next" : "Skip", "lesson next",
                         (primary ? "The next step (" : "The next step, without an answer (") +
                             context.key("lesson.next") + ")",
                         half))
            lesson.next();
    }
}

// A question of a lesson: points to mark, options to choose among, or a number; then the right
// answer with the decisions that led to it.

/// Maximum number of decisions listed with an answer.
constexpr std::size_t kMaxListed = 40;

bool isChoice(const LessonWalk& walk) { return walk.question()->kind == "choice"; }

/// The task in words.
std::string taskOf(const LessonWalk& walk) {
    const std::string& kind = walk.question()->kind;
    if (kind == "points") return "Click the points in the view, or type them:";
    if (kind == "play") return "Choose a move and click its points, or type it:";
    if (kind == "point") return "Click the point in the view, or type it:";
    return kind == "number" ? "Your number:" : "Your choice:";
}

/// The choice of the move that a click makes, for a pivot to play.
void drawMoveChoice(const PanelContext& context, LessonWalk& walk) {
    for (const teach::MoveRow& row : teach::moveTable()) {
        const std::string name(row.name);
        if (accentButton(context, walk.state().move == row.id, name, "move " + name,
                         std::string(row.help)))
            walk.chooseMove(row.id);
        ImGui::SameLine();
        if (ImGui::GetContentRegionAvail().x < 4.0F * context.em) ImGui::NewLine();
    }
    ImGui::NewLine();
}

/// The moves so far of a pivot to play, below the buttons, which keep their place.
void drawMoves(const PanelContext& context, LessonWalk& walk) {
    const std::vector<teach::PlayMove>& moves = walk.state().given.moves;
    std::optional<std::size_t> gone;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (smallButton(context, "x", "remove move " + std::to_string(i + 1), "Take it back"))
            gone = i;
        ImGui::SameLine();
        ImGui::TextUnformatted(teach::moveText(moves[i], walk.setting().names).c_str());
        ImGui::PopID();
    }
    if (gone) walk.removeMove(*gone);
}

/// Options as rows that can be chosen, by letter.
void drawOptions(const PanelContext& context, LessonWalk& walk) {
    const std::vector<std::string>& options = walk.question()->options;
    for (std::size_t i = 0; i < options.size(); ++i) {
        const std::string letter = teach::optionLetter(i);
        const std::string label = withBreaks(letter + "   " + options[i]);
        if (selectable(context, label, walk.chosen() == i, "option " + letter)) walk.choose(i);
    }
}

/// A field for each option: how many people in the room chose it.
void drawHands(const PanelContext& context, LessonWalk& walk) {
    const std::vector<std::string>& options = walk.question()->options;
    std::vector<int> hands = walk.state().hands;
    hands.resize(options.size());
    bool changed = false;
    for (std::size_t i = 0; i < options.size(); ++i) {
        const std::string letter = teach::optionLetter(i);
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetNextItemWidth(3.5F * context.em);
        if (ImGui::InputInt("##hands", &hands[i], 0)) changed = true;
        nameItem(context, "hands " + letter, "How many of the room chose " + letter);
        ImGui::SameLine();
        wrappedText(letter + "   " + options[i]);
        hands[i] = std::clamp(hands[i], 0, 9999);
        ImGui::PopID();
    }
    if (changed) walk.setHands(std::move(hands));
}

/// An example of how points are typed: by name where candidates have names.
std::string exampleOfPoints(const LessonWalk& walk) {
    const std::size_t most = walk.question()->kind == "point" ? 1 : 3;
    std::vector<std::string> words;
    for (const PointName& each : walk.setting().names) {
        const bool isCandidate = each.name != "p" && each.name != "first" && each.name != "last";
        if (isCandidate && words.size() < most) words.push_back(each.name);
    }
    if (words.empty()) words = {"3", "4", "5"};
    std::string text = "for example " + words.front();
    for (std::size_t i = 1; i < std::min(words.size(), most); ++i) text += ", " + words[i];
    return text;
}

void drawField(const PanelContext& context, LessonWalk& walk) {
    std::string typed = walk.state().typed;
    ImGui::SetNextItemWidth(-1.0F);
    const std::string& kind = walk.question()->kind;
    const std::string hint = kind == "number" ? "a number"
                             : kind == "play" ? "start 4; keep 7; fan 3 4 7 9; next 4"
                                              : exampleOfPoints(walk);
    const bool entered =
        textField("##answer", hint.c_str(), typed, ImGuiInputTextFlags_EnterReturnsTrue);
    nameItem(context, "lesson answer field");
    if (typed != walk.state().typed) walk.type(std::move(typed));
    if (entered) context.commands.lesson.answer();
}

void drawOpen(const PanelContext& context, LessonWalk& walk) {
    LessonPanel& panel = context.state<LessonPanel>();
    const bool room = panel.countsRoom();
    dimText(room ? "Hands for each option:" : taskOf(walk));
    if (room) {
        drawHands(context, walk);
    } else if (isChoice(walk)) {
        drawOptions(context, walk);
    } else {
        if (walk.question()->kind == "play") drawMoveChoice(context, walk);
        drawField(context, walk);
    }
    ImGui::Spacing();
    if (!room) {
        ImGui::BeginDisabled(walk.state().given == teach::Answer{});
        if (textButton(context, "Answer", "lesson answer", "Enter"))
            context.commands.lesson.answer();
        ImGui::EndDisabled();
        ImGui::SameLine();
    }
    if (textButton(context, "Show answer", "lesson show",
                   "Go through the decisions up to the answer"))
        context.commands.lesson.showAnswer();
    if (!walk.question()->options.empty()) {
        ImGui::Checkbox("Count hands of a room", &panel.countsHands);
        nameItem(context, "lesson hands");
    }
    // Below the buttons, which keep their place.
    if (const std::string wrong = walk.tryText(); !wrong.empty())
        wrappedText(wrong, walk.state().complaint.empty() ? context.palette.last
                                                          : context.palette.rejected);
    if (walk.question()->kind == "play") drawMoves(context, walk);
}

/// The share of a room that chose each option.
void drawRoom(const PanelContext& context, const LessonWalk& walk,
              const teach::GivenAnswer& answer) {
    const int all = static_cast<int>(
        std::accumulate(answer.counts.begin(), answer.counts.end(), std::size_t{0}));
    for (std::size_t i = 0; i < answer.counts.size(); ++i) {
        const bool right = i == answer.rightOption;
        const float share =
            all == 0 ? 0.0F : static_cast<float>(answer.counts[i]) / static_cast<float>(all);
        ImGui::PushStyleColor(ImGuiCol_PlotHistogram,
                              toVec4(right ? context.palette.used : context.palette.textDim));
        const std::string label = teach::optionLetter(i) + "   " +
                                  std::to_string(answer.counts[i]) + (right ? "   right" : "");
        ImGui::ProgressBar(share, {-1.0F, 0.0F}, label.c_str());
        ImGui::PopStyleColor();
        tooltip(walk.question()->options[i]);
    }
}

const teach::GivenAnswer* answerOf(const LessonWalk& walk) {
    for (const teach::GivenAnswer& each : walk.result().answers) {
        if (each.step == walk.step() + 1) return &each;
    }
    return nullptr;
}

/// The answer given beside the right one.
void drawResult(const PanelContext& context, const LessonWalk& walk) {
    const auto& grade = walk.state().grade;
    const Palette& palette = context.palette;
    if (const teach::GivenAnswer* answer = answerOf(walk); answer != nullptr && answer->isOfRoom())
        drawRoom(context, walk, *answer);
    if (grade && grade->right) wrappedText("Right.", palette.used);
    const bool wrong = grade && !grade->right;
    if (wrong) wrappedText("Yours: " + walk.state().typed, palette.rejected);
    if (walk.right().answer.moves.empty())
        wrappedText((grade && grade->right ? "" : "Answer: ") + walk.right().text, palette.text);
    if (!walk.right().reason.empty()) {
        ImGui::Spacing();
        wrappedText(withShortNumbers(walk.right().reason));
        if (smallButton(context, walk.question()->why, "lesson why", "Go to this decision"))
            context.commands.lesson.follow(walk.question()->why);
    }
}

/// The moves of the run, each a way to its decision.
void drawSolution(const PanelContext& context, const LessonWalk& walk) {
    const std::vector<teach::PlayMove>& given = walk.state().given.moves;
    const std::vector<teach::RunMove> moves = teach::movesOfRun(walk.right().shown);
    const std::size_t alike = teach::movesAlike(given, walk.right().answer.moves);
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const bool agrees = !walk.state().grade || i < alike;
        const Color& color = agrees ? context.palette.used : context.palette.rejected;
        const std::string address = toString(moves[i].event.address);
        ImGui::PushStyleColor(ImGuiCol_Text, toVec4(color));
        ImGui::PushID(static_cast<int>(i));
        if (selectable(context, teach::moveText(moves[i].move, walk.setting().names), false,
                       "solution " + std::to_string(i + 1),
                       describe(moves[i].event, walk.setting().names)))
            context.commands.lesson.follow(address);
        ImGui::PopID();
        ImGui::PopStyleColor();
        dimAtRight(address);
    }
}

/// The last decision on a candidate that is not among the answer: why it was kept, where those
/// removed are the answer, or the other way round.
bool explainsOther(const LessonWalk& walk, std::size_t number) {
    const std::string& answer = walk.question()->answer;
    if (answer != "refused" && answer != "kept") return false;
    const std::vector<Event>& shown = walk.right().shown;
    const Index point = subjectOf(shown[number]);
    if (point == kNone || !verdictOf(shown[number])) return false;
    return std::none_of(
        shown.begin() + static_cast<std::ptrdiff_t>(number) + 1, shown.end(),
        [&](const Event& each) { return subjectOf(each) == point && verdictOf(each).has_value(); });
}

/// The decisions on the points of the answer and on those that were given, each a way there.
void drawDecisions(const PanelContext& context, const LessonWalk& walk) {
    if (!walk.right().answer.moves.empty()) return drawSolution(context, walk);
    const std::vector<Index>& right = walk.right().answer.points;
    const std::vector<Index>& given = walk.state().given.points;
    std::size_t listed = 0;
    const std::vector<Event>& decisions = walk.right().shown;
    for (std::size_t i = 0; i < decisions.size(); ++i) {
        const Event& event = decisions[i];
        const Index point = subjectOf(event);
        const bool isRight = isAmong(point, right);
        if (!isRight && !isAmong(point, given) && !explainsOther(walk, i)) continue;
        if (++listed > kMaxListed) return;
        if (listed == 1) ImGui::Spacing();
        const std::string address = toString(event.address);
        const bool agrees = !walk.state().grade || isRight == isAmong(point, given);
        ImGui::PushID(static_cast<int>(listed));
        ImGui::PushStyleColor(ImGuiCol_Text,
                              toVec4(agrees ? context.palette.used : context.palette.rejected));
        const std::string label = (agrees ? "\xE2\x9C\x93 " : "\xE2\x9C\x97 ") +
                                  withShortNumbers(describe(event, walk.setting().names));
        const std::string shown = fittedWords(label, ImGui::GetContentRegionAvail().x);
        if (selectable(context, shown, false, "decision " + address,
                       describe(event, walk.setting().names)))
            context.commands.lesson.follow(address);
        ImGui::PopStyleColor();
        ImGui::PopID();
    }
}

/// Requires a step with a question.
void drawQuestion(const PanelContext& context) {
    LessonWalk& walk = context.state<LessonPanel>().walk;
    separator();
    if (walk.asks()) return drawOpen(context, walk);
    drawResult(context, walk);
    drawDecisions(context, walk);
    if (walk.hasAnswers() && smallButton(context, "Save result...", "lesson save result"))
        context.run("file.saveresult");
}

}  // namespace

void drawLesson(const PanelContext& context) {
    const auto& opening = context.commands.lesson.opening();
    if (opening.busy()) {
        ImGui::ProgressBar(static_cast<float>(opening.share()), {-1.0F, 0.0F},
                           "Opening the lesson");
    }
    const LessonWalk& walk = context.state<LessonPanel>().walk;
    if (!walk.isOpen()) return drawLessons(context);
    complain(context, context.commands.lesson.opening().complaint());
    drawHead(context, walk);
    const float foot = footRows(context, walk) * ImGui::GetFrameHeightWithSpacing();
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
