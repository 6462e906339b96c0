#include "scene/framing.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "drawn.h"
#include "run/model.h"
#include "scene/picking.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

/// Cosine of the angle between the normal of the pivot and the way to the eye.
float steepness(OpenSession& open, const Address& address) {
    open.session.moves().goTo(address);
    open.session.waitUntilDone();
    Camera camera;
    lookAtDecision(open.session.model(), open.session.picture(), {}, {1.4F, 0.0F}, camera);
    const glm::vec3 toEye = glm::normalize(camera.matrices(1.0F).eye - camera.target());
    return glm::dot(toEye, open.session.model().normal[open.session.picture().pivot]);
}

}  // namespace

TEST_CASE("Sort, limits and sphere are seen along the normal") {
    OpenSession open("scene:torus");
    for (const Address& address :
         {Address{137, Stage::Sort, 3}, {137, Stage::Limits, 1}, {137, Stage::Sphere, 2}}) {
        CAPTURE(toString(address));
        CHECK(steepness(open, address) > 0.95F);
        CHECK(viewWayOf(open.session.model(), open.session.picture()) == ViewWay::AlongNormal);
    }
}

TEST_CASE("A hole and a convexity test are seen along the surface") {
    OpenSession hole("scene:long-lists");
    const Address tested = firstWhere<HoleEvidence>(hole, [](const HoleEvidence&) { return true; });
    CHECK(std::abs(steepness(hole, tested)) < 0.3F);
    OpenSession convex("scene:small-torus");
    Timeline timeline(convex.session.model().points, convex.session.model().params);
    bool found = false;
    for (std::uint32_t pivot = 1; pivot < 60 && !found; ++pivot) {
        for (const Event& event : timeline.record(pivot)->events) {
            if (event.address.stage != Stage::Convex) continue;
            found = true;
            CHECK(std::abs(steepness(convex, event.address)) < 0.3F);
            break;
        }
    }
    CHECK(found);
}

TEST_CASE("Along the surface, the side is chosen where no triangle hides the decision") {
    OpenSession open("scene:small-torus");
    open.session.moves().goToText("54.convex.1");
    open.session.waitUntilDone();
    const Model& model = open.session.model();
    const DecisionState& picture = open.session.picture();
    const std::span<const Triangle> shown = open.session.shownTriangles();
    const DecisionPlace place = decisionPlace(model, picture.pivot, neighborhoodOf(picture));
    for (const float yaw : {0.0F, 90.0F, 180.0F, 270.0F}) {
        CAPTURE(yaw);
        Camera camera;
        CameraPose pose = camera.pose();
        pose.yawDegrees = yaw;
        camera.setPose(pose);
        lookAtDecision(model, picture, shown, {1.4F, 0.0F}, camera);
        CHECK_FALSE(isHidden(model, shown, camera.matrices(1.0F), place));
    }
}

TEST_CASE("Close sheets are recognized, a bend and a crease are none") {
    OpenSession close("scene:close-sheets");
    std::size_t found = 0;
    const Model& model = close.session.model();
    for (Index p = 0; p < model.points.size(); ++p) found += hasCloseSheets(model, p) ? 1 : 0;
    CHECK(found > model.points.size() / 3);
    for (const char* scene : {"scene:sphere", "scene:torus", "scene:sharp-crease"}) {
        CAPTURE(scene);
        OpenSession open(scene);
        const Model& smooth = open.session.model();
        std::size_t wrong = 0;
        for (Index p = 0; p < smooth.points.size(); ++p) wrong += hasCloseSheets(smooth, p) ? 1 : 0;
        CHECK(wrong == 0);
    }
}
