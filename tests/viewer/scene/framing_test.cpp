#include "scene/framing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <vector>

#include "open_session.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

constexpr ViewPart kWide{1.6F, 0.0F};
/// A view whose width limits.
constexpr ViewPart kNarrow{0.5F, 0.0F};
/// A view with a caption over its lower quarter.
constexpr ViewPart kCovered{1.6F, 0.25F};

/// The box around the picture of positions, in shares of the view, y down.
struct Seen {
    glm::vec2 low{1e9F};
    glm::vec2 high{-1e9F};
    glm::vec2 size() const { return high - low; }
    glm::vec2 middle() const { return 0.5F * (low + high); }
};

Seen seen(const std::vector<glm::vec3>& places, const ViewPart& part, const Camera& camera) {
    Seen box;
    for (const glm::vec3& place : places) {
        const glm::vec3 at = project(camera.matrices(part.aspect), place, glm::vec2(1.0F));
        REQUIRE(at.z > 0.0F);
        box.low = glm::min(box.low, glm::vec2(at));
        box.high = glm::max(box.high, glm::vec2(at));
    }
    return box;
}

/// The picture is in the middle of the part that is free, and fills that share of it.
void checkFills(const Seen& box, const ViewPart& part, float share) {
    const float free = 1.0F - part.coveredBelow;
    CHECK(std::max(box.size().x, box.size().y / free) == doctest::Approx(share).epsilon(0.01));
    CHECK(box.middle().x == doctest::Approx(0.5F).epsilon(0.01));
    CHECK(box.middle().y == doctest::Approx(0.5F * free).epsilon(0.01));
}

/// Points of an ellipsoid about the origin with these half axes, along those of a rotation about x
/// and then z.
Model ellipsoid(const glm::vec3& half, float tilt = 0.0F, float turn = 0.0F) {
    Model model;
    const auto placed = [&](glm::vec3 p) {
        p = {p.x, std::cos(tilt) * p.y - std::sin(tilt) * p.z,
             std::sin(tilt) * p.y + std::cos(tilt) * p.z};
        return glm::vec3(std::cos(turn) * p.x - std::sin(turn) * p.y,
                         std::sin(turn) * p.x + std::cos(turn) * p.y, p.z);
    };
    constexpr int kCount = 2000;
    for (int i = 0; i < kCount; ++i) {
        const float z = 1.0F - (2.0F * static_cast<float>(i) + 1.0F) / kCount;
        const float angle = 2.39996F * static_cast<float>(i);
        const float flat = std::sqrt(1.0F - z * z);
        const glm::vec3 at(flat * std::cos(angle), flat * std::sin(angle), z);
        model.place.push_back(placed(half * at));
        model.normal.push_back(glm::normalize(placed(at / half)));
    }
    model.drawable.assign(kCount, true);
    model.sample = model.place;
    return model;
}

Camera broadside(const Model& model, const ViewPart& part = kWide, UpAxis up = UpAxis::Z) {
    Camera camera;
    camera.setUp(up);
    showBroadside(model, part, camera);
    return camera;
}

}  // namespace

TEST_CASE("A subject fills its share of the free part, in its middle, from any side") {
    const std::vector<glm::vec3> places = {
        {1, 0, 0}, {-0.2F, 0.1F, 0.6F}, {0, 0.9F, 0.3F}, {0.4F, -0.5F, -0.1F}};
    for (const ViewPart& part : {kWide, kNarrow, kCovered}) {
        for (const float share : {kDecisionShare, kModelShare, kFaultShare}) {
            for (const bool orthographic : {false, true}) {
                Camera camera;
                camera.orbit({90.0F * share, 10.0F}, 600.0F);
                if (orthographic) camera.toggleOrthographic();
                const CameraPose before = camera.pose();
                framePlaces(places, 0.01F, part, share, camera);
                checkFills(seen(places, part, camera), part, share);
                CHECK(camera.pose().yawDegrees == before.yawDegrees);
                CHECK(camera.pose().pitchDegrees == before.pitchDegrees);
            }
        }
    }
}

