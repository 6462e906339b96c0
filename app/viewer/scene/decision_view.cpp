#include "decision_view.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "hiding.h"
#include "run/neighborhood.h"

namespace se::view {

namespace {

/// Target size of points, in em, if there is room: names fit beside them, and the surroundings
/// are visible.
constexpr glm::vec2 kPoints(18.0F, 11.0F);
/// Limits of the share of the view that the points occupy.
constexpr float kLeastShare = 0.45F;
constexpr float kMaxShare = 0.68F;
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

void lookAlongNormal(const glm::vec3& normal, Camera& camera) {
    camera.faceStraight(normal);
    CameraPose pose = camera.pose();
    pose.pitchDegrees += pose.pitchDegrees > 0.0F ? -kTiltDegrees : kTiltDegrees;
    camera.setPose(pose);
}

/// Centers the points, and comes close. The direction stays.
void encloseDecision(const Model& model, std::span<const Index> points, Index pivot, Camera& camera,
                     glm::vec2 size) {
    std::vector<glm::vec3> places;
    places.reserve(points.size() + 6);
    for (const Index point : points) places.push_back(model.place[point]);
    // Also if the point is alone: the disc and the normal.
    for (const glm::vec3& way : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
        places.push_back(model.place[pivot] + (0.6F * model.spacing) * way);
        places.push_back(model.place[pivot] - (0.6F * model.spacing) * way);
    }
    const glm::vec2 share = kPoints / glm::max(size, glm::vec2(1.0F));
    camera.enclose(places, size.x / std::max(1.0F, size.y),
                   glm::clamp(share, glm::vec2(kLeastShare), glm::vec2(kMaxShare)));
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
                    std::span<const Triangle> finished, Camera& camera, glm::vec2 size) {
    if (picture.pivot == kNone) return;
    const Index pivot = picture.pivot;
    const glm::vec3& normal = model.normal[pivot];
    const std::vector<Index> points = neighborhoodOf(picture);
    const glm::vec3 way = viewWayOf(model, picture) == ViewWay::AlongSurface
                              ? wayAlongSurface(model, picture)
                              : glm::vec3(0.0F);
    if (way == glm::vec3(0.0F)) {
        lookAlongNormal(normal, camera);
        return encloseDecision(model, points, pivot, camera, size);
    }
    const float raised = glm::radians(kRaisedDegrees);
    const auto from = [&](float side) {
        Camera aim = camera;
        aim.faceStraight(std::cos(raised) * side * way + std::sin(raised) * normal);
        encloseDecision(model, points, pivot, aim, size);
        return aim;
    };
    const glm::vec3 toEye = camera.matrices(1.0F).eye - camera.target();
    const float nearer = glm::dot(way, toEye) < 0.0F ? -1.0F : 1.0F;
    const DecisionPlace place = decisionPlace(model, pivot, points);
    const Camera near = from(nearer);
    const Camera far = from(-nearer);
    const bool changes = isHidden(model, finished, near.matrices(1.0F), place) &&
                         !isHidden(model, finished, far.matrices(1.0F), place);
    camera.setPose((changes ? far : near).pose());
}

}  // namespace se::view
