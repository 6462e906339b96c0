#include "paint/dial_painter.h"

#include <doctest/doctest.h>

#include <array>

using namespace se::view;

TEST_CASE("Dial: without names the disc fills the room") {
    const DialCircle place = fitDial({{10, 20}, {200, 100}}, {}, 5, 2);
    CHECK(place.radius == doctest::Approx(48).epsilon(0.01));
    CHECK(place.center.x == doctest::Approx(110));
    CHECK(place.center.y == doctest::Approx(70));
}

TEST_CASE("Dial: names take room only where they are") {
    const std::array right = {DialName{0.0, {40, 10}}};
    const DialCircle wide = fitDial({{0, 0}, {200, 100}}, right, 5, 2);
    CHECK(wide.radius == doctest::Approx(48).epsilon(0.01));
    const DialCircle narrow = fitDial({{0, 0}, {100, 100}}, right, 5, 2);
    CHECK(narrow.radius < 30);
    CHECK(narrow.center.x + narrow.radius + 45 <= doctest::Approx(100.1));
    CHECK(narrow.center.x < 50);
}
