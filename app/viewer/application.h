/// The whole program: the order of one frame. Independent of GLFW and EGL.
#pragma once

#include <memory>
#include <string>

#include "compare/compared_runs.h"
#include "document/alert_actions.h"
#include "document/context.h"
#include "document/document.h"
#include "document/edit_history.h"
#include "document/first_run.h"
#include "document/mesh_saving.h"
#include "document/new_points.h"
#include "document/scene_painter.h"
#include "input/key_map.h"
#include "lesson/lesson_player.h"
#include "options.h"
#include "panels/panel.h"
#include "panels/ui.h"
#include "scene/camera.h"
#include "scene/framing.h"
#include "session/playback.h"
#include "session/session.h"

namespace se::view {

/// The input of the window that is handled, for tests that wait for it.
struct InputProgress {
    std::uint64_t events = 0;  ///< Keys, characters, buttons, motions and changes of the window.
    bool settled = true;       ///< All of them are drawn.
};

class WindowExport;

class Application {
  public:
    Application(const Options& options, const ViewSettings& settings);
    ~Application();

    /// Call with a current OpenGL context. `contentScale` is the scale of the monitor.
    Status start(float contentScale);

    // From the window.
    /// The window is on a monitor of another scale, or the page is zoomed.
    void setContentScale(float scale) { contentScale_ = scale; }
    /// True if the key was handled: the user interface must not get it.
    bool key(const KeyChord& chord, bool repeated);
    void keyReleased(const KeyChord& chord);
    /// An input line was opened and gets the keyboard focus in a few frames: until then keys have
    /// to wait, so that the first characters are not lost.
    bool keysHaveToWait() const { return ui_.typing.waits(); }
    void character(const KeyPress& typed);
    /// A mouse button was pressed there, in pixels.
    void buttonPressed(glm::vec2 pointer) { ui_.viewDrag.press(pointer); }
    /// Files from the desktop: the first is opened; a notice reports the others.
    void drop(const std::vector<std::string>& paths);
    const Document& document() const { return document_; }
    /// The window is to be closed: at once, or after a question.
    void requestQuit() { document_.quit(); }
    /// Takes the results of the threads, or without threads does some of their work. To be called
    /// once before each frame. True if there is something new to draw.
    bool poll();
    /// Draws one frame into the bound framebuffer. The platform side of ImGui must be up to date.
    /// False if it equals the frame before: nothing was drawn, so do not swap.
    bool frame(glm::ivec2 size, double seconds);
    /// The next two frames are drawn even if they equal the one before: the window lost its
    /// content. Two, because some drivers resize the buffers one frame late.
    void redraw() { redraws_ = 2; }
    /// Called after each frame of the window, and at the end: writes the visible state in the
    /// program of the tests, and nothing in any other.
    Status writeState(const InputProgress& input = {});
    /// Times of the last frame: seconds outside of OpenGL, and in it.
    double uiSeconds() const { return uiSeconds_; }
    double glSeconds() const { return glSeconds_; }
    Session& session() { return session_; }
    /// Everything that a command may use, for pictures without a user and for tests.
    CommandContext& context() { return context_; }
    /// What the view shows, as last drawn.
    const DrawList& drawn() const { return painter_.list(); }
    const ScenePainter& painter() const { return painter_; }
    /// The run beside the open one, and what its view shows; null: there is none.
    Session* otherSession() { return compare_.shows() ? compare_.other() : nullptr; }
    const DrawList& otherDrawn() const { return compare_.list(); }
    /// Areas as last drawn, in pixels.
    const PanelRects& areas() const { return areas_; }
    float em() const { return imgui_->em(); }
    Camera& camera() { return camera_; }
    /// Draws later frames on that background.
    void setBackground(const Color& color) { ui_.picture.background = color; }
    /// Blocks until everything that the command line requests is visible.
    Status waitUntilDone();

