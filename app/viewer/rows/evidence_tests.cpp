/// Rows of Inspect where a ring begins (§4), at the walls (§7), and for the tests of §6.1 to §6.4.
#include <algorithm>
#include <array>

#include "evidence_parts.h"
#include "run/neighborhood.h"
#include "spiraling_edge/stepper/rules.h"

namespace se::view {

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

namespace {

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

}  // namespace

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

namespace {

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

}  // namespace

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
    const bool inside = e.degrees < e.limitDegrees;
    // Outside: either way around to the sector.
    const double margin = inside ? std::min(e.degrees, e.limitDegrees - e.degrees)
                                 : std::min(360.0 - e.degrees, e.degrees - e.limitDegrees);
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

namespace {

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

}  // namespace

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

}  // namespace se::view
