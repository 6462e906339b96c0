#include "input/key_routing.h"

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

constexpr std::initializer_list<KeyStop> kDebug = {KeyStop::Rail, KeyStop::Content, KeyStop::Steps,
                                                   KeyStop::Rings, KeyStop::RingPoints};

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
    CHECK(frame(walk, kDebug) == KeyStop::RingPoints);
}

TEST_CASE("Missing panels are skipped") {
    KeyWalk walk;
    frame(walk, {KeyStop::Rail});
    frame(walk, {KeyStop::Rail});
    walk.go(1);
    CHECK(frame(walk, {KeyStop::Rail}) == KeyStop::Rail);
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
    CHECK(walk.at() == KeyStop::Rail);
    frame(walk, {});
    frame(walk, {});
    CHECK(walk.at() == KeyStop::View);
}
