#include "document/ui_state.h"

#include <doctest/doctest.h>

#include <string>

using namespace se::view;

TEST_CASE("A call is made at once outside of drawing, at the end of the frame within") {
    BetweenFrames betweenFrames;
    int calls = 0;
    betweenFrames([&] { ++calls; });
    CHECK(calls == 1);
    betweenFrames.beginDrawing();
    betweenFrames([&] { ++calls; });
    CHECK(calls == 1);
    betweenFrames.endDrawing();
    CHECK(calls == 2);
    betweenFrames([&] { ++calls; });
    CHECK(calls == 3);
}

TEST_CASE("Calls that wait keep their order") {
    BetweenFrames betweenFrames;
    std::string order;
    betweenFrames.beginDrawing();
    for (const char sign : {'a', 'b', 'c'}) betweenFrames([&order, sign] { order += sign; });
    betweenFrames.endDrawing();
    CHECK(order == "abc");
    // Each is made once.
    betweenFrames.beginDrawing();
    betweenFrames.endDrawing();
    CHECK(order == "abc");
}

TEST_CASE("A call made by a waiting call is made at once") {
    BetweenFrames betweenFrames;
    std::string order;
    betweenFrames.beginDrawing();
    betweenFrames([&] {
        order += 'a';
        betweenFrames([&] { order += 'b'; });
        order += 'c';
    });
    betweenFrames([&] { order += 'd'; });
    betweenFrames.endDrawing();
    CHECK(order == "abcd");
}
