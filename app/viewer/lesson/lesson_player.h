/// Shows the steps of the open lesson in the run: opens their inputs, goes to their positions,
/// hides what follows an open question. Independent of window and OpenGL.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "document/context.h"
#include "document/document.h"
#include "document/start_options.h"
#include "export/order.h"
#include "input/key_map.h"
#include "jobs/background_job.h"
#include "jobs/file_watch.h"
#include "jobs/open_lesson.h"
#include "layers/layer.h"
#include "run/model.h"
#include "run/selection.h"
#include "session/compare_with.h"
#include "session/layout_preset.h"
#include "session/playback.h"
#include "spiraling_edge/base/result.h"
#include "teach/lesson.h"

namespace se::view {

/// A step of a lesson in the open run, of the window or of an export. What it changes of the user's
/// choices is put back when it is left: layers, playback, the layout for a comparison.
class ShownStep {
  public:
    explicit ShownStep(CommandContext& context) : c_(context) {}

    /// Gives the points their names, selects those of the step, pins and hides its layers. The run
    /// has to be at its position, and `walk` to stay at the step until leave().
    void enter(const LessonWalk& walk);
    /// Camera of the step: its own, or one that frames the decision or all, from the direction of
    /// its view. Fails if its own is no position.
    Status aim(const LessonWalk& walk);
    /// Plays from the cursor to an address.
    void play(PlayUnit unit, double rate, const Address& until);
    /// Shows the run of `compare` beside this one: in the layout Compare, or within Present.
    /// Requires a step that compares.
    void compare(const LessonWalk& walk);
    void leave();
    void putBackChoices();
    /// The layers as the user has them, without those that the step pins and hides.
    LayerModes layersOfUser() const;

  private:
    CommandContext& c_;
    std::vector<std::pair<LayerId, LayerMode>> layers_;
    std::optional<PlaySpeed> speed_;
    bool compares_ = false;
    std::optional<LayoutPreset> layout_;  ///< Before the layout Compare.
};

inline constexpr const char* kNoLesson = "No lesson is open: Help > Tour opens the first one.";

class LessonPlayer {
  public:
    explicit LessonPlayer(CommandContext& context) : c_(context), step_(context) {}

    /// Opens the lesson of the command line, if there is one.
    void begin(const Options& options);
    /// Takes what threads have done; shows a step once its input is open. True if there is
    /// something new to draw.
    bool poll();

    void open(const std::string& source, std::optional<std::size_t> step = std::nullopt);
    /// To the next step; in Present an open question is answered first.
    void next();
    void previous();
    /// To a step, from 0.
    void toStep(std::size_t step);
    /// To the position of the step.
    void returnToStep();
    /// From the position of the step to its end.
    void play();
    /// Grades what is given to the open question.
    void answer();
    /// Shows the right answer to the open question.
    void showAnswer();
    void close();
    /// Something else than a step of the lesson is opened: closes it at once, or stops opening it.
    /// Not while a frame is drawn.
    void closeForOther();
    /// To the address of a link in the text.
    void follow(const std::string& address);
    void saveResult(const std::string& file);
    /// Writes the bookmarks as the steps of a lesson.
    void saveLesson(const std::string& file);

    /// Puts the user's choices back that the step has changed.
    void putBackChoices() { step_.putBackChoices(); }
    LayerModes layersOfUser() const { return step_.layersOfUser(); }
    /// True once per step, when its camera can be placed.
    bool takeAim();
    /// Places the camera of the step.
    void aim();
    /// A lesson is being opened, or the run goes to a step.
    bool moving() const { return opening_.busy() || entering_; }
    /// Blocks until the lesson is open, or failed.
    void waitUntilDone();
    /// The opening of a lesson, and why the last one failed.
    const BackgroundQuery<SharedLesson>& opening() const { return opening_; }

  private:
    using Clock = std::chrono::steady_clock;

    LessonPanel& panel() { return c_.ui.lesson; }
    LessonWalk& walk() { return c_.ui.lesson.walk; }
    void take(SharedLesson lesson);
    std::vector<Index> possiblePoints() const;
    std::size_t keptStep(const OpenedLesson& lesson) const;
    void keepStep();
    void watchFile();
    bool goTo(std::size_t step);
    void arrive();
    void enter();
    void leaveStep();
    void playTo(const Address& until);
    void playStep();
    void show();
    void save();
    void conclude();
    void leave();
    void whileOpen(const std::function<void()>& call);
    bool hasInput() const;
    bool isUnderWay() const;
    bool isAtStep() const;
    bool isAway() const;

    CommandContext& c_;
    BackgroundQuery<SharedLesson> opening_;
    std::optional<std::size_t> toStep_;  ///< Of the lesson that is being opened.
    bool entering_ = false;              ///< The run is on its way to the step.
    bool aiming_ = false;                ///< The camera is not placed yet.
    bool fresh_ = false;                 ///< The step has opened another input.
    std::optional<Address> home_;        ///< Position of the step, or of its answer.
    RunSpec input_;                      ///< Input of the step.
    ShownStep step_;
    bool playsOnArrival_ = false;               ///< The step is played once the run is there.
    bool retried_ = false;                      ///< The move to the step was made again.
    std::optional<LayoutPreset> layoutBefore_;  ///< The user's, while a lesson is open.
    bool layoutGiven_ = false;                  ///< By the command line.
    std::string resultSource_;                  ///< The lesson of the command line.
    std::filesystem::path resultFile_;          ///< Of --result; empty: none.
    FileWatch watch_;                           ///< Of the lesson's file.
    Clock::time_point polled_ = Clock::now();
};

// Commands of the open lesson, and the commands that are off while its question is open.

/// Whether a command shows nothing of what follows the cursor in the run: camera, layers, looks,
/// moves, which end at the question, and what leaves it.
bool isAllowedDuringQuestion(const Command& command);

/// Answers the open question by a key: a letter chooses its option, Enter is the button Answer.
/// True if the key was for the question; not in Present, where B is black.
bool answerByKey(const KeyChord& chord, CommandContext& context);

namespace actions {

/// Opens the lesson that shows the six stages on a torus.
void openTour(CommandContext& c);
/// Opens the next pivot to play: that after the open one, or after the last one.
void openPractice(CommandContext& c);

}  // namespace actions

}  // namespace se::view
