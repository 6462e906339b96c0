#include "scene/motion.h"

#include <doctest/doctest.h>

#include "commands/commands.h"
#include "drawn.h"
#include "input/key_map.h"
#include "open_session.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

Moment after(double seconds, bool single = false) {
    return {Moment::Kind::Moving, seconds, single};
}

}  // namespace

TEST_CASE("A single blink lights up, fades, and stays lit in saved pictures") {
    CHECK(blinkStrength(after(0.0)) == 1.0F);
    CHECK(blinkStrength(after(0.3)) == 1.0F);
    const float dying = blinkStrength(after(0.5));
    CHECK(dying > 0.0F);
    CHECK(dying < 1.0F);
    CHECK(blinkStrength(after(0.6)) == doctest::Approx(0.0));
    CHECK(blinkStrength(Moment{}) == 0.0F);
    CHECK(blinkStrength(kPaper) == 1.0F);
}

TEST_CASE("A fading thing is fully visible at first, and half in saved pictures") {
    CHECK(fadeStrength(after(0.0), 0.0F) == doctest::Approx(1.0));
    float last = 1.0F;
    for (double t = 0.05; t < 0.5; t += 0.05) {
        CHECK(fadeStrength(after(t), 0.2F) < last);
        last = fadeStrength(after(t), 0.2F);
    }
    CHECK(fadeStrength(after(0.5), 0.2F) == doctest::Approx(0.2));
    CHECK(fadeStrength(Moment{}, 0.2F) == 0.2F);
    CHECK(fadeStrength(kPaper, 0.2F) == 0.5F);
    CHECK(fadeStrength(kPaper, 0.7F) == 0.7F);
}

TEST_CASE("Things pop up one after the other, and all have settled when the motion is over") {
    CHECK(popSize(after(0.0), 0, 3) > 1.0F);
    CHECK(popSize(after(0.0), 1, 3) == 0.0F);
    CHECK(popSize(after(0.2), 1, 3) > 1.0F);
    CHECK(popSize(after(0.2), 2, 3) == 0.0F);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(popSize(after(0.5), i, 3) == doctest::Approx(1.0));
        CHECK(popSize(Moment{}, i, 3) == 1.0F);
        CHECK(popSize(kPaper, i, 3) == 1.0F);
    }
    // One step forward only brings the last of them.
    CHECK(popSize(after(0.0, true), 0, 3) == 1.0F);
    CHECK(popSize(after(0.0, true), 2, 3) > 1.0F);
}

TEST_CASE("A step starts the motion, and it ends by itself") {
    Motion motion;
    CHECK(motion.look({1, 10, 3}, 0.5, 7.0) == after(0.0));
    CHECK(motion.moving());
    CHECK(motion.look({1, 10, 3}, 0.5, 7.25).seconds == doctest::Approx(0.25));
    CHECK(motion.look({1, 10, 3}, 0.5, 7.5) == Moment{});
    CHECK_FALSE(motion.moving());
    // It stays over until the next step, which is known to be a single one.
    CHECK(motion.look({1, 10, 3}, 0.5, 7.6) == Moment{});
    CHECK(motion.look({1, 10, 4}, 0.5, 8.0) == after(0.0, true));
    CHECK(motion.look({1, 11, 4}, 0.5, 8.1) == after(0.0));
    CHECK(motion.look({1, 11, 2}, 0.5, 8.2) == after(0.0));
}

TEST_CASE("After a step without animation nothing moves, then or later") {
    Motion motion;
    CHECK(motion.look({1, 10, 3}, 0.0, 1.0) == Moment{});
    CHECK(motion.look({1, 10, 3}, 0.5, 1.1) == Moment{});
    motion.look({1, 10, 4}, 0.5, 2.0);
    // A look back in the middle of it ends it.
    CHECK(motion.look({1, 10, 4}, 0.0, 2.1) == Moment{});
    CHECK(motion.look({1, 10, 4}, 0.5, 2.2) == Moment{});
}

TEST_CASE("Only an animated picture keeps the window drawing") {
    test::OpenSession open;
    const auto seconds = [&](const Address& address) {
        open.session.moves().goTo(address);
        open.session.waitUntilDone();
        return motionSeconds(open.session.picture());
    };
    CHECK(seconds({1, Stage::Seed, 1}) == doctest::Approx(0.6));
    CHECK(seconds({30, Stage::Sort, 1}) == 0.0);
    CHECK(seconds({30, Stage::Sphere, 1}) == 0.0);
    CHECK(seconds({30, Stage::Emit, 1}) == doctest::Approx(0.5));
    CHECK(seconds({30, Stage::Ring, 1}) == doctest::Approx(0.5));
    CHECK(seconds({30, Stage::Advance, 1}) == doctest::Approx(0.5));
    CHECK(motionSeconds(DecisionState{}) == 0.0);
}

TEST_CASE("While blinking, before and after are shown twice a second, before first") {
    LookBack look;
    CHECK_FALSE(look.showsBefore(3.0));
    look.begin(LookBack::Mode::Blink, '`', 3.0);
    CHECK(look.showsBefore(3.0));
    CHECK(look.showsBefore(3.24));
    CHECK_FALSE(look.showsBefore(3.26));
    CHECK_FALSE(look.showsBefore(3.49));
    CHECK(look.showsBefore(3.51));
    int turns = 0;
    for (int i = 1; i <= 1000; ++i) {
        turns += look.showsBefore(3.001 + 0.01 * i) != look.showsBefore(3.001 + 0.01 * (i - 1));
    }
    CHECK(turns == 40);  // In ten seconds: two full turns each.
}

TEST_CASE("Looking back lasts while its key is held, Shift makes it blink") {
    LookBack look;
    look.begin(LookBack::Mode::Before, '`', 1.0);
    CHECK(look.showsBefore(1.3));
    look.released('X');
    CHECK(look.on());
    look.shift(true, 2.0);
    CHECK(look.blinking());
    CHECK(look.showsBefore(2.0));
    CHECK_FALSE(look.showsBefore(2.3));
    look.shift(false, 3.0);
    CHECK_FALSE(look.blinking());
    CHECK(look.showsBefore(3.3));
    look.released('`');
    CHECK_FALSE(look.on());
    look.shift(true, 4.0);
    CHECK_FALSE(look.on());
}

TEST_CASE("From a menu, without a held key, looking back is switched on and off") {
    LookBack look;
    look.toggle(LookBack::Mode::Before, 1.0);
    CHECK(look.showsBefore(1.3));
    look.released('`');
    look.shift(true, 1.4);
    CHECK(look.mode() == LookBack::Mode::Before);
    look.toggle(LookBack::Mode::Blink, 1.5);
    CHECK(look.blinking());
    look.toggle(LookBack::Mode::Blink, 1.6);
    CHECK_FALSE(look.on());
}

TEST_CASE("Back-quote looks back, with Shift it blinks") {
    const KeyMap keys;
    CHECK(keys.commandFor({'`', kNoMods}) == findCommand("step.before"));
    CHECK(keys.commandFor({'`', kShift}) == findCommand("step.blink"));
}
