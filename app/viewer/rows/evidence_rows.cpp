// A row compares what a decision was based on with its limit.

#include "evidence_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "run/model.h"
#include "run/repair_diff.h"
#include "run/selection.h"
#include "run/strings.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/stepper/rules.h"

namespace se::view {

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

/// Collects the rows of one event, one after the other.
class EvidenceRows {
  public:
    void row(std::string name, std::string value) {
        rows_.push_back({std::move(name), std::move(value), std::nullopt});
    }
    void row(std::string name, std::string value, const EvidenceGauge& gauge) {
        rows_.push_back({std::move(name), std::move(value), gauge});
    }
    /// An angle that must stay below a limit (or above it), and the margin.
    void angle(const std::string& name, double degrees, double limit, double largest = 360.0) {
        row(name, degreesText(degrees) + ", limit " + degreesText(limit),
            {degrees, limit, largest});
        row("margin", degreesText(std::abs(limit - degrees)) +
                          (degrees > limit ? " over" : " under") + " it");
    }
    /// A value whose sign decides; `scale` is a large value for comparison.
    void sign(const std::string& name, const std::string& value, double number, double scale) {
        // Zero in the middle.
        const double reach = std::max(std::abs(number), std::abs(scale));
        row(name, value, {number + reach, reach, 2.0 * reach});
    }
    std::vector<EvidenceRow> take() { return std::move(rows_); }

  private:
    std::vector<EvidenceRow> rows_;
};

/// "12, 34", or the letters of a figure; "none" for no point.
std::string pointsText(const std::vector<Index>& list, std::span<const PointName> names) {
    return joined(list, ", ", [&](Index p) { return nameOf(p, names); });
}

// Where a ring begins (section 4), at the walls (7), and the tests of 6.1 to 6.4.

void addRows(const SeedEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const auto list = in.model.points.neighbors[e.first];
    const auto nearer = std::find(list.begin(), list.end(), e.second) - list.begin();
    out.row("start point", pointsText({e.first}, in.names));
    out.row("its neighbor", pointsText({e.second}, in.names));
    out.row("distance", numberText(e.distance));
    out.row("nearer ones", nearer == 0 ? "none" : std::to_string(nearer) + ", none UNUSED");
    out.row("ring", "of two");
}

void addRows(const StrandEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const std::size_t listed = in.model.points.neighbors[e.point].size();
    out.row("point", pointsText({e.point}, in.names));
    out.row("why", e.isolated   ? "its list is empty"
                   : e.unseeded ? "neighbors are UNUSED, but no seed is left to try"
                                : "no neighbor left: all " + std::to_string(listed) + " are DONE");
}

void addRows(const PivotEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("first, last", pointsText({e.first, e.last}, in.names));
    out.row("ring", counted(e.ringLength, "point", "points"));
    out.row("free sector",
            degreesText(e.sectorDegrees) + (e.sectorDegrees > 180.0 ? ", over half a turn" : ""),
            {e.sectorDegrees, 180.0, 360.0});
}

/// Reason why a boundary point is no pivot.
std::string reasonToSkip(const EvidenceInput& in) {
    if (const auto* tried = in.picture.evidence<InsertEvidence>(Stage::Insert)) {
        return tried->verdict == Verdict::OtherSideOpen
                   ? "a third point would leave its other side open"
                   : "no UNUSED neighbor on the same wall fits";
    }
    if (in.picture.first == in.picture.last) return "the other ring point is not on a wall";
    return "the ring does not pass from wall to wall here";
}

/// §7.1: the components of the cross product toward the walls of p.
void addCross(const InsertEvidence& e, EvidenceRows& out) {
    out.row("N \xC3\x97 v", numbersText(e.cross));
    const double size = glm::length(e.cross);
    for (int face = 0; face < 6; ++face) {
        const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(face));
        if ((e.faces & bit) == 0) continue;
        const double component = (face < 3 ? 1.0 : -1.0) * e.cross[face % 3];
        out.sign("toward " + wallsText(bit),
                 signedText(component) + (component > 0.0 ? " > 0: out, before the pivot"
                                                          : " \xE2\x89\xA4 0: after the pivot"),
                 component, size);
    }
    const bool outward = pointsOut(e.cross, e.faces);
    if (isRimPoint(e.faces) || outward == (e.verdict == Verdict::Before)) return;
    out.row("but", std::string("the sector ") + (outward ? "before" : "after") +
                       " the pivot would leave the box: the other side");
}

