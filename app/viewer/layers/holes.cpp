/// Holes: the plane of a hole of three (§6.2, Fig. 7), and, beyond the paper (RobustRules::fill),
/// the ears that close a larger one, the largest least angle first.
#include <algorithm>
#include <array>

#include "disc.h"
#include "run/number_format.h"
#include "run/strings.h"

namespace se::view {

namespace {

void addPlane(const LayerInput& in, const glm::vec3& up, DrawList& out) {
    const glm::vec3 s = in.at(in.picture.start);
    const glm::vec3 e = in.at(in.picture.end);
    const glm::vec3 beyond = 0.25F * (e - s);
    const glm::vec3 rise = 0.9F * in.model.spacing * up;
    const std::array corners = {s - beyond - rise, e + beyond - rise, e + beyond + rise,
                                s - beyond + rise};
    const Color& color = in.palette.test;
    out.sheet(corners, color.withAlpha(0.3F));
    out.loop(corners, color, 0.1F);
    out.arrow(0.5F * (s + e), 0.5F * (s + e) + 1.4F * rise, color, 0.12F);
    out.label(0.5F * (s + e) + 1.4F * rise, "mean normal", color);
}

void addFeet(const LayerInput& in, const Disc& plane, float pivotSide, DrawList& out) {
    for (const CandidateMark& mark : in.picture.candidates) {
        if (mark.state == CandidateState::Rejected && mark.stage != Stage::Hole) continue;
        const glm::vec3 at = in.at(mark.point);
        // Those that are not tested yet, by their side.
        const bool far = glm::dot(at - plane.origin, plane.normal) * pivotSide <= 0.0F;
        const bool refused =
            mark.stage == Stage::Hole ? mark.state == CandidateState::Rejected : far;
        const Color& color = refused ? in.palette.rejected : in.palette.used;
        out.dashed(at, plane.foot(at), color, 0.1F, 0.2F);
        out.mark(plane.foot(at), Shape::Dot, color, 0.4F);
    }
}

/// The rim of the hole, bold.
void addHole(const LayerInput& in, const FillEvidence& e, DrawList& out) {
    const std::vector<RingPath>& rings = in.picture.rings;
    if (rings.empty() || !rings.front().active || rings.front().points.empty()) return;
    const std::vector<Index>& points = rings.front().points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.line(in.at(points[i]), in.at(points[(i + 1) % points.size()]), in.palette.last, 0.28F,
                 Depth::XRay);
    }
    // Away from the ear, which has labels of its own.
    const auto ear = std::find(points.begin(), points.end(), e.pivot) - points.begin();
    const std::size_t away = (static_cast<std::size_t>(ear) + points.size() / 2) % points.size();
    out.label(in.at(points[away]), "hole of " + std::to_string(e.ringLength), in.palette.last,
              true);
}

}  // namespace

void addHolePlane(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<HoleEvidence>(Stage::Hole);
    const DecisionState& picture = in.picture;
    if (e == nullptr || picture.pivot == kNone || picture.start == kNone) return;
    const glm::vec3 normal(e->planeNormal);
    if (!(glm::length(normal) > 0.0F)) return;
    const glm::vec3 p = in.at(picture.pivot);
    const glm::vec3 s = in.at(picture.start);
    const glm::vec3 end = in.at(picture.end);
    const Disc plane{s, glm::normalize(normal), {}, {}};
    const glm::vec3 up = glm::normalize(glm::cross(plane.normal, end - s));
    const float way = glm::dot(up, in.model.normal[picture.pivot]) < 0.0F ? -1.0F : 1.0F;
    const Palette& c = in.palette;
    out.sheet(p, s, end, c.used.withAlpha(0.35F));
    out.loop(std::array{p, s, end}, c.used, 0.16F);
    out.label((p + s + end) / 3.0F, "side of the pivot", c.used, true);
    addPlane(in, way * up, out);
    addFeet(in, plane, glm::dot(p - s, plane.normal), out);
    if (e->point == kNone) return;
    const bool near = e->side * e->pivotSide > 0.0;
    out.label(0.5F * (in.at(e->point) + plane.foot(in.at(e->point))),
              (near ? "near" : "far") + formatted(" side, %.3g off", std::abs(e->side)),
              verdictColor(e->verdict, c), true);
    if (isWhatIf(e->verdict)) addVerdict(e->verdict, in.at(e->point), c, out);
}

void addHoleFill(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<FillEvidence>(Stage::Fill);
    if (e == nullptr || e->first == kNone || e->last == kNone) return;
    const Palette& c = in.palette;
    const glm::vec3& p = in.at(e->pivot);
    const glm::vec3& first = in.at(e->first);
    const glm::vec3& last = in.at(e->last);
    addHole(in, *e, out);
    out.sheet(p, first, last, c.test.withAlpha(0.25F));
    out.hatch(first, last, p, c.test, 9);
    out.line(first, last, c.test, 0.26F, Depth::OnTop);
    out.label(
        0.5F * (first + last),
        (e->forced ? "no ear without a fault: " : "best ear: ") + degreesText(e->leastDegrees),
        e->forced ? c.rejected : c.test, true);
}

}  // namespace se::view
