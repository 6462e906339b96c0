#include "question.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>

#include "lesson.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/why/figure_check.h"

namespace se::teach {
namespace {

using Words = std::vector<std::string>;

std::vector<Index> sortedSet(std::vector<Index> points) {
    sortUnique(points);
    return points;
}

// ---- points, point ----

Result<Answer> readPoints(const Words& words, const QuestionContext& context) {
    Answer answer;
    for (const std::string& word : words) {
        const Index point = pointOf(word, context.names);
        if (point == kNone) return Error{excerpt(word) + ": no name and no number of a point"};
        answer.points.push_back(point);
    }
    answer.points = sortedSet(std::move(answer.points));
    return answer;
}

Result<Answer> readPoint(const Words& words, const QuestionContext& context) {
    if (words.size() != 1) return Error{"expected one point"};
    return readPoints(words, context);
}

/// The grade of an answer that has no parts.
Grade wholeGrade(bool right) { return {right, right ? 1.0 : 0.0, {}, {}}; }

Grade gradePoints(const Answer& given, const Answer& right, const Question&) {
    const std::vector<Index> a = sortedSet(given.points);
    const std::vector<Index> b = sortedSet(right.points);
    Grade grade;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(grade.wrong));
    std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(grade.missing));
    grade.right = a == b;
    const std::size_t common = a.size() - grade.wrong.size();
    const std::size_t all = b.size() + grade.wrong.size();
    grade.score = all == 0 ? 1.0 : static_cast<double>(common) / static_cast<double>(all);
    return grade;
}

Grade gradePoint(const Answer& given, const Answer& right, const Question& question) {
    Grade grade = gradePoints(given, right, question);
    grade.score = grade.right ? 1.0 : 0.0;
    return grade;
}

std::string textOfPoints(const Answer& answer, const QuestionContext& context) {
    return pointsText(answer.points, context.names);
}

// ---- choice ----

Result<Answer> readChoice(const Words& words, const QuestionContext& context) {
    const Words& options = context.question.options;
    Answer answer;
    if (words.size() != 1) return Error{"expected one of the options"};
    for (std::size_t i = 0; i < options.size(); ++i) {
        if (words.front() == optionLetter(i) || words.front() == options[i]) answer.choice = i;
    }
    if (!answer.choice)
        return Error{excerpt(words.front()) + ": expected the letter of one of the options"};
    return answer;
}

Grade gradeChoice(const Answer& given, const Answer& right, const Question&) {
    return wholeGrade(given.choice.has_value() && given.choice == right.choice);
}

std::string textOfChoice(const Answer& answer, const QuestionContext& context) {
    if (!answer.choice || *answer.choice >= context.question.options.size()) return "none";
    return optionLetter(*answer.choice) + ": " + context.question.options[*answer.choice];
}

// ---- number ----

Result<Answer> readNumberAnswer(const Words& words, const QuestionContext&) {
    if (words.size() != 1) return Error{"expected a number"};
    Answer answer;
    answer.number = numberIn<double>(words.front());
    if (!answer.number || !std::isfinite(*answer.number))
        return Error{excerpt(words.front()) + ": expected a number"};
    return answer;
}

Grade gradeNumber(const Answer& given, const Answer& right, const Question& question) {
    return wholeGrade(given.number && right.number &&
                      std::abs(*given.number - *right.number) <= question.within);
}

std::string textOfNumber(const Answer& answer, const QuestionContext&) {
    return answer.number ? plainNumber(*answer.number) : "none";
}

// ---- play ----

Result<Answer> readPlay(const Words& words, const QuestionContext& context) {
    Answer answer;
    for (const std::string& word : words) {
        Result<PlayMove> move = moveFromText(word, context.names);
        if (!move) return move.error();
        answer.moves.push_back(std::move(move.value()));
    }
    return answer;
}

Grade gradePlay(const Answer& given, const Answer& right, const Question&) {
    const std::size_t alike = movesAlike(given.moves, right.moves);
    Grade grade;
    grade.right = given.moves == right.moves;
    grade.score = right.moves.empty()
                      ? 0.0
                      : static_cast<double>(alike) / static_cast<double>(right.moves.size());
    if (grade.right) return grade;
    // The points of a fan that belong to it are not wrong.
    const std::vector<Index> none;
    const auto& wrong = alike < given.moves.size() ? given.moves[alike].points : none;
    const auto& wanted = alike < right.moves.size() ? right.moves[alike].points : none;
    const bool isFan = alike < right.moves.size() && right.moves[alike].kind == MoveKind::Fan;
    for (const Index point : wrong) {
        const bool belongs = std::find(wanted.begin(), wanted.end(), point) != wanted.end();
        if (!(isFan && belongs)) grade.wrong.push_back(point);
    }
    return grade;
}