/// §7.2: no cross product, but the ring neighbor on the other wall.
void addTransition(const InsertEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const PointSet& points = in.model.points;
    const bool entering =
        e.third == kNone ? e.other == in.picture.last : e.verdict == Verdict::Before;
    out.row("across", nameOf(e.other, in.names) + ", wall " + wallsText(points.type[e.other]));
    out.row("transition", entering ? "entering: the next ring point is across, so before it"
                                   : "leaving: the ring point before is across, so after it");
    out.row("cross product", "not computed in 7.2");
    if (e.third == kNone) return;
    const double sector = entering ? freeDegrees(points, e.third, e.pivot, e.other)
                                   : freeDegrees(points, e.other, e.pivot, e.third);
    out.angle("sector", sector, 180.0);
}

void addRows(const SkipEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("pivot", pointsText({e.pivot}, in.names));
    out.row("wall", wallsText(e.type) + (isCorner(e.type) ? ", a corner" : ""));
    out.row("why", reasonToSkip(in));
}

void addRows(const InsertEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("rule", e.corner ? "7.2, from wall to wall" : "7.1, two boundary points");
    out.row("wall of pivot", wallsText(e.faces) + (isCorner(e.faces) ? ", a corner" : ""));
    out.row("third point", pointsText({e.third}, in.names));
    if (e.corner) return addTransition(e, in, out);
    // Without a point to insert nothing is computed.
    e.third == kNone ? out.row("cross product", "not computed: no point to insert")
                     : addCross(e, out);
}

void addRows(const SortEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("point", pointsText({e.point}, in.names));
    if (e.verdict == Verdict::AlreadyDone || e.verdict == Verdict::OnRingEnd) {
        out.row("angle", "not computed: no candidate");
        return;
    }
    out.row("cosine z\xC2\xB7v", numberText(e.cosine));
    out.row("n\xC2\xB7v", e.secondHalf ? "< 0: second half, 360\xC2\xB0 \xE2\x88\x92 arccos"
                                       : "\xE2\x89\xA5 0: first half, arccos");
    out.angle("angle", e.degrees, e.endDegrees);
    if (e.rival != kNone) out.row("same angle as", nameOf(e.rival, in.names) + ", which is nearer");
}

/// The conditions of Fig. 4, in the order in which they are tested.
struct Condition {
    const char* name;
    Verdict failure;
};

constexpr std::array kConditions = {
    Condition{"not other end", Verdict::OtherLimit},  Condition{"mesh edge", Verdict::NotAnEdge},
    Condition{"listed by pivot", Verdict::NotListed}, Condition{"in the sector", Verdict::Outside},
    Condition{"ring concave", Verdict::NotConcave},
};

/// After a failed condition the later ones are not tested. A rule or a what-if may move start or
/// end where the ring is convex; which condition beyond that one a what-if overrides is not known.
void addConditions(const LimitEvidence& e, const Params& rules, EvidenceRows& out) {
    bool asked = true;
    const bool overridden = e.verdict == Verdict::WhatIfKept;
    const auto add = [&](const Condition& condition) {
        const bool failed = asked && e.verdict == condition.failure;
        const bool convex = condition.failure == Verdict::NotConcave && !(e.turn > 0.0);
        const bool passed = overridden && (condition.failure == Verdict::HalfTurn ||
                                           condition.failure == Verdict::Blocked);
        out.row(condition.name, !asked                 ? "not tested"
                                : failed               ? "no: it stays"
                                : convex && overridden ? "no"
                                : convex               ? "no, but its rule is off"
                                : passed               ? "overridden"
                                                       : "yes");
        asked = asked && !failed && !(convex && overridden);
    };
    for (const Condition& condition : kConditions) add(condition);
    if (rules.readings.belowHalfTurn) add({"below 180", Verdict::HalfTurn});
    if (rules.robust.unblocked) add({"way clear", Verdict::Blocked});
}

void addRows(const LimitEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const std::string side = e.side == Side::Start ? "start" : "end";
    out.row(side + ", next", pointsText({e.from, e.to}, in.names));
    const std::string from = degreesText(e.fromDegrees);
    if (!isMeasured(e)) {
        out.row("angle of " + side, from + ", stays");
    } else if (e.moves()) {
        out.row("angle of " + side, from + " \xE2\x86\x92 " + degreesText(e.toDegrees));
    } else {
        out.row("angle of " + side, from + ", stays; next " + degreesText(e.toDegrees));
    }
    addConditions(e, in.model.params, out);
    if (!isMeasured(e)) return;
    out.row("turn",
            signedText(e.turn) + (e.turn > 0.0 ? " > 0: concave" : " \xE2\x89\xA4 0: convex"));
    const Index p = in.picture.pivot;
    const bool start = e.side == Side::Start;
    out.angle("ring corner",
              freeDegrees(in.model.points, start ? e.to : p, e.from, start ? p : e.to), 180.0);
}

