/// §6.1, Fig. 6: the pivot as seen from the candidate e, on a second disc.
#include <algorithm>
#include <vector>

#include "overlap.h"

namespace se::view {

namespace {

/// The triangles that the candidate would form with its neighbors in the fan, hatched, and their
/// overlap with finished ones.
void addPreview(const LayerInput& in, const ReciprocalEvidence& e, DrawList& out) {
    const Picture& p = in.picture;
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

void addReciprocal(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<ReciprocalEvidence>(Stage::Reciprocal);
    if (e == nullptr || in.picture.pivot == kNone) return;
    const std::optional<Disc> disc = discAt(in, e->point, e->pred);
    if (!disc) return;
    const Palette& c = in.palette;
    const bool kept = e->verdict == Verdict::Kept;
    const Color& verdict = kept ? c.used : c.rejected;
    const float radius = 1.15F * discRadius(in);
    addPreview(in, *e, out);
    addSectorSheet(*disc, {0.0, e->limitDegrees, radius}, c.test.withAlpha(0.35F), out);
    addArc(*disc, {0.0, 360.0, radius}, c.test, 0.1F, out);
    addArc(*disc, {0.0, e->limitDegrees, radius}, c.test, 0.24F, out);
    out.arrow(disc->origin, in.at(e->pred), c.first, 0.14F);
    out.label(in.at(e->pred), "first of e", c.first);
    if (e->succ != e->pred) {
        out.line(disc->origin, in.at(e->succ), c.last, 0.14F, Depth::OnTop);
        out.label(in.at(e->succ), "last of e", c.last);
    }
    out.line(disc->origin, in.at(in.picture.pivot), verdict, 0.2F, Depth::OnTop);
    addArc(*disc, {0.0, e->degrees, 0.6F * radius}, verdict, 0.14F, out);
    out.label(disc->at(0.5 * e->degrees, 0.6F * radius), degreesText(e->degrees), verdict, true);
    out.label(disc->at(e->limitDegrees, radius), "to " + degreesText(e->limitDegrees), c.test);
    out.label(disc->origin, kept ? "e: p lies inside" : "e: p lies outside", verdict, true);
}

}  // namespace se::view
