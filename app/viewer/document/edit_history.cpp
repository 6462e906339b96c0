#include "edit_history.h"

#include <chrono>
#include <utility>

#include "document.h"
#include "session/session.h"
#include "ui_state.h"

namespace se::view {

// Instead of a command object per action, the state of everything that can be undone is captured
// once per frame and compared with the last entry. New actions are thus undoable without any code,
// at the cost of a comparison per frame; the snapshots are small, since the run itself is not part
// of them.

namespace {

void add(std::string& text, const std::string& what) { text += (text.empty() ? "" : ", ") + what; }

std::string changedLayers(const LayerModes& from, const LayerModes& to) {
    std::string changed;
    for (const Layer& layer : layers()) {
        const auto i = static_cast<std::size_t>(layer.id);
        if (from[i] == to[i]) continue;
        if (!changed.empty()) return "layers";
        changed = "layer " + std::string(layer.name);
    }
    return changed;
}

/// Camera moves within this many seconds of each other are merged.
constexpr double kOneMove = 0.5;

bool onlyCamera(Edits from, const Edits& to) {
    from.camera = to.camera;
    return from == to;
}

}  // namespace

std::string describeChange(const Edits& from, const Edits& to) {
    std::string text;
    if (from.theme != to.theme) add(text, "theme");
    if (from.uiScale != to.uiScale) add(text, "text size");
    if (from.legend != to.legend) add(text, "legend");
    if (from.layers != to.layers) add(text, changedLayers(from.layers, to.layers));
    if (from.layout != to.layout) add(text, "layout");
    if (from.camera != to.camera) add(text, "camera");
    if (from.selected != to.selected) add(text, "selection");
    if (from.annotations.bookmarks.size() != to.annotations.bookmarks.size()) {
        add(text, "bookmark");
    } else if (from.annotations.bookmarks != to.annotations.bookmarks) {
        add(text, "note of a bookmark");
    }
    if (from.annotations.notes != to.annotations.notes) add(text, "notes");
    if (from.annotations.breakpoints != to.annotations.breakpoints) add(text, "breakpoints");
    if (from.annotations.watches != to.annotations.watches) add(text, "watches");
    // The other changes are consequences of this one.
    const RunSpec& a = from.input;
    const RunSpec& b = to.input;
    if (withRulesOf(a, b) != b) {
        if (a.fixes != b.fixes) return "the doctor's fix";
        return a.leftOut != b.leftOut ? "points left out" : "preparation of the points";
    }
    if (a == b) return text;
    const std::vector<RuleValue> rules = differingRules(ruleParams(b), ruleParams(a));
    if (a.whatIf != b.whatIf)
        add(text, "what-if");
    else if (a.rules != b.rules)
        add(text, b.rules + " rules");
    else
        add(text, rules.size() == 1 ? "rule " + rules.front().name : "rules");
    return text;
}

void UndoStack::begin(const Edits& now) {
    present_ = now;
    past_.clear();
    future_.clear();
    cameraMoved_ = false;
}

void UndoStack::note(const Edits& now) {
    if (now == present_) return;
    past_.push_back(std::exchange(present_, now));
    if (past_.size() > kDepth) past_.erase(past_.begin());
    future_.clear();
}

void UndoStack::observe(const Edits& now, double seconds, bool changing) {
    if (changing) {
        cameraMoved_ = false;
        return;
    }
    if (now == present_) return;
    const bool goesOn = cameraMoved_ && seconds - movedAt_ < kOneMove;
    cameraMoved_ = onlyCamera(present_, now);
    movedAt_ = seconds;
    if (cameraMoved_ && goesOn) {
        present_ = now;
    } else {
        note(now);
    }
}

std::optional<UndoStack::Step> UndoStack::step(const Edits& now, std::vector<Edits>& from,
                                               std::vector<Edits>& to) {
    note(now);
    cameraMoved_ = false;
    if (from.empty()) return std::nullopt;
    to.push_back(std::exchange(present_, from.back()));
    from.pop_back();
    // Named is what was done once, or is done again: not the way back.
    const bool undone = &to == &future_;
    return Step{present_,
                undone ? describeChange(present_, to.back()) : describeChange(to.back(), present_)};
}

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

void EditHistory::undo() { go(&UndoStack::undo, "Undone: ", "There is nothing to undo."); }

void EditHistory::redo() { go(&UndoStack::redo, "Redone: ", "There is nothing to redo."); }

void EditHistory::go(std::optional<UndoStack::Step> (UndoStack::*step)(const Edits& now),
                     const char* done, const char* nothing) {
    c_.ui.betweenFrames([this, step, done, nothing] {
        Messages& messages = c_.session.messages();
        if (c_.session.input().phase() == SessionPhase::Loading)
            return messages.say("Wait until the input is open.");
        const auto taken = (stack_.*step)(captureEdits(c_));
        if (!taken) return messages.say(nothing);
        applyEdits(taken->edits, c_);
        Edits made = captureEdits(c_);
        // An input that was opened again has no selection.
        if (c_.document.arriving()) made.selected = {};
        made.input = taken->edits.input;
        stack_.accept(made);
        messages.say(done + taken->change + ".");
        if (c_.document.arriving()) c_.document.sayOnArrival(messages.notice());
    });
}

}  // namespace se::view
