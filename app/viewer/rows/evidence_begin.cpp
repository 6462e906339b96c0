/// Rows of Inspect where a ring begins (§4) and at the walls (§7).
#include <algorithm>
#include <cmath>

#include "evidence_parts.h"
#include "spiraling_edge/stepper/rules.h"

namespace se::view {

void addRows(const SeedEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const auto list = in.model.points.neighbors[e.first];
    const auto nearer = std::find(list.begin(), list.end(), e.second) - list.begin();
    out.row("start point", pointsText({e.first}));
    out.row("its neighbor", pointsText({e.second}));
    out.row("distance", numberText(e.distance));
    out.row("nearer ones", nearer == 0 ? "none" : std::to_string(nearer) + ", all DONE");
    out.row("ring", "of two");
}

void addRows(const StrandEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const std::size_t listed = in.model.points.neighbors[e.point].size();
    out.row("point", pointsText({e.point}));
    out.row("why", e.isolated ? "its list is empty"
                              : "no neighbor left: all " + std::to_string(listed) + " are DONE");
}

void addRows(const PivotEvidence& e, const EvidenceInput&, EvidenceRows& out) {
    out.row("first, last", pointsText({e.first, e.last}));
    out.row("ring", countText(e.ringLength, "point"));
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
                 signedText(component) +
                     (component > 0.0 ? " > 0: out, before p" : " \xE2\x89\xA4 0: after p"),
                 component, size);
    }
    const bool outward = pointsOut(e.cross, e.faces);
    if (isRimPoint(e.faces) || outward == (e.verdict == Verdict::Before)) return;
    out.row("but", std::string("the sector ") + (outward ? "before" : "after") +
                       " p would leave the box: the other side");
}

/// §7.2: no cross product, but the ring neighbor on the other wall.
void addTransition(const InsertEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    const PointSet& points = in.model.points;
    const bool entering =
        e.third == kNone ? e.other == in.picture.last : e.verdict == Verdict::Before;
    out.row("across", std::to_string(e.other) + ", wall " + wallsText(points.type[e.other]));
    out.row("transition", entering ? "entering: the next ring point is across, so before p"
                                   : "leaving: the ring point before is across, so after p");
    out.row("cross product", "not computed in 7.2");
    if (e.third == kNone) return;
    const double sector = entering ? freeDegrees(points, e.third, e.pivot, e.other)
                                   : freeDegrees(points, e.other, e.pivot, e.third);
    out.angle("sector", sector, 180.0);
}

}  // namespace

void addRows(const SkipEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("pivot", pointsText({e.pivot}));
    out.row("wall", wallsText(e.type) + (isCorner(e.type) ? ", a corner" : ""));
    out.row("why", reasonToSkip(in));
}

void addRows(const InsertEvidence& e, const EvidenceInput& in, EvidenceRows& out) {
    out.row("rule", e.corner ? "7.2, from wall to wall" : "7.1, two boundary points");
    out.row("wall of p", wallsText(e.faces) + (isCorner(e.faces) ? ", a corner" : ""));
    out.row("third point", pointsText({e.third}));
    if (e.corner) return addTransition(e, in, out);
    // Without a point to insert nothing is computed.
    e.third == kNone ? out.row("cross product", "not computed: no point to insert")
                     : addCross(e, out);
}

}  // namespace se::view
