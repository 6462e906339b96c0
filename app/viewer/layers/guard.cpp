/// Beyond the paper (docs/robust.md): the objection of a rule to the whole fan.
#include <algorithm>

#include "disc.h"
#include "scene/selection_measures.h"

namespace se::view {

namespace {

/// An angle at the pivot from a to b, against its limit.
void addWidth(const LayerInput& in, const Disc& disc, const GuardEvidence& e, double limit,
              DrawList& out) {
    const Palette& c = in.palette;
    const double from = degreesOn(disc, in.at(e.a));
    double to = degreesOn(disc, in.at(e.b));
    if (to <= from) to += 360.0;
    const float radius = discRadius(in);
    addArc(disc, {from, to, radius}, c.rejected, 0.26F, out);
    out.line(disc.at(from + limit, 0.85F * radius), disc.at(from + limit, 1.15F * radius), c.text,
             0.12F, Depth::OnTop);
    out.label(
        disc.at(0.5 * (from + to), radius),
        degreesText(to - from) + (to - from > limit ? " > " : ", limit ") + degreesText(limit),
        c.rejected, true);
}

/// The normal of the triangle and those of its corners, from which it deviates too much.
void addTilt(const LayerInput& in, const Triangle& t, double limit, DrawList& out) {
    const Palette& c = in.palette;
    const glm::vec3 across = in.acrossOf(t);
    if (!(glm::length(across) > 0.0F)) return;
    const float length = 1.1F * in.model.spacing;
    const glm::vec3 middle = in.middleOf(t);
    const glm::vec3 tip = middle + length * glm::normalize(across);
    out.arrow(middle, tip, c.rejected, 0.16F);
    for (const Index corner : {t.a, t.b, t.c}) {
        out.arrow(in.at(corner), in.at(corner) + length * in.model.normal[corner], c.unused, 0.1F);
    }
    out.label(
        tip,
        degreesText(tiltDegrees(in.model.points, t)) + " off a normal, limit " + degreesText(limit),
        c.rejected, true);
}

/// Edges of the triangle that a finished one has already, in the same direction.
void addTaken(const LayerInput& in, const Triangle& t, DrawList& out) {
    if (in.meshIndex == nullptr) return;
    const auto passes = [](const Triangle& old, Index from, Index to) {
        return (old.a == from && old.b == to) || (old.b == from && old.c == to) ||
               (old.c == from && old.a == to);
    };
    const std::size_t count = std::min(in.picture.finishedTriangles, in.triangles.size());
    for (const auto& [from, to] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
        for (const std::uint32_t number : in.meshIndex->atEdge(in.triangles, from, to)) {
            if (number >= count || !passes(in.triangles[number], from, to)) continue;
            out.line(in.at(from), in.at(to), in.palette.rejected, 0.34F, Depth::OnTop);
            out.label(in.middleOf(from, to), "taken", in.palette.rejected);
        }
    }
}

void addTriangle(const LayerInput& in, const Disc& disc, const GuardEvidence& e, const Color& color,
                 DrawList& out) {
    const Triangle t{in.picture.pivot, e.a, e.b};
    out.sheet(in.at(t.a), in.at(t.b), in.at(t.c), color.withAlpha(0.22F));
    out.hatch(in.at(t.b), in.at(t.c), in.at(t.a), color, 9);
    out.dashed(in.at(t.b), in.at(t.c), color, 0.2F, 0.35F);
    const RobustThresholds& thresholds = in.model.params.thresholds;
    const auto is = [&](Verdict verdict) { return e.verdict == verdict; };
    if (is(Verdict::WideGap)) addWidth(in, disc, e, 180.0, out);
    if (is(Verdict::OverRim)) addWidth(in, disc, e, degreesOf(thresholds.rimAngleCosine), out);
    if (is(Verdict::Steep)) addTilt(in, t, degreesOf(thresholds.steepCosine), out);
    if (is(Verdict::AgainstNormal)) addTilt(in, t, 90.0, out);
    if (is(Verdict::EdgeTaken)) addTaken(in, t, out);
    if (is(Verdict::Crosses) || is(Verdict::Meets) || is(Verdict::FoldsOver))
        addOverlap(in, overlapOf(in, disc, t), out);
}

}  // namespace

void addGuard(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<GuardEvidence>(Stage::Guard);
    const std::optional<Disc> disc = pivotDisc(in);
    if (e == nullptr || !disc) return;
    // A what-if without an objection.
    if (e->a == kNone) return addVerdict(e->verdict, disc->origin, in.palette, out);
    const Color& color = verdictColor(e->verdict, in.palette);
    if (e->b == kNone) {
        out.dashed(disc->origin, in.at(e->a), color, 0.26F, 0.35F);
    } else {
        addTriangle(in, *disc, *e, color, out);
    }
    const glm::vec3 far = e->b == kNone ? in.at(e->a) : in.middleOf(e->a, e->b);
    out.label(far,
              std::string(verdictText(e->verdict)) +
                  (isTaken(e->verdict)   ? ""
                   : e->dropped == kNone ? ": fan refused"
                                         : ": " + std::to_string(e->dropped) + " dropped"),
              color, true);
}

}  // namespace se::view
