#include "layers/disc.h"

#include <doctest/doctest.h>

#include <cmath>

#include "drawn.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

using Corners = std::array<glm::vec3, 3>;

float lengthOf(const std::vector<std::pair<glm::vec3, glm::vec3>>& segments) {
    float sum = 0.0F;
    for (const auto& [from, to] : segments) sum += glm::distance(from, to);
    return sum;
}

}  // namespace

TEST_CASE("The cut of a sphere and a triangle is on both") {
    const Sphere sphere{{0.1F, 0.2F, 0.3F}, 1.0F, {}};
    const Corners corners = {glm::vec3(0, 0, 0), {2, 0, 0}, {0, 2, 0}};
    const auto segments = sphereCut(sphere, corners);
    REQUIRE_FALSE(segments.empty());
    for (const auto& [from, to] : segments) {
        for (const glm::vec3& end : {from, to}) {
            CHECK(glm::distance(end, sphere.center) == doctest::Approx(1.0F).epsilon(1e-4));
            CHECK(std::abs(end.z) < 1e-5F);
            CHECK(end.x > -1e-4F);
            CHECK(end.y > -1e-4F);
            CHECK(end.x + end.y < 2.0F + 1e-4F);
        }
    }
}

TEST_CASE("A small sphere cuts a large triangle in a whole circle, or not at all") {
    const Corners corners = {glm::vec3(-9, -9, 0), {9, -9, 0}, {0, 9, 0}};
    // 0.3 above the plane, radius 0.5: a circle of radius 0.4.
    const float length = lengthOf(sphereCut({{0.0F, 0.0F, 0.3F}, 0.5F, {}}, corners));
    CHECK(length == doctest::Approx(2.0 * 3.14159265 * 0.4).epsilon(1e-2));
    CHECK(sphereCut({{0.0F, 0.0F, 0.6F}, 0.5F, {}}, corners).empty());
    CHECK(sphereCut({{20.0F, 0.0F, 0.3F}, 0.5F, {}}, corners).empty());
}

TEST_CASE("A sphere around a whole triangle does not cut it") {
    const Corners corners = {glm::vec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}};
    CHECK(sphereCut({{0.3F, 0.3F, 0.0F}, 5.0F, {}}, corners).empty());
}

TEST_CASE("Drawn for sphere: the curve on the mesh, and the feet of q and c on the disc") {
    OpenSession open("scene:torus");
    open.session.moves().goToText("137.sphere.3");
    open.session.waitUntilDone();
    const DrawList list = drawnAt(open, kPaper, addCircumsphere);
    REQUIRE(list.spheres.size() == 1);
    const Sphere& sphere = list.spheres[0];
    const Model& model = open.session.model();
    const Index pivot = open.session.picture().pivot;
    const auto onDisc = [&](const glm::vec3& place) {
        const float height = glm::dot(place - model.place[pivot], model.normal[pivot]);
        return std::abs(height) < 1e-5F;
    };
    std::size_t feet = 0;
    for (const Sprite& sprite : list.sprites) feet += onDisc(sprite.position) ? 1 : 0;
    CHECK(feet >= 2);
    std::size_t contact = 0;
    for (const Line& line : list.lines) {
        const bool touches = std::abs(glm::distance(line.from, sphere.center) - sphere.radius) <
                             1e-3F * sphere.radius;
        contact += touches && !onDisc(line.from) ? 1 : 0;
    }
    // More than the circle through p, s and t.
    CHECK(contact > 96);
}
