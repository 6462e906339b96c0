#include "scene/camera.h"

#include <doctest/doctest.h>

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <initializer_list>
#include <utility>
#include <vector>

using namespace se::view;

namespace {

constexpr glm::vec2 kSize{800.0F, 600.0F};
constexpr float kAspect = 800.0F / 600.0F;

glm::vec3 seen(const Camera& camera, const glm::vec3& point) {
    return project(camera.matrices(kAspect), point, kSize);
}

}  // namespace

TEST_CASE("The target is in the middle of the view, from everywhere") {
    Camera camera;
    for (const ViewPreset preset : {ViewPreset::Front, ViewPreset::Right, ViewPreset::Top,
                                    ViewPreset::Bottom, ViewPreset::Back, ViewPreset::Left}) {
        camera.set(preset);
        const glm::vec3 at = seen(camera, camera.target());
        CHECK(at.x == doctest::Approx(400.0F));
        CHECK(at.y == doctest::Approx(300.0F));
        CHECK(at.z > 0.0F);
    }
}

TEST_CASE("The presets look along the axes") {
    Camera camera;
    camera.set(ViewPreset::Front);
    CHECK(seen(camera, {0.5F, 0, 0}).x > 400.0F);
    CHECK(seen(camera, {0, 0, 0.5F}).y < 300.0F);
    camera.set(ViewPreset::Right);
    CHECK(seen(camera, {0, 0.5F, 0}).x > 400.0F);
    camera.set(ViewPreset::Top);
    CHECK(seen(camera, {0.5F, 0, 0}).x > 400.0F);
    CHECK(seen(camera, {0, 0.5F, 0}).y < 300.0F);
}

TEST_CASE("Zooming keeps the point under the pointer there") {
    Camera camera;
    const glm::vec2 pixel(600.0F, 200.0F);
    const glm::vec2 ndc(2.0F * pixel.x / kSize.x - 1.0F, 1.0F - 2.0F * pixel.y / kSize.y);
    // The point of the plane through the target that lies under the pixel.
    const CameraMatrices m = camera.matrices(kAspect);
    const glm::vec4 far4 = glm::inverse(m.viewProjection()) * glm::vec4(ndc, 1.0F, 1.0F);
    const glm::vec3 way = glm::normalize(glm::vec3(far4) / far4.w - m.eye);
    const glm::vec3 axis = glm::normalize(camera.target() - m.eye);
    const glm::vec3 point = m.eye + way * (camera.distance() / glm::dot(way, axis));
    camera.zoomAt(3.0F, ndc, kAspect);
    const glm::vec3 after = seen(camera, point);
    CHECK(after.x == doctest::Approx(pixel.x).epsilon(0.002));
    CHECK(after.y == doctest::Approx(pixel.y).epsilon(0.002));
}

TEST_CASE("A pan moves the picture with the pointer") {
    Camera camera;
    const glm::vec3 before = seen(camera, glm::vec3(0.0F));
    camera.pan({30.0F, -20.0F}, kSize.y);
    const glm::vec3 after = seen(camera, glm::vec3(0.0F));
    CHECK(after.x - before.x == doctest::Approx(30.0F).epsilon(0.01));
    CHECK(after.y - before.y == doctest::Approx(-20.0F).epsilon(0.01));
}

TEST_CASE("Turning keeps target and distance, and never goes over the pole") {
    Camera camera;
    const float distance = camera.distance();
    for (int i = 0; i < 50; ++i) camera.orbit({37.0F, 90.0F}, kSize.y);
    CHECK(camera.target() == glm::vec3(0.0F));
    CHECK(camera.distance() == distance);
    CHECK(glm::length(camera.matrices(kAspect).eye) == doctest::Approx(distance));
    CHECK(camera.matrices(kAspect).eye.z == doctest::Approx(distance));
}

TEST_CASE("Facing a surface seen from within turns to its outer side, otherwise it has no effect") {
    Camera camera;
    for (const glm::vec3 normal : {glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 0, -1)}) {
        camera.set(ViewPreset::Front);
        camera.face({0, -1, 0});
        CHECK(camera.matrices(kAspect).eye.y == doctest::Approx(-camera.distance()));
        camera.face(normal);
        CHECK(glm::dot(glm::normalize(camera.matrices(kAspect).eye), normal) > 0.99F);
    }
}

