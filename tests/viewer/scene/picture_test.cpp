#include "scene/picture.h"

#include <doctest/doctest.h>

using namespace se::view;

namespace {

using Bytes = std::vector<std::uint8_t>;

}  // namespace

TEST_CASE("A picture is cut out where its background shows through") {
    // Nothing; something opaque; something red of which half the background shows through.
    const Picture black{{3, 1}, {0, 0, 0, 255, 10, 200, 30, 255, 128, 0, 0, 255}};
    const Picture white{{3, 1}, {255, 255, 255, 255, 10, 200, 30, 255, 255, 127, 127, 255}};
    CHECK(cutOut(black, white).rgba == Bytes{0, 0, 0, 0, 10, 200, 30, 255, 255, 0, 0, 128});
}

TEST_CASE("A reduced picture has the average of the opaque parts, and of their opacity") {
    const Picture large{{2, 2}, {100, 0, 0, 255, 200, 0, 0, 255, 9, 9, 9, 0, 9, 9, 9, 0}};
    const Picture small = reduced(large, 2);
    CHECK(small.size == glm::ivec2(1));
    CHECK(small.rgba == Bytes{150, 0, 0, 128});
    CHECK(reduced(large, 1).rgba[4] == 200);
}
