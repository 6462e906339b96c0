#include "panel_state/picture_look.h"

#include <doctest/doctest.h>

using namespace se::view;

TEST_CASE("Tiles cover a picture once, and each fits with its margin") {
    const auto tiles = tilesOf({1000, 700}, 300, 40, 2);
    int covered = 0;
    for (const PictureTile& each : tiles) {
        covered += each.size.x * each.size.y;
        CHECK(each.size.x + 2 * each.margin <= 300);
        CHECK(each.min.x % 2 == 0);
        CHECK(each.min.y % 2 == 0);
    }
    CHECK(covered == 1000 * 700);
    CHECK(tiles.front().min == glm::ivec2(0));
    CHECK(tiles.back().min + tiles.back().size == glm::ivec2(1000, 700));
    CHECK(tilesOf({1000, 700}, 300, 148, 2).empty());
}

TEST_CASE("The part of a view for a tile has its margin, and none beyond the view") {
    const Rect view{{100.0F, 50.0F}, {400.0F, 300.0F}};
    CHECK(partOfView(view, std::nullopt) == PixelRect{{0, 0}, {400, 300}});
    // Rows are counted from below in the view, from above in the picture.
    const PixelRect part = partOfView(view, PictureTile{{200, 150}, {100, 100}, 10});
    CHECK(part == PixelRect{{88, 88}, {210, 210}});
    CHECK(partOfView(view, PictureTile{{0, 0}, {110, 60}, 500}) == PixelRect{{0, 0}, {400, 300}});
    CHECK(partOfView(view, PictureTile{{0, 0}, {100, 400}, 10}).empty());
}