void addRows(const DropEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const DecisionState& picture = in.picture;
    const bool start = e.side == Side::Start;
    const std::string side = start ? "start" : "end";
    out.row("point", pointsText({e.point}, in.names));
    if (e.isLimit())
        return out.row("angle", degreesText(e.degrees) + ", where " + side + " is now");
    if (in.event.address.stage != Stage::Convex) {
        const double limit = start ? picture.startDegrees : picture.endDegrees;
        out.row("angle", degreesText(e.degrees) + ", " + side + " is at " + degreesText(limit),
                {e.degrees, limit, 360.0});
        const double over = start ? limit - e.degrees : e.degrees - limit;
        out.row("margin", degreesText(std::max(0.0, over)) + " outside");
        return;
    }
    const Index p = picture.pivot;
    const Index limit = start ? picture.start : picture.end;
    // A what-if drops points that are not next on the ring.
    const bool next = e.verdict != Verdict::WhatIfDropped;
    if (next) out.row("next on ring", "after " + side + " " + pointsText({limit}, in.names));
    out.row("angle", degreesText(e.degrees) + ", inside " + degreesText(picture.startDegrees) +
                         " to " + degreesText(picture.endDegrees));
    if (next)
        out.angle("corner at " + side,
                  freeDegrees(in.model.points, start ? e.point : p, limit, start ? p : e.point),
                  180.0);
    const double height = heightOver(in.model.points, p, e.point);
    const double distance =
        glm::length(in.model.points.position[e.point] - in.model.points.position[p]);
    out.row("height", signedText(height) + " out of the plane");
    if (distance > 0.0) out.row("of its distance", percentText(height / distance));
}

void addRows(const ReciprocalEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("point", pointsText({e.point}, in.names));
    out.row("its first, last", pointsText({e.succ, e.pred}, in.names));
    out.row("its sector", "0\xC2\xB0 to " + degreesText(e.limitDegrees));
    out.row("pivot seen at", degreesText(e.degrees), {e.degrees, e.limitDegrees, 360.0});
    // By the verdict where the test decided: the angles shown are rounded.
    const bool inside = e.verdict == Verdict::Kept ||
                        (e.verdict != Verdict::NotReciprocal && e.degrees < e.limitDegrees);
    // Outside: either way around to the sector.
    const double fromStart = inside ? e.degrees : std::min(e.degrees, 360.0 - e.degrees);
    const double margin = std::min(fromStart, std::abs(e.limitDegrees - e.degrees));
    out.row("margin", degreesText(margin) + (inside ? " inside" : " outside"));
    if (e.verdict == Verdict::WallComplete) {
        out.row("but", "both its ring neighbors share its wall");
    }
}

void addRows(const HoleEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("hole of " + std::to_string(e.edges),
            pointsText({in.picture.pivot, in.picture.start, in.picture.end}, in.names));
    if (e.point != kNone) out.row("point", pointsText({e.point}, in.names));
    const bool near = e.side * e.pivotSide > 0.0;
    out.sign("off the plane", signedText(e.side) + (near ? ", side of the pivot" : ", far side"),
             e.side, e.pivotSide);
    out.row("pivot off it", signedText(e.pivotSide));
    if (e.pivotSide != 0.0)
        out.row("margin", percentText(e.side / e.pivotSide) + " of the pivot's way");
}

const char* ruleOf(const SphereEvidence& e) {
    if (e.verdict == Verdict::InsideSphere)
        return e.distance < e.radius ? "d < r: kept, no second rule"
                                     : "on the sphere: kept, no second rule";
    if (e.verdict == Verdict::GapTooWide)
        return "d \xE2\x89\xA5 r, but the gap is over its limit: kept";
    if (e.verdict == Verdict::NoCircle) return "no circle: kept";
    return "d \xE2\x89\xA5 r, and the gap is small enough";
}

/// The effect of §6.4, by rule and what-if.
const char* twoPointEffect(const TwoPointEvidence& e) {
    if (isWhatIf(e.verdict))
        return isTaken(e.verdict) ? "one triangle is made" : "the ring is dropped";
    if (!isTaken(e.verdict)) return "overlap: the ring is dropped";
    return e.degrees > 180.0 ? "one triangle is made anyway" : "hole: filled by one triangle";
}

