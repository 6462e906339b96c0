/// Ties everything together: the order of one frame. Knows neither GLFW nor EGL.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "commands/commands.h"
#include "controllers/alerts.h"
#include "controllers/compare.h"
#include "controllers/document.h"
#include "controllers/mesh_saving.h"
#include "controllers/sampling.h"
#include "controllers/scene_painter.h"
#include "options.h"
#include "panels/panel.h"
#include "panels/ui.h"
#include "scene/camera.h"
#include "session/playback.h"
#include "session/session.h"

namespace se::view {

class Application {
  public:
    Application(const Options& options, const ViewSettings& settings);
    ~Application();

    /// Requires a current OpenGL context. `contentScale` is what the monitor says.
    Status start(float contentScale);

    // From the window.
    /// True if the key is used up: the user interface must not see it.
    bool key(const KeyChord& chord, bool repeated);
    void keyReleased(const KeyChord& chord);
    /// A line to type into was opened and gets the keyboard in a few frames: until then keys have
    /// to wait, or the first of what is typed would be lost.
    bool keysHaveToWait() const { return ui_.typing.waits(); }
    void character(unsigned sign);
    /// A button of the mouse came down there, in pixels.
    void buttonPressed(glm::vec2 pointer) { ui_.viewDrag.press(pointer); }
    /// Files from the desktop: the first is opened, what becomes of the others is said.
    void drop(const std::vector<std::string>& paths);
    /// The window is to be closed: at once, or after a question.
    void requestQuit() { ui_.requests.quit = true; }
    /// Takes over what threads have finished. True if there is something new to draw.
    bool poll();
    /// Draws one frame into the bound framebuffer. The platform side of ImGui must be up to date.
    void frame(glm::ivec2 size, double seconds);
    /// What can be seen and asked of the program, as JSON: for tests.
    std::string stateDump() const;
    /// Writes stateDump() to the file of --state-dump, if there is one and it says something new.
    Status writeState();
    /// Of the last frame: seconds outside of OpenGL, and in it.
    double uiSeconds() const { return uiSeconds_; }
    double glSeconds() const { return glSeconds_; }
    /// From the start of the program until the input was first drawn; 0 before.
    double firstFrameSeconds() const { return firstFrameSeconds_; }
    /// From the start of the program until the first frame at all, with or without an input.
    double firstWindowSeconds() const { return firstWindowSeconds_; }
    /// The longest time between two frames while an input was being opened, the one that shows it
    /// among them, apart from OpenGL.
    double longestOpeningSeconds() const { return longestOpeningSeconds_; }
    Session& session() { return session_; }
    /// Blocks until what was asked for on the command line can be seen.
    Status settle();

    /// The next frame differs from this one even if nothing comes in.
    bool animating() const;
    bool wantsToQuit() const { return ui_.quitting; }
    bool takeFullScreenRequest() { return std::exchange(ui_.requests.fullScreen, false); }
    bool inputFailed() const {
        return session_.phase() == SessionPhase::Failed || ui_.growth.phase == GrowthPhase::Failed;
    }
    std::string title() const;
    /// Takes recent files and layout from that file and keeps them there; to be called before
    /// start().
    void keepIn(const std::filesystem::path& path) { filing_.keepIn(path, options_.resetLayout); }
    const ViewSettings& settings() const { return ui_.settings; }
    void rememberSize(glm::ivec2 size);

  private:
    void noteTimes(std::chrono::steady_clock::time_point built);
    bool goToBoxTakes(const KeyChord& chord);
    void goToTyped();
    void undoOrRedo();
    void observeEdits();
    bool holdsLook(const Command& command, int key);
    void play(double seconds);
    void placeCamera(const Layout& layout);
    void drawUserInterface(const Layout& layout);
    void saveWindowPicture(glm::ivec2 size);
    void copyPlace();
    void pastePlace();
    void narrate();
    const Palette& palette() const { return paletteOf(ui_.settings.theme); }

    Options options_;
    Session session_;
    Playback playback_;
    Camera camera_;
    UiState ui_;
    CommandContext commands_;
    std::unique_ptr<Ui> imgui_;
    ScenePainter painter_;
    std::uint32_t placedGeneration_ = 0;  ///< The camera was placed for it.
    float contentScale_ = 1.0F;
    Filing filing_;
    Alerting alerting_;
    Growing growing_;
    Comparing comparing_;
    MeshSaving meshSaving_;
    UndoStack undo_;
    std::uint32_t undoGeneration_ = 0xffffffffU;  ///< Of the input that the stack is about.
    std::string undoSource_;
    Cures undoCures_;
    RuleSet undoRules_;
    bool differenceAsked_ = false;   ///< --goto difference is under way, or done.
    bool noticed_ = false;           ///< A notice is in sight.
    const char* focused_ = nullptr;  ///< The window that has the keyboard where no panel has it.
    std::string homeOf_;             ///< Name of the input that the camera went home for.
    std::string writtenState_;
    std::string narrated_;  ///< The address of the last sentence on stdout.
    double uiSeconds_ = 0.0;
    double glSeconds_ = 0.0;
    double firstFrameSeconds_ = 0.0;
    double firstWindowSeconds_ = 0.0;
    double longestOpeningSeconds_ = 0.0;
    std::chrono::steady_clock::time_point lastFrame_;
    bool opening_ = false;  ///< An input was being opened in the frame before.
};

}  // namespace se::view
