/// §6.1: the angle of a candidate from the slicing plane (Fig. 3), and of the pivot as seen from
/// the candidate e, on a second disc (Fig. 6).

#include <algorithm>
#include <vector>

#include "disc.h"
#include "run/model.h"
#include "run/strings.h"

namespace se::view {

namespace {

/// The plane through p that divides the disc into halves: it contains z and the normal.
void addSlicingPlane(const LayerInput& in, const Disc& disc, DrawList& out) {
    const float size = 1.5F * in.model.spacing;
    const glm::vec3 along = size * disc.zero;
    const glm::vec3 up = 0.55F * size * disc.normal;
    const glm::vec3& p = disc.origin;
    const Color& color = in.palette.accent;
    const std::array corners = {p - along - up, p + along - up, p + along + up, p - along + up};
    out.sheet(corners, color.withAlpha(0.14F));
    out.loop(corners, color.withAlpha(0.7F), 0.06F);
    out.arrow(p, p + 0.7F * size * disc.quarter, color, 0.1F);
    out.label(p + 0.7F * size * disc.quarter, "n", in.palette.text);
}

void addRanks(const LayerInput& in, DrawList& out) {
    std::vector<const CandidateMark*> kept;
    for (const CandidateMark& mark : in.picture.candidates) {
        if (mark.state == CandidateState::Kept) kept.push_back(&mark);
    }
    std::stable_sort(kept.begin(), kept.end(), [](const CandidateMark* a, const CandidateMark* b) {
        return a->degrees < b->degrees;
    });
    const glm::vec3 p = in.at(in.picture.pivot);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        out.label(p + 0.72F * (in.at(kept[i]->point) - p), std::to_string(i + 1) + ".",
                  in.palette.used);
    }
}

void addTested(const LayerInput& in, const Disc& disc, const SortEvidence& e, DrawList& out) {
    const Palette& c = in.palette;
    const Color& half = e.secondHalf ? c.last : c.first;
    const glm::vec3 foot = disc.foot(in.at(e.point));
    const Arc arc{0.0, e.degrees, 0.8F * discRadius(in)};
    out.dashed(in.at(e.point), foot, half, 0.08F, 0.2F);
    out.dashed(disc.origin, foot, half, 0.06F, 0.2F);
    addArc(disc, arc, half, 0.16F, out);
    out.label(disc.at(0.5 * e.degrees, arc.radius),
              degreesText(e.degrees) + (e.secondHalf ? ", n\xC2\xB7v < 0" : ""), half, true);
    if (e.verdict == Verdict::NotBeforeEnd) {
        addDashedArc(disc, {e.endDegrees, e.degrees, 1.1F * arc.radius}, c.rejected, 0.12F, out);
        out.label(disc.at(e.endDegrees, 1.5F * arc.radius), "limit " + degreesText(e.endDegrees),
                  c.rejected);
    }
    if (e.verdict == Verdict::SameAngle && e.rival != kNone) {
        out.mark(in.at(e.rival), Shape::Circle, c.used, 1.1F);
        out.label(in.at(e.rival), e.farther < 0.0 ? "farther: kept" : "nearer: kept", c.used);
        out.label(in.at(e.point),
                  e.farther < 0.0   ? "same angle, nearer"
                  : e.farther > 0.0 ? "same angle, farther"
                                    : "same angle",
                  c.rejected);
    }
    if (isWhatIf(e.verdict)) addVerdict(e.verdict, in.at(e.point), c, out);
}

/// The result of the test, at the candidate e.
std::string reciprocalText(const ReciprocalEvidence& e) {
    if (e.verdict == Verdict::Kept) return "the pivot lies inside";
    if (e.verdict == Verdict::NotReciprocal) return "the pivot lies outside";
    return std::string(verdictText(e.verdict));
}

/// The triangles that the candidate would form with its neighbors in the fan, hatched, and their
/// overlap with finished ones.
void addPreview(const LayerInput& in, const ReciprocalEvidence& e, DrawList& out) {
    const DecisionState& p = in.picture;
    const std::optional<Disc> disc = pivotDisc(in);
    if (!disc) return;
    double angle = 0.0;
    for (const CandidateMark& mark : p.candidates) {
        if (mark.point == e.point) angle = mark.degrees;
    }
    Index before = p.start;
    Index after = p.end;
    double low = p.startDegrees;
    double high = p.endDegrees;
    for (const CandidateMark& mark : p.candidates) {
        if (mark.point == e.point || mark.state == CandidateState::Rejected) continue;
        if (mark.degrees < angle && mark.degrees > low) low = mark.degrees, before = mark.point;
        if (mark.degrees > angle && mark.degrees < high) high = mark.degrees, after = mark.point;
    }
    Overlap largest;
    for (const Index other : {before, after}) {
        if (other == kNone || other == e.point) continue;
        const Color color = in.palette.test.withAlpha(0.8F);
        out.hatch(in.at(p.pivot), in.at(e.point), in.at(other), color);
        out.line(in.at(e.point), in.at(other), color, 0.1F, Depth::OnTop);
        const Overlap overlap = overlapOf(in, *disc, {p.pivot, e.point, other});
        addOverlap(in, overlap, out);
        if (overlap.share > largest.share) largest = overlap;
    }
    if (largest.share > 0.0F) out.label(largest.middle, "overlap", in.palette.rejected, true);
}

}  // namespace