TEST_CASE("Everything in the unit sphere is between the planes of the camera") {
    Camera camera;
    for (const float radius : {0.02F, 0.3F, 1.0F}) {
        camera.setPose({{0.6F, 0.6F, 0.0F}, 4.0F * radius});
        for (const glm::vec3 corner :
             {glm::vec3(-1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, 1)}) {
            const glm::vec4 clip =
                camera.matrices(kAspect).viewProjection() * glm::vec4(corner, 1.0F);
            if (clip.w > 0.0F) CHECK(clip.z <= clip.w);
        }
    }
}

TEST_CASE("Every change is counted, so that pictures are redrawn") {
    Camera camera;
    unsigned last = camera.revision();
    const auto changed = [&] {
        return std::exchange(last, camera.revision()) != camera.revision();
    };
    camera.orbit({1, 1}, 600);
    CHECK(changed());
    camera.pan({1, 1}, 600);
    CHECK(changed());
    camera.zoomAt(1, {0, 0}, kAspect);
    CHECK(changed());
    camera.toggleOrthographic();
    CHECK(changed());
    camera.lookAt({0.1F, 0, 0});
    CHECK(changed());
    camera.fill(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}}, {}, 0.8F);
    CHECK(changed());
}

TEST_CASE("The axis that is up points up in the picture, from every side") {
    for (const auto& [axis, tip] : {std::pair{UpAxis::X, glm::vec3(0.5F, 0, 0)},
                                    {UpAxis::Y, glm::vec3(0, 0.5F, 0)},
                                    {UpAxis::Z, glm::vec3(0, 0, 0.5F)}}) {
        Camera camera;
        camera.setUp(axis);
        const glm::vec3 at = seen(camera, tip);
        CHECK(at.x == doctest::Approx(400.0F).epsilon(0.001));
        CHECK(at.y < 300.0F);
        for (const ViewPreset preset : {ViewPreset::Front, ViewPreset::Right, ViewPreset::Back}) {
            camera.set(preset);
            CHECK(seen(camera, tip).x == doctest::Approx(400.0F).epsilon(0.001));
            CHECK(seen(camera, tip).y < 200.0F);
        }
        // Nothing is mirrored: x, y and z keep their handedness.
        const glm::mat3 turn(camera.matrices(kAspect).view);
        CHECK(glm::determinant(turn) == doctest::Approx(1.0F));
    }
}

TEST_CASE("With y up the front is seen along -z, with x to the right") {
    Camera camera;
    camera.setUp(UpAxis::Y);
    camera.set(ViewPreset::Front);
    CHECK(seen(camera, {0.5F, 0, 0}).x > 400.0F);
    CHECK(seen(camera, {0, 0, 0.5F}).z < seen(camera, {0, 0, -0.5F}).z);
}

TEST_CASE("A surface is faced from its outer side, for any up axis") {
    const glm::vec3 normal = glm::normalize(glm::vec3(-0.4F, -0.7F, 0.2F));
    for (const UpAxis axis : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
        Camera camera;
        camera.setUp(axis);
        camera.set(ViewPreset::Front);
        camera.face(normal);
        const glm::vec3 eye = camera.matrices(kAspect).eye - camera.target();
        CHECK(glm::dot(glm::normalize(eye), normal) > 0.1F);
        CHECK(camera.pose().up == axis);
    }
}

TEST_CASE("A surface is faced straight, also one that is seen from its outer side") {
    for (const UpAxis axis : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
        for (const glm::vec3 way : {glm::vec3(0.3F, -0.8F, 0.5F), glm::vec3(0, 0, 1)}) {
            const glm::vec3 normal = glm::normalize(way);
            Camera camera;
            camera.setUp(axis);
            camera.set(ViewPreset::Front);
            camera.faceStraight(normal);
            const glm::vec3 eye = camera.matrices(kAspect).eye - camera.target();
            CHECK(glm::dot(glm::normalize(eye), normal) > 0.999F);
        }
    }
}
