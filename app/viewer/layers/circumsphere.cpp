#include <cmath>
#include <glm/geometric.hpp>

#include "layer.h"

namespace se::view {

void addCircumsphere(const LayerInput& in, DrawList& out) {
    if (!in.picture.sphere || in.picture.pivot == kNone) return;
    const SphereEvidence& test = *in.picture.sphere;
    if (test.verdict == Verdict::NoCircle || !std::isfinite(test.radius)) return;
    const glm::vec3 center = in.model.toView(test.center);
    const auto radius = static_cast<float>(test.radius * in.model.scale);
    const glm::vec3 p = in.at(in.picture.pivot);
    const glm::vec3 across = glm::cross(in.at(test.s) - p, in.at(test.t) - p);
    if (radius <= 0.0F || glm::length(across) < 1e-12F) return;

    // The circle through p, s and t is the equator of the sphere (Fig. 8).
    const glm::vec3 axis = glm::normalize(across);
    const glm::vec3 u = glm::normalize(p - center);
    const glm::vec3 v = glm::cross(axis, u);
    const Color& color = in.palette.test;
    out.spheres.push_back({center, radius, color.withAlpha(0.10F)});
    out.circle(center, u, v, radius, color, 0.13F, Depth::XRay, 96);
    out.circle(center, u, axis, radius, color.withAlpha(0.55F), 0.06F, Depth::XRay);
    out.circle(center, v, axis, radius, color.withAlpha(0.55F), 0.06F, Depth::XRay);

    out.sprites.push_back({center, {color, 0.36F, Shape::Disc}});
    out.line(center, p, color, 0.08F, Depth::OnTop);
    Line distance;
    distance.from = center;
    distance.to = in.at(test.q);
    const bool removed = test.verdict == Verdict::Removed;
    distance.color = removed ? in.palette.rejected : in.palette.used;
    distance.width = 0.1F;
    distance.dash = 0.3F;
    distance.depth = Depth::OnTop;
    out.lines.push_back(distance);
    out.labels.push_back({center, "c", color, false});
    out.labels.push_back({0.5F * (center + p), "r", color, false});
    out.labels.push_back({0.5F * (center + in.at(test.q)), "d", distance.color, false});
}

}  // namespace se::view