std::string textOfPlay(const Answer& answer, const QuestionContext& context) {
    const std::string text = joined(
        answer.moves, "; ", [&](const PlayMove& each) { return moveText(each, context.names); });
    return text.empty() ? "none" : text;
}

constexpr std::array kQuestionKinds{
    QuestionKind{"points", "Mark a set of points.",
                 "a list of points, or \"refused\", \"kept\" or \"fan\"", readPoints, gradePoints,
                 textOfPoints},
    QuestionKind{"point", "Mark one point.", "a point, or \"next\", \"start\" or \"end\"",
                 readPoint, gradePoint, textOfPoints},
    QuestionKind{"choice", "Choose one of A to D.", "a letter, or \"verdict\"", readChoice,
                 gradeChoice, textOfChoice},
    QuestionKind{"number", "Give a number.", "a number, or \"count:triangles\" and the like",
                 readNumberAnswer, gradeNumber, textOfNumber},
    QuestionKind{"play", "Play the whole pivot: start, end, keep, remove, fan, next.",
                 "a list of moves such as \"keep q\", or \"moves\"", readPlay, gradePlay,
                 textOfPlay},
};

// ---- answers of a run ----

/// True for a neighbor that was left out by a fact before any test: DONE, or first or last itself.
bool isSettled(const CandidateMark& mark) {
    return mark.verdict == Verdict::AlreadyDone || mark.verdict == Verdict::OnRingEnd;
}

std::vector<Index> candidatesIn(const DecisionState& state, CandidateState which) {
    std::vector<Index> points;
    for (const CandidateMark& mark : state.candidates) {
        if (mark.state == which && !isSettled(mark)) points.push_back(mark.point);
    }
    std::sort(points.begin(), points.end());
    return points;
}

/// The points refused after the first position, up to the second.
std::vector<Index> refusedIn(const RunRange& range) {
    const std::vector<Index> before = candidatesIn(range.before, CandidateState::Rejected);
    const std::vector<Index> after = candidatesIn(range.after, CandidateState::Rejected);
    std::vector<Index> points;
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                        std::back_inserter(points));
    return points;
}
/// The neighbors that are left at the second position.
std::vector<Index> keptIn(const RunRange& range) {
    return candidatesIn(range.after, CandidateState::Kept);
}

std::vector<Index> fanOf(const RunRange& range) {
    std::vector<Index> points;
    for (const RingPoint& each : range.after.fan()) points.push_back(each.point);
    return points;
}

/// Points of a run as an answer.
template <std::vector<Index> (*find)(const RunRange&)>
Result<Answer> pointsFrom(const RunRange& range, const QuestionContext&) {
    return Answer{.points = sortedSet(find(range))};
}

Result<Answer> onePoint(Index point) {
    if (point == kNone) return Error{"the run names no point there"};
    return Answer{.points = {point}};
}
Result<Answer> nextPivot(const RunRange& range, const QuestionContext&) {
    for (const Event& event : range.events) {
        if (const auto* advance = as<AdvanceEvidence>(event); advance && advance->to != kNone)
            return onePoint(advance->to);
    }
    return onePoint(kNone);
}
Result<Answer> startPoint(const RunRange& range, const QuestionContext&) {
    return onePoint(range.after.start);
}
Result<Answer> endPoint(const RunRange& range, const QuestionContext&) {
    return onePoint(range.after.end);
}

Result<Answer> verdictThere(const RunRange& range, const QuestionContext& context) {
    const Words& verdicts =
        context.question.verdicts.empty() ? context.question.options : context.question.verdicts;
    const std::string outcome = range.events.empty() ? "" : outcomeText(range.events.back());
    const auto isThat = [&](const std::string& words) { return isOutcome(words, outcome); };
    if (std::count_if(verdicts.begin(), verdicts.end(), isThat) != 1)
        return Error{"the outcome is " + inQuotes(outcome) + ", which is not one of the options"};
    const auto found = std::find_if(verdicts.begin(), verdicts.end(), isThat);
    return Answer{.choice = static_cast<std::size_t>(found - verdicts.begin())};
}

Result<Answer> playedMoves(const RunRange& range, const QuestionContext&) {
    // Within a pivot its first decisions are known already.
    const bool isWithin = !range.before.candidates.empty() && !range.before.complete;
    Answer answer;
    if (!isWithin) answer.moves = movesOf(movesOfRun(range.events));
    if (!answer.moves.empty()) return answer;
    return Error{
        "no pivot is played there; `at` has to be where an interior pivot begins, "
        "such as 9.pivot.1"};
}

