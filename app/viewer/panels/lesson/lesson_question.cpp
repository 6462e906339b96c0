// A question of a lesson: points to mark, options to choose among, or a number; then the right
// answer with the decisions that led to it.
#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "lesson/lesson_panel.h"
#include "lesson/lesson_player.h"
#include "lesson_parts.h"
#include "panels/widgets/widgets.h"
#include "run/number_format.h"
#include "scene/palette.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"
#include "teach/play_moves.h"

namespace se::view {

namespace {

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

/// Of a pivot to play: the move that a click makes.
void drawMoveChoice(const PanelContext& context, LessonWalk& walk) {
    for (const teach::MoveRow& row : teach::moveTable()) {
        const bool on = walk.state().move == row.id;
        if (on) ImGui::PushStyleColor(ImGuiCol_Button, toVec4(context.palette.accent));
        if (on) ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.accentText));
        const std::string name(row.name);
        if (smallButton(context, name, "move " + name, std::string(row.help)))
            walk.chooseMove(row.id);
        if (on) ImGui::PopStyleColor(2);
        ImGui::SameLine();
        if (ImGui::GetContentRegionAvail().x < 4.0F * context.em) ImGui::NewLine();
    }
    ImGui::NewLine();
}

/// Of a pivot to play, below the buttons, which keep their place: the moves so far.
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
        std::string label;
        for (const std::string& line :
             wrapped(letter + "   " + options[i], ImGui::GetContentRegionAvail().x))
            label += (label.empty() ? "" : "\n") + line;
        if (selectable(context, label, walk.chosen() == i, "option " + letter)) walk.choose(i);
    }
}

/// How many of a room chose each option.
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
    for (const teach::NamedPoint& each : walk.setting().names) {
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
                       "solution " + std::to_string(i + 1), describe(moves[i].event, walk.names())))
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
    const auto among = [](const std::vector<Index>& points, Index point) {
        return std::find(points.begin(), points.end(), point) != points.end();
    };
    std::size_t listed = 0;
    const std::vector<Event>& decisions = walk.right().shown;
    for (std::size_t i = 0; i < decisions.size(); ++i) {
        const Event& event = decisions[i];
        const Index point = subjectOf(event);
        const bool isRight = among(right, point);
        if (!isRight && !among(given, point) && !explainsOther(walk, i)) continue;
        if (++listed > kMaxListed) return;
        if (listed == 1) ImGui::Spacing();
        const std::string address = toString(event.address);
        const bool agrees = !walk.state().grade || isRight == among(given, point);
        ImGui::PushID(static_cast<int>(listed));
        ImGui::PushStyleColor(ImGuiCol_Text,
                              toVec4(agrees ? context.palette.used : context.palette.rejected));
        const std::string label = (agrees ? "\xE2\x9C\x93 " : "\xE2\x9C\x97 ") +
                                  withShortNumbers(describe(event, walk.names()));
        const std::string shown = fittedWords(label, ImGui::GetContentRegionAvail().x);
        if (selectable(context, shown, false, "decision " + address, describe(event, walk.names())))
            context.commands.lesson.follow(address);
        ImGui::PopStyleColor();
        ImGui::PopID();
    }
}

}  // namespace

void drawQuestion(const PanelContext& context) {
    LessonWalk& walk = context.state<LessonPanel>().walk;
    separator();
    if (walk.asks()) return drawOpen(context, walk);
    drawResult(context, walk);
    drawDecisions(context, walk);
    if (walk.hasAnswers() && smallButton(context, "Save result...", "lesson save result"))
        context.run("file.saveresult");
}

}  // namespace se::view
