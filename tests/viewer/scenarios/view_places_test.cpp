/// Positions of the legend, the arrow to the pivot and the names of the dial.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "document/actions.h"
#include "document/ui_state.h"
#include "headless_app.h"
#include "layout/overlays.h"
#include "paint/dial_painter.h"
#include "run/model.h"
#include "scene/framing.h"
#include "session/playback.h"

using namespace se;
using namespace se::view;
using se::view::test::OpenSession;

namespace {

constexpr glm::vec2 kSize(800.0F, 500.0F);
constexpr float kInset = 30.0F;
constexpr float kAspect = 1.6F;

/// From the front, at the origin.
Camera frontCamera() {
    Camera camera;
    camera.setPose({{0.0F, 0.0F, 0.0F}, 3.0F, -90.0F, 0.0F, false});
    return camera;
}

}  // namespace

TEST_CASE("No arrow points to a pivot within the view") {
    const CameraMatrices camera = frontCamera().matrices(kAspect);
    CHECK_FALSE(edgeArrow(camera, {0, 0, 0}, kSize, kInset));
    CHECK_FALSE(edgeArrow(camera, {0.5F, 0, 0.5F}, kSize, kInset));
}

TEST_CASE("The arrow is at the edge on the side of the pivot, and points there") {
    struct Case {
        glm::vec3 place;
        glm::vec2 way;
    };
    // x to the right, z up on the screen.
    for (const Case& each : {Case{{9, 0, 0}, {1, 0}}, Case{{-9, 0, 0}, {-1, 0}},
                             Case{{0, 0, 9}, {0, -1}}, Case{{0, 0, -9}, {0, 1}}}) {
        const auto arrow = edgeArrow(frontCamera().matrices(kAspect), each.place, kSize, kInset);
        REQUIRE(arrow);
        CHECK(arrow->way.x == doctest::Approx(each.way.x));
        CHECK(arrow->way.y == doctest::Approx(each.way.y));
        const glm::vec2 wanted = 0.5F * kSize + each.way * (0.5F * kSize - kInset);
        CHECK(arrow->at.x == doctest::Approx(wanted.x));
        CHECK(arrow->at.y == doctest::Approx(wanted.y));
    }
}

TEST_CASE("The arrow shows the way to a pivot behind the eye") {
    for (const bool orthographic : {false, true}) {
        Camera camera = frontCamera();
        if (orthographic) camera.toggleOrthographic();
        const auto right = edgeArrow(camera.matrices(kAspect), {9, -20, 0}, kSize, kInset);
        REQUIRE(right);
        CHECK(right->way.x > 0.9F);
    }
    // Directly behind it: any direction is right, but there is one.
    const auto behind = edgeArrow(frontCamera().matrices(kAspect), {0, -20, 0}, kSize, kInset);
    REQUIRE(behind);
    CHECK(glm::length(behind->way) == doctest::Approx(1.0F));
}

TEST_CASE("Every arrow lies on the rectangle at the inset, in any direction") {
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const float a = static_cast<float>(degrees) * 0.0174533F;
        const auto arrow = edgeArrow(frontCamera().matrices(kAspect),
                                     {9.0F * std::cos(a), 0.0F, 9.0F * std::sin(a)}, kSize, kInset);
        REQUIRE(arrow);
        const glm::vec2 off = glm::abs(arrow->at - 0.5F * kSize) - (0.5F * kSize - kInset);
        CHECK(std::max(off.x, off.y) == doctest::Approx(0.0F).epsilon(0.001));
    }
    CHECK_FALSE(edgeArrow(frontCamera().matrices(kAspect), {9, 0, 0}, {50, 50}, kInset));
}

TEST_CASE("A click on the arrow brings the pivot into the view, with any selection") {
    OpenSession open;
    open.session.moves().goToText("40.sort.1");
    open.session.waitUntilDone();
    test::AroundSession around(open.session);
    Camera& camera = around.camera;
    UiState& ui = around.ui;
    CommandContext& context = around.context;
    camera.lookAt({50.0F, 0.0F, 0.0F});
    const glm::vec3 pivot = open.session.model().place[open.session.picture().pivot];
    REQUIRE(edgeArrow(camera.matrices(kAspect), pivot, kSize, kInset));
    open.session.select(Index{0});
    frameRequested(context, FrameRequest::Decision);
    CHECK_FALSE(edgeArrow(camera.matrices(kAspect), pivot, kSize, kInset));
    CHECK(isInView(pivot, ui.viewPart(), camera));
}

TEST_CASE("The legend leaves the corner where it would hide the pivot") {
    const Rect view{{0, 0}, {600, 400}};
    const glm::vec2 size(120, 150);
    constexpr std::array kCorners = {Corner::TopRight, Corner::TopLeft, Corner::BottomRight};
    const auto at = [&](std::span<const LabelMark> marks, std::span<const Rect> taken) {
        return freeCorner({view, 10, taken, marks}, size, kCorners);
    };
    const Rect right = cornerRect(view, size, 10, Corner::TopRight);
    CHECK(right.max() == glm::vec2(590, 160));
    CHECK(at({}, {})->min == right.min);
    const std::array pivot = {LabelMark{{500, 60}, 20}};
    CHECK(at(pivot, {})->min == glm::vec2(10, 10));
    // Beside the arrow is near enough.
    const std::array beside = {LabelMark{{460, 60}, 20}};
    CHECK(at(beside, {})->min == glm::vec2(10, 10));
    const std::array axes = {Rect{{0, 0}, {100, 100}}};
    CHECK(at(pivot, axes)->min == glm::vec2(470, 240));
    const std::array all = {LabelMark{{500, 60}, 20}, LabelMark{{50, 60}, 20},
                            LabelMark{{500, 350}, 20}};
    CHECK_FALSE(at(all, {}));
    // It never leaves the view.
    CHECK_FALSE(freeCorner({{{0, 0}, {600, 160}}, 10, {}, {}}, size, kCorners));
}

