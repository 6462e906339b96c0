#include "scene/picking.h"

#include <doctest/doctest.h>

#include "open_session.h"
#include "run/model.h"
#include "scene/framing.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

struct SeenDecision {
    OpenSession open{"scene:sphere"};
    DecisionPlace place;
    Camera camera;

    SeenDecision() {
        open.session.moves().goToText("60.sphere.1");
        open.session.waitUntilDone();
        const DecisionState& picture = open.session.picture();
        place = decisionPlace(open.session.model(), picture.pivot, neighborhoodOf(picture));
        lookAtDecision(open.session.model(), picture, {}, {1.4F, 0.0F}, camera);
    }
    bool hidden() const {
        const std::size_t finished = open.session.picture().finishedTriangles;
        return isHidden(open.session.model(), std::span(open.session.triangles()).first(finished),
                        camera.matrices(1.3F), place);
    }
};

}  // namespace

TEST_CASE("Nothing hides a decision that is seen along the normal") {
    CHECK_FALSE(SeenDecision().hidden());
}

TEST_CASE("From behind, the other side of the surface hides a decision") {
    SeenDecision decision;
    // A triangle between the eye and the pivot, far from its neighbors.
    const Model& model = decision.open.session.model();
    CameraPose pose = decision.camera.pose();
    pose.target = glm::vec3(0.0F);
    pose.yawDegrees += 180.0F;
    pose.pitchDegrees = -pose.pitchDegrees;
    pose.distance = 5.0F;
    decision.camera.setPose(pose);
    decision.open.session.moves().toEnd();
    decision.open.session.waitUntilDone();
    for (const bool orthographic : {false, true}) {
        CAPTURE(orthographic);
        pose.orthographic = orthographic;
        decision.camera.setPose(pose);
        CHECK(isHidden(model, decision.open.session.triangles(), decision.camera.matrices(1.3F),
                       decision.place));
        CHECK_FALSE(isHidden(model, {}, decision.camera.matrices(1.3F), decision.place));
    }
}

TEST_CASE("The radius on the screen is that of the place, in both projections") {
    SeenDecision decision;
    for (const bool orthographic : {false, true}) {
        CAPTURE(orthographic);
        CameraPose pose = decision.camera.pose();
        pose.target = decision.place.center;
        pose.orthographic = orthographic;
        decision.camera.setPose(pose);
        const float share = 2.0F * decision.place.radius / decision.camera.heightAtTarget();
        CHECK(pixelRadius(decision.camera.matrices(1.3F), decision.place, 600.0F) ==
              doctest::Approx(0.5 * 600.0 * share).epsilon(1e-3));
    }
}

TEST_CASE("The place of a decision holds all its points") {
    const SeenDecision decision;
    for (const glm::vec3& point : decision.place.points)
        CHECK(glm::distance(point, decision.place.center) < decision.place.radius);
    CHECK(decision.place.radius >= decision.open.session.model().spacing);
}