TEST_CASE("A subject that is deep in the view lies before the eye, within its share") {
    std::vector<glm::vec3> places;
    Camera camera;
    camera.set(ViewPreset::Front);
    for (int i = -10; i <= 10; ++i)
        places.emplace_back(0.02F * static_cast<float>(i % 3), 0.1F * static_cast<float>(i), 0.0F);
    framePlaces(places, 0.001F, kWide, kModelShare, camera);
    const Seen box = seen(places, kWide, camera);
    CHECK(std::max(box.size().x, box.size().y) <= kModelShare);
    CHECK(box.size().x > 0.1F);
}

TEST_CASE("A point alone is shown with its surroundings") {
    Camera camera;
    const glm::vec3 at(0.2F, -0.3F, 0.1F);
    framePlaces({at}, 0.05F, kCovered, 0.5F, camera);
    const Seen box =
        seen({at + 0.05F * camera.upward(), at - 0.05F * camera.upward()}, kCovered, camera);
    CHECK(box.size().y == doctest::Approx(0.5F * 0.75F).epsilon(0.01));
    CHECK(box.middle().y == doctest::Approx(0.5F * 0.75F).epsilon(0.01));
    const CameraPose before = camera.pose();
    framePlaces({}, 0.05F, kWide, 0.5F, camera);
    CHECK(camera.pose() == before);
}

TEST_CASE("The least axis of an ellipsoid points to the eye, upright, and it fills its share") {
    for (const ViewPart& part : {kWide, kNarrow, kCovered}) {
        for (const float turn : {0.0F, 0.7F, 2.0F}) {
            for (const float tilt : {0.3F, 0.6F, 0.9F}) {
                CAPTURE(turn);
                CAPTURE(tilt);
                // The axis with the least extent is y, which rises by the tilt.
                const Model model = ellipsoid({0.9F, 0.2F, 0.5F}, tilt, turn);
                const Camera camera = broadside(model, part);
                const glm::vec3 axis(-std::sin(turn) * std::cos(tilt),
                                     std::cos(turn) * std::cos(tilt), std::sin(tilt));
                CHECK(std::abs(glm::dot(camera.direction(), axis)) > 0.999F);
                CHECK(camera.right().z == doctest::Approx(0.0F));
                CHECK(camera.upward().z > 0.0F);
                checkFills(seen(model.place, part, camera), part, 0.8F);
            }
        }
    }
}

TEST_CASE("A model is seen from a little above, but not from straight above") {
    // It stands: exactly level, height and depth could not be told apart.
    const Camera standing = broadside(ellipsoid({0.6F, 0.2F, 0.9F}));
    CHECK(standing.pose().pitchDegrees == doctest::Approx(10.0F));
    CHECK(std::abs(standing.direction().y) > 0.98F);
    // It lies: its broad side is seen, with the longest axis across.
    const Camera lying = broadside(ellipsoid({0.5F, 0.9F, 0.2F}));
    CHECK(lying.pose().pitchDegrees == doctest::Approx(60.0F));
    CHECK(std::abs(lying.right().y) > 0.99F);
    // As thick as wide: from the front, right and above.
    const Camera ball = broadside(ellipsoid(glm::vec3(0.8F)));
    CHECK(ball.pose().yawDegrees == CameraPose{}.yawDegrees);
    CHECK(ball.pose().pitchDegrees == CameraPose{}.pitchDegrees);
    // With another axis up, that one is up.
    const Model model = ellipsoid({0.6F, 0.2F, 0.9F}, 0.0F, 0.4F);
    const Camera turned = broadside(model, kWide, UpAxis::X);
    CHECK(turned.upward().x > 0.0F);
    checkFills(seen(model.place, kWide, turned), kWide, 0.8F);
}

