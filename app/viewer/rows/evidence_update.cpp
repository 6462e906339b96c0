/// Rows of Inspect for the effects of a pivot: triangles (§6.4), ring (§6.5), end (§3, §7).
#include <algorithm>

#include "evidence_parts.h"

namespace se::view {

void addRows(const EmitEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const PointSet& points = in.model.points;
    out.row("triangle", std::to_string(e.triangle));
    out.row("of this pivot", "number " + std::to_string(in.picture.newTriangles.size()));
    out.row("corners", pointsText({e.corners.a, e.corners.b, e.corners.c}));
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

namespace {

std::string lengthOf(const std::vector<RingPath>& rings) {
    if (rings.empty() || !rings.front().active) return "none";
    return std::to_string(rings.front().points.size());
}

std::size_t stacked(const std::vector<RingPath>& rings) {
    return static_cast<std::size_t>(
        std::count_if(rings.begin(), rings.end(), [](const RingPath& r) { return !r.active; }));
}

}  // namespace

void addRows(const RingEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const auto& changes = in.picture.ringChanges;
    const auto inserted = static_cast<std::size_t>(std::count_if(
        changes.begin(), changes.end(), [](const RingEvidence& each) { return each.inserted; }));
    out.row("point", pointsText({e.point}));
    out.row("change", e.inserted ? "inserted" : "removed");
    const int before = e.inserted ? e.status - 1 : std::max(e.status, 0) + 1;
    out.row("ring entries", std::to_string(before) + " \xE2\x86\x92 " +
                                (e.status == kDone ? "0: DONE" : std::to_string(e.status)));
    out.row("so far", std::to_string(changes.size() - inserted) + " removed, " +
                          std::to_string(inserted) + " inserted");
    out.row("ring length",
            lengthOf(in.picture.oldRings) + " \xE2\x86\x92 " + lengthOf(in.picture.rings) + " now");
}

void addRows(const SplitEvidence& e, const EvidenceInput&, EvidenceRows& out) {
    out.row("at point", pointsText({e.point}));
    out.row("met again", "in the same ring");
    out.row("continues", countText(e.activeLength, "point"));
    out.row("to the stack", countText(e.stackedLength, "point"));
    out.row("stack depth", std::to_string(e.stackDepth));
}

void addRows(const JoinEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("at point", pointsText({e.point}));
    out.row("met again", e.depthFromTop == kNone ? "in the active ring"
                                                 : "in #" + std::to_string(e.depthFromTop + 1) +
                                                       " of the stack, searched from the top");
    out.row("joined ring", countText(e.length, "point"));
    out.row("stack depth", std::to_string(stacked(in.picture.rings)));
}

void addRows(const CloseEvidence& e, const EvidenceInput&, EvidenceRows& out) {
    e.b == kNone ? out.row("lone entry", pointsText({e.a}))
                 : out.row("ring of two", pointsText({e.a, e.b}));
    out.row("so", "it is a finished edge: closed");
}

void addRows(const AdvanceEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("next pivot", e.to == kNone ? "none: no ring is left" : std::to_string(e.to));
    if (e.popped) out.row("ring", "taken off the stack");
    const std::vector<RingPath>& rings = in.picture.rings;
    const bool active = !rings.empty() && rings.front().active;
    const double circuit = e.circuit;
    if (e.circuit == 0 || !active) return;
    const auto length = static_cast<double>(rings.front().points.size());
    out.row("no triangle", "for " + countText(e.circuit, "pivot"),
            {circuit, length, std::max(circuit, length)});
    out.row("full circuit", countText(rings.front().points.size(), "pivot"));
}

void addRows(const FreeEvidence& e, const EvidenceInput&, EvidenceRows& out) {
    out.row("ring", countText(e.length, "point") + ", freed");
    out.row("on walls", std::to_string(e.length - e.interior));
    out.row("interior", std::to_string(e.interior) +
                            (e.interior == 0 ? ": the surface ends here" : ": something is open"));
}

namespace {

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

}  // namespace

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

namespace {

const char* meaningOf(AlertKind kind) {
    switch (kind) {
        case AlertKind::TriangleCap:
            return "too many triangles: the run is stopped";
        case AlertKind::Hole:
            return "a hole stays open";
        case AlertKind::LostSeed:
            return "the seed got no triangle";
    }
    return "";
}

}  // namespace

void addRows(const AlertEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("alert", meaningOf(e.kind));
    if (e.point != kNone) out.row("point", pointsText({e.point}));
    if (e.kind == AlertKind::TriangleCap) {
        const auto per = static_cast<double>(in.picture.finishedTriangles) /
                         static_cast<double>(std::max<std::size_t>(1, in.model.points.size()));
        out.row("per point", numberText(per) + " triangles, limit " +
                                 numberText(in.model.params.maxTrianglesPerPoint));
    }
    if (!in.picture.freed) return;
    const ShownFreedRing& ring = *in.picture.freed;
    out.row("freed ring", countText(ring.path.points.size(), "point"));
    if (ring.told) out.row("interior", std::to_string(ring.told->interior));
}

}  // namespace se::view
