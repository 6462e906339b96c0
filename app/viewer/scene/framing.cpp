#include "framing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>

#include "picking.h"
#include "spiraling_edge/prepare/normals.h"

namespace se::view {

namespace {

/// Share of the points that may be far outside at each end of an axis; and how far outside, as a
/// share of the extent of the others.
constexpr double kFarShare = 0.01;
constexpr float kFarOutside = 0.5F;
/// Limits of the pitch of a model's view: from a little above, its height and depth are told apart;
/// from straight above, up is not seen.
constexpr float kLowestDegrees = 10.0F;
constexpr float kHighestDegrees = 60.0F;
/// An axis that rises more than this is steep.
constexpr float kLevelDegrees = 30.0F;
/// More than the extent of any model, in view units.
constexpr float kTornApart = 4.0F;
/// Both ends of an axis differ if the numbers of points that face them do, by more than this share
/// of all; and those of an open surface.
constexpr double kTie = 0.01;
constexpr double kOpen = 0.5;
/// A least axis whose variance is not below this share of the next one says nothing.
constexpr double kDistinct = 0.85;
/// Points of one side have a common normal if the mean of theirs is longer.
constexpr float kAgreement = 0.5F;
/// Least radii of what is framed, in spacings: of a fault, and of a selection.
constexpr float kLeastFault = 2.0F;
constexpr float kLeastSelected = 2.0F;

/// The common normal of points; zero if they face all ways.
glm::vec3 normalOf(const Model& model, std::span<const Index> points) {
    glm::vec3 sum(0.0F);
    for (const Index p : points) sum += model.normal[p];
    const float agreement = glm::length(sum) / static_cast<float>(points.size());
    return agreement > kAgreement ? glm::normalize(sum) : glm::vec3(0.0F);
}

std::vector<glm::vec3> placesOf(const Model& model, std::span<const Index> points) {
    std::vector<glm::vec3> places;
    places.reserve(points.size());
    for (const Index p : points) {
        if (model.drawable[p]) places.push_back(model.place[p]);
    }
    return places;
}

/// The axis of least variance, on either side, and whether it is distinct from the next one.
std::optional<glm::vec3> leastAxis(std::span<const glm::vec3> places) {
    const std::vector<Vec3> exact(places.begin(), places.end());
    std::vector<Index> rest(exact.empty() ? 0 : exact.size() - 1);
    std::iota(rest.begin(), rest.end(), Index{1});
    const PlaneFit fit = se::planeAt(exact, 0, rest);
    if (!(fit.variance[0] < kDistinct * fit.variance[1])) return std::nullopt;
    return glm::vec3(fit.normal);
}

/// The end of an axis to look from, in the frame of the camera: the one that more points face,
/// which is the outer side of an open surface, and the side with more relief of a closed one. A
/// steep axis is seen from above unless the surface is open. Where about as many points face either
/// end, it is the upper end, or the one in front.
glm::vec3 endToSee(const Model& model, const glm::vec3& axis, const Camera& camera) {
    std::ptrdiff_t more = 0;
    for (const glm::vec3& normal : model.normal) {
        const float along = glm::dot(normal, axis);
        more += along > 0.0F ? 1 : along < 0.0F ? -1 : 0;
    }
    const glm::vec3 way = camera.inFrame(axis);
    const bool steep = std::abs(way.z) > std::sin(glm::radians(kLevelDegrees));
    const double share = static_cast<double>(more) / static_cast<double>(model.normal.size());
    const bool rises = std::abs(way.z) > std::sin(glm::radians(kLowestDegrees));
    const bool usual = rises ? way.z > 0.0F : way.y <= 0.0F;
    const bool stays = std::abs(share) > (steep ? kOpen : kTie) ? share > 0.0 : usual;
    return stays ? way : -way;
}

}  // namespace

std::vector<glm::vec3> withoutFar(std::span<const glm::vec3> places) {
    if (places.empty()) return {};
    std::vector<glm::vec3> kept(places.begin(), places.end());
    const auto end = static_cast<std::size_t>(kFarShare * static_cast<double>(places.size()));
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> along;
        for (const glm::vec3& p : places) along.push_back(p[axis]);
        std::sort(along.begin(), along.end());
        const float low = along[end];
        const float high = along[along.size() - 1 - end];
        const float margin = kFarOutside * (high - low);
        std::erase_if(kept, [&](const glm::vec3& p) {
            return p[axis] < low - margin || p[axis] > high + margin;
        });
    }
    return kept;
}

