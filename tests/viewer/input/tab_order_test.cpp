#include "input/tab_order.h"
#include "layout/bars.h"

#include <doctest/doctest.h>

#include <array>
#include <initializer_list>

using namespace se::view;

namespace {

/// Draws the panels of a frame; returns the one that got the keyboard, View for none.
KeyStop frame(KeyWalk& walk, std::initializer_list<KeyStop> panels) {
    walk.begin();
    KeyStop got = KeyStop::View;
    for (const KeyStop panel : panels) {
        if (walk.offer(panel)) got = panel;
    }
    return got;
}

constexpr std::initializer_list<KeyStop> kDebug = {
    KeyStop::Steps, KeyStop::Rings, KeyStop::RingPoints, KeyStop::Tabs, KeyStop::Content};

}  // namespace

TEST_CASE("Tab leads from the view through all panels and back to the view") {
    KeyWalk walk;
    CHECK(frame(walk, kDebug) == KeyStop::View);
    frame(walk, kDebug);
    for (const KeyStop next : kDebug) {
        walk.go(1);
        CHECK(frame(walk, kDebug) == next);
        CHECK(walk.at() == next);
        CHECK(frame(walk, kDebug) == KeyStop::View);  // it gets the keyboard once
        CHECK(walk.at() == next);
    }
    walk.go(1);
    CHECK(walk.at() == KeyStop::View);
    walk.go(-1);
    CHECK(frame(walk, kDebug) == KeyStop::Content);
}

TEST_CASE("Missing panels are skipped") {
    KeyWalk walk;
    frame(walk, {KeyStop::Tabs});
    frame(walk, {KeyStop::Tabs});
    walk.go(1);
    CHECK(frame(walk, {KeyStop::Tabs}) == KeyStop::Tabs);
    walk.go(1);
    CHECK(walk.at() == KeyStop::View);
    KeyWalk alone;
    frame(alone, {});
    frame(alone, {});
    alone.go(1);
    CHECK(alone.at() == KeyStop::View);
}

TEST_CASE("The view has the keyboard again when the panel with it is gone") {
    KeyWalk walk;
    frame(walk, kDebug);
    frame(walk, kDebug);
    walk.go(1);
    frame(walk, kDebug);
    CHECK(walk.at() == KeyStop::Steps);
    frame(walk, {});
    frame(walk, {});
    CHECK(walk.at() == KeyStop::View);
}

TEST_CASE("Parts of the status bar are whole or missing, the most important first") {
    const std::array<float, 4> widths = {60, 80, 200, 300};
    CHECK(fittingParts(1000, widths, 20) == 4);
    CHECK(fittingParts(700, widths, 20) == 4);
    CHECK(fittingParts(699, widths, 20) == 3);
    CHECK(fittingParts(379, widths, 20) == 2);
    CHECK(fittingParts(159, widths, 20) == 1);
    CHECK(fittingParts(59, widths, 20) == 0);
}
