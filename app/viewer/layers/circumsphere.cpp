// The circumsphere test of a candidate q (6.3): circle, radius and distance, and the angle that
// would remain without q.

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <string>

#include "disc.h"
#include "run/strings.h"

namespace se::view {

// A clear ball in space has no readable place; the curves in which it cuts what is around it do.
// The plane of a triangle cuts the sphere in a circle; its arcs inside the triangle are drawn.

namespace {

constexpr float kFullTurn = 2.0F * std::numbers::pi_v<float>;
/// Segments of a whole circle.
constexpr int kCutParts = 72;

/// The circle in which a plane cuts a sphere.
struct CutCircle {
    glm::vec3 center{0.0F};
    glm::vec3 u{0.0F};
    glm::vec3 v{0.0F};
    float radius = 0.0F;

    glm::vec3 at(float angle) const {
        return center + radius * (std::cos(angle) * u + std::sin(angle) * v);
    }
    float angleOf(const glm::vec3& place) const {
        const float a = std::atan2(glm::dot(place - center, v), glm::dot(place - center, u));
        return a < 0.0F ? a + kFullTurn : a;
    }
};

std::optional<CutCircle> cutByPlane(const Sphere& sphere, const glm::vec3& place,
                                    const glm::vec3& normal) {
    const float height = glm::dot(sphere.center - place, normal);
    const float square = sphere.radius * sphere.radius - height * height;
    if (!(square > 0.0F)) return std::nullopt;
    const glm::vec3 n = glm::abs(normal);
    const glm::vec3 other = n.x < 0.6F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 u = glm::normalize(glm::cross(normal, other));
    return CutCircle{sphere.center - height * normal, u, glm::cross(normal, u), std::sqrt(square)};
}

/// Angles at which the circle crosses a line between two places of its plane.
void addCrossings(const CutCircle& circle, const glm::vec3& from, const glm::vec3& to,
                  std::vector<float>& angles) {
    const glm::vec3 way = to - from;
    const glm::vec3 start = from - circle.center;
    const float a = glm::dot(way, way);
    const float b = glm::dot(start, way);
    const float c = glm::dot(start, start) - circle.radius * circle.radius;
    const float root = b * b - a * c;
    if (!(a > 0.0F) || !(root > 0.0F)) return;
    for (const float sign : {-1.0F, 1.0F}) {
        const float share = (-b + sign * std::sqrt(root)) / a;
        if (share >= 0.0F && share <= 1.0F) angles.push_back(circle.angleOf(from + share * way));
    }
}

bool isInside(const std::array<glm::vec3, 3>& corners, const glm::vec3& normal,
              const glm::vec3& place) {
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3& a = corners[i];
        const glm::vec3& b = corners[(i + 1) % 3];
        if (glm::dot(glm::cross(b - a, place - a), normal) < 0.0F) return false;
    }
    return true;
}

/// The part of the circle between two angles, as segments.
template <typename Add>
void addCutArc(const CutCircle& circle, float from, float to, Add&& add) {
    const int parts =
        std::max(1, static_cast<int>(std::ceil((to - from) / kFullTurn * float{kCutParts})));
    for (int i = 0; i < parts; ++i) {
        const float step = (to - from) / static_cast<float>(parts);
        add(circle.at(from + step * static_cast<float>(i)),
            circle.at(from + step * static_cast<float>(i + 1)));
    }
}

bool reaches(const Sphere& sphere, const std::array<glm::vec3, 3>& corners) {
    const float size =
        std::max(glm::distance(corners[0], corners[1]), glm::distance(corners[0], corners[2]));
    const float distance = glm::distance(corners[0], sphere.center);
    return std::abs(distance - sphere.radius) <= size;
}

void addMeshCut(const LayerInput& in, const Sphere& sphere, DrawList& out) {
    const std::size_t count = std::min(in.picture.finishedTriangles, in.triangles.size());
    for (const Triangle& t : in.triangles.first(count)) {
        for (const auto& [from, to] : sphereCut(sphere, in.cornersOf(t)))
            out.line(from, to, in.palette.test, 0.09F, Depth::XRay);
    }
}

/// The part of the disc's plane inside the sphere, as far as the disc reaches.
void addDiscCut(const LayerInput& in, const Sphere& sphere, const Disc& disc, DrawList& out) {
    const std::optional<CutCircle> circle = cutByPlane(sphere, disc.origin, disc.normal);
    if (!circle) return;
    const float reach = discRadius(in);
    addCutArc(*circle, 0.0F, kFullTurn, [&](const glm::vec3& from, const glm::vec3& to) {
        const bool within = glm::distance(0.5F * (from + to), disc.origin) <= reach;
        if (within) out.line(from, to, in.palette.test.withAlpha(0.8F), 0.1F, Depth::OnTop);
    });
}

/// The shadow of a place on the disc, with its drop line.
void addShadow(const LayerInput& in, const Disc& disc, const glm::vec3& place, DrawList& out) {
    const glm::vec3 foot = disc.foot(place);
    const Color& color = in.palette.textDim;
    out.dashed(place, foot, color, 0.07F, 0.18F);
    // Below the marks of points.
    out.sprites.insert(out.sprites.begin(), {foot, {color, 0.5F, Shape::Disc}});
}

}  // namespace

