/// Shows the steps of the open lesson in the run: opens their inputs, goes to their positions,
/// hides what follows an open question. Independent of window and OpenGL.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "document.h"
#include "jobs/background_job.h"
#include "jobs/open_lesson.h"
#include "layers/layer.h"
#include "spiraling_edge/base/result.h"
#include "start_options.h"

namespace se::view {

class LessonController {
  public:
    LessonController(CommandContext& context, DocumentController& document)
        : c_(context), document_(document) {}

    /// Opens the lesson of the command line, if there is one.
    void begin(const Options& options);
    /// Takes what threads have done; shows a step once its input is open. True if there is
    /// something new to draw.
    bool poll();
    /// Carries out the requests of panels and commands.
    void carryOut();
    /// True once per step, when its camera can be placed.
    bool takeAim();
    /// Places the camera of the step.
    void aim();
    /// Something is on its way.
    bool moving() const { return opening_.busy() || entering_; }
    /// Blocks until the lesson is open, or failed.
    void waitUntilDone();
    /// Error if the lesson of the command line cannot be opened.
    const Status& status() const { return status_; }

  private:
    using Clock = std::chrono::steady_clock;

    LessonPanel& panel() { return c_.ui.lesson; }
    LessonWalk& walk() { return c_.ui.lesson.walk; }
    void open(const std::string& source, std::optional<std::size_t> step);
    void take(OpenedLesson lesson);
    std::size_t keptStep(const OpenedLesson& lesson) const;
    void keepStep();
    void watchFile();
    void goTo(std::size_t step);
    void enter();
    void leaveStep();
    void applyLayers();
    void compare();
    void play();
    void show();
    void follow(const std::string& address);
    void save();
    void saveLesson(const std::string& file);
    void close();
    bool hasInput() const;
    bool arrived() const;
    bool isAway() const;
    void carryOut(LessonAsk ask);

    CommandContext& c_;
    DocumentController& document_;
    BackgroundQuery<OpenedLesson> opening_;
    std::optional<std::size_t> toStep_;          ///< Of the lesson that is being opened.
    bool entering_ = false;                      ///< The run is on its way to the step.
    bool aiming_ = false;                        ///< The camera is not placed yet.
    bool fresh_ = false;                         ///< The step has opened another input.
    std::optional<Address> home_;                ///< Position of the step, or of its answer.
    InputSpec input_;                            ///< Input of the step.
    std::optional<LayerModes> layers_;           ///< The user's, while a step pins or hides some.
    std::optional<double> rate_;                 ///< The user's, while a step plays.
    std::optional<LayoutPreset> layout_;         ///< Of the lesson, while a step compares.
    std::filesystem::path resultFile_;           ///< Of --result; empty: none.
    std::filesystem::file_time_type written_{};  ///< Of the lesson's file, when it was read.
    Clock::time_point looked_;                   ///< When the file was looked at.
    Clock::time_point polled_ = Clock::now();
    Status status_ = success();
};

}  // namespace se::view
