#include "framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numeric>
#include <optional>

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
/// steep axis is seen from above unless the surface is open; where as many face both ends, the
/// upper one is, or the front.
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

}  // namespace se::view
