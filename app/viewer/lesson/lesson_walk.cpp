#include "lesson_walk.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "rows/evidence_rows.h"
#include "run/strings.h"

namespace se::view {

namespace {

bool asksPoints(const teach::Question& question) {
    return question.kind == "points" || question.kind == "point";
}

/// The parts of a text between any of these signs, without blanks around them.
std::vector<std::string> partsOf(const std::string& text, std::string_view signs) {
    std::vector<std::string> parts;
    std::string part;
    for (const char sign : text + signs.front()) {
        if (signs.find(sign) == std::string_view::npos) {
            part += sign;
        } else {
            const std::string whole = trimmed(std::exchange(part, {}));
            if (!whole.empty()) parts.push_back(whole);
        }
    }
    return parts;
}

/// "3, 4 q" as points, "keep 3; fan 2 3 4" as moves, all else as it is.
std::vector<std::string> wordsOfAnswer(const std::string& text, const teach::Question& question) {
    if (asksPoints(question)) return partsOf(text, ", ");
    return question.kind == "play" ? partsOf(text, ";\n") : std::vector<std::string>{text};
}

/// Moves are played in this order; candidates, kept or removed, in that of the clicks.
int orderOf(const teach::PlayMove& move) {
    const bool removes = move.kind == teach::MoveKind::Remove;
    return static_cast<int>(removes ? teach::MoveKind::Keep : move.kind);
}

bool isVerdict(teach::MoveKind kind) {
    return kind == teach::MoveKind::Keep || kind == teach::MoveKind::Remove;
}

}  // namespace

void LessonWalk::open(SharedLesson lesson, std::size_t step) {
    const bool same =
        isOpen() && lesson->source == source() && lesson->lesson.hash == this->lesson().hash;
    opened_ = std::move(lesson);
    if (!same) {
        states_.assign(this->lesson().steps.size(), {});
        result_ = {this->lesson().title, this->lesson().hash, {}, {}};
        step_ = 0;
        open_ = 0.0;
    }
    goTo(step);
}

void LessonWalk::goTo(std::size_t step) {
    assert(isOpen());
    states_[step_].seconds = open_;
    step_ = std::min(step, lesson().steps.size() - 1);
    setting_ = teach::settingOf(lesson(), step_);
    open_ = state().seconds;
}

bool LessonWalk::takesPoints() const {
    return asks() && (asksPoints(*question()) || question()->kind == "play");
}

std::vector<Index> LessonWalk::givenPoints() const {
    std::vector<Index> points = state().given.points;
    for (const teach::PlayMove& move : state().given.moves)
        points.insert(points.end(), move.points.begin(), move.points.end());
    return points;
}

void LessonWalk::typeMoves(std::vector<teach::PlayMove> moves) {
    std::stable_sort(moves.begin(), moves.end(),
                     [](const auto& a, const auto& b) { return orderOf(a) < orderOf(b); });
    type(joined(moves, "; ", [this](const teach::PlayMove& each) {
        return teach::moveText(each, setting_.names);
    }));
    // A fan of one point, which goes on to grow, cannot be read yet.
    states_[step_].given.moves = std::move(moves);
}

void LessonWalk::removeMove(std::size_t move) {
    std::vector<teach::PlayMove> moves = state().given.moves;
    if (move >= moves.size()) return;
    moves.erase(moves.begin() + static_cast<std::ptrdiff_t>(move));
    typeMoves(std::move(moves));
}

/// Adds the chosen move about a point: the fan grows, another verdict on a candidate and another
/// next pivot replace those before.
void LessonWalk::addMove(Index point) {
    std::vector<teach::PlayMove> moves = state().given.moves;
    const teach::MoveKind kind = state().move;
    const auto found = std::find_if(moves.begin(), moves.end(), [&](const teach::PlayMove& each) {
        const bool verdict = isVerdict(kind) && isVerdict(each.kind);
        const bool once = kind == teach::MoveKind::Fan || kind == teach::MoveKind::NextPivot;
        return (verdict && each.points.front() == point) || (once && each.kind == kind);
    });
    if (found == moves.end()) {
        moves.push_back({kind, {point}});
    } else if (kind == teach::MoveKind::Fan) {
        found->points.push_back(point);
    } else {
        *found = {kind, {point}};
    }
    typeMoves(std::move(moves));
}

const Event* LessonWalk::decisionAgainstTry() const {
    const auto& grade = state().grade;
    if (question() == nullptr || question()->kind != "play" || !grade || grade->right)
        return nullptr;
    const std::vector<Event>& shown = right().shown;
    const std::vector<teach::PlayMove>& given = state().given.moves;
    const std::vector<teach::RunMove> moves = teach::movesOfRun(shown);
    const std::size_t alike = teach::movesAlike(given, right().answer.moves);
    if (alike == given.size()) return nullptr;
    const teach::RunMove* expected = alike < moves.size() ? &moves[alike] : nullptr;
    const Event* against = teach::decisionAgainst(shown, given[alike], expected);
    // Of the next pivot only the rule is told.
    const bool tells = expected != nullptr && against == &expected->event &&
                       expected->move.kind != teach::MoveKind::NextPivot &&
                       expected->move.points != given[alike].points;
    if (tells || (against != nullptr && isA<EmitEvidence>(*against))) return nullptr;
    // Not that of `moves`, which end with this function.
    const auto same = std::find_if(shown.begin(), shown.end(), [&](const Event& each) {
        return against != nullptr && each.address == against->address;
    });
    return same != shown.end() ? &*same : nullptr;
}

std::string LessonWalk::tryText() const {
    if (!state().complaint.empty()) return "! " + state().complaint;
    const auto& grade = state().grade;
    if (!grade || grade->right) return {};
    if (question()->kind != "play") return "Not right yet: try again.";
    const std::vector<teach::PlayMove>& given = state().given.moves;
    const std::size_t alike = teach::movesAlike(given, right().answer.moves);
    const std::string upTo =
        alike == 0 ? "Not so. " : "Right up to move " + std::to_string(alike) + ". ";
    if (alike == given.size()) return upTo + "More follows.";
    const Event* against = decisionAgainstTry();
    if (against == nullptr) return upTo + "Another move follows.";
    return upTo + "Section " + sectionOf(*against) + ": " +
           withShortNumbers(teach::moveReasonText(*against, setting_.names));
}

void LessonWalk::choose(std::size_t option) {
    const bool byLetter = question()->kind == "choice";
    type(byLetter ? teach::optionLetter(option) : question()->options[option]);
}

std::optional<std::size_t> LessonWalk::chosen() const {
    if (state().given.choice) return state().given.choice;
    const std::vector<std::string>& options = question()->options;
    const auto found = std::find(options.begin(), options.end(), state().typed);
    if (found == options.end()) return std::nullopt;
    return static_cast<std::size_t>(found - options.begin());
}

void LessonWalk::type(std::string text) {
    assert(asks());
    QuestionState& state = states_[step_];
    state.typed = std::move(text);
    state.given = {};
    state.complaint.clear();
    state.grade.reset();
    const std::vector<std::string> words = wordsOfAnswer(state.typed, *question());
    if (words.empty() || words.front().empty()) return;
    const Result<teach::Answer> read =
        teach::findQuestionKind(question()->kind)->read(words, context());
    if (!read) {
        state.complaint = read.error().message;
        return;
    }
    state.given = read.value();
    for (const Index point : givenPoints()) {
        if (point < pointCount_) continue;
        state.complaint = "There is no point " + std::to_string(point) + ".";
        state.given = {};
        return;
    }
}

void LessonWalk::toggle(Index point) {
    assert(takesPoints());
    if (question()->kind == "play") return addMove(point);
    std::vector<Index> points = state().given.points;
    const auto found = std::find(points.begin(), points.end(), point);
    const bool marked = found != points.end();
    if (marked) points.erase(found);
    if (!marked && question()->kind == "point") points.clear();
    if (!marked) points.push_back(point);
    type(points.empty() ? std::string{} : teach::pointsText(points, setting_.names));
}

void LessonWalk::record(teach::GivenAnswer answer) {
    QuestionState& state = states_[step_];
    answer.seconds = state.seconds = open_;
    answer.tries = std::max<std::size_t>(1, state.tries);
    auto& all = result_.answers;
    const auto place = std::lower_bound(
        all.begin(), all.end(), answer.step,
        [](const teach::GivenAnswer& each, std::size_t step) { return each.step < step; });
    if (place != all.end() && place->step == answer.step) {
        if (!answer.isOfRoom() && place->first) answer.first = place->first;
        *place = std::move(answer);
    } else {
        all.insert(place, std::move(answer));
    }
}

void LessonWalk::answer() {
    assert(asks());
    QuestionState& state = states_[step_];
    if (!state.complaint.empty() || state.given == teach::Answer{}) return;
    ++state.tries;
    state.grade = teach::gradeAnswer(*question(), state.given, right().answer);
    record(teach::gradedAnswer(lesson(), step_, state.given, right()));
    if (state.grade->right) state.shown = true;
}

void LessonWalk::showAnswer() {
    assert(asks());
    QuestionState& state = states_[step_];
    const std::vector<int>& hands = state.hands;
    if (std::accumulate(hands.begin(), hands.end(), 0) > 0) {
        record(teach::roomAnswer(lesson(), step_, {hands.begin(), hands.end()}, right()));
    } else if (!state.grade) {
        answer();
    }
    state.shown = true;
}

}  // namespace se::view
