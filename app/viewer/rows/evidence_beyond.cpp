/// Rows of Inspect for the rules beyond the paper (docs/robust.md).
#include <algorithm>

#include "evidence_parts.h"
#include "run/repair_diff.h"

namespace se::view {

namespace {

/// The measure of a guard, if it is a number.
void addMeasured(const GuardEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const PointSet& points = in.model.points;
    const RobustThresholds& thresholds = in.model.params.thresholds;
    const Triangle t{in.picture.pivot, e.a, e.b};
    if (e.verdict == Verdict::WideGap) {
        out.angle("gap at p", freeDegrees(points, e.a, t.a, e.b), 180.0);
    } else if (e.verdict == Verdict::Steep) {
        out.angle("off a normal", tiltDegrees(points, t), degreesOf(thresholds.steepCosine), 180.0);
    } else if (e.verdict == Verdict::AgainstNormal) {
        out.angle("off a normal", tiltDegrees(points, t), 90.0, 180.0);
    } else if (e.verdict == Verdict::OverRim) {
        out.angle("angle at p", freeDegrees(points, e.a, t.a, e.b),
                  degreesOf(thresholds.rimAngleCosine));
        const auto list = points.neighbors[t.a];
        const Index sixth = list[std::min<std::size_t>(5, list.size() - 1)];
        const double limit = glm::length(points.position[sixth] - points.position[t.a]);
        const double radius = circleRadius(points, t);
        out.row("its circle",
                "r = " + numberText(radius) + ", sixth neighbor at " + numberText(limit),
                {radius, limit, 2.0 * limit});
    }
}

}  // namespace

void addRows(const GuardEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    if (e.a == kNone) return out.row("fan", "refused: what-if");
    const bool spoke = e.b == kNone;
    out.row(spoke ? "spoke to" : "triangle",
            spoke ? pointsText({e.a}) : pointsText({in.picture.pivot, e.a, e.b}));
    out.row("against it", std::string(verdictText(e.verdict)));
    if (!spoke) addMeasured(e, in, out);
    if (e.verdict == Verdict::WhatIfKept) return out.row("dropped", "nothing: what-if");
    out.row("dropped", e.dropped == kNone ? "nothing: the fan is refused"
                                          : std::to_string(e.dropped) + ", 6.3 is repeated");
}

void addRows(const FillEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const double length = e.ringLength;
    const double limit = in.model.params.maxFillLength;
    out.row("ear", pointsText({e.pivot, e.first, e.last}));
    out.row("hole", countText(e.ringLength, "point") + ", limit " + numberText(limit),
            {length, limit, limit});
    out.row("least angle", degreesText(e.leastDegrees) + ", the best of all ears",
            {e.leastDegrees, 60.0, 60.0});
    out.angle("angle at p", freeDegrees(in.model.points, e.first, e.pivot, e.last), 180.0);
    if (e.forced) out.row("forced", "no ear without a fault was left");
}

namespace {

/// The least angle of the removed triangles and of the new ones.
void addLeastAngles(const EvidenceInput& in, EvidenceRows& out) {
    const PointSet& points = in.model.points;
    const double before = leastDegrees(points, in.picture.goneTriangles);
    const double after = leastDegrees(points, in.picture.newTriangles);
    if (in.picture.goneTriangles.empty()) {
        out.row("least angle", degreesText(after), {after, 60.0, 60.0});
        return;
    }
    out.row("least angle", degreesText(before) + " \xE2\x86\x92 " + degreesText(after),
            {after, before, 60.0});
    const double gain = after - before;
    out.row("margin", degreesText(std::abs(gain)) + (gain < 0.0 ? " smaller" : " larger"));
}

/// Number of triangles that are against their normals.
std::string flippedText(const PointSet& points, const std::vector<Triangle>& triangles) {
    return std::to_string(std::count_if(triangles.begin(), triangles.end(),
                                        [&](const Triangle& t) { return isFlipped(points, t); }));
}

void addFlipped(const EvidenceInput& in, EvidenceRows& out) {
    const PointSet& points = in.model.points;
    out.row("flipped ones", flippedText(points, in.picture.goneTriangles) + " \xE2\x86\x92 " +
                                flippedText(points, in.picture.newTriangles));
}

std::string countsText(const Picture& picture) {
    return std::to_string(picture.goneTriangles.size()) + " \xE2\x86\x92 " +
           std::to_string(picture.newTriangles.size());
}

}  // namespace

void addRows(const FlipEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("edge before", pointsText({e.u, e.v}));
    out.row("edge after", pointsText({e.x, e.y}));
    addLeastAngles(in, out);
    addFlipped(in, out);
}

void addRows(const ReinsertEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const MeshEdges edges = edgesOf(in.picture.goneTriangles, in.picture.newTriangles, e.point);
    out.row("point", pointsText({e.point}) + ", in no triangle until now");
    if (in.picture.goneTriangles.empty()) {
        out.row("put", "beside the border");
    } else if (edges.gone.empty()) {
        out.row("put", "into a triangle");
    } else {
        out.row("put", "on the edge " + pointsText({edges.gone[0][0], edges.gone[0][1]}));
    }
    out.row("triangles", countsText(in.picture));
    addLeastAngles(in, out);
}

void addRows(const RemoveFoldedEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("point", pointsText({e.point}) + ", taken out");
    out.row("triangles", countsText(in.picture));
    addFlipped(in, out);
    addLeastAngles(in, out);
}

}  // namespace se::view
