#include "document/edit_history.h"

#include <doctest/doctest.h>

using namespace se;
using namespace se::view;

namespace {

/// An undo stack and the visible state; every change comes ten seconds after the previous one.
struct Bench {
    UndoStack stack;
    Edits now;
    double time = 100.0;

    Bench() { stack.begin(now); }
    void look(double pass = 10.0, bool changing = false) {
        time += pass;
        stack.observe(now, time, changing);
    }
    std::string undo() {
        const auto step = stack.undo(now);
        if (!step) return "nothing";
        now = step->edits;
        return step->change;
    }
    std::string redo() {
        const auto step = stack.redo(now);
        if (!step) return "nothing";
        now = step->edits;
        return step->change;
    }
};

}  // namespace

TEST_CASE("Changes are undone in reverse and redone in order") {
    Bench b;
    b.now.theme = Theme::Light;
    b.look();
    modeOf(b.now.layers, LayerId::Normals) = LayerMode::PinnedOn;
    b.look();
    b.now.selected = Selection::ofEdge(7, 9);
    b.look();
    const Edits last = b.now;
    CHECK(b.stack.undoDepth() == 3);
    CHECK(b.undo() == "selection");
    CHECK(b.undo() == "layer normals");
    CHECK(b.undo() == "theme");
    CHECK(b.now == Edits{});
    CHECK(b.undo() == "nothing");
    CHECK(b.redo() == "theme");
    CHECK(b.redo() == "layer normals");
    CHECK(b.redo() == "selection");
    CHECK(b.now == last);
    CHECK(b.redo() == "nothing");
}

TEST_CASE("A new change after an undo discards the undone ones") {
    Bench b;
    b.now.layout = LayoutPreset::Present;
    b.look();
    b.undo();
    b.now.annotations.notes = "x";
    b.look();
    CHECK(b.stack.redoDepth() == 0);
    CHECK(b.undo() == "notes");
}

TEST_CASE("A drag is one entry, and two drags are two") {
    Bench b;
    for (int drag = 0; drag < 2; ++drag) {
        for (int i = 0; i < 20; ++i) {
            b.now.camera.yawDegrees += 1.0F;
            b.look(0.016, true);
        }
        b.look(0.016);
    }
    CHECK(b.stack.undoDepth() == 2);
    CHECK(b.undo() == "camera");
    CHECK(b.now.camera.yawDegrees == doctest::Approx(CameraPose{}.yawDegrees + 20.0F));
}

TEST_CASE("Successive notches of a wheel are one entry") {
    Bench b;
    for (int i = 0; i < 5; ++i) {
        b.now.camera.distance *= 0.9F;
        b.look(0.1);
    }
    CHECK(b.stack.undoDepth() == 1);
    b.now.camera.distance *= 0.9F;
    b.look(2.0);
    CHECK(b.stack.undoDepth() == 2);
}

TEST_CASE("Undo records a pending change, so that nothing is lost") {
    Bench b;
    b.now.camera.yawDegrees = 5.0F;
    b.look(0.016, true);
    CHECK(b.undo() == "camera");
    CHECK(b.redo() == "camera");
    CHECK(b.now.camera.yawDegrees == 5.0F);
}

TEST_CASE("The stack is bounded, and another input begins a new one") {
    Bench b;
    for (std::size_t i = 0; i < 3 * UndoStack::kDepth; ++i) {
        b.now.selected = Selection::ofPoint(static_cast<Index>(i));
        b.look();
    }
    CHECK(b.stack.undoDepth() == UndoStack::kDepth);
    b.stack.begin(b.now);
    CHECK(b.undo() == "nothing");
}

TEST_CASE("Every kind of change has a name") {
    const Edits from;
    Edits to = from;
    to.uiScale = 2.0;
    to.legend = false;
    to.camera.orthographic = true;
    to.annotations.bookmarks.push_back({*addressFromString("3.sort.1"), ""});
    CHECK(describeChange(from, to) == "text size, legend, camera, bookmark");
    Edits noted = to;
    noted.annotations.bookmarks[0].note = "look";
    CHECK(describeChange(to, noted) == "note of a bookmark");
    Edits ruled = from;
    ruled.input.rules = "robust";
    CHECK(describeChange(from, ruled) == "robust rules");
    Edits prepared = ruled;
    prepared.input.neighbors.reach = KNearest{10};
    CHECK(describeChange(ruled, prepared) == "preparation of the points");
    prepared.input.fixes = {"noise"};
    CHECK(describeChange(ruled, prepared) == "the doctor's fix");
}

TEST_CASE("Undo names the change that it takes back, redo the same one") {
    Bench b;
    b.now.input.rules = "robust";
    b.look();
    CHECK(b.undo() == "robust rules");
    CHECK(b.now.input.rules == "paper");
    CHECK(b.redo() == "robust rules");
}

TEST_CASE("Breakpoints and watches are undone and redone") {
    Bench b;
    b.now.annotations.breakpoints.push_back({"", "stage=split"});
    b.look();
    b.now.annotations.breakpoints[0].on = false;
    b.look();
    b.now.annotations.watches.push_back("ring");
    b.look();
    CHECK(b.undo() == "watches");
    CHECK(b.undo() == "breakpoints");
    CHECK(b.now.annotations.breakpoints[0].on);
    CHECK(b.undo() == "breakpoints");
    CHECK(b.now.annotations.breakpoints.empty());
    CHECK(b.redo() == "breakpoints");
    CHECK(b.now.annotations.breakpoints.size() == 1);
}
