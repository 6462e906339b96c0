#include "input/view_drag.h"

#include <doctest/doctest.h>

using namespace se::view;

namespace {

constexpr float kThreshold = 8.0F;

void pressAt(ViewDrag& drag, glm::vec2 pointer) {
    drag.press(pointer);
    drag.begin();
}

}  // namespace

TEST_CASE("A press right after a jump of the pointer moves nothing, and is a click") {
    ViewDrag drag;
    pressAt(drag, {900.0F, 700.0F});
    CHECK(drag.move({900.0F, 700.0F}, kThreshold) == glm::vec2(0.0F));
    CHECK_FALSE(drag.drags());
    // Nor does a second one elsewhere, after a drag.
    CHECK(drag.move({950.0F, 700.0F}, kThreshold) == glm::vec2(50.0F, 0.0F));
    CHECK(drag.drags());
    pressAt(drag, {20.0F, 30.0F});
    CHECK(drag.move({20.0F, 30.0F}, kThreshold) == glm::vec2(0.0F));
    CHECK(drag.move({22.0F, 30.0F}, kThreshold) == glm::vec2(0.0F));
    CHECK_FALSE(drag.drags());
}

TEST_CASE("A drag begins at the threshold, and then has all of the motion") {
    ViewDrag drag;
    pressAt(drag, {100.0F, 100.0F});
    CHECK(drag.move({104.0F, 100.0F}, kThreshold) == glm::vec2(0.0F));
    CHECK(drag.move({107.0F, 101.0F}, kThreshold) == glm::vec2(0.0F));
    CHECK(drag.move({109.0F, 102.0F}, kThreshold) == glm::vec2(9.0F, 2.0F));
    CHECK(drag.move({109.0F, 102.0F}, kThreshold) == glm::vec2(0.0F));
    // Back at the press it is still a drag.
    CHECK(drag.move({100.0F, 100.0F}, kThreshold) == glm::vec2(-9.0F, -2.0F));
}

TEST_CASE("A drag that ends within one frame counts as a whole") {
    ViewDrag drag;
    // The frame sees the button down at the current position of the pointer.
    pressAt(drag, {100.0F, 100.0F});
    CHECK(drag.move({160.0F, 120.0F}, kThreshold) == glm::vec2(60.0F, 20.0F));
    CHECK(drag.drags());
}

TEST_CASE("Another button pressed meanwhile does not disturb a drag") {
    ViewDrag drag;
    pressAt(drag, {100.0F, 100.0F});
    CHECK(drag.move({120.0F, 100.0F}, kThreshold) == glm::vec2(20.0F, 0.0F));
    drag.press({121.0F, 100.0F});
    CHECK(drag.move({130.0F, 100.0F}, kThreshold) == glm::vec2(10.0F, 0.0F));
}

TEST_CASE("A click counts once the time of a double click is over, and then once") {
    DoubleClickFilter click;
    CHECK_FALSE(click.waiting());
    click.begin(Selection::ofPoint(7), 10.3);
    CHECK(click.waiting());
    CHECK_FALSE(click.due(10.2).has_value());
    CHECK(click.due(10.3) == Selection::ofPoint(7));
    CHECK_FALSE(click.waiting());
    CHECK_FALSE(click.due(11.0).has_value());
}

TEST_CASE("The first half of a double click never counts") {
    DoubleClickFilter click;
    click.begin(Selection::ofPoint(7), 10.3);
    click.takeBack();
    CHECK_FALSE(click.due(20.0).has_value());
}

TEST_CASE("A click elsewhere replaces one that waits") {
    DoubleClickFilter click;
    click.begin(Selection::ofPoint(7), 10.3);
    click.begin(Selection{}, 10.5);
    CHECK_FALSE(click.due(10.4).has_value());
    CHECK(click.due(10.5) == Selection{});
}
