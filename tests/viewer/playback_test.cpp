#include "playback.h"

#include <doctest/doctest.h>

using namespace se::view;

TEST_CASE("Nothing is due while paused") {
    Playback playback;
    CHECK(playback.due(10.0) == 0);
}

TEST_CASE("Playing begins with a step at once, and goes on at the rate") {
    Playback playback;
    playback.setRate(4.0);
    playback.play();
    CHECK(playback.due(0.0) == 1);
    int steps = 0;
    for (int i = 0; i < 64; ++i) steps += playback.due(0.03125);
    CHECK(steps == 8);
}

TEST_CASE("A long pause between frames does not lead to a burst") {
    Playback playback;
    playback.setRate(60.0);
    playback.play();
    CHECK(playback.due(10.0) == 8);
    CHECK(playback.due(0.0) <= 1);
}

TEST_CASE("The rate stays between 0.5 and 60 a second") {
    Playback playback;
    playback.setRate(1000.0);
    CHECK(playback.rate() == Playback::kFastest);
    playback.setRate(0.0);
    CHECK(playback.rate() == Playback::kSlowest);
}

TEST_CASE("Faster and slower go over the same notches, and above all lies no limit") {
    Playback playback;
    playback.setRate(30.0);
    playback.faster();
    CHECK(playback.rate() == 60.0);
    CHECK_FALSE(playback.unlimited());
    playback.faster();
    CHECK(playback.unlimited());
    playback.play();
    CHECK(playback.due(0.0001) == 1);
    playback.slower();
    CHECK_FALSE(playback.unlimited());
    CHECK(playback.rate() == 60.0);
    for (int i = 0; i < 20; ++i) playback.slower();
    CHECK(playback.rate() == Playback::kSlowest);
}