void framePlaces(std::vector<glm::vec3> places, float least, const ViewPart& part, float share,
                 Camera& camera) {
    if (places.empty()) return;
    glm::vec3 low = places.front();
    glm::vec3 high = low;
    for (const glm::vec3& p : places) low = glm::min(low, p), high = glm::max(high, p);
    const glm::vec3 middle = 0.5F * (low + high);
    const bool small = std::all_of(places.begin(), places.end(), [&](const glm::vec3& p) {
        return glm::distance(p, middle) < least;
    });
    if (small) {
        for (const glm::vec3& way : {camera.right(), camera.upward(), camera.direction()})
            places.insert(places.end(), {middle + least * way, middle - least * way});
    }
    camera.fill(places, part, share);
}

void frameModel(const Model& model, const ViewPart& part, Camera& camera) {
    camera.fill(withoutFar(model.sample), part, kModelShare);
}

void showBroadside(const Model& model, const ViewPart& part, Camera& camera) {
    CameraPose pose = camera.pose();
    pose.yawDegrees = CameraPose{}.yawDegrees;
    pose.pitchDegrees = CameraPose{}.pitchDegrees;
    std::vector<glm::vec3> places = withoutFar(model.sample);
    std::optional<glm::vec3> axis = leastAxis(places);
    if (axis) {
        glm::vec3 way = endToSee(model, *axis, camera);
        const float degrees = glm::degrees(std::asin(std::clamp(way.z, -1.0F, 1.0F)));
        const float least = degrees < -kLevelDegrees ? -kHighestDegrees : kLowestDegrees;
        pose.pitchDegrees = std::clamp(degrees, least, kHighestDegrees);
        if (std::abs(degrees) > kHighestDegrees) {
            // It lies flat. Torn apart by height, its least axis is a horizontal one.
            const auto up = static_cast<int>(camera.up());
            for (std::size_t i = 0; i < places.size(); ++i)
                places[i][up] = i % 2 == 0 ? kTornApart : -kTornApart;
            axis = leastAxis(places);
            if (axis) way = endToSee(model, *axis, camera);
        }
        if (axis) pose.yawDegrees = glm::degrees(std::atan2(way.y, way.x));
    }
    camera.setPose(pose);
    frameModel(model, part, camera);
}

void frameFault(const Model& model, std::span<const Index> points, const ViewPart& part,
                Camera& camera) {
    const std::vector<glm::vec3> places = placesOf(model, points);
    if (places.empty()) return;
    const glm::vec3 normal = normalOf(model, points);
    if (normal != glm::vec3(0.0F)) camera.faceStraight(normal);
    Camera whole = camera;
    frameModel(model, part, whole);
    framePlaces(places, kLeastFault * model.spacing, part, kFaultShare, camera);
    if (camera.distance() > whole.distance()) camera.setPose(whole.pose());
}

void frameSelected(const Model& model, std::span<const Index> points, const ViewPart& part,
                   Camera& camera) {
    std::vector<Index> all(points.begin(), points.end());
    for (const Index p : points) {
        const auto list = model.points.neighbors[p];
        all.insert(all.end(), list.begin(), list.end());
    }
    glm::vec3 normal(0.0F);
    for (const Index p : points) normal += model.normal[p];
    if (glm::length(normal) > 0.0F) camera.face(glm::normalize(normal));
    framePlaces(placesOf(model, all), kLeastSelected * model.spacing, part, kDecisionShare, camera);
}

bool isInView(const glm::vec3& place, const ViewPart& part, const Camera& camera) {
    const glm::vec3 at = project(camera.matrices(part.aspect), place, glm::vec2(1.0F));
    return at.z > 0.0F && at.x > 0.0F && at.x < 1.0F && at.y > 0.0F &&
           at.y < 1.0F - part.coveredBelow;
}

void centerPlace(const glm::vec3& place, const glm::vec3& normal, const ViewPart& part,
                 Camera& camera) {
    camera.face(normal);
    camera.lookAt(place);
    camera.pan({0.0F, -0.5F * part.coveredBelow}, 1.0F);
}

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
