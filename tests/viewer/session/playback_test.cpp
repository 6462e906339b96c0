#include "session/playback.h"

#include <doctest/doctest.h>

#include "commands/commands.h"
#include "document/actions.h"
#include "document/ui_state.h"
#include "headless_app.h"
#include "scene/camera.h"

using namespace se::view;

TEST_CASE("Nothing is due while paused") {
    Playback playback;
    CHECK(playback.due(10.0) == 0);
}

TEST_CASE("Playing begins with a step at once, and continues at the rate") {
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

TEST_CASE("The rate stays between 0.5 and 60 per second") {
    Playback playback;
    playback.setRate(1000.0);
    CHECK(playback.rate() == Playback::kFastest);
    playback.setRate(0.0);
    CHECK(playback.rate() == Playback::kSlowest);
}

TEST_CASE("Faster and slower use the same notches, with no limit above all") {
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

TEST_CASE("The units form a cycle and have names") {
    CHECK(following(PlayUnit::SubStep) == PlayUnit::Pivot);
    CHECK(following(PlayUnit::Pivot) == PlayUnit::Event);
    CHECK(following(PlayUnit::Event) == PlayUnit::SubStep);
    CHECK(unitName(PlayUnit::SubStep) == "sub-step");
    CHECK(unitName(PlayUnit::Event) == "event");
}

TEST_CASE("A loop needs two marks in the order of the run, the newer mark wins") {
    PlayLoop loop;
    CHECK(loop.empty());
    loop.setTo({20, se::Stage::Pivot, 0});
    CHECK_FALSE(loop.complete());
    loop.setFrom({10, se::Stage::Sort, 2});
    CHECK(loop.complete());
    loop.setFrom({30, se::Stage::Pivot, 0});
    CHECK_FALSE(loop.to.has_value());
    loop.setTo({5, se::Stage::Pivot, 0});
    CHECK_FALSE(loop.from.has_value());
    CHECK_FALSE(loop.complete());
}

namespace {

struct Player {
    test::OpenSession open{"scene:torus"};
    test::AroundSession around{open.session};
    Playback& playback = around.playback;
    CommandContext& context = around.context;

    std::string step(PlayUnit unit, int count = 1) {
        playback.setUnit(unit);
        playSteps(context, count);
        return open.place();
    }
};

}  // namespace

TEST_CASE("A step is a sub-step, a pivot or an event, forward and back") {
    Player player;
    player.open.session.moves().goToPivot(10);
    player.open.session.waitUntilDone();
    const std::string here = player.open.place();
    CHECK(player.step(PlayUnit::SubStep) == "11.pivot.1");
    CHECK(player.step(PlayUnit::SubStep, -1) == here);
    CHECK(player.step(PlayUnit::Pivot, 3).starts_with("13."));
    CHECK(player.step(PlayUnit::Pivot, -3) == here);
    const auto mark = player.open.session.nextMark(1);
    REQUIRE(mark.has_value());
    CHECK(player.step(PlayUnit::Event).starts_with(toString(*mark)));
    // Playing leaves no entry in the history.
    player.open.session.moves().goBack();
    CHECK(player.open.place() == "start");
}

TEST_CASE("Playing from event to event pauses after the last one") {
    Player player;
    player.open.session.moves().toEnd();
    player.open.session.waitUntilDone();
    player.playback.play();
    player.step(PlayUnit::Event);
    CHECK_FALSE(player.playback.playing());
    CHECK_FALSE(player.open.session.messages().last().empty());
}

TEST_CASE("Pivots are not played beyond the end of the loop") {
    Player player;
    player.playback.loop.setFrom({10, se::Stage::Pivot, 0});
    player.playback.loop.setTo({15, se::Stage::Pivot, 0});
    player.open.session.moves().goToPivot(12);
    player.open.session.waitUntilDone();
    CHECK_FALSE(player.open.session.reached(*player.playback.loop.to));
    CHECK(player.step(PlayUnit::Pivot, 8).starts_with("15."));
    CHECK(player.open.session.reached(*player.playback.loop.to));
    CHECK(player.open.session.reached({15, se::Stage::Pivot, 1}));
    CHECK_FALSE(player.open.session.reached({16, se::Stage::Pivot, 0}));
}
