/// Undo and redo of what a person changed. Snapshots are compared; no action knows of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "annotations.h"
#include "layers/layer.h"
#include "layout_preset.h"
#include "run/doctor_fixes.h"
#include "run/rule_set.h"
#include "run/selection.h"
#include "scene/camera.h"
#include "scene/palette.h"
#include "spiraling_edge/replay/breakpoint.h"

namespace se::view {

/// Everything that can be undone. Moving through the run is not among it: Alt+Left goes back there.
struct Edits {
    Theme theme = Theme::Dark;
    double uiScale = 0.0;
    bool legend = true;
    LayerModes layers{};
    Arrangement layout = Arrangement::Debug;
    CameraPose camera;
    Selection selected;
    Bookmarks bookmarks;
    std::string notes;
    std::vector<Breakpoint> breakpoints;
    std::vector<std::string> watches;
    Cures cures;    ///< Of the input: to change them it is opened anew.
    RuleSet rules;  ///< To change them it is run anew.
    friend bool operator==(const Edits&, const Edits&) = default;
};

/// What differs between two of them, in words: "camera", "layer normals, selection".
std::string describeChange(const Edits& from, const Edits& to);

class UndoStack {
  public:
    static constexpr std::size_t kDepth = 200;

    /// Forgets everything: `now` is where it begins.
    void begin(const Edits& now);
    /// Looks at the state of a frame at a time in seconds. While `changing` (a drag, a text being
    /// typed) nothing is noted, so that all of it becomes one entry; so do moves of the camera that
    /// follow each other at once, as those of a wheel.
    void observe(const Edits& now, double seconds, bool changing);

    /// What to go back to, and what that undoes. Notes a change under way first.
    struct Step {
        Edits edits;
        std::string change;
    };
    std::optional<Step> undo(const Edits& now);
    std::optional<Step> redo(const Edits& now);

    /// What the program made of a step, which need not be its edits to the last digit.
    void accept(const Edits& now) { present_ = now; }

    std::size_t undoDepth() const { return past_.size(); }
    std::size_t redoDepth() const { return future_.size(); }

  private:
    void note(const Edits& now);

    Edits present_;
    std::vector<Edits> past_;
    std::vector<Edits> future_;
    bool cameraMoved_ = false;  ///< The last entry is a move of the camera that may go on.
    double movedAt_ = 0.0;
};

}  // namespace se::view
