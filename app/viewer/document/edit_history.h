/// Undo and redo of the user's changes in the window. Independent of window and OpenGL.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "context.h"
#include "layers/layer.h"
#include "run/model.h"
#include "run/selection.h"
#include "scene/camera.h"
#include "scene/motion.h"
#include "scene/palette.h"
#include "session/layout_preset.h"
#include "session/session_file.h"

namespace se::view {

// Undo and redo of the user's changes. Snapshots are compared; actions need no code for it.

/// Everything that can be undone. Moves through the run are not: Alt+Left goes back there.
struct Edits {
    Theme theme = Theme::Dark;
    double uiScale = 0.0;
    bool legend = true;
    LayerModes layers{};
    LayoutPreset layout = LayoutPreset::Debug;
    CameraPose camera;
    Selection selected;
    Annotations annotations;
    RunSpec input;  ///< The options of the open input: a change runs it again.
    friend bool operator==(const Edits&, const Edits&) = default;
};

/// Differences in words: "camera", "layer normals, selection".
std::string describeChange(const Edits& from, const Edits& to);

class UndoStack {
  public:
    static constexpr std::size_t kDepth = 200;

    /// Clears the history, which begins at `now`.
    void begin(const Edits& now);
    /// Records the state of a frame at a time in seconds. While `changing` (a drag, a text being
    /// typed) nothing is recorded, so that all of it becomes one entry; the same holds for camera
    /// moves in quick succession, such as those of a wheel.
    void observe(const Edits& now, double seconds, bool changing);

    /// The state to return to, and a description of what is undone. Records a pending change first.
    struct Step {
        Edits edits;
        std::string change;
    };
    std::optional<Step> undo(const Edits& now) { return step(now, past_, future_); }
    std::optional<Step> redo(const Edits& now) { return step(now, future_, past_); }

    /// State that resulted from a step, which may differ from its edits in the last digits.
    void accept(const Edits& now) { present_ = now; }

    /// A pose that the camera took by itself, which is no change to undo.
    void acceptCamera(const CameraPose& pose) { present_.camera = pose; }

    std::size_t undoDepth() const { return past_.size(); }
    std::size_t redoDepth() const { return future_.size(); }

  private:
    void note(const Edits& now);
    std::optional<Step> step(const Edits& now, std::vector<Edits>& from, std::vector<Edits>& to);

    Edits present_;
    std::vector<Edits> past_;
    std::vector<Edits> future_;
    bool cameraMoved_ = false;  ///< The last entry is a camera move that may continue.
    double movedAt_ = 0.0;
};

/// What the user has noted about the open input.
Annotations annotationsOf(const UiState& ui);
void putBack(const Annotations& annotations, UiState& ui);

/// The state that can be undone, and the way back to it.
Edits captureEdits(const CommandContext& context);
void applyEdits(const Edits& edits, CommandContext& context);

class EditHistory {
  public:
    explicit EditHistory(CommandContext& context) : c_(context) {}

    /// Records the state of a frame. While `changing` (a drag, a text being typed) nothing is
    /// recorded, so that all of it becomes one entry.
    void observe(bool changing);
    void undo();
    void redo();
    /// Clears the history, which begins here.
    void begin();
    /// The camera was moved by the program: there is nothing to undo.
    void acceptCamera();

    std::size_t undoDepth() const { return stack_.undoDepth(); }
    std::size_t redoDepth() const { return stack_.redoDepth(); }

  private:
    void go(std::optional<UndoStack::Step> (UndoStack::*step)(const Edits& now), const char* done,
            const char* nothing);

    CommandContext& c_;
    UndoStack stack_;
    std::uint32_t generation_ = 0xffffffffU;  ///< Source of the entries.
    std::string source_;
    RunSpec input_;  ///< Options that the open run was made with.
    CameraMove::Kind camera_ = CameraMove::Kind::None;  ///< Of the frame before.
};

}  // namespace se::view
