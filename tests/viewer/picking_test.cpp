#include "picking.h"

#include <doctest/doctest.h>

#include "rig.h"

using namespace se;
using namespace se::view;

namespace {

constexpr glm::vec2 kSize{640.0F, 480.0F};

/// Two points behind each other as seen from the front, and one on either side.
Model smallModel() {
    Model model;
    model.points.position = {{0, -1, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};
    model.points.normal = {{0, -1, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};
    model.points.type = {0, 0, 0, 0};
    for (int i = 0; i < 4; ++i) model.points.neighbors.append({});
    placeModel(model);
    return model;
}

CameraMatrices front() {
    Camera camera;
    camera.frame(glm::vec3(0.0F), 1.0F);
    camera.set(ViewPreset::Front);
    return camera.matrices(kSize.x / kSize.y);
}

}  // namespace

TEST_CASE("The nearer of two points behind each other is picked") {
    const Model model = smallModel();
    const CameraMatrices camera = front();
    const glm::vec2 pixel(project(camera, model.place[0], kSize));
    CHECK(pickPoint(model, camera, kSize, pixel, 6.0F) == 0);
    CHECK(pickPoint(model, camera, kSize, pixel + glm::vec2(4.0F, 0.0F), 6.0F) == 0);
}

TEST_CASE("Nothing is picked where nothing is") {
    const Model model = smallModel();
    CHECK(pickPoint(model, front(), kSize, {5.0F, 5.0F}, 6.0F) == kNone);
}

TEST_CASE("Points that cannot be drawn are not picked") {
    Model model = smallModel();
    model.drawable[0] = false;
    const CameraMatrices camera = front();
    const glm::vec2 pixel(project(camera, model.place[0], kSize));
    CHECK(pickPoint(model, camera, kSize, pixel, 6.0F) == 1);
}

TEST_CASE("Every point of a sphere is found where it is drawn, if it faces the eye") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    const CameraMatrices camera = front();
    int found = 0;
    int facing = 0;
    for (Index p = 0; p < model->points.size(); ++p) {
        if (glm::dot(camera.eye - model->place[p], model->normal[p]) < 0.3F) continue;
        ++facing;
        const glm::vec2 pixel(project(camera, model->place[p], kSize));
        found += pickPoint(*model, camera, kSize, pixel, 1.0F) == p ? 1 : 0;
    }
    CHECK(facing > 100);
    CHECK(found == facing);
}
