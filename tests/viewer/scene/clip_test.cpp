#include "scene/screen_rect.h"

#include <doctest/doctest.h>

#include <array>

using namespace se::view;

namespace {

using Polygon = std::vector<glm::vec2>;

const Polygon kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Polygon moved(const Polygon& polygon, glm::vec2 by) {
    Polygon result;
    for (const glm::vec2& at : polygon) result.push_back(at + by);
    return result;
}

}  // namespace

TEST_CASE("Areas are positive counterclockwise and negative clockwise") {
    CHECK(areaOf(kSquare) == doctest::Approx(1.0));
    CHECK(areaOf(Polygon{{0, 0}, {0, 1}, {1, 1}, {1, 0}}) == doctest::Approx(-1.0));
    CHECK(areaOf(Polygon{{5, 5}, {7, 5}, {5, 8}}) == doctest::Approx(3.0));
    CHECK(areaOf(Polygon{}) == 0.0F);
}

TEST_CASE("Two squares have a corner in common") {
    const Polygon common = clipConvex(kSquare, moved(kSquare, {0.75F, 0.5F}));
    CHECK(common.size() == 4);
    CHECK(areaOf(common) == doctest::Approx(0.125));
}

TEST_CASE("Polygons inside stay whole, polygons outside are removed") {
    const Polygon small = {{0.25F, 0.25F}, {0.75F, 0.25F}, {0.5F, 0.75F}};
    CHECK(areaOf(clipConvex(small, kSquare)) == doctest::Approx(areaOf(small)));
    CHECK(areaOf(clipConvex(kSquare, small)) == doctest::Approx(areaOf(small)));
    CHECK(clipConvex(kSquare, moved(kSquare, {3, 0})).empty());
    CHECK(clipConvex(Polygon{}, kSquare).empty());
}

TEST_CASE("A side or a corner in common is no overlap") {
    CHECK(clipConvex(kSquare, moved(kSquare, {1, 0})).empty());
    CHECK(clipConvex(kSquare, moved(kSquare, {1, 1})).empty());
    // Two triangles of a mesh, on both sides of an edge.
    const Polygon left = {{0, 0}, {1, 1}, {0, 1}};
    const Polygon right = {{0, 0}, {1, 0}, {1, 1}};
    CHECK(clipConvex(left, right).empty());
}

TEST_CASE("Triangles can have six corners in common, and nothing depends on their order") {
    const Polygon up = {{-1, -0.5F}, {1, -0.5F}, {0, 1}};
    const Polygon down = {{0, -1}, {1, 0.5F}, {-1, 0.5F}};
    const Polygon star = clipConvex(up, down);
    CHECK(star.size() == 6);
    CHECK(areaOf(star) == doctest::Approx(areaOf(clipConvex(down, up))));
    CHECK(areaOf(star) > 0.5F);
    CHECK(areaOf(star) < areaOf(up));
}

TEST_CASE("The parts of a square that two halves cover make up the whole") {
    const Polygon lower = {{-1, -1}, {2, -1}, {2, 2}};
    const Polygon upper = {{-1, -1}, {2, 2}, {-1, 2}};
    CHECK(areaOf(clipConvex(kSquare, lower)) + areaOf(clipConvex(kSquare, upper)) ==
          doctest::Approx(1.0));
}
