#include "panel_state/recent.h"
#include "open_session.h"
#include "run/strings.h"

#include <doctest/doctest.h>

#include <cstdlib>

using namespace se::view;

TEST_CASE("The latest file is first and listed once, and the oldest ones are dropped") {
    KeptState state;
    for (int i = 0; i < 14; ++i) remember(state, "/data/" + std::to_string(i) + ".ply");
    remember(state, "/data/9.ply");
    remember(state, "/data/sub/../9.ply");
    REQUIRE(state.recent.size() == kMaxRecent);
    CHECK(state.recent[0] == "/data/9.ply");
    CHECK(state.recent[1] == "/data/13.ply");
    CHECK(state.recent.back() == "/data/4.ply");
}

TEST_CASE("Scenes and nothing are no recent files; relative paths become absolute") {
    KeptState state;
    remember(state, "scene:torus");
    remember(state, "");
    CHECK(state.recent.empty());
    remember(state, "here.ply");
    REQUIRE(state.recent.size() == 1);
    CHECK(std::filesystem::path(state.recent[0]).is_absolute());
}

TEST_CASE("Sampled points are recorded by their specification, with a readable name") {
    KeptState state;
    remember(state, "sample:torus,n=4000");
    remember(state, "/data/a.ply");
    remember(state, "sample:torus,n=4000");
    REQUIRE(state.recent.size() == 2);
    CHECK(state.recent[0] == "sample:torus,n=4000");
    CHECK(recentName(state.recent[0]) == "torus, " + grouped(4000) + " points");
    CHECK(recentName("/data/a.ply") == "a.ply");
    CHECK(recentName("sample:gyroid,spacing=0.25,steps=9") == "gyroid, 0.25 apart, step 9");
    // From any folder.
    remember(state, "sample:scans/lobster.nhdr,n=500");
    CHECK(state.recent[0].starts_with("sample:/"));
    CHECK(recentName(state.recent[0]) == "lobster, 500 points");
    remember(state, "sample:");
    CHECK(state.recent.size() == 3);
}

TEST_CASE("Layout and recent files are read back as written") {
    KeptState state{LayoutPreset::Present, {"/a.ply", "/b \"c\".sesession"}};
    CHECK(keptStateFromJson(keptStateToJson(state)) == state);
    for (const char* bad : {"", "[]", "{", R"({"layout": 3, "recent": [1, {}]})"}) {
        CAPTURE(bad);
        CHECK(keptStateFromJson(bad) == KeptState{});
    }
}

TEST_CASE("The state file is in the XDG folder, which is made with it") {
    const std::filesystem::path folder = test::ownPlace("state-test");
    std::filesystem::remove_all(folder);
    setenv("XDG_STATE_HOME", folder.c_str(), 1);
    CHECK(statePath() == folder / "spiraling-edge" / "state.json");
    CHECK(readKeptState(statePath()) == KeptState{});
    const KeptState state{LayoutPreset::Learn, {"/a.ply"}};
    REQUIRE(writeKeptState(statePath(), state).ok());
    CHECK(readKeptState(statePath()) == state);
    CHECK(writeKeptState({}, state).ok());
    std::filesystem::remove_all(folder);
    unsetenv("XDG_STATE_HOME");
}
