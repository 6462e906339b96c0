#include "edit_history.h"

#include <chrono>
#include <utility>

#include "document.h"
#include "session/session.h"
#include "ui_state.h"

namespace se::view {

Annotations annotationsOf(const UiState& ui) {
    return {ui.bookmarks, ui.notes, ui.breakpoints, ui.watch.expressions};
}

void putBack(const Annotations& annotations, UiState& ui) {
    ui.bookmarks = annotations.bookmarks;
    ui.notes = annotations.notes;
    ui.breakpoints = annotations.breakpoints;
    ui.watch.expressions = annotations.watches;
}

Edits captureEdits(const CommandContext& context) {
    const UiState& ui = context.ui;
    return {ui.settings.theme,           ui.settings.uiScale, ui.settings.legend,
            ui.settings.layers,          ui.layoutPreset,     context.camera.pose(),
            context.session.selection(), annotationsOf(ui),   context.session.input().spec()};
}

void applyEdits(const Edits& edits, CommandContext& context) {
    UiState& ui = context.ui;
    ui.settings.theme = edits.theme;
    ui.settings.uiScale = edits.uiScale;
    ui.settings.legend = edits.legend;
    ui.settings.layers = edits.layers;
    ui.layoutPreset = edits.layout;
    if (context.camera.pose() != edits.camera) context.camera.setPose(edits.camera);
    putBack(edits.annotations, ui);
    if (edits.input != context.session.input().spec()) context.document.run(edits.input);
    // With other points the numbers may refer to others.
    if (!context.document.arriving()) context.session.select(edits.selected);
}

void EditHistory::begin() { stack_.begin(captureEdits(c_)); }

void EditHistory::acceptCamera() { stack_.acceptCamera(c_.camera.pose()); }

void EditHistory::observe(bool changing) {
    const SessionInput& input = c_.session.input();
    // The result of an opening belongs to the change that requested it.
    if (input.phase() == SessionPhase::Loading || c_.ui.growth.open) return;
    if (std::exchange(generation_, c_.session.generation()) != c_.session.generation()) {
        const bool same = std::exchange(source_, input.spec().source) == input.spec().source;
        const bool changed = std::exchange(input_, input.spec()) != input.spec();
        if (!same || !changed) return begin();
    }
    if (camera_ == CameraMove::Kind::Followed) acceptCamera();
    camera_ = c_.ui.cameraMove.kind();
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    stack_.observe(captureEdits(c_), std::chrono::duration<double>(now).count(),
                   changing || c_.ui.cameraMove.active());
}

/// An input is being opened: says so.
bool EditHistory::waits() {
    const bool opening = c_.session.input().phase() == SessionPhase::Loading;
    if (opening) c_.session.messages().say("Wait until the input is open.");
    return opening;
}

void EditHistory::undo() {
    c_.ui.betweenFrames([this] {
        if (!waits()) apply(stack_.undo(captureEdits(c_)), "Undone: ", "There is nothing to undo.");
    });
}

void EditHistory::redo() {
    c_.ui.betweenFrames([this] {
        if (!waits()) apply(stack_.redo(captureEdits(c_)), "Redone: ", "There is nothing to redo.");
    });
}

void EditHistory::apply(const std::optional<UndoStack::Step>& step, const char* done,
                        const char* nothing) {
    Messages& messages = c_.session.messages();
    if (!step) return messages.say(nothing);
    applyEdits(step->edits, c_);
    Edits made = captureEdits(c_);
    // An input that was opened again has no selection.
    if (c_.document.arriving()) made.selected = {};
    made.input = step->edits.input;
    stack_.accept(made);
    messages.say(done + step->change + ".");
    if (c_.document.arriving()) c_.document.sayOnArrival(messages.notice());
}

}  // namespace se::view