std::vector<std::pair<glm::vec3, glm::vec3>> sphereCut(const Sphere& sphere,
                                                       const std::array<glm::vec3, 3>& corners) {
    std::vector<std::pair<glm::vec3, glm::vec3>> segments;
    const glm::vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (!reaches(sphere, corners) || !(glm::length(across) > 0.0F)) return segments;
    const glm::vec3 normal = glm::normalize(across);
    const std::optional<CutCircle> circle = cutByPlane(sphere, corners[0], normal);
    if (!circle) return segments;
    std::vector<float> angles;
    for (std::size_t i = 0; i < 3; ++i)
        addCrossings(*circle, corners[i], corners[(i + 1) % 3], angles);
    std::sort(angles.begin(), angles.end());
    // Without a crossing the circle is inside or outside as a whole.
    if (angles.empty()) angles.push_back(0.0F);
    angles.push_back(angles.front() + kFullTurn);
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        if (!isInside(corners, normal, circle->at(0.5F * (angles[i] + angles[i + 1])))) continue;
        addCutArc(
            *circle, angles[i], angles[i + 1],
            [&](const glm::vec3& from, const glm::vec3& to) { segments.emplace_back(from, to); });
    }
    return segments;
}

namespace {

/// Draws the curves, and the feet of q and of the center on the disc.
void addSphereContact(const LayerInput& in, const Sphere& sphere, const glm::vec3& tested,
                      DrawList& out) {
    addMeshCut(in, sphere, out);
    const std::optional<Disc> disc = pivotDisc(in);
    if (!disc) return;
    addDiscCut(in, sphere, *disc, out);
    addShadow(in, *disc, tested, out);
    addShadow(in, *disc, sphere.center, out);
}

/// The angle that would remain without q, against its limit, usually 120 degrees; and the edge
/// from t to s that would close the rim.
void addGap(const LayerInput& in, const SphereEvidence& test, DrawList& out) {
    const std::optional<Disc> disc = pivotDisc(in);
    if (!disc) return;
    const Palette& c = in.palette;
    const double from = degreesOn(*disc, in.at(test.t));
    const double to = from + test.gapDegrees;
    const double limit = gapLimitDegrees(in.model.params);
    const float radius = discRadius(in);
    const bool wide = test.verdict == Verdict::GapTooWide;
    const Color& color = wide ? c.rejected : c.used;
    addArc(*disc, {from, to, radius}, color, wide ? 0.34F : 0.2F, out);
    out.line(disc->at(from + limit, 0.88F * radius), disc->at(from + limit, 1.12F * radius), c.text,
             0.12F, Depth::OnTop);
    out.label(
        disc->at(0.5 * (from + to), radius),
        degreesText(test.gapDegrees) + (wide ? " > " + numberText(limit) + "\xC2\xB0: kept" : ""),
        color, wide);
    if (isTaken(test.verdict)) {
        out.dashed(in.at(test.t), in.at(test.s), c.used.withAlpha(0.7F), 0.1F);
    } else {
        out.line(in.at(test.t), in.at(test.s), c.used, 0.26F, Depth::OnTop);
    }
}

/// Names of the sphere's measures.
struct MeasureNames {
    std::string center = "c";
    std::string radius = "r";
    std::string distance = "d";
};

/// Letters, or words where a point has one of the letters as its name.
MeasureNames measureNames(const LayerInput& in) {
    const MeasureNames letters;
    const bool taken = std::any_of(in.names.begin(), in.names.end(), [&](const PointName& each) {
        return each.name == letters.center || each.name == letters.radius ||
               each.name == letters.distance;
    });
    return taken ? MeasureNames{"center", "radius", "distance"} : letters;
}

/// The line d from the center to q, with a mark where it leaves the sphere: q lies before or after
/// it in every view.
void addMeasure(const LayerInput& in, const SphereEvidence& test, const glm::vec3& center,
                float radius, DrawList& out) {
    const glm::vec3& q = in.at(test.q);
    const Color& verdict = verdictColor(test.verdict, in.palette);
    out.dashed(center, q, verdict, 0.1F);
    if (!(glm::distance(center, q) > 0.0F)) return;
    const glm::vec3 surface = center + radius * glm::normalize(q - center);
    out.line(surface, q, verdict, 0.3F, Depth::OnTop);
    out.mark(surface, Shape::Diamond, in.palette.test, 0.55F);
}

}  // namespace

