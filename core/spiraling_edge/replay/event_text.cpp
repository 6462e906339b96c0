/// Every decision as one plain sentence with its numbers, for the event list, `why` and golden
/// logs. One overload of text() per kind of evidence.
#include <cstdio>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/replay/reading.h"
#include "spiraling_edge/stepper/event.h"

namespace se {
namespace {

/// Degrees with one digit after the point, which hides rounding differences between machines.
std::string deg(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.1f", value == 0.0 ? 0.0 : value);
    return std::string(buffer) + " deg";
}
std::string str(Index value) { return value == kNone ? "none" : std::to_string(value); }
std::string str(std::string_view text) { return std::string(text); }

std::string sideName(Side side) { return side == Side::Start ? "start" : "end"; }

std::string faceNames(std::uint8_t faces) {
    constexpr std::array<std::string_view, 6> kNames{"+x", "+y", "+z", "-x", "-y", "-z"};
    std::string text;
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if ((faces >> i & 1U) == 0) continue;
        if (!text.empty()) text += ' ';
        text += kNames[i];
    }
    return text;
}

std::string counted(Index count, std::string_view singular) {
    return std::to_string(count) + ' ' + str(singular) + (count == 1 ? "" : "s");
}

std::string text(const SeedEvidence& e) {
    return "A new edge ring of two: point " + str(e.first) + " and its nearest neighbor " +
           str(e.second) + ", " + sixDigits(e.distance) + " away.";
}
std::string text(const StrandEvidence& e) {
    return "Point " + str(e.point) +
           (e.isolated ? " has no neighbors: isolated, marked DONE."
                       : " has only DONE neighbors: stranded, marked DONE.");
}
std::string text(const PivotEvidence& e) {
    return "Pivot " + str(e.pivot) + " between first = " + str(e.first) +
           " and last = " + str(e.last) + "; free sector " + deg(e.sectorDegrees) + ", ring of " +
           std::to_string(e.ringLength) + ".";
}
std::string text(const SkipEvidence& e) {
    const std::string where =
        isRimPoint(e.type) ? "on a rim of the surface" : "on wall " + faceNames(e.type);
    return "Point " + str(e.pivot) + " lies " + where + ": passed over, it stays on the ring.";
}
/// §7.1 and §7.2 for a rim point.
std::string rimText(const InsertEvidence& e) {
    const std::string where =
        e.corner ? "Beside the gap of rim point " + str(e.pivot)
                 : "On the ring of two boundary points " + str(e.pivot) + " and " + str(e.other);
    if (e.verdict == Verdict::NoThirdPoint)
        return where + " no next point of the rim is UNUSED: passed over.";
    return where + ", point " + str(e.third) + ", the next on the rim, joins the ring " +
           (e.verdict == Verdict::Before ? "before" : "after") + " the pivot.";
}
std::string text(const InsertEvidence& e) {
    if (isRimPoint(e.faces)) return rimText(e);
    const std::string where =
        e.corner ? "At the corner between " + str(e.pivot) + " and " + str(e.other)
                 : "On the ring of two boundary points " + str(e.pivot) + " and " + str(e.other);
    if (e.verdict == Verdict::NoThirdPoint) {
        return where + " no UNUSED neighbor on the same wall fits: passed over.";
    }
    if (e.verdict == Verdict::OtherSideOpen) {
        return where + " a third point would end the pivot with its other side open: passed over.";
    }
    std::string result = where + ", point " + str(e.third) + " joins the ring " +
                         (e.verdict == Verdict::Before ? "before" : "after") + " the pivot";
    if (!e.corner) {
        result += "; normal x vector = (" + sixDigits(e.cross.x) + ", " + sixDigits(e.cross.y) +
                  ", " + sixDigits(e.cross.z) + ") on wall " + faceNames(e.faces);
    }
    return result + ".";
}
std::string text(const SortEvidence& e) {
    const std::string at = "Point " + str(e.point) + " at " + deg(e.degrees);
    switch (e.verdict) {
        case Verdict::AlreadyDone:
            return "Point " + str(e.point) + " is DONE: no candidate.";
        case Verdict::OnRingEnd:
            return "Point " + str(e.point) + " is first or last itself: no candidate.";
        case Verdict::NotAfterStart:
            return at + " is not after the start: left out.";
        case Verdict::NotBeforeEnd:
            return at + " is not before last at " + deg(e.endDegrees) + ": left out.";
        case Verdict::SameAngle:
            return at + " has the same angle as " + str(e.rival) + ", which is " +
                   (e.farther ? "nearer" : "farther") + ": dropped.";
        default:
            return at + " of " + deg(e.endDegrees) + ": a candidate.";
    }
}
std::string text(const LimitEvidence& e) {
    const std::string point =
        "Point " + str(e.to) + " beyond " + sideName(e.side) + " = " + str(e.from);
    switch (e.verdict) {
        case Verdict::Moved:
            return point + " is listed, inside the limits, and the ring is " +
                   (e.turn > 0.0
                        ? "concave there (turn " + sixDigits(e.turn) + "): "
                        : "convex there (turn " + sixDigits(e.turn) + "), no obstacle now: ") +
                   sideName(e.side) + " moves from " + deg(e.fromDegrees) + " to " +
                   deg(e.toDegrees) + ".";
        case Verdict::OtherLimit:
            return point + " is the other end: " + sideName(e.side) + " stays.";
        case Verdict::NotAnEdge:
            return point + " is not joined to it by an edge: " + sideName(e.side) + " stays.";
        case Verdict::NotListed:
            return point + " is not among the pivot's neighbors: " + sideName(e.side) + " stays.";
        case Verdict::Outside:
            return point + " at " + deg(e.toDegrees) +
                   " is outside the limits: " + sideName(e.side) + " stays.";
        case Verdict::Blocked:
            return point +
                   ": an UNUSED neighbor lies in the triangle's sphere: " + sideName(e.side) +
                   " stays.";
        default:
            return point + ": the ring is convex there (turn " + sixDigits(e.turn) +
                   "): " + sideName(e.side) + " stays.";
    }
}
std::string text(const DropEvidence& e) {
    if (e.isLimit()) {
        return "Candidate " + str(e.point) + " at " + deg(e.degrees) + " is now " +
               sideName(e.side) + ".";
    }
    if (e.verdict == Verdict::Outside) {
        return "Candidate " + str(e.point) + " at " + deg(e.degrees) + " is outside the moved " +
               sideName(e.side) + ": removed.";
    }
    return "Candidate " + str(e.point) + " is next on the ring behind a convex " +
           sideName(e.side) + ": removed.";
}
std::string text(const ReciprocalEvidence& e) {
    return "Seen from ring point " + str(e.point) + " (between " + str(e.pred) + " and " +
           str(e.succ) + ") the pivot is at " + deg(e.degrees) +
           (e.printed ? ", the sector from efirst to elast " : ", its free sector ") +
           deg(e.limitDegrees) +
           (e.verdict == Verdict::Kept           ? ": inside, kept."
            : e.verdict == Verdict::WallComplete ? "; it is complete along its walls: refused."
                                                 : ": outside, refused.");
}
/// "three", "12".
std::string spelled(Index count) {
    constexpr std::array<std::string_view, 9> kWords{"none", "one", "two",   "three", "four",
                                                     "five", "six", "seven", "eight"};
    return count < kWords.size() ? str(kWords[count]) : std::to_string(count);
}
std::string text(const HoleEvidence& e) {
    return "Hole of " + spelled(e.edges) + ": point " + str(e.point) + " is " + sixDigits(e.side) +
           " from the plane through start and end, the pivot " + sixDigits(e.pivotSide) +
           (e.verdict == Verdict::Kept ? ": same side, kept." : ": far side, removed.");
}
std::string text(const SphereEvidence& e) {
    const std::string q = "q = " + str(e.q);
    const std::string circle = "of the pivot, t = " + str(e.t) + " and s = " + str(e.s);
    if (e.verdict == Verdict::NoCircle) {
        return q + " is kept: there is no circle " + circle + ", they lie in line.";
    }
    const double d = e.distance - e.radius;
    if (e.verdict == Verdict::InsideSphere && !(d < 0.0))
        return q + " lies on the sphere " + circle + " (r = " + sixDigits(e.radius) + "): kept.";
    const std::string place = q + " lies " + sixDigits(d < 0 ? -d : d) +
                              (d < 0 ? " inside" : " outside") + " the sphere " + circle +
                              " (d = " + sixDigits(e.distance) + ", r = " + sixDigits(e.radius) +
                              ")";
    if (e.verdict == Verdict::InsideSphere) return place + ": kept.";
    const std::string gap = ", and removing it leaves a gap of " + deg(e.gapDegrees);
    return place + gap +
           (e.verdict == Verdict::GapTooWide ? ", more than the limit: kept." : ": removed.");
}
std::string text(const TwoPointEvidence& e) {
    const std::string text = "Only first and last are left, " + deg(e.degrees) + " apart";
    const bool over = e.degrees > 180.0;
    if (e.verdict == Verdict::Discarded)
        return text + (over ? ": over 180, the ring is discarded."
                            : ": not under 180, the ring is discarded.");
    return text + (over ? ": over 180 degrees, but a triangle is made anyway."
                        : ": under 180, one triangle closes the gap.");
}
std::string text(const GuardEvidence& e) {
    const std::string what =
        e.b == kNone ? "Spoke to " + str(e.a) : "Triangle over " + str(e.a) + " and " + str(e.b);
    return what + ": " + str(verdictText(e.verdict)) +
           (e.dropped == kNone ? ": the fan is refused."
                               : ": candidate " + str(e.dropped) + " is dropped.");
}
std::string text(const FillEvidence& e) {
    return "Hole of " + std::to_string(e.ringLength) + ": the ear at " + str(e.pivot) +
           " between " + str(e.first) + " and " + str(e.last) + " has the best least angle, " +
           deg(e.leastDegrees) + (e.forced ? "; no ear without a fault was left." : ".");
}
std::string text(const ReinsertEvidence& e) {
    return "Stranded point " + str(e.point) + " goes into the triangle it lies over.";
}
std::string text(const RemoveFoldedEvidence& e) {
    return "Point " + str(e.point) + " has a flipped triangle: taken out, its hole is closed.";
}
std::string text(const FlipEvidence& e) {
    return "Edge " + str(e.u) + " - " + str(e.v) + " is better as " + str(e.x) + " - " + str(e.y) +
           ": flipped.";
}
std::string text(const EmitEvidence& e) {
    return "Triangle " + str(e.triangle) + " = (" + str(e.corners.a) + ", " + str(e.corners.b) +
           ", " + str(e.corners.c) + ").";
}
std::string text(const RingEvidence& e) {
    const std::string status =
        e.status < 0 ? "DONE" : (e.status == 0 ? "UNUSED" : "USED " + std::to_string(e.status));
    return "Point " + str(e.point) + (e.inserted ? " enters" : " leaves") + " the ring: now " +
           status + ".";
}
std::string text(const SplitEvidence& e) {
    return "Point " + str(e.point) +
           " is met again in the same ring, which splits: " + std::to_string(e.activeLength) +
           " entries go on, " + std::to_string(e.stackedLength) + " go on the stack (depth " +
           std::to_string(e.stackDepth) + ").";
}
std::string text(const JoinEvidence& e) {
    return "Point " + str(e.point) + " is met again in " +
           (e.depthFromTop == kNone
                ? str("the active ring")
                : "stacked ring " + std::to_string(e.depthFromTop + 1) + " from the top") +
           ": the rings join, " + std::to_string(e.length) + " entries.";
}
std::string text(const CloseEvidence& e) {
    if (e.b == kNone) return "A lone entry of point " + str(e.a) + " is left: closed.";
    return "The ring of " + str(e.a) + " and " + str(e.b) + " is one finished edge: closed.";
}
std::string text(const AdvanceEvidence& e) {
    if (e.to == kNone) return "No ring is left.";
    if (e.whatIf) return "What if: the next pivot is " + str(e.to) + ".";
    if (e.popped) return "The next ring comes off the stack; the next pivot is " + str(e.to) + ".";
    if (e.circuit == 0) return "The next pivot is " + str(e.to) + ".";
    return "No triangle; the next pivot is " + str(e.to) + " (" + counted(e.circuit, "pivot") +
           " without one).";
}
std::string text(const FreeEvidence& e) {
    return "A full circuit of " + std::to_string(e.length) +
           " without a triangle: the ring is freed" +
           (e.interior == 0 ? str(".")
                            : ", with " + counted(e.interior, "interior point") + " on it.");
}
std::string text(const ComponentEvidence& e) {
    return "Component " + std::to_string(e.component) + " is complete; " +
           counted(e.triangles, "triangle") + " so far.";
}
std::string text(const AlertEvidence& e) {
    switch (e.kind) {
        case AlertKind::TriangleCap:
            return "Alert: too many triangles for the number of points; the run is stopped.";
        case AlertKind::Hole:
            return "Alert: a hole is left open at point " + str(e.point) + ".";
        case AlertKind::LostSeed:
            return "Alert: the ring begun at point " + str(e.point) + " got no triangle.";
    }
    return {};
}

}  // namespace

