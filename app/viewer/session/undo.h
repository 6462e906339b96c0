/// Undo and redo of the user's changes. Snapshots are compared; actions need no code for it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "annotations.h"
#include "layers/layer.h"
#include "layout_preset.h"
#include "run/model.h"
#include "run/selection.h"
#include "scene/camera.h"
#include "scene/palette.h"

namespace se::view {

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
    std::optional<Step> undo(const Edits& now);
    std::optional<Step> redo(const Edits& now);

    /// State that resulted from a step, which may differ from its edits in the last digits.
    void accept(const Edits& now) { present_ = now; }

    /// A pose that the camera took by itself, which is no change to undo.
    void acceptCamera(const CameraPose& pose) { present_.camera = pose; }

    std::size_t undoDepth() const { return past_.size(); }
    std::size_t redoDepth() const { return future_.size(); }

  private:
    void note(const Edits& now);

    Edits present_;
    std::vector<Edits> past_;
    std::vector<Edits> future_;
    bool cameraMoved_ = false;  ///< The last entry is a camera move that may continue.
    double movedAt_ = 0.0;
};

}  // namespace se::view