    /// The next frame differs from this one even without new input.
    bool animating() const;
    bool wantsToQuit() const { return ui_.quitting; }
    bool fullScreen() const { return ui_.fullScreen; }
    bool inputFailed() const {
        return session_.input().phase() == SessionPhase::Failed ||
               sampling_.growth().phase() == GrowthPhase::Failed ||
               !lesson_.opening().complaint().empty();
    }
    std::string title() const;
    /// Reads recent files and layout from that file and keeps them there; to be called before
    /// start().
    void keepIn(const std::filesystem::path& path) { document_.keepIn(path, options_.resetLayout); }
    const ViewSettings& settings() const { return ui_.settings; }
    void rememberSize(glm::ivec2 size);

  private:
    /// The subject that the camera was last made to frame, and the part of the view for it.
    struct Framed {
        FrameRequest request = FrameRequest::None;
        ViewPart part;
        unsigned revision = 0;  ///< Of the camera, after that.
    };

    // The parts of a frame, in their order.
    void update(double seconds);
    void layOut(glm::ivec2 size, double seconds);
    void fillViews();
    void drawUserInterface(const PanelRects& rects);
    bool draw(glm::ivec2 size, bool panelsChanged);
    void endFrame(glm::ivec2 size);

    PanelRects areasIn(glm::vec2 size) const;
    bool holdsLook(const Command& command, int key);
    bool endsBlankScreen(const KeyChord& chord);
    const Command* commandFor(const KeyChord& chord) const;
    bool isOfLesson(const Command& command) const;
    void play(double seconds);
    WindowState windowState() const;
    void followTask();
    float scaleIn(glm::ivec2 size) const;
    void placeCamera();
    void settleCamera();
    void frameNow(FrameRequest request);
    void moveCamera();
    void showFinishedMesh();
    void saveWindowPicture(glm::ivec2 size);
    void narrate();
    const Palette& palette() const { return paletteOf(ui_.settings.theme); }

    Options options_;
    Session session_;
    Playback playback_;
    Camera camera_;
    UiState ui_;
    CommandContext context_;
    std::unique_ptr<Ui> imgui_;
    ScenePainter painter_;
    std::uint32_t placedGeneration_ = 0;  ///< Generation that the camera was placed for.
    float contentScale_ = 1.0F;
    Document document_;
    AlertsShown alerts_;
    NewPoints sampling_;
    ComparedRuns compare_;
    MeshSaving mesh_;
    LessonPlayer lesson_;
    FirstRun firstRun_;
    std::unique_ptr<WindowExport> export_;
    EditHistory history_;
    bool differenceAsked_ = false;   ///< --goto difference is in progress, or done.
    bool noticed_ = false;           ///< A notice is visible.
    bool working_ = false;           ///< Without threads: there is work left.
    const char* focused_ = nullptr;  ///< The window with the keyboard focus where no panel has it.
    FollowedDecision followed_;      ///< Last decision at the cursor.
    std::optional<unsigned> closeUp_;  ///< Revision of the camera as it was led to a decision.
    bool ended_ = false;               ///< The cursor was at the end of the run.
    bool dragged_ = false;             ///< A point was being dragged in the last frame.
    std::string homeOf_;               ///< Name of the input that the camera was reset for.
    std::string narrated_;             ///< Address of the last sentence on stdout.
    std::optional<Framed> framed_;     ///< Framed while the layout was settling.
    bool pivotSeen_ = false;  ///< The pivot was in the view, or the camera on the way to it.
    PanelRects areas_;        ///< As last drawn.
    std::string taskOf_;      ///< Source of the input that the column was reset for.
    bool finished_ = false;   ///< The finished mesh was shown in the frame before.
    bool judged_ = false;     ///< Its faults were known.
    int redraws_ = 0;         ///< Number of frames to draw even if nothing changes.
    double uiSeconds_ = 0.0;
    double glSeconds_ = 0.0;
};

}  // namespace se::view
