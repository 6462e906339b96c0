#include "input/double_click_filter.h"

#include <doctest/doctest.h>

using namespace se::view;

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
