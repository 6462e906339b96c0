#include "lesson_walk.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace se::view {

namespace {

/// "3, 4 q" as words; commas separate as well.
std::vector<std::string> wordsOfAnswer(const std::string& text, bool points) {
    if (!points) return {text};
    std::vector<std::string> words;
    std::string word;
    for (const char sign : text + ' ') {
        if (sign != ' ' && sign != ',') {
            word += sign;
        } else if (!word.empty()) {
            words.push_back(std::exchange(word, {}));
        }
    }
    return words;
}

bool asksPoints(const teach::Question& question) {
    return question.kind == "points" || question.kind == "point";
}

}  // namespace

void LessonWalk::open(OpenedLesson lesson, std::size_t step) {
    opened_ = std::make_shared<const OpenedLesson>(std::move(lesson));
    states_.assign(this->lesson().steps.size(), {});
    result_ = {this->lesson().title, this->lesson().hash, {}, {}};
    goTo(step);
}

void LessonWalk::goTo(std::size_t step) {
    assert(isOpen());
    step_ = std::min(step, lesson().steps.size() - 1);
    setting_ = teach::settingOf(lesson(), step_);
    names_ = teach::pointNames(setting_.names);
    open_ = state().seconds;
}

bool LessonWalk::takesPoints() const { return asks() && asksPoints(*question()); }

void LessonWalk::type(std::string text) {
    assert(asks());
    QuestionState& state = states_[step_];
    state.typed = std::move(text);
    state.given = {};
    state.complaint.clear();
    state.grade.reset();
    const std::vector<std::string> words = wordsOfAnswer(state.typed, asksPoints(*question()));
    if (words.empty() || words.front().empty()) return;
    const Result<teach::Answer> read =
        teach::findQuestionKind(question()->kind)->read(words, context());
    if (read) {
        state.given = read.value();
    } else {
        state.complaint = read.error().message;
    }
}

void LessonWalk::toggle(Index point) {
    assert(takesPoints());
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
