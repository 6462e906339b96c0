#include "spiraling_edge/sampling/field.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "support/oracles.h"

using namespace se;

namespace {

Vec3 randomPlace(const Field& field, test::Random& random) {
    return random.inBox(field.low, field.high);
}

}  // namespace

TEST_CASE("shapes have distinct names and can be found by them") {
    std::set<std::string_view> names;
    for (const Shape& shape : shapes()) {
        names.insert(shape.id);
        CHECK(findShape(shape.id) == &shape);
        CHECK_FALSE(shape.title.empty());
    }
    CHECK(names.size() == shapes().size());
    CHECK(findShape("no-such-shape") == nullptr);
}

TEST_CASE("the gradient of every shape is the slope of its values") {
    for (const Shape& shape : shapes()) {
        CAPTURE(shape.id);
        const Field field = fieldOf(shape);
        test::Random random(1);
        const double size = field.high.x - field.low.x;
        int looked = 0;
        while (looked < 200) {
            const Vec3 x = randomPlace(field, random);
            const Vec3 gradient = field.gradient(x);
            const double steepness = std::sqrt(glm::dot(gradient, gradient));
            Vec3 slope;
            const double step = 1e-6 * size;
            for (int axis = 0; axis < 3; ++axis) {
                Vec3 e(0.0);
                e[axis] = step;
                slope[axis] = (field.value(x + e) - field.value(x - e)) / (2.0 * step);
            }
            ++looked;
            // Where two tori are equally near, the distance has a crease.
            const bool creased = shape.id == "two-tori" && glm::dot(slope, slope) < 0.99;
            if (creased) continue;
            CHECK(glm::length(gradient - slope) <= 1e-4 * (steepness + 1e-3));
        }
    }
}

TEST_CASE("normals point to the side that a shape calls outside") {
    const Field sphere = fieldOf(*findShape("sphere"));
    CHECK(glm::length(sphere.normal(Vec3(0, 0, 1)) - Vec3(0, 0, 1)) < 1e-12);
    // Densities fall outwards.
    for (const char* id : {"hydrogen", "blast-wave", "metaballs"}) {
        CAPTURE(id);
        const Field field = fieldOf(*findShape(id));
        const Vec3 x =
            0.5 * (field.low + field.high) + Vec3(0.1, 0.15, 0.2) * (field.high - field.low);
        const Vec3 n = field.normal(x);
        CHECK(std::abs(glm::length(n) - 1.0) < 1e-12);
        CHECK(field.value(x + 1e-3 * n) < field.value(x));
    }
    Field flat = sphere;
    flat.gradient = [](const Vec3&) { return Vec3(0.0); };
    CHECK(flat.normal(Vec3(0.0)) == Vec3(0.0));
}

TEST_CASE("the hyperboloid of Table 1 is the printed function") {
    const Field field = fieldOf(*findShape("hyperboloid"));
    CHECK(field.value(Vec3(0, 1, 0)) == 17.0);  // 2 * 9 - 1
    CHECK(field.value(Vec3(1.5, 1, 1.5)) == -1.0);
    CHECK(field.value(Vec3(3, 0, 0)) == -23.0);  // -2 * 9 - 4 - 1
    CHECK(field.high == Vec3(3, 2, 3));
}

TEST_CASE("the hydrogen orbital has two lobes and a ring at its isovalue") {
    const Field field = fieldOf(*findShape("hydrogen"));
    const Vec3 middle(31.5);
    CHECK(field.value(middle + Vec3(0, 0, 10)) > field.isovalue);
    CHECK(field.value(middle - Vec3(0, 0, 10)) > field.isovalue);
    CHECK(field.value(middle + Vec3(9, 0, 0)) > field.isovalue);
    CHECK(field.value(middle + Vec3(0, -9, 0)) > field.isovalue);
    // Nothing at the nucleus, nor on the cone between lobes and ring, where 3 z^2 = r^2.
    CHECK(field.value(middle) == 0.0);
    CHECK(field.value(middle + Vec3(std::sqrt(2.0), 0, 1) * 5.0) < 1e-12);
}
