/// The open lesson: the step that is shown, and the answers to its questions. Independent of the
/// run; lesson_player.h shows the steps in it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jobs/open_lesson.h"
#include "spiraling_edge/points/point_name.h"
#include "teach/play_moves.h"
#include "teach/question.h"
#include "teach/result.h"

namespace se::view {

/// The user's work on one question.
struct QuestionState {
    std::string typed;    ///< Points by name, an option by letter, or a number.
    teach::Answer given;  ///< Answer read from `typed`.
    teach::MoveKind move = teach::MoveKind::MoveStart;  ///< The next one by a click.
    std::string complaint;   ///< Why `typed` cannot be read; empty: it can.
    std::vector<int> hands;  ///< Raised by people in a room, per option.
    std::size_t tries = 0;
    double seconds = 0.0;               ///< For which the question was open, until the last try.
    std::optional<teach::Grade> grade;  ///< Of the last try; nothing before the first.
    bool shown = false;                 ///< The right answer is shown.
};

class LessonWalk {
  public:
    /// Opens a lesson at a step, from 0, or at its last one. The answers to the same text stay.
    void open(SharedLesson lesson, std::size_t step);
    bool isOpen() const { return opened_ != nullptr; }

    // Everything below requires isOpen().
    const SharedLesson& opened() const { return opened_; }
    const std::string& source() const { return opened_->source; }
    const std::filesystem::path& folder() const { return opened_->folder; }
    const teach::Lesson& lesson() const { return opened_->lesson; }
    std::size_t step() const { return step_; }
    const teach::LessonStep& shownStep() const { return lesson().steps[step_]; }
    /// Input, rules, names and position of the step.
    const teach::StepSetting& setting() const { return setting_; }
    /// To a step, from 0, or to the last one.
    void goTo(std::size_t step);

    // The question of the step.
    const teach::Question* question() const {
        return shownStep().question ? &*shownStep().question : nullptr;
    }
    /// There is a question whose answer is not shown.
    bool asks() const { return question() != nullptr && !state().shown; }
    /// The question takes points, and its answer is not shown.
    bool takesPoints() const;
    const QuestionState& state() const { return states_[step_]; }
    const teach::RightAnswer& right() const { return *opened_->right[step_]; }
    /// Number of points of the input of the step, which answers refer to.
    void setPointCount(std::size_t count) { pointCount_ = count; }
    /// Reads the text of an answer.
    void type(std::string text);
    /// Answers by one of the options, from 0: by its letter, or where the question takes something
    /// else, by what the option says.
    void choose(std::size_t option);
    /// The option that the answer is; nothing if it is none.
    std::optional<std::size_t> chosen() const;
    /// Marks a point or unmarks it. A question for one point has one mark at most; for a pivot to
    /// play, this adds a move. Requires takesPoints().
    void toggle(Index point);
    /// Chooses the move that a click makes, for a pivot to play.
    void chooseMove(teach::MoveKind move) { states_[step_].move = move; }
    void removeMove(std::size_t move);
    /// Of a pivot to play, after a wrong try: the decision of the run against the first wrong move;
    /// null if there is none, or if it would tell a move that is still to find.
    const Event* decisionAgainstTry() const;
    /// What is wrong with the answer given, without the right one: why it cannot be read, or that
    /// the last try was wrong. Empty if nothing is.
    std::string tryText() const;
    /// Points that the answer given names.
    std::vector<Index> givenPoints() const;
    void setHands(std::vector<int> hands) { states_[step_].hands = std::move(hands); }
    /// Counts time during which the question is open.
    void addSeconds(double seconds) { open_ += seconds; }
    /// Grades what is given; a right answer is shown. No effect if nothing can be read.
    void answer();
    /// Shows the right answer. Hands that were counted become the answer of a room.
    void showAnswer();

    /// All answers so far, in the order of the steps.
    const teach::LessonResult& result() const { return result_; }
    bool hasAnswers() const { return !result_.answers.empty(); }

  private:
    teach::QuestionContext context() const { return {*question(), setting_.names}; }
    void record(teach::GivenAnswer answer);
    void addMove(Index point);
    void typeMoves(std::vector<teach::PlayMove> moves);

    SharedLesson opened_;
    std::size_t step_ = 0;
    teach::StepSetting setting_;
    std::vector<QuestionState> states_;  ///< By step.
    std::size_t pointCount_ = kNone;
    double open_ = 0.0;  ///< Seconds for which the question has been open.
    teach::LessonResult result_;
};

// State of the panel Lesson: the open lesson. Plain values.

struct LessonPanel {
    LessonWalk walk;
    float captionEms = 0.0F;   ///< Height of the text in Present; 0: not drawn yet.
    bool countsHands = false;  ///< Of the question: the fields for hands are open.

    std::uint64_t nextPractice = 1;  ///< Seed of the next pivot to play.

    /// Set by LessonPlayer: the run is at another position, or has other settings.
    bool away = false;

    /// Hands of a room are counted for the open question: clicks mark nothing.
    bool countsRoom() const {
        return countsHands && walk.question() != nullptr && !walk.question()->options.empty();
    }
    /// A question is open: all decisions after it are hidden.
    bool hides() const { return walk.isOpen() && walk.asks() && !away; }
};

}  // namespace se::view
