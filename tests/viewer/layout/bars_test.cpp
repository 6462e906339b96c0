#include "layout/bars.h"

#include <doctest/doctest.h>

using namespace se::view;

TEST_CASE("Transport: parts that do not fit are left out, the least important first") {
    const TransportWidths widths{100, 60, 30, 90, 50, 30, 10};
    CHECK_FALSE(fitTransport(180, widths).unit);
    TransportParts parts = fitTransport(210, widths);
    CHECK(parts.unit);
    CHECK_FALSE(parts.speed);
    parts = fitTransport(275, widths);
    CHECK(parts.speed);
    CHECK_FALSE(parts.units);
    parts = fitTransport(335, widths);
    CHECK(parts.units);
    CHECK_FALSE(parts.loop);
    CHECK(fitTransport(375, widths).loop);
}