namespace {

std::string fanText(const GuardEvidence& e, bool kept) {
    if (!kept) return "What if: no triangle is made.";
    return (e.b == kNone ? "What if: the spoke to " + str(e.a)
                         : "What if: the triangle over " + str(e.a) + " and " + str(e.b)) +
           " is made, whatever the rules on fans say.";
}

/// The end of a sentence about a what-if that overrides the numbers; empty without one.
template <typename Evidence>
std::string whatIfText(const Evidence& e, const Event& event) {
    if constexpr (requires { e.verdict; }) {
        const bool kept = e.verdict == Verdict::WhatIfKept;
        if (!kept && e.verdict != Verdict::WhatIfDropped) return {};
        if (event.address.stage == Stage::TwoPoint) {
            return kept ? "What if: the triangle is made." : "What if: no triangle is made.";
        }
        const std::string point = "What if: point " + str(testedPoint(event));
        if constexpr (std::is_same_v<Evidence, LimitEvidence>)
            return point +
                   (kept ? " is advanced to, whatever the test says." : " is not advanced to.");
        if constexpr (std::is_same_v<Evidence, GuardEvidence>) return fanText(e, kept);
        return point + (kept ? " is kept" : " is dropped") + ", whatever the test says.";
    }
    return {};
}

}  // namespace

std::string describe(const Event& event) {
    return std::visit(
        [&](const auto& evidence) {
            const std::string whatIf = whatIfText(evidence, event);
            return whatIf.empty() ? text(evidence) : whatIf;
        },
        event.evidence);
}

std::string_view endingText(const Event& event) {
    const auto verdict = verdictOf(event);
    return verdict ? verdictText(*verdict) : std::string_view{};
}

std::string_view alertName(AlertKind kind) {
    switch (kind) {
        case AlertKind::TriangleCap:
            return "triangle_cap";
        case AlertKind::Hole:
            return "hole";
        case AlertKind::LostSeed:
            return "lost_seed";
    }
    return {};
}

}  // namespace se
