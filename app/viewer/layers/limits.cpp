/// §6.1: start and end advance along the ring (Fig. 4), or a convex ring drops the point next to
/// them (Fig. 5).
#include "disc.h"
#include "run/neighborhood.h"
#include "run/strings.h"

namespace se::view {

namespace {

void addMove(const LayerInput& in, const LimitEvidence& e, DrawList& out) {
    const Palette& c = in.palette;
    const bool start = e.side == Side::Start;
    const Color& color = start ? c.first : c.last;
    if (!e.moves()) {
        out.dashed(in.at(e.from), in.at(e.to), c.rejected, 0.12F);
        out.label(in.at(e.to), std::string(verdictText(e.verdict)), c.rejected, true);
        return;
    }
    out.arrow(in.at(e.from), in.at(e.to), color, 0.24F, 0.8F);
    out.label(in.middleOf(e.from, e.to), start ? "start moves here" : "end moves here", color,
              true);
    if (isWhatIf(e.verdict)) addVerdict(e.verdict, in.at(e.to), c, out);
    // The lost part of the range is dotted, outside of the remaining part.
    if (const std::optional<Disc> disc = pivotDisc(in)) {
        addDashedArc(*disc, {e.fromDegrees, e.toDegrees, 1.12F * discRadius(in)}, c.textDim, 0.12F,
                     out);
    }
}

/// Height of the point above the plane of the disc: the reason why the angle misleads.
void addStem(const LayerInput& in, const Disc& disc, Index point, const Color& color,
             DrawList& out) {
    const glm::vec3 at = in.at(point);
    const glm::vec3 foot = disc.foot(at);
    out.line(at, foot, color, 0.14F, Depth::OnTop);
    out.mark(foot, Shape::Dot, color, 0.4F);
    out.dashed(disc.origin, foot, color.withAlpha(0.7F), 0.06F, 0.2F);
    const double height = glm::dot(at - disc.origin, disc.normal) / in.model.scale;
    out.label(0.5F * (at + foot), formatted("height %+.3g", height), color);
}

}  // namespace

void addLimits(const LayerInput& in, DrawList& out) {
    if (const auto* drop = in.picture.evidence<DropEvidence>(Stage::Limits)) {
        const bool start = drop->side == Side::Start;
        if (drop->isLimit()) {
            out.label(in.at(drop->point), start ? "now start" : "now end",
                      start ? in.palette.first : in.palette.last, true);
        } else {
            out.label(in.at(drop->point), "outside now", in.palette.rejected, true);
        }
    }
    const auto* e = in.picture.evidence<LimitEvidence>(Stage::Limits);
    if (e == nullptr || e->to == kNone) return;
    const bool start = e->side == Side::Start;
    const Index p = in.picture.pivot;
    if (isMeasured(*e))
        addCorner(in, {start ? e->to : p, e->from, start ? p : e->to, e->turn > 0.0}, out);
    addMove(in, *e, out);
}

void addConvexity(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<DropEvidence>(Stage::Convex);
    const std::optional<Disc> disc = pivotDisc(in);
    if (e == nullptr || !disc) return;
    // A what-if drops points that are not next on the ring.
    if (e->verdict == Verdict::WhatIfDropped)
        return addVerdict(e->verdict, in.at(e->point), in.palette, out);
    const bool start = e->side == Side::Start;
    const Index p = in.picture.pivot;
    const Index limit = start ? in.picture.start : in.picture.end;
    addCorner(in, {start ? e->point : p, limit, start ? p : e->point, false}, out);
    const Color& color = verdictColor(e->verdict, in.palette);
    addStem(in, *disc, e->point, color, out);
    // The path along the ring, against the spoke.
    out.dashed(in.at(p), in.at(limit), in.palette.used, 0.22F, 0.16F);
    out.dashed(in.at(limit), in.at(e->point), in.palette.used, 0.22F, 0.16F);
    out.label(in.middleOf(limit, e->point), "along the ring", in.palette.used, true);
    const std::string effect(isWhatIf(e->verdict) ? verdictText(e->verdict) : "removed");
    out.label(in.middleOf(p, e->point), "spoke: " + effect, color, true);
}

}  // namespace se::view
