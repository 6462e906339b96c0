#include "rows/step_tree.h"

#include <doctest/doctest.h>

using namespace se::view;

namespace {

constexpr float kEm = 16.0F;

}  // namespace

TEST_CASE("Steps: the largest numbers fit their columns") {
    // A run of 278 631 tests, at about half an em per digit.
    const StepNumberWidths widest{52.0F, 58.0F, 64.0F};
    const StepColumns c = placeStepColumns(10.0F, 25.0F * kEm, kEm, widest);
    REQUIRE(c.triangles > 0.0F);
    CHECK(c.refused <= 10.0F + 25.0F * kEm);
    CHECK(c.refused - widest.refused > c.tests);
    CHECK(c.tests - widest.tests > c.triangles);
    CHECK(c.triangles - widest.triangles > c.labels);
}

TEST_CASE("Steps: triangles are left out where labels would have no room") {
    const StepNumberWidths widest{52.0F, 58.0F, 64.0F};
    const StepColumns c = placeStepColumns(0.0F, 17.0F * kEm, kEm, widest);
    CHECK(c.triangles == 0.0F);
    CHECK(c.tests - widest.tests > c.labels);
    CHECK(c.labels > 6.0F * kEm);
    // Small numbers leave enough room.
    CHECK(placeStepColumns(0.0F, 17.5F * kEm, kEm, {20.0F, 20.0F, 24.0F}).triangles > 0.0F);
}
