/// The pivot with its candidates and its sector, and the listed neighbors of a point.
#include <algorithm>

#include "disc.h"
#include "run/neighborhood.h"
#include "scene/hiding.h"

namespace se::view {

namespace {

void addSpoke(const LayerInput& in, const CandidateMark& mark, DrawList& out) {
    const bool rejected = mark.state == CandidateState::Rejected;
    const bool tested = mark.point == in.picture.underTest;
    const Color color = rejected ? in.palette.rejected.withAlpha(0.75F)
                        : tested ? in.palette.test
                                 : in.palette.used;
    out.dashed(in.at(in.picture.pivot), in.at(mark.point), color,
               tested     ? 0.16F
               : rejected ? 0.06F
                          : 0.09F,
               rejected ? 0.3F : 0.0F);
}

void addMark(const LayerInput& in, Index point, Shape shape, const Color& color, float size,
             DrawList& out) {
    if (point != kNone) out.mark(in.at(point), shape, color, size);
}

void addCandidates(const LayerInput& in, DrawList& out) {
    for (const CandidateMark& mark : in.picture.candidates) {
        addSpoke(in, mark, out);
        const bool rejected = mark.state == CandidateState::Rejected;
        addMark(in, mark.point, rejected ? Shape::Cross : Shape::Disc,
                rejected ? in.palette.rejected : in.palette.used, rejected ? 0.72F : 0.62F, out);
    }
}

void addEnds(const LayerInput& in, DrawList& out) {
    const DecisionState& p = in.picture;
    const auto spoke = [&](Index point, const Color& color, float width) {
        if (point != kNone) out.line(in.at(p.pivot), in.at(point), color, width, Depth::OnTop);
    };
    spoke(p.first, in.palette.first, 0.12F);
    if (p.last != p.first) spoke(p.last, in.palette.last, 0.12F);
    if (p.start != p.first) spoke(p.start, in.palette.first, 0.12F);
    if (p.end != p.last) spoke(p.end, in.palette.last, 0.12F);
    if (p.start != p.first) addMark(in, p.first, Shape::Forward, in.palette.first, 0.7F, out);
    if (p.end != p.last) addMark(in, p.last, Shape::Back, in.palette.last, 0.7F, out);
    addMark(in, p.end, Shape::Back, in.palette.last, 1.0F, out);
    addMark(in, p.start, Shape::Forward, in.palette.first, 1.0F, out);
}

void addList(const LayerInput& in, Index point, const Color& color, DrawList& out) {
    if (point == kNone) return;
    for (const Index q : in.model.points.neighbors[point]) {
        out.dashed(in.at(point), in.at(q), color, 0.06F, 0.2F);
    }
}

}  // namespace

void addSector(const LayerInput& in, DrawList& out) {
    const std::optional<Disc> disc = pivotDisc(in);
    if (!disc) return;
    const float radius = discRadius(in);
    const Color& color = in.palette.pivot;
    const double from = in.picture.startDegrees;
    const Arc arc{from, std::max(in.picture.endDegrees, from), radius};
    addSectorSheet(*disc, arc, color.withAlpha(0.16F), out);
    addArc(*disc, {0.0, 360.0, radius}, color.withAlpha(0.25F), 0.05F, out);
    addArc(*disc, arc, color.withAlpha(0.8F), 0.08F, out);
    out.line(disc->origin, disc->origin + disc->normal * in.model.spacing, color.withAlpha(0.8F),
             0.08F, Depth::XRay);
}

void addNeighborRing(const LayerInput& in, DrawList& out) {
    const DecisionState& p = in.picture;
    // Seeds, stranded points and the steps after the last pivot have layers of their own.
    if (p.pivot == kNone) return;
    out.decision = decisionPlace(in.model, p.pivot, neighborhoodOf(p));
    // Once the pivot is complete only the result of its tests is shown.
    if (!p.complete) addCandidates(in, out);
    if (!p.complete) addEnds(in, out);
    if (!p.complete && p.underTest != p.pivot) {
        addMark(in, p.underTest, Shape::RingedDisc, in.palette.test, 1.0F, out);
    }
    for (const CandidateMark& mark : p.candidates) {
        const bool rejected = mark.state == CandidateState::Rejected;
        if (p.complete || mark.point != p.underTest || !rejected) continue;
        addMark(in, mark.point, Shape::Cross, in.palette.rejected, 1.0F, out);
    }
    addMark(in, p.pivot, Shape::RingedDisc, in.palette.pivot, 1.15F, out);
}

void addLinks(const LayerInput& in, DrawList& out) {
    addList(in, in.picture.pivot, in.palette.unused, out);
    if (in.selected != in.picture.pivot) addList(in, in.selected, in.palette.accent, out);
}

}  // namespace se::view
