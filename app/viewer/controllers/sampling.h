/// New points: ties the page, the thread that spreads them, and what is drawn of them. Knows
/// neither window nor OpenGL.
#pragma once

#include <memory>
#include <optional>

#include "jobs/growth.h"
#include "panel_state/ui_state.h"
#include "scene/draw_list.h"
#include "session/session.h"

namespace se::view {

class Growing {
  public:
    explicit Growing(CommandContext& context) : c_(context) {}

    /// Opens the page with these particles; `usual` is how its points will be opened.
    void begin(const SampleSpec& spec);
    void setUsual(const InputSpec& usual) { usual_ = usual; }
    /// Takes over what the thread has made. True if there is something new to draw.
    bool poll();
    /// Carries out what page and commands asked for.
    void carryOut();
    /// Blocks until nothing moves: for pictures without a person.
    void settle();
    bool moving() const { return c_.ui.growth.open && c_.ui.growth.moving(); }

    /// What is to be drawn in the view, in view space.
    const DrawList& drawList(const Palette& palette);
    /// Where the particles are, for the renderer; null while there are none.
    const Model* model() const { return model_.get(); }
    /// Grows whenever model() changes.
    std::uint32_t revision() const { return revision_; }

  private:
    void start();
    void use();
    void leave();
    void save(const std::string& path);
    void playOrPause();
    void home();
    void takePicture();

    CommandContext& c_;
    Growth growth_;
    InputSpec usual_;
    std::unique_ptr<Model> model_;
    DrawList list_;
    std::uint32_t revision_ = 0;
    std::string homeOf_;                ///< The surface that the camera went home for.
    std::optional<CameraPose> before_;  ///< Where the camera was when the page was opened.
};

}  // namespace se::view
