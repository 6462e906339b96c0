#include "paint/screen_space.h"

#include <doctest/doctest.h>

using namespace se::view;

namespace {

const std::array<glm::vec3, 3> kNear = {glm::vec3(10, 10, 0.1F), {50, 10, 0.1F}, {10, 50, 0.1F}};
const std::array<glm::vec3, 3> kFar = {glm::vec3(0, 0, 0.5F), {90, 0, 0.5F}, {0, 90, 0.5F}};

}  // namespace

TEST_CASE("A triangle hides what lies after it, whatever their order") {
    for (const bool nearFirst : {true, false}) {
        DepthPicture picture({100.0F, 100.0F});
        picture.add(nearFirst ? kNear : kFar, nearFirst ? 1 : 2);
        picture.add(nearFirst ? kFar : kNear, nearFirst ? 2 : 1);
        CHECK(picture.hides({15.0F, 15.0F, 0.3F}));
        CHECK_FALSE(picture.hides({15.0F, 15.0F, 0.05F}));
        CHECK_FALSE(picture.hides({60.0F, 5.0F, 0.3F}));
        CHECK(picture.hides({60.0F, 5.0F, 0.6F}));
        CHECK(picture.visible() == std::vector<std::uint32_t>{1, 2});
    }
}

TEST_CASE("What lies on a triangle is not hidden by it, nor is what lies beside the picture") {
    DepthPicture picture({100.0F, 100.0F});
    picture.add(kFar, 0);
    CHECK_FALSE(picture.hides({20.5F, 20.5F, 0.5F}));
    CHECK_FALSE(picture.hides({-5.0F, 20.0F, 0.9F}));
    CHECK_FALSE(picture.hides({20.0F, 100.0F, 0.9F}));
}

TEST_CASE("A triangle that others cover is not visible") {
    DepthPicture picture({100.0F, 100.0F});
    picture.add(kNear, 1);
    picture.add({glm::vec3(15, 15, 0.4F), {25, 15, 0.4F}, {15, 25, 0.4F}}, 2);
    CHECK(picture.visible() == std::vector<std::uint32_t>{1});
}

TEST_CASE("The later of two equal triangles is visible") {
    DepthPicture picture({100.0F, 100.0F});
    picture.add(kNear, 1);
    picture.add(kNear, 2);
    CHECK(picture.visible() == std::vector<std::uint32_t>{2});
}

TEST_CASE("Screen space has its corner at the top left, and nothing behind the eye") {
    Camera camera;
    const ScreenSpace screen(camera.matrices(1.5F), {300.0F, 200.0F});
    const glm::vec3 middle = *screen.at(camera.target());
    CHECK(middle.x == doctest::Approx(150.0F));
    CHECK(middle.y == doctest::Approx(100.0F));
    CHECK(screen.at(camera.target() + 0.1F * screen.up())->y < 100.0F);
    CHECK(screen.at(camera.target(), 0.1F)->z < middle.z);
    CHECK_FALSE(screen.at(camera.matrices(1.5F).eye + screen.toEye(camera.target())));
}