void addCircumsphere(const LayerInput& in, DrawList& out) {
    const auto* latest = in.picture.evidence<SphereEvidence>(Stage::Sphere);
    if (latest == nullptr || in.picture.pivot == kNone) return;
    const SphereEvidence& test = *latest;
    addGap(in, test, out);
    if (isWhatIf(test.verdict)) addVerdict(test.verdict, in.at(test.q), in.palette, out);
    if (!hasSphere(test)) return;
    const glm::vec3 center = in.model.toView(test.center);
    const auto radius = static_cast<float>(test.radius * in.model.scale);
    const glm::vec3 p = in.at(in.picture.pivot);
    const glm::vec3 across = glm::cross(in.at(test.s) - p, in.at(test.t) - p);
    if (glm::length(across) < 1e-12F) return;

    // The circle through p, s and t is the equator of the sphere (Fig. 8).
    const glm::vec3 axis = glm::normalize(across);
    const glm::vec3 u = glm::normalize(p - center);
    const glm::vec3 v = glm::cross(axis, u);
    const Color& color = in.palette.test;
    out.spheres.push_back({center, radius, color.withAlpha(0.10F)});
    out.circle(center, u, v, radius, color, 0.13F, Depth::XRay, 96);
    addSphereContact(in, out.spheres.back(), in.at(test.q), out);

    out.mark(center, Shape::Disc, color, 0.36F);
    out.line(center, p, color, 0.08F, Depth::OnTop);
    addMeasure(in, test, center, radius, out);
    const MeasureNames names = measureNames(in);
    out.label(center, names.center, color);
    out.label(0.5F * (center + p), names.radius, color);
    const std::string sign = test.distance < test.radius             ? " < "
                             : test.verdict == Verdict::InsideSphere ? " = "
                                                                     : " \xE2\x89\xA5 ";
    out.label(0.5F * (center + in.at(test.q)), names.distance + sign + names.radius,
              verdictColor(test.verdict, in.palette), true);
}

}  // namespace se::view
