/// An export: a program of its own, without a window, goes to each frame, and a writer takes it.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "application.h"
#include "document/context.h"
#include "export/formats.h"
#include "export/order.h"
#include "panel_state/picture_look.h"
#include "panel_state/settings.h"
#include "render/context.h"
#include "render/gl_objects.h"
#include "scene/framing.h"
#include "scene/picture.h"

struct ImGuiContext;

namespace se::view {

// Pictures of the program's frames, without a window: their size, and how they are drawn.

class Application;

/// Scale of text in a picture of that size, which is looked at as a whole: 1 up to 1280x800.
double textScale(glm::ivec2 size);

/// Pixels to draw for the size of the settings; sets their scale of text to that of the look.
glm::ivec2 drawnSize(ViewSettings& settings, const PictureLook& look);

/// Fails with a sentence if a picture of `size` pixels cannot be drawn, not even in tiles of which
/// no side exceeds `most` pixels.
Status checkDrawn(glm::ivec2 size, double uiScale, int most = greatestPicture());

/// Draws `frames` frames of `size` pixels, of which the first may only determine the layout, and
/// returns the last as the look has it: on no background, reduced. A picture with a side over
/// `most` pixels is drawn in tiles. Call with a current context.
Picture drawPicture(Application& application, Target& target, glm::ivec2 size, int frames,
                    int most = greatestPicture());

/// Reason why an export ended without its file, with the exit code of the command line.
struct ExportFailure {
    int code = kExitInternal;
    std::string message;
};

/// Draws one frame at each advance(). Needs a current OpenGL context, also when it is destroyed;
/// the context of Dear ImGui and the framebuffer stay as they were.
class ExportRun {
  public:
    /// `options`: with an order. The settings give size, theme and layers.
    ExportRun(const Options& options, ViewSettings settings);
    ~ExportRun();
    ExportRun(const ExportRun&) = delete;
    ExportRun& operator=(const ExportRun&) = delete;

    /// Does the next part of the work: opens the input, or makes one frame. With `waits` it blocks
    /// until that is done; otherwise it returns while the input is being opened.
    void advance(bool waits);
    /// Complete, or failed.
    bool done() const { return phase_ == Phase::Done; }
    const std::optional<ExportFailure>& failure() const { return failure_; }
    /// Frames made so far, and of all; 0 until that is known.
    std::size_t made() const { return made_; }
    std::size_t total() const { return plan_.places.size(); }
    /// What the file lacks, in a sentence; empty: nothing.
    const std::string& notice() const { return notice_; }
    /// The sentence at the end: "Saved 29 frames as out.gif.".
    std::string doneText() const;

  private:
    enum class Phase : std::uint8_t { Starting, Opening, Planning, Frames, Done };

    void start();
    void open(bool waits);
    void plan();
    void makeFrame();
    Status goTo(const std::string& place);
    Status openStep(std::size_t step);
    Status showComparison(bool wasSplit);
    void placeCamera();
    void aimAtFigure();
    void goToAnswer();
    Status addStep();
    Status addFrame(const FrameStep* step, bool answer);
    Status addShapes(ExportFrame& frame);
    FrameShapes shapesOf(const Session& run, const DrawList& list, const Rect& view,
                         const std::optional<DrawList>& other);
    std::string caption();
    std::function<std::string(const std::string&)> linkToProgram();
    void draw(int frames);
    void fail(int code, std::string message);
    Session& session() { return application_->session(); }
    UiState& ui() { return application_->context().ui; }

    Options options_;
    ViewSettings settings_;
    ExportOrder order_;
    const ExportFormat* format_;
    glm::ivec2 size_;
    ImGuiContext* context_ = nullptr;  ///< Of application_.
    std::unique_ptr<Application> application_;
    Target target_{0};
    std::unique_ptr<FrameWriter> writer_;
    FramePlan plan_;
    std::vector<std::size_t> steps_;  ///< Of the lesson, from 0; one per frame.
    LessonWalk walk_;                 ///< Of the lesson.
    std::optional<ShownStep> shown_;  ///< Of application_.
    FollowedDecision aimed_{};        ///< Decision of the step that the camera was aimed for.
    bool ownView_ = false;            ///< The step before has a camera of its own.
    Picture pixels_;
    Phase phase_ = Phase::Starting;
    std::size_t made_ = 0;
    std::string notice_;
    std::optional<ExportFailure> failure_;
};

// The export of the window: connects the dialog, the open run and the work.

class ExportRun;

class WindowExport {
  public:
    explicit WindowExport(CommandContext& context);
    ~WindowExport();
    WindowExport(const WindowExport&) = delete;
    WindowExport& operator=(const WindowExport&) = delete;

    /// Begins, continues or ends the work as the dialog says. Once per frame of the window, with
    /// its OpenGL context.
    void advance();
    bool busy() const { return run_ != nullptr; }

  private:
    void begin();
    void end();

    CommandContext& c_;
    std::unique_ptr<ExportRun> run_;
};

}  // namespace se::view
