#include "decision_view.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "framing.h"
#include "hiding.h"
#include "run/neighborhood.h"

namespace se::view {

namespace {

/// Along the normal: a small tilt, so that heights are no mere dots. Along the surface: from above,
/// so that the disc is not a mere line. In degrees.
constexpr float kTiltDegrees = 12.0F;
constexpr float kRaisedDegrees = 10.0F;
/// A neighbor is on another sheet if its height is more than this share of its distance in the
/// plane, and its normal nearly parallel, which no bend explains: on a sphere, a height of half the
/// distance means a turn by 53 degrees, whose cosine is 0.6.
constexpr float kSteep = 0.5F;
constexpr float kParallel = 0.8F;

glm::vec3 flattened(const glm::vec3& offset, const glm::vec3& normal) {
    return offset - normal * glm::dot(offset, normal);
}

/// The point whose height decides: the tested one, or the highest neighbor.
Index pointBeside(const Model& model, const DecisionState& picture) {
    const Index p = picture.pivot;
    if (picture.underTest != kNone && picture.underTest != p) return picture.underTest;
    Index found = picture.first;
    float highest = 0.0F;
    for (const Index q : model.points.neighbors[p]) {
        const float height = std::abs(glm::dot(model.place[q] - model.place[p], model.normal[p]));
        if (height > highest) highest = height, found = q;
    }
    return found;
}

/// From the pivot to the eye, in the tangent plane: along the plane of a hole, otherwise
/// perpendicular to the way to the deciding point.
glm::vec3 wayAlongSurface(const Model& model, const DecisionState& picture) {
    const glm::vec3& normal = model.normal[picture.pivot];
    const bool hole = picture.event && picture.event->address.stage == Stage::Hole &&
                      picture.start != kNone && picture.end != kNone;
    const Index beside = pointBeside(model, picture);
    const glm::vec3 way =
        hole              ? flattened(model.place[picture.end] - model.place[picture.start], normal)
        : beside != kNone ? glm::cross(normal, model.place[beside] - model.place[picture.pivot])
                          : glm::vec3(0.0F);
    return glm::length(way) > 1e-9F ? glm::normalize(way) : glm::vec3(0.0F);
}

/// Least radius of a decision, in spacings: of two points beside each other also the surroundings
/// are seen.
constexpr float kLeastDecision = 1.2F;
/// A sphere is all in the view up to this share of the extent of the points; larger ones are almost
/// planes.
constexpr float kMaxSphere = 1.0F;

void lookAlongNormal(const glm::vec3& normal, Camera& camera) {
    camera.faceStraight(normal);
    CameraPose pose = camera.pose();
    pose.pitchDegrees += pose.pitchDegrees > 0.0F ? -kTiltDegrees : kTiltDegrees;
    camera.setPose(pose);
}

/// Frames the points of the decision, and the sphere under test. The direction stays.
void frameNeighborhood(const Model& model, const DecisionState& picture, const ViewPart& part,
                       Camera& camera) {
    std::vector<glm::vec3> places;
    float reach = 0.0F;
    for (const Index point : neighborhoodOf(picture)) {
        places.push_back(model.place[point]);
        reach = std::max(reach, glm::distance(places.front(), places.back()));
    }
    const auto* test =
        picture.event ? std::get_if<SphereEvidence>(&picture.event->evidence) : nullptr;
    const float radius = test != nullptr ? static_cast<float>(test->radius * model.scale) : 0.0F;
    if (radius > 0.0F && radius <= kMaxSphere * reach) {
        const glm::vec3 center = model.toView(test->center);
        for (const glm::vec3& way : {camera.right(), camera.upward(), camera.direction()})
            places.insert(places.end(), {center + radius * way, center - radius * way});
    }
    framePlaces(places, kLeastDecision * model.spacing, part, kDecisionShare, camera);
}

}  // namespace

bool hasCloseSheets(const Model& model, Index pivot) {
    const glm::vec3& normal = model.normal[pivot];
    const auto& listed = model.points.neighbors[pivot];
    return std::any_of(listed.begin(), listed.end(), [&](Index q) {
        const glm::vec3 offset = model.place[q] - model.place[pivot];
        const float height = std::abs(glm::dot(offset, normal));
        return height > kSteep * glm::length(flattened(offset, normal)) &&
               std::abs(glm::dot(model.normal[q], normal)) > kParallel;
    });
}

ViewWay viewWayOf(const Model& model, const DecisionState& picture) {
    if (picture.pivot == kNone) return ViewWay::AlongNormal;
    const bool heights = picture.event && (picture.event->address.stage == Stage::Hole ||
                                           picture.event->address.stage == Stage::Convex);
    return heights || hasCloseSheets(model, picture.pivot) ? ViewWay::AlongSurface
                                                           : ViewWay::AlongNormal;
}

void lookAtDecision(const Model& model, const DecisionState& picture,
                    std::span<const Triangle> finished, const ViewPart& part, Camera& camera,
                    const std::optional<glm::vec3>& from) {
    const Index center = picture.pivot != kNone ? picture.pivot : picture.underTest;
    if (center == kNone) return;
    const glm::vec3& normal = model.normal[center];
    const glm::vec3 way = !from && viewWayOf(model, picture) == ViewWay::AlongSurface
                              ? wayAlongSurface(model, picture)
                              : glm::vec3(0.0F);
    if (way == glm::vec3(0.0F)) {
        from ? camera.faceStraight(*from) : lookAlongNormal(normal, camera);
        return frameNeighborhood(model, picture, part, camera);
    }
    const float raised = glm::radians(kRaisedDegrees);
    const auto aimFrom = [&](float side) {
        Camera aim = camera;
        aim.faceStraight(std::cos(raised) * side * way + std::sin(raised) * normal);
        frameNeighborhood(model, picture, part, aim);
        return aim;
    };
    const float nearer = glm::dot(way, camera.direction()) < 0.0F ? -1.0F : 1.0F;
    const DecisionPlace place = decisionPlace(model, center, neighborhoodOf(picture));
    const Camera near = aimFrom(nearer);
    const Camera far = aimFrom(-nearer);
    const bool changes = isHidden(model, finished, near.matrices(1.0F), place) &&
                         !isHidden(model, finished, far.matrices(1.0F), place);
    camera.setPose((changes ? far : near).pose());
}

}  // namespace se::view
