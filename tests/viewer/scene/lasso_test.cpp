#include "scene/lasso.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "open_session.h"
#include "scene/picking.h"

using namespace se;
using namespace se::view;

namespace {

constexpr glm::vec2 kSize{640.0F, 480.0F};

CameraMatrices front() {
    Camera camera;
    camera.frame(glm::vec3(0.0F), 1.0F);
    camera.set(ViewPreset::Front);
    return camera.matrices(kSize.x / kSize.y);
}

const std::vector<glm::vec2> kAll{{0, 0}, {640, 0}, {640, 480}, {0, 480}};

}  // namespace

TEST_CASE("A line around everything encloses only the points that face the eye") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    const CameraMatrices camera = front();
    const std::vector<Index> points = pointsWithin(*model, camera, kSize, kAll);
    std::size_t facing = 0;
    for (Index p = 0; p < model->place.size(); ++p)
        facing += glm::dot(camera.eye - model->place[p], model->normal[p]) >= 0.0F ? 1 : 0;
    CHECK(points.size() == facing);
    CHECK(facing > 100);
    CHECK(std::is_sorted(points.begin(), points.end()));
}

TEST_CASE("Points left of a line are not enclosed by one around the right half") {
    const auto model = test::sphereModel();
    const CameraMatrices camera = front();
    const std::vector<glm::vec2> right{{320, 0}, {640, 0}, {640, 480}, {320, 480}};
    const auto points = pointsWithin(*model, camera, kSize, right);
    CHECK_FALSE(points.empty());
    CHECK(points.size() < pointsWithin(*model, camera, kSize, kAll).size());
    for (const Index p : points) CHECK(project(camera, model->place[p], kSize).x >= 320.0F);
}

TEST_CASE("A concave line excludes the points in its notch; two corners enclose nothing") {
    const auto model = test::sphereModel();
    const CameraMatrices camera = front();
    // A U open at the top: the middle is outside.
    const std::vector<glm::vec2> hollow{{0, 0},   {280, 0}, {280, 400}, {360, 400},
                                        {360, 0}, {640, 0}, {640, 480}, {0, 480}};
    for (const Index p : pointsWithin(*model, camera, kSize, hollow)) {
        const glm::vec3 at = project(camera, model->place[p], kSize);
        CHECK((at.x <= 280.0F || at.x >= 360.0F || at.y >= 400.0F));
    }
    CHECK(pointsWithin(*model, camera, kSize, std::span(kAll).first(2)).empty());
}