TEST_CASE("Of both ends of the least axis the front is seen, or the side that more points face") {
    const Model both = ellipsoid({0.6F, 0.2F, 0.9F});
    CHECK(broadside(both).direction().y < 0.0F);
    Model back = both;
    for (std::size_t p = 0; p < 100; ++p) {
        back.place.emplace_back(0.0F, 0.2F, 0.0F);
        back.normal.emplace_back(0.0F, 1.0F, 0.0F);
    }
    CHECK(broadside(back).direction().y > 0.0F);
    // A sheet is seen from its outer side, even from below; a closed body never.
    Model lying = ellipsoid({0.9F, 0.5F, 0.2F});
    CHECK(broadside(lying).direction().z > 0.0F);
    for (glm::vec3& normal : lying.normal) normal.z = -std::abs(normal.z);
    CHECK(broadside(lying).direction().z < 0.0F);
}

TEST_CASE("Strays change neither the side nor the size of a model") {
    const Model model = ellipsoid({0.5F, 0.1F, 0.3F}, 0.5F, 0.7F);
    Model strayed = model;
    for (const glm::vec3& stray :
         {glm::vec3(1, 1, 1), glm::vec3(-0.9F, 1.5F, 0), glm::vec3(0, -1.8F, 0.2F)}) {
        strayed.place.push_back(stray);
        strayed.normal.emplace_back(0.0F, 0.0F, 1.0F);
        strayed.drawable.push_back(true);
        strayed.sample.push_back(stray);
    }
    CHECK(withoutFar(strayed.sample).size() == model.sample.size());
    CHECK(withoutFar(model.sample).size() == model.sample.size());
    CHECK(broadside(strayed).pose() == broadside(model).pose());
    CHECK(withoutFar({}).empty());
}

TEST_CASE("A fault is seen straight on half of the view, a large one on as much as the model") {
    const auto model = sphereModel();
    REQUIRE(model);
    std::vector<Index> all(model->points.size());
    std::iota(all.begin(), all.end(), Index{0});
    std::vector<Index> cap;
    std::vector<glm::vec3> places;
    for (const Index p : all) {
        if (model->normal[p].x < 0.9F) continue;
        cap.push_back(p);
        places.push_back(model->place[p]);
    }
    REQUIRE(cap.size() > 5);
    for (const ViewPart& part : {kWide, kCovered}) {
        Camera camera;
        frameFault(*model, cap, part, camera);
        CHECK(camera.direction().x > 0.98F);
        checkFills(seen(places, part, camera), part, 0.5F);
        Camera whole;
        frameFault(*model, all, part, whole);
        CHECK(whole.pose().yawDegrees == CameraPose{}.yawDegrees);
        checkFills(seen(model->sample, part, whole), part, 0.8F);
    }
    Camera still;
    frameFault(*model, {}, kWide, still);
    CHECK(still == Camera{});
}

TEST_CASE("A selected point is framed with its neighbors, not from within") {
    const auto model = sphereModel();
    REQUIRE(model);
    const Index point = 7;
    std::vector<glm::vec3> places{model->place[point]};
    for (const Index q : model->points.neighbors[point]) places.push_back(model->place[q]);
    Camera camera;
    camera.faceStraight(-model->normal[point]);
    frameSelected(*model, std::vector<Index>{point}, kCovered, camera);
    CHECK(glm::dot(camera.direction(), model->normal[point]) > 0.99F);
    checkFills(seen(places, kCovered, camera), kCovered, 2.0F / 3.0F);
}

TEST_CASE("A place under the caption is not in the view, and is centered above it") {
    Camera camera;
    camera.set(ViewPreset::Front);
    const glm::vec3 low(0.0F, 0.0F, -0.7F);
    CHECK(isInView(low, kWide, camera));
    CHECK_FALSE(isInView(low, kCovered, camera));
    CHECK_FALSE(isInView({0.0F, -9.0F, 0.0F}, kWide, camera));
    const float distance = camera.distance();
    centerPlace(low, {0, -1, 0}, kCovered, camera);
    const glm::vec3 at = project(camera.matrices(kCovered.aspect), low, glm::vec2(1.0F));
    CHECK(at.x == doctest::Approx(0.5F));
    CHECK(at.y == doctest::Approx(0.375F));
    CHECK(camera.distance() == distance);
    CHECK(camera.direction().y == doctest::Approx(-1.0F));
}