TEST_CASE("Dial: names of points at nearly the same angle are side by side") {
    const Rect area{{0, 0}, {300, 240}};
    const DialCircle disc{{150, 120}, 70};
    const glm::vec2 extent(44, 14);
    for (const double at : {0.0, 45.0, 90.0, 180.0, 200.0, 270.0}) {
        CAPTURE(at);
        const std::array names = {DialName{at, extent}, DialName{at + 2.0, extent},
                                  DialName{at + 3.0, extent}, DialName{at + 3.5, extent}};
        const std::vector<PlacedName> placed = placeNames(disc, {area, {}, 5, 15}, names);
        REQUIRE(placed.size() == names.size());
        CHECK_FALSE(placed[0].leader);
        for (const PlacedName& a : placed) {
            // A corner may touch the rim.
            CHECK_FALSE(overlap(a.rect, LabelMark{disc.center, disc.radius - 2.0F}));
            CHECK(a.rect.min.x >= -0.5F);
            CHECK(a.rect.max().x <= 300.5F);
            for (const PlacedName& b : placed) CHECK((&a == &b || !overlap(a.rect, b.rect)));
            // Not at its usual position: then a tick leads there.
            const float angle = 0.0174533F * static_cast<float>(names[a.name].degrees);
            const glm::vec2 rim =
                disc.center + disc.radius * glm::vec2(std::cos(angle), -std::sin(angle));
            if (!a.leader) CHECK(glm::distance(nearestIn(a.rect, rim), rim) < 16.0F);
        }
    }
}

TEST_CASE("Dial: a name without room is left out, the last first") {
    const Rect area{{0, 0}, {300, 240}};
    const DialCircle disc{{150, 120}, 70};
    std::vector<DialName> names(40, DialName{0.0, {60, 14}});
    const std::vector<PlacedName> placed = placeNames(disc, {area, {}, 5, 15}, names);
    CHECK(placed.size() < names.size());
    CHECK(placed.size() >= 4);
    CHECK(placed[0].name == 0);
    for (std::size_t i = 1; i < placed.size(); ++i) CHECK(placed[i - 1].name < placed[i].name);
    const std::array taken = {Rect{{150, 0}, {150, 240}}};
    const std::array right = {DialName{0.0, {20, 14}}};
    CHECK(placeNames(disc, {area, taken, 5, 15}, right).empty());
}

TEST_CASE("Points of a decision: pivot, ends, candidates, and others that it names, once each") {
    OpenSession open("scene:coarse-torus");
    open.session.moves().goToText("42.reciprocal.1");
    open.session.waitUntilDone();
    const DecisionState& picture = open.session.picture();
    const std::vector<Index> points = neighborhoodOf(picture);
    const auto has = [&](Index point) {
        return std::count(points.begin(), points.end(), point) == 1;
    };
    REQUIRE_FALSE(points.empty());
    CHECK(points.front() == picture.pivot);
    for (const CandidateMark& mark : picture.candidates) {
        if (mark.state == CandidateState::Kept) CHECK(has(mark.point));
    }
    const auto* e = std::get_if<ReciprocalEvidence>(&picture.event->evidence);
    REQUIRE(e != nullptr);
    for (const Index point : {e->pred, e->succ, e->point, picture.start, picture.end}) {
        CHECK(has(point));
    }
    CHECK(neighborhoodOf(DecisionState{}).empty());
}

TEST_CASE("A decision and the sphere under test fill two thirds of the view") {
    for (const ViewPart& part : {ViewPart{2.3F, 0.0F}, {0.7F, 0.0F}, {1.5F, 0.2F}}) {
        for (const char* address : {"42.reciprocal.1", "15.twopoint.1", "137.sphere.3"}) {
            CAPTURE(part.aspect);
            CAPTURE(address);
            const bool sphere = std::string_view(address) == "137.sphere.3";
            const bool small = std::string_view(address) == "15.twopoint.1";
            OpenSession open(sphere ? "scene:torus" : "scene:coarse-torus");
            open.session.moves().goToText(address);
            open.session.waitUntilDone();
            const Model& model = open.session.model();
            Camera camera;
            lookAtDecision(model, open.session.picture(), {}, part, camera);
            std::vector<glm::vec3> places;
            for (const Index point : neighborhoodOf(open.session.picture()))
                places.push_back(model.place[point]);
            const auto* test = std::get_if<SphereEvidence>(&open.session.picture().event->evidence);
            CHECK((test != nullptr) == sphere);
            if (test != nullptr) {
                const auto radius = static_cast<float>(test->radius * model.scale);
                for (const glm::vec3& way : {camera.right(), camera.upward()}) {
                    places.push_back(model.toView(test->center) + radius * way);
                    places.push_back(model.toView(test->center) - radius * way);
                }
            }
            glm::vec2 low(1.0F);
            glm::vec2 high(0.0F);
            for (const glm::vec3& place : places) {
                const glm::vec2 at(project(camera.matrices(part.aspect), place, glm::vec2(1.0F)));
                low = glm::min(low, at);
                high = glm::max(high, at);
            }
            const float free = 1.0F - part.coveredBelow;
            const glm::vec2 size = (high - low) / glm::vec2(1.0F, free);
            // Of a few points the surroundings are seen as well.
            const float filled = std::max(size.x, size.y);
            CHECK((small ? filled < 0.66F : filled == doctest::Approx(2.0 / 3.0).epsilon(0.02)));
            CHECK(glm::distance(0.5F * (low + high), glm::vec2(0.5F, 0.5F * free)) < 0.02F);
        }
    }
}