/// A number that a run has, as an answer.
template <std::size_t (*count)(const RunRange&)>
Result<Answer> numberOf(const RunRange& range, const QuestionContext&) {
    return Answer{.number = static_cast<double>(count(range))};
}
/// The triangles made between the positions.
std::size_t triangleCount(const RunRange& range) {
    return range.trianglesAfter - std::min(range.trianglesBefore, range.trianglesAfter);
}
/// How many points enter the edge ring, or leave it.
template <bool kInserted>
std::size_t ringChanges(const RunRange& range) {
    return static_cast<std::size_t>(
        std::count_if(range.events.begin(), range.events.end(), [](const Event& event) {
            const auto* ring = as<RingEvidence>(event);
            return ring != nullptr && ring->inserted == kInserted;
        }));
}
std::size_t refusedCount(const RunRange& range) { return refusedIn(range).size(); }
std::size_t keptCount(const RunRange& range) { return keptIn(range).size(); }

/// Entries of a ring; 0 without one.
std::size_t lengthOf(std::span<const RingPath> rings) {
    return rings.empty() ? 0 : rings.front().points.size();
}
std::size_t activeLength(const RunRange& range) {
    const std::vector<RingPath>& rings = range.after.rings;
    return lengthOf({rings.data(), rings.size() - stackedCount(rings)});
}
std::size_t stackedLength(const RunRange& range) {
    const std::span<const RingPath> rings = range.after.rings;
    return lengthOf(rings.last(stackedCount(rings)));
}
std::size_t ringCount(const RunRange& range) { return range.after.rings.size(); }

constexpr std::array kRunAnswers{
    RunAnswer{"refused", "points", pointsFrom<refusedIn>},
    RunAnswer{"kept", "points", pointsFrom<keptIn>},
    RunAnswer{"fan", "points", pointsFrom<fanOf>},
    RunAnswer{"next", "point", nextPivot},
    RunAnswer{"start", "point", startPoint},
    RunAnswer{"end", "point", endPoint},
    RunAnswer{"verdict", "choice", verdictThere},
    RunAnswer{"moves", "play", playedMoves},
    RunAnswer{"count:triangles", "number", numberOf<triangleCount>},
    RunAnswer{"count:enter", "number", numberOf<ringChanges<true>>},
    RunAnswer{"count:leave", "number", numberOf<ringChanges<false>>},
    RunAnswer{"count:refused", "number", numberOf<refusedCount>},
    RunAnswer{"count:kept", "number", numberOf<keptCount>},
    RunAnswer{"count:ring", "number", numberOf<activeLength>},
    RunAnswer{"count:stack", "number", numberOf<stackedLength>},
    RunAnswer{"count:rings", "number", numberOf<ringCount>},
};

}  // namespace

std::span<const QuestionKind> questionKinds() { return kQuestionKinds; }

const QuestionKind* findQuestionKind(std::string_view name) {
    return findNamed(kQuestionKinds, name);
}

Grade gradeAnswer(const Question& question, const Answer& given, const Answer& right) {
    const QuestionKind* kind = findQuestionKind(question.kind);
    assert(kind != nullptr);
    return kind->grade(given, right, question);
}

std::optional<std::size_t> rightOption(const QuestionContext& context, const Answer& right) {
    const QuestionKind* kind = findQuestionKind(context.question.kind);
    assert(kind != nullptr);
    if (right.choice) return right.choice;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < context.question.options.size(); ++i) {
        // "8, 9" names two points.
        const Words words = io::wordsIn(context.question.options[i], ',');
        const Result<Answer> option = kind->read(words, context);
        if (!option || !kind->grade(option.value(), right, context.question).right) continue;
        if (found) return std::nullopt;
        found = i;
    }
    return found;
}

bool isOutcome(std::string_view words, std::string_view outcome) {
    if (words.empty() || !outcome.starts_with(words)) return words == outcome;
    const std::string_view rest = outcome.substr(words.size());
    return rest.empty() || rest.front() == ' ' || rest.front() == ',';
}

bool isPossibleOutcome(std::string_view words) {
    const std::vector<std::string_view> known = outcomeWords();
    return std::any_of(known.begin(), known.end(), [&](std::string_view each) {
        if (isOutcome(words, each)) return true;
        // As in "splits into 19 and 13", "leaves, DONE".
        const std::string_view rest = words.substr(std::min(each.size(), words.size()));
        return isOutcome(each, words) &&
               (rest == ", DONE" || rest.find_first_of("0123456789") != std::string_view::npos);
    });
}

std::span<const RunAnswer> runAnswers() { return kRunAnswers; }

const RunAnswer* findRunAnswer(std::string_view name) { return findNamed(kRunAnswers, name); }

std::string optionLetter(std::size_t option) {
    return std::string(1, static_cast<char>('A' + static_cast<int>(option)));
}

}  // namespace se::teach