void addRows(const SphereEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("point", pointsText({e.q}, in.names));
    out.row("between", pointsText({e.t, e.s}, in.names));
    if (!isWhatIf(e.verdict)) out.row("decided by", ruleOf(e));
    if (hasSphere(e)) {
        const double over = e.distance - e.radius;
        out.row("radius r", numberText(e.radius));
        out.row("distance d", numberText(e.distance), {e.distance, e.radius, 2.0 * e.radius});
        out.row("margin d \xE2\x88\x92 r",
                signedText(over) + (over < 0.0                           ? ", inside"
                                    : e.verdict == Verdict::InsideSphere ? ", on it"
                                                                         : ", outside"));
        out.row("of r", percentText(over / e.radius));
    }
    out.angle("gap", e.gapDegrees, gapLimitDegrees(in.model.params));
}

void addRows(const TwoPointEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("first, last", pointsText({in.picture.first, in.picture.last}, in.names));
    out.angle("angle", e.degrees, 180.0);
    out.row("so", twoPointEffect(e));
}

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
    const std::size_t inserted =
        countWhere(changes, [](const RingEvidence& each) { return each.inserted; });
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
        return std::to_string(countWhere(
            triangles, [&](const Triangle& t) { return isFlipped(in.model.points, t); }));
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

namespace {

std::string valueText(const Reading& reading, double value) {
    return reading.unit.empty() ? numberText(value) : degreesText(value);
}

}  // namespace

std::string marginText(double margin) { return margin == 0.0 ? "0" : formatted("%+.2g", margin); }

std::string comparisonText(const Reading& reading, bool named) {
    return (named ? std::string(reading.quantity) + " " : std::string{}) +
           valueText(reading, reading.value) + " against " + valueText(reading, reading.threshold);
}

std::string readingText(const Reading& reading) {
    return comparisonText(reading, true) + ", margin " + marginText(reading.margin);
}

std::string lineText(const LedgerLine& line) {
    const std::string_view section = stageSection(line.event.address.stage);
    std::string text = toString(line.event.address) + "  " + std::string(roleName(line.role)) +
                       (line.pivot == kNone ? "" : "  pivot " + std::to_string(line.pivot)) +
                       (section.empty() ? "" : "  " + std::string(section)) + "  " +
                       describe(line.event);
    if (line.reading) text += "\n    " + readingText(*line.reading);
    return text;
}

std::string ledgerText(const std::string& answer, std::span<const LedgerLine> lines,
                       std::size_t cause) {
    std::string text = answer + "\n\n";
    for (std::size_t i = 0; i < lines.size(); ++i)
        text += (i == cause ? "> " : "  ") + lineText(lines[i]) + "\n";
    return text;
}

namespace {

std::string_view lastWord(std::string_view line) {
    const std::size_t blank = line.find_last_of(" \t");
    return blank == std::string_view::npos ? line : line.substr(blank + 1);
}

/// The literal part of a form: "stage=" of "stage=NAME", all of "kept".
std::string_view fixedPart(const QueryTerm& term) {
    const std::size_t sign = term.form.find_first_of("=<");
    return sign == std::string_view::npos ? term.form : term.form.substr(0, sign + 1);
}

/// True if one is a prefix of the other: "mar" and "margin<", "margin<1e" and "margin<".
bool agree(std::string_view word, std::string_view fixed) {
    return word.starts_with(fixed) || fixed.starts_with(word);
}

}  // namespace

std::vector<const QueryTerm*> termsFor(std::string_view line) {
    const std::string_view word = lastWord(line);
    std::vector<const QueryTerm*> all;
    std::vector<const QueryTerm*> fitting;
    for (const QueryTerm& term : queryTerms()) {
        all.push_back(&term);
        if (!word.empty() && agree(word, fixedPart(term))) fitting.push_back(&term);
    }
    return fitting.empty() ? all : fitting;
}

std::string completed(std::string_view line, const QueryTerm& term) {
    const std::string_view word = lastWord(line);
    const std::string_view fixed = fixedPart(term);
    std::string text(line.substr(0, line.size() - word.size()));
    // A complete word stays; the new one is added after it.
    if (!word.empty() && !agree(word, fixed)) text += std::string(word) + " ";
    const bool whole = fixed.size() == term.form.size();
    return text + std::string(fixed) + (whole ? " " : "");
}

}  // namespace se::view
