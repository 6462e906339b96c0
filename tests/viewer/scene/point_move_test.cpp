#include "scene/picking.h"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

using namespace se::view;

namespace {

constexpr glm::vec2 kViewSize{800.0F, 600.0F};

Camera tiltedCamera() {
    Camera camera;
    return camera;
}

}  // namespace

TEST_CASE("A place in a plane is under the pointer, and in the plane") {
    for (const bool orthographic : {false, true}) {
        Camera camera = tiltedCamera();
        if (orthographic) camera.toggleOrthographic();
        const CameraMatrices matrices = camera.matrices(kViewSize.x / kViewSize.y);
        const glm::vec3 origin(0.1F, -0.2F, 0.3F);
        const glm::vec3 normal = glm::normalize(glm::vec3(0.1F, -0.6F, 0.8F));
        const glm::vec2 pixel(350.0F, 280.0F);
        const auto place = placeInPlane(matrices, kViewSize, pixel, origin, normal);
        REQUIRE(place);
        CHECK(glm::dot(*place - origin, normal) == doctest::Approx(0.0).epsilon(1e-4));
        const glm::vec3 at = project(matrices, *place, kViewSize);
        CHECK(at.x == doctest::Approx(pixel.x).epsilon(1e-3));
        CHECK(at.y == doctest::Approx(pixel.y).epsilon(1e-3));
    }
}

TEST_CASE("A plane or a line seen edge on gives no place") {
    const CameraMatrices matrices = tiltedCamera().matrices(kViewSize.x / kViewSize.y);
    const glm::vec2 middle = 0.5F * kViewSize;
    const glm::vec3 sight = rayThrough(matrices, kViewSize, middle).way;
    const glm::vec3 across = glm::normalize(glm::cross(sight, glm::vec3(0.0F, 0.0F, 1.0F)));
    CHECK_FALSE(placeInPlane(matrices, kViewSize, middle, glm::vec3(0.0F), across));
    CHECK_FALSE(placeOnLine(matrices, kViewSize, middle, glm::vec3(0.0F), sight));
}

TEST_CASE("A place on a line is on the line, as near to the pointer as it gets") {
    const CameraMatrices matrices = tiltedCamera().matrices(kViewSize.x / kViewSize.y);
    const glm::vec3 origin(0.1F, -0.2F, 0.3F);
    const glm::vec3 direction = glm::normalize(glm::vec3(0.1F, 0.2F, 0.9F));
    const glm::vec3 target = origin + 0.37F * direction;
    const glm::vec3 at = project(matrices, target, kViewSize);
    const auto place = placeOnLine(matrices, kViewSize, {at.x, at.y}, origin, direction);
    REQUIRE(place);
    CHECK(glm::distance(*place, target) < 1e-4F);
}

TEST_CASE("A dragged place is rounded well below the spacing, to a few digits") {
    CHECK(roundedTo(0.123456789, 0.05) == 0.123457);
    CHECK(roundedTo(-1234.56789, 20.0) == -1234.568);
    CHECK(roundedTo(7e6 + 0.26, 1e5) == 7'000'000.0);
}
