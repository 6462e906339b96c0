// A row compares what a decision was based on with its limit. The rows of what begins a ring and of
// its tests are in evidence_tests.cpp; those of effects, and of the rules beyond the paper, are
// here.
#include "evidence_rows.h"

#include <algorithm>
#include <cmath>

#include "evidence_parts.h"
#include "run/repair_diff.h"
#include "spiraling_edge/geometry/triangle_shape.h"

namespace se::view {

void EvidenceRows::angle(const std::string& name, double degrees, double limit, double largest) {
    row(name, degreesText(degrees) + ", limit " + degreesText(limit), {degrees, limit, largest});
    row("margin",
        degreesText(std::abs(limit - degrees)) + (degrees > limit ? " over" : " under") + " it");
}

void EvidenceRows::sign(const std::string& name, const std::string& value, double number,
                        double scale) {
    // Zero in the middle.
    const double reach = std::max(std::abs(number), std::abs(scale));
    row(name, value, {number + reach, reach, 2.0 * reach});
}

std::string pointsText(const std::vector<Index>& list, std::span<const PointName> names) {
    std::string text;
    for (const Index p : list) text += (text.empty() ? "" : ", ") + nameOf(p, names);
    return text;
}

std::string wallsText(std::uint8_t type) {
    constexpr const char* kFaces[] = {"+x",           "+y", "+z", "\xE2\x88\x92x", "\xE2\x88\x92y",
                                      "\xE2\x88\x92z"};
    std::string text;
    for (unsigned i = 0; i < 6; ++i) {
        if ((type >> i & 1U) != 0) text += (text.empty() ? "" : " ") + std::string(kFaces[i]);
    }
    return text.empty() ? (isRimPoint(type) ? "none, a rim" : "none") : text;
}

namespace {

// Effects of a pivot: triangles (§6.4), ring (§6.5), end (§3, §7).

void addRows(const EmitEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const PointSet& points = in.model.points;
    out.row("triangle", std::to_string(e.triangle));
    out.row("of this pivot", "number " + std::to_string(in.picture.newTriangles.size()));
    out.row("corners", pointsText({e.corners.a, e.corners.b, e.corners.c}, in.names));
    out.row("least angle", degreesText(leastDegrees(points, e.corners)),
            {leastDegrees(points, e.corners), 60.0, 60.0});
    out.row("area", numberText(triangleArea(points, e.corners)));
    // The normals of its corners define the outer side.
    const double tilt = tiltDegrees(points, e.corners);
    out.row("orientation", isFlipped(points, e.corners) ? "flipped: against the normals"
                           : tilt > 90.0                ? "against the normal of a corner"
                                                        : "counterclockwise about all normals");
    out.angle("off a normal", tilt, 90.0, 180.0);
}

std::string lengthOf(const std::vector<RingPath>& rings) {
    if (rings.empty() || !rings.front().active) return "none";
    return std::to_string(rings.front().points.size());
}

void addRows(const RingEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const auto& changes = in.picture.ringChanges;
    const auto inserted = static_cast<std::size_t>(std::count_if(
        changes.begin(), changes.end(), [](const RingEvidence& each) { return each.inserted; }));
    out.row("point", pointsText({e.point}, in.names));
    out.row("change", e.inserted ? "inserted" : "removed");
    const int before = e.inserted ? e.status - 1 : std::max(e.status, 0) + 1;
    out.row("ring entries", std::to_string(before) + " \xE2\x86\x92 " +
                                (e.status == kDone ? "0: DONE" : std::to_string(e.status)));
    out.row("so far", std::to_string(changes.size() - inserted) + " removed, " +
                          std::to_string(inserted) + " inserted");
    out.row("ring length",
            lengthOf(in.picture.oldRings) + " \xE2\x86\x92 " + lengthOf(in.picture.rings) + " now");
}

void addRows(const SplitEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("at point", pointsText({e.point}, in.names));
    out.row("met again", "in the same ring");
    out.row("continues", counted(e.activeLength, "point", "points"));
    out.row("to the stack", counted(e.stackedLength, "point", "points"));
    out.row("stack depth", std::to_string(e.stackDepth));
}

void addRows(const JoinEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("at point", pointsText({e.point}, in.names));
    out.row("met again", e.depthFromTop == kNone
                             ? "in the active ring"
                             : "in number " + std::to_string(e.depthFromTop + 1) +
                                   " of the stack, searched from the top");
    out.row("joined ring", counted(e.length, "point", "points"));
    out.row("stack depth", std::to_string(stackedCount(in.picture.rings)));
}

void addRows(const CloseEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    e.b == kNone
        ? out.row("lone entry", pointsText({e.a}, in.names))
        : out.row(e.rest > 0 ? "within a ring" : "ring of two", pointsText({e.a, e.b}, in.names));
    if (e.rest > 0) out.row("remaining ring", counted(e.rest, "point", "points"));
    out.row("so", "it is a finished edge: closed");
}

void addRows(const AdvanceEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("next pivot", e.to == kNone ? "none: no ring is left" : nameOf(e.to, in.names));
    if (e.popped) out.row("ring", "taken off the stack");
    const std::vector<RingPath>& rings = in.picture.rings;
    const bool active = !rings.empty() && rings.front().active;
    const double circuit = e.circuit;
    if (e.circuit == 0 || !active) return;
    const auto length = static_cast<double>(rings.front().points.size());
    out.row("no triangle", "for " + counted(e.circuit, "pivot", "pivots"),
            {circuit, length, std::max(circuit, length)});
    out.row("full circuit", counted(rings.front().points.size(), "pivot", "pivots"));
}

void addRows(const ShelveEvidence& e, const EvidenceInput&, EvidenceRows& out) {
    out.row("ring", counted(e.length, "point", "points") + ", shelved");
    out.row("on the shelf", counted(e.shelved + 1, "ring", "rings"));
    out.row("waits for", "a join, or the last seed");
}

void addRows(const TakeUpEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("on the shelf", counted(e.rings, "ring", "rings") + ", taken up");
    out.row("next pivot", nameOf(e.to, in.names));
}

void addRows(const FreeEvidence& e, const EvidenceInput&, EvidenceRows& out) {
    if (e.seed) {
        out.row("ring", "a seed without a triangle, freed");
        out.row("its points", "UNUSED again");
        return;
    }
    out.row("ring", counted(e.length, "point", "points") + ", freed");
    out.row("on walls", std::to_string(e.length - e.interior));
    out.row("interior", std::to_string(e.interior) +
                            (e.interior == 0 ? ": the surface ends here" : ": something is open"));
}

/// The pivot that begins the next ring.
std::string nextSeed(const EvidenceInput& in) {
    if (in.run == nullptr) return "not known yet";
    const std::uint32_t here = in.event.address.pivot;
    for (const RunMark& mark : in.run->marks) {
        if (mark.kind == MarkKind::Seed && mark.pivot > here) {
            return "at pivot " + std::to_string(mark.pivot);
        }
    }
    return in.run->complete ? "none: the run has ended" : "not known yet";
}

void addRows(const ComponentEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("component", std::to_string(e.component));
    const ComponentShape* shape =
        in.run == nullptr ? nullptr : shapeAt(in.run->shapes, in.event.address.pivot);
    if (shape == nullptr) {
        out.row("triangles", std::to_string(e.triangles) + " so far; the rest is being counted");
        return;
    }
    out.row("triangles", std::to_string(shape->end - shape->begin) + " of " +
                             std::to_string(e.triangles) + " so far");
    out.row("points", std::to_string(shape->points));
    out.row("open loops", shape->loops == 0 ? "none: closed" : std::to_string(shape->loops));
    if (shape->loops > 0) out.row("open edges", std::to_string(shape->rim.size()));
    out.row("time", durationText(shape->seconds) + " of the run, with all decisions recorded");
    out.row("next seed", nextSeed(in));
}

const char* meaningOf(AlertKind kind) {
    if (kind == AlertKind::TriangleCap) return "too many triangles: the run is stopped";
    return kind == AlertKind::Hole ? "a hole stays open" : "the seed got no triangle";
}

void addRows(const AlertEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("alert", meaningOf(e.kind));
    if (e.point != kNone) out.row("point", pointsText({e.point}, in.names));
    if (e.kind == AlertKind::TriangleCap) {
        const auto per = static_cast<double>(in.picture.finishedTriangles) /
                         static_cast<double>(std::max<std::size_t>(1, in.model.points.size()));
        out.row("per point", numberText(per) + " triangles, limit " +
                                 numberText(in.model.params.maxTrianglesPerPoint));
    }
    if (!in.picture.freed) return;
    const FreedRingState& ring = *in.picture.freed;
    out.row("freed ring", counted(ring.path.points.size(), "point", "points"));
    if (ring.evidence) out.row("interior", std::to_string(ring.evidence->interior));
}

void addRows(const FinishedEvidence& e, const EvidenceInput&, EvidenceRows& out) {
    out.row("ended", e.capped ? "too many triangles for the number of points"
                              : "every point is DONE, and no seed is left");
    out.row("triangles", std::to_string(e.triangles));
    out.row("components", std::to_string(e.components));
    out.row("in no triangle", counted(e.unused, "point", "points"));
    out.row("open loops", e.loops == 0 ? "none: closed" : std::to_string(e.loops));
}

// Rules beyond the paper (docs/robust.md).

/// The measure of a guard, if it is a number.
void addMeasured(const GuardEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const PointSet& points = in.model.points;
    const RobustThresholds& thresholds = in.model.params.thresholds;
    const Triangle t{in.picture.pivot, e.a, e.b};
    if (e.verdict == Verdict::WideGap) {
        out.angle("gap at pivot", freeDegrees(points, e.a, t.a, e.b), 180.0);
    } else if (e.verdict == Verdict::Steep) {
        out.angle("off a normal", tiltDegrees(points, t), degreesOf(thresholds.steepCosine), 180.0);
    } else if (e.verdict == Verdict::AgainstNormal) {
        out.angle("off a normal", tiltDegrees(points, t), 90.0, 180.0);
    } else if (e.verdict == Verdict::OverRim) {
        out.angle("angle at pivot", freeDegrees(points, e.a, t.a, e.b),
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

void addRows(const GuardEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    if (e.a == kNone) return out.row("fan", "refused: what-if");
    const bool spoke = e.b == kNone;
    out.row(
        spoke ? "spoke to" : "triangle",
        spoke ? pointsText({e.a}, in.names) : pointsText({in.picture.pivot, e.a, e.b}, in.names));
    if (isTaken(e.verdict)) return out.row("dropped", "nothing: what-if");
    out.row("against it", std::string(verdictText(e.verdict)));
    if (!spoke) addMeasured(e, in, out);
    out.row("dropped", e.dropped == kNone ? "nothing: the fan is refused"
                                          : nameOf(e.dropped, in.names) + ", 6.3 is repeated");
}

void addRows(const FillEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const double length = e.ringLength;
    const double limit = in.model.params.maxFillLength;
    out.row("ear", pointsText({e.pivot, e.first, e.last}, in.names));
    out.row("hole", counted(e.ringLength, "point", "points") + ", limit " + numberText(limit),
            {length, limit, limit});
    out.row("least angle", degreesText(e.leastDegrees) + ", the best of all ears",
            {e.leastDegrees, 60.0, 60.0});
    out.angle("angle at pivot", freeDegrees(in.model.points, e.first, e.pivot, e.last), 180.0);
    if (e.forced) out.row("forced", "no ear without a fault was left");
}

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
void addFlipped(const EvidenceInput& in, EvidenceRows& out) {
    const auto flipped = [&](const std::vector<Triangle>& triangles) {
        return std::to_string(
            std::count_if(triangles.begin(), triangles.end(),
                          [&](const Triangle& t) { return isFlipped(in.model.points, t); }));
    };
    out.row("flipped ones", flipped(in.picture.goneTriangles) + " \xE2\x86\x92 " +
                                flipped(in.picture.newTriangles));
}

std::string countsText(const DecisionState& picture) {
    return std::to_string(picture.goneTriangles.size()) + " \xE2\x86\x92 " +
           std::to_string(picture.newTriangles.size());
}

void addRows(const FlipEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("edge before", pointsText({e.u, e.v}, in.names));
    out.row("edge after", pointsText({e.x, e.y}, in.names));
    addLeastAngles(in, out);
    addFlipped(in, out);
}

void addRows(const ReinsertEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const MeshEdges edges = edgesOf(in.picture.goneTriangles, in.picture.newTriangles, e.point);
    out.row("point", pointsText({e.point}, in.names) + ", in no triangle until now");
    if (in.picture.goneTriangles.empty()) {
        out.row("put", "beside the border");
    } else if (edges.gone.empty()) {
        out.row("put", "into a triangle");
    } else if (edges.gone.size() > 1) {
        out.row("put", "in the place of several triangles");
    } else {
        out.row("put", "on the edge " + pointsText({edges.gone[0][0], edges.gone[0][1]}, in.names));
    }
    out.row("triangles", countsText(in.picture));
    addLeastAngles(in, out);
}

void addRows(const DropPatchEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("triangles", grouped(e.triangles) + ", taken out");
    if (e.kept > 0) out.row("kept", "a fan of " + grouped(e.kept));
    out.row("point", pointsText({e.point}, in.names));
}

void addRows(const CloseHoleEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("hole", grouped(e.length) + " points, at " + pointsText({e.first, e.second}, in.names));
    out.row("triangles", countsText(in.picture));
    addLeastAngles(in, out);
}

void addRows(const RemeshEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("faulty", pointsText({e.faulty.a, e.faulty.b, e.faulty.c}, in.names));
    out.row("triangles", countsText(in.picture));
    addFlipped(in, out);
    addLeastAngles(in, out);
}

void addRows(const RemoveFoldedEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("point", pointsText({e.point}, in.names) + ", taken out");
    out.row("triangles", countsText(in.picture));
    addFlipped(in, out);
    addLeastAngles(in, out);
}

}  // namespace

std::vector<EvidenceRow> evidenceRows(const EvidenceInput& in) {
    EvidenceRows rows;
    std::visit([&](const auto& evidence) { addRows(evidence, in, rows); }, in.event.evidence);
    if (const auto verdict = verdictOf(in.event); verdict && isWhatIf(*verdict))
        rows.row("decided by", "a what-if, whatever the numbers");
    return rows.take();
}

std::string sectionOf(const Event& event) {
    const auto* insert = std::get_if<InsertEvidence>(&event.evidence);
    return insert != nullptr && insert->corner ? "7.2"
                                               : std::string(stageSection(event.address.stage));
}

}  // namespace se::view
