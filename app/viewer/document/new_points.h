/// New points: connects the page, the thread that spreads them, and their drawing. Independent of
/// window and OpenGL.
#pragma once

#include <memory>
#include <optional>

#include "context.h"
#include "jobs/growth.h"
#include "scene/camera.h"
#include "scene/draw_list.h"
#include "session/playback.h"
#include "session/session.h"
#include "ui_state.h"

namespace se::view {

class NewPoints {
  public:
    /// Steps per second as long as the user has chosen no other speed.
    static constexpr double kRate = 30.0;

    explicit NewPoints(CommandContext& context) : c_(context) { playback_.setRate(kRate); }

    /// Opens the page with these particles; `usual` has the options for opening the points later.
    void begin(SampleSpec spec);
    void setUsual(const RunSpec& usual) { usual_ = usual; }
    /// Takes the results of the thread. True if there is something new to draw.
    bool poll();

    /// Opens the page with the last form, of a shape or of a volume.
    void openPage(GrowthSource from);
    /// Opens the page and spreads points over that volume.
    void openVolume(const std::string& volume);
    /// Spreads the points of the form from the start.
    void start();
    void playOrPause();
    /// Makes the steps that are due after `seconds` more, while it plays.
    void play(double seconds);
    const Playback& playback() const { return playback_; }
    void slower() { playback_.slower(); }
    void faster() { playback_.faster(); }
    /// One step, then pauses.
    void step();
    /// To the end of spreading.
    void finish();
    /// Opens the points for a run.
    void use();
    /// Frames the points.
    void home();
    /// Closes the page; the open input returns.
    void leave();
    /// Saves the points of the page, or those of the open input.
    void save(const std::string& path);

    /// Blocks until nothing moves: for pictures without a user.
    void waitUntilDone();
    bool moving() const;
    /// The particles, and what their thread does.
    const Growth& growth() const { return growth_; }

    /// Drawing of the view, in view space.
    const DrawList& drawList(const Palette& palette);
    /// Positions of the particles, for the renderer; null while there are none.
    const Model* model() const { return model_.get(); }
    /// Grows whenever model() changes.
    std::uint32_t revision() const { return revision_; }

  private:
    void showPage(GrowthSource from);
    void spread(SampleSpec spec);
    void pause();
    void takePicture();

    CommandContext& c_;
    Growth growth_;
    Playback playback_;  ///< Of its steps.
    RunSpec usual_;
    std::unique_ptr<Model> model_;
    DrawList list_;
    std::uint32_t revision_ = 0;
    std::string homeOf_;                ///< The surface that the camera was reset for.
    std::optional<CameraPose> before_;  ///< Camera pose when the page was opened.
};

}  // namespace se::view
