// The circumsphere test of a candidate q (6.3): circle, radius and distance, and the angle that
// would remain without q.
#include <algorithm>
#include <string>

#include "disc.h"
#include "run/number_format.h"
#include "sphere_contact.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

namespace {

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
