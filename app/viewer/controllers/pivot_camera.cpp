#include "pivot_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "run/neighborhood.h"

namespace se::view {

namespace {

/// Target size of points, in em, if there is room: names fit beside them, and the surroundings
/// are visible.
constexpr glm::vec2 kPoints(18.0F, 11.0F);
/// Limits of the share of the view that the points occupy.
constexpr float kLeastShare = 0.45F;
constexpr float kMaxShare = 0.68F;

/// Obliquely, from the outer side.
void lookDown(const glm::vec3& normal, Camera& camera) {
    CameraPose pose = camera.pose();
    const glm::vec3 to = camera.inFrame(normal);
    const float pitch = glm::degrees(std::atan2(to.z, std::hypot(to.x, to.y)));
    if (std::abs(pitch) < 80.0F) pose.yawDegrees = glm::degrees(std::atan2(to.y, to.x));
    pose.yawDegrees += 14.0F;
    pose.pitchDegrees = pitch > 10.0F ? pitch - 34.0F : pitch + 30.0F;
    camera.setPose(pose);
}

}  // namespace

void framePivotNeighborhood(const Session& session, Camera& camera, glm::vec2 size) {
    if (!session.ready() || session.picture().pivot == kNone) return;
    const Model& model = session.shown();
    const Index pivot = session.picture().pivot;
    camera.face(model.normal[pivot]);
    lookDown(model.normal[pivot], camera);
    std::vector<glm::vec3> places;
    for (const Index point : neighborhoodOf(session.picture())) {
        places.push_back(model.place[point]);
    }
    // Also if the point is alone: the disc and the normal.
    for (const glm::vec3& way : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
        places.push_back(model.place[pivot] + (0.6F * model.spacing) * way);
        places.push_back(model.place[pivot] - (0.6F * model.spacing) * way);
    }
    const glm::vec2 share = kPoints / glm::max(size, glm::vec2(1.0F));
    camera.enclose(places, size.x / std::max(1.0F, size.y),
                   glm::clamp(share, glm::vec2(kLeastShare), glm::vec2(kMaxShare)));
}

}  // namespace se::view
