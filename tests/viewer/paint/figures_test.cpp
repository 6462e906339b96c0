#include "paint/figures.h"

#include <doctest/doctest.h>

#include <array>

#include "open_session.h"
#include "spiraling_edge/run/run_cursor.h"

using namespace se;
using namespace se::view;

namespace {

/// The color of a pixel of a picture, x to the right and y up.
std::array<int, 3> colorAt(const Picture& picture, int x, int y) {
    const auto at = 4 * static_cast<std::size_t>(y * picture.size.x + x);
    return {picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]};
}

bool isReddish(const std::array<int, 3>& color) { return color[0] > color[2] + 30; }

const std::vector<Vec3> kCorners{{1e6, 0, 5}, {1e6 + 4, 0, 5}, {1e6, 2, 5}, {1e6 + 1, 1, 6}};

}  // namespace

TEST_CASE(
    "A mesh fills its picture, the outer side in its color, the inner one in that of errors") {
    const std::vector<Triangle> up{{0, 1, 2}};
    const Picture outer = meshPicture(kCorners, up, 100, {0, 0, 1});
    REQUIRE(outer.size == glm::ivec2(100));
    const auto ground = colorAt(outer, 0, 99);
    CHECK(colorAt(outer, 20, 40) != ground);
    CHECK(colorAt(outer, 99, 99) == ground);
    CHECK(colorAt(outer, 80, 60) == ground);
    CHECK_FALSE(isReddish(colorAt(outer, 20, 40)));
    CHECK(isReddish(colorAt(meshPicture(kCorners, up, 100, {0, 0, -1}), 80, 40)));
}

TEST_CASE("The nearest triangle is seen, from wherever") {
    const std::vector<Triangle> closed{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    for (const Vec3& way : {Vec3(0, 0, 1), Vec3(1, 0, 0.2), Vec3(0, -1, 0), Vec3(0.3, 1, 2)}) {
        const Picture picture = meshPicture(kCorners, closed, 64, way);
        int red = 0;
        int filled = 0;
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                red += isReddish(colorAt(picture, x, y)) ? 1 : 0;
                filled += colorAt(picture, x, y) != colorAt(picture, 0, 0) ? 1 : 0;
            }
        }
        CHECK(red == 0);
        CHECK(filled > 100);
    }
    CHECK(meshPicture(kCorners, {}, 8, {0, 0, 1}).rgba.size() == 4 * 64);
}

TEST_CASE("A decision is drawn with its dial, address and sentence, in a style of its own") {
    LoadProgress progress;
    const auto model = test::loadModel(RunSpec{"scene:torus"}, progress);
    REQUIRE(model.ok());
    RunCursor cursor(model.value()->points, model.value()->params);
    const auto drawn = [&] {
        return decisionSvg(model.value()->points, model.value()->params, cursor.state(), 400.0F);
    };
    CHECK(drawn().find("The start of the run") != std::string::npos);
    CHECK(drawn().find("Tangent plane at") == std::string::npos);
    REQUIRE(cursor.goTo({137, Stage::Sphere, 2}));
    const std::string svg = drawn();
    for (const char* part : {"width=\"400\"", ">137.sphere.2, section 6.3<", ">Tangent plane at ",
                             "data-point=", "<style>#decision-"})
        CHECK_MESSAGE(svg.find(part) != std::string::npos, part);
    CHECK(svg.find("}.") == std::string::npos);
    CHECK(svg == drawn());
}
