/// Undo and redo of the user's changes in the window. Independent of window and OpenGL.
#pragma once

#include <string>

#include "context.h"
#include "scene/camera_move.h"
#include "session/undo.h"

namespace se::view {

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
    bool waits();
    void apply(const std::optional<UndoStack::Step>& step, const char* done, const char* nothing);

    CommandContext& c_;
    UndoStack stack_;
    std::uint32_t generation_ = 0xffffffffU;  ///< Source of the entries.
    std::string source_;
    RunSpec input_;  ///< Options that the open run was made with.
    CameraMove::Kind camera_ = CameraMove::Kind::None;  ///< Of the frame before.
};

}  // namespace se::view