void addSortAngles(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<SortEvidence>(Stage::Sort);
    const std::optional<Disc> disc = pivotDisc(in);
    if (e == nullptr || !disc) return;
    addSlicingPlane(in, *disc, out);
    const glm::vec3 p = disc->origin;
    out.arrow(p, in.at(in.picture.first), in.palette.first, 0.16F);
    out.label(p + 0.62F * (in.at(in.picture.first) - p), "z", in.palette.first, true);
    addRanks(in, out);
    if (e->verdict != Verdict::OnRingEnd && e->verdict != Verdict::AlreadyDone) {
        addTested(in, *disc, *e, out);
    }
}

void addReciprocal(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<ReciprocalEvidence>(Stage::Reciprocal);
    if (e == nullptr || in.picture.pivot == kNone) return;
    // The free sector runs from the point before e, elast in Figure 6, to the one after it, efirst.
    const Index from = e->printed ? e->succ : e->pred;
    const std::optional<Disc> disc = discAt(in, e->point, from);
    if (!disc) return;
    const Palette& c = in.palette;
    const Color& verdict = verdictColor(e->verdict, c);
    const float radius = 1.15F * discRadius(in);
    addPreview(in, *e, out);
    addSectorSheet(*disc, {0.0, e->limitDegrees, radius}, c.test.withAlpha(0.35F), out);
    addArc(*disc, {0.0, 360.0, radius}, c.test, 0.1F, out);
    addArc(*disc, {0.0, e->limitDegrees, radius}, c.test, 0.24F, out);
    out.arrow(disc->origin, in.at(from), e->printed ? c.first : c.last, 0.14F);
    if (e->succ != e->pred) {
        const Index to = e->printed ? e->pred : e->succ;
        out.line(disc->origin, in.at(to), e->printed ? c.last : c.first, 0.14F, Depth::OnTop);
    }
    out.line(disc->origin, in.at(in.picture.pivot), verdict, 0.2F, Depth::OnTop);
    addArc(*disc, {0.0, e->degrees, 0.6F * radius}, verdict, 0.14F, out);
    out.label(disc->at(0.5 * e->degrees, 0.6F * radius), degreesText(e->degrees), verdict, true);
    out.label(disc->at(e->limitDegrees, radius), "to " + degreesText(e->limitDegrees), c.test);
    out.label(disc->origin, reciprocalText(*e), verdict, true);
}

// §6.1: start and end advance along the ring (Fig. 4), or a convex ring drops the point next to
// them (Fig. 5).

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
