/// Every decision as one plain sentence with its numbers, for the event list, `why` and golden
/// logs. One overload of text() per kind of evidence.
#include "spiraling_edge/run/event_text.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/stepper/rules.h"

namespace se {
namespace {

/// Degrees with one digit after the point, which hides rounding differences between machines.
std::string deg(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.1f", value == 0.0 ? 0.0 : value);
    return std::string(buffer) + " deg";
}
/// The names of points in a sentence.
class Names {
  public:
    explicit Names(std::span<const PointName> names) : names_(names) {}
    std::string operator()(Index point) const { return nameOf(point, names_); }

    /// "first = 46"; the role alone where it is the name of the point.
    std::string as(std::string_view role, Index point) const {
        const std::string name = nameOf(point, names_);
        return name == role ? name : std::string(role) + " = " + name;
    }
    /// The letters of the sphere's measures (Fig. 8), or their words where a point has one of these
    /// letters as its name.
    std::string distance() const { return lettersAreFree() ? "d" : "distance"; }
    std::string radius() const { return lettersAreFree() ? "r" : "radius"; }

  private:
    bool lettersAreFree() const {
        return std::none_of(names_.begin(), names_.end(), [](const PointName& each) {
            return each.name == "c" || each.name == "d" || each.name == "r";
        });
    }

    std::span<const PointName> names_;
};

std::string str(Index value) { return std::to_string(value); }
std::string str(double value) { return sixDigits(value); }
std::string str(std::string_view text) { return std::string(text); }

/// `form` with each "{}" replaced by the next of `parts`.
template <typename... Parts>
std::string sentence(std::string_view form, const Parts&... parts) {
    std::string text;
    const auto add = [&](const std::string& part) {
        const std::size_t gap = form.find("{}");
        assert(gap != std::string_view::npos);
        text.append(form.substr(0, gap)).append(part);
        form.remove_prefix(gap + 2);
    };
    (add(str(parts)), ...);
    return text.append(form);
}

std::string sideName(Side side) { return side == Side::Start ? "start" : "end"; }

std::string faceNames(std::uint8_t faces) {
    constexpr std::array<std::string_view, 6> kNames{"+x", "+y", "+z", "-x", "-y", "-z"};
    std::string text;
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if ((faces >> i & 1U) != 0) text.append(text.empty() ? "" : " ").append(kNames[i]);
    }
    return text;
}

std::string text(const SeedEvidence& e, const Names& names) {
    return sentence(
        "A new edge ring of two: point {} and its nearest UNUSED neighbor {}, "
        "{} away.",
        names(e.first), names(e.second), e.distance);
}
std::string text(const StrandEvidence& e, const Names& names) {
    return sentence(e.isolated   ? "Point {} has no neighbors: isolated, marked DONE."
                    : e.unseeded ? "Point {} has UNUSED neighbors, but no seed is left to try: "
                                   "stranded, marked DONE."
                                 : "Point {} has only DONE neighbors: stranded, marked DONE.",
                    names(e.point));
}
std::string text(const PivotEvidence& e, const Names& names) {
    return sentence("Pivot {} between {} and {}; free sector {}, ring of {}.", names(e.pivot),
                    names.as("first", e.first), names.as("last", e.last), deg(e.sectorDegrees),
                    e.ringLength);
}
std::string text(const SkipEvidence& e, const Names& names) {
    return sentence(
        "Point {} lies {}: passed over, it stays on the ring.", names(e.pivot),
        isRimPoint(e.type) ? "on a rim of the surface" : "on wall " + faceNames(e.type));
}
/// §7.1 and §7.2: where a third point is looked for.
std::string insertPlace(const InsertEvidence& e, const Names& names) {
    if (!e.corner)
        return sentence("On the ring of two boundary points {} and {}", names(e.pivot),
                        names(e.other));
    if (isRimPoint(e.faces)) return sentence("Beside the gap of rim point {}", names(e.pivot));
    return sentence("At the corner between {} and {}", names(e.pivot), names(e.other));
}
std::string text(const InsertEvidence& e, const Names& names) {
    const std::string where = insertPlace(e, names);
    const bool rim = isRimPoint(e.faces);
    if (e.verdict == Verdict::NoThirdPoint)
        return where + (rim ? " no next point of the rim is UNUSED."
                            : " no UNUSED neighbor on the same wall fits.");
    if (e.verdict == Verdict::OtherSideOpen && !rim)
        return where + " a third point would end the pivot with its other side open.";
    const std::string result = sentence("{}, point {}{} joins the ring {} the pivot", where,
                                        names(e.third), rim ? ", the next on the rim," : "",
                                        e.verdict == Verdict::Before ? "before" : "after");
    if (rim || e.corner) return result + ".";
    const bool isBySide = pointsOut(e.cross, e.faces) == (e.verdict == Verdict::Before);
    return sentence("{}; cross product = ({}, {}, {}) on wall {}{}.", result, e.cross.x, e.cross.y,
                    e.cross.z, faceNames(e.faces),
                    isBySide ? "" : ", but on the other side the sector would leave the box");
}
std::string text(const SortEvidence& e, const Names& names) {
    const std::string at = sentence("Point {} at {}", names(e.point), deg(e.degrees));
    switch (e.verdict) {
        case Verdict::AlreadyDone:
            return sentence("Point {} is DONE: no candidate.", names(e.point));
        case Verdict::OnRingEnd:
            return sentence("Point {} is first or last itself: no candidate.", names(e.point));
        case Verdict::NotAfterStart:
            return at + " is not after the start: left out.";
        case Verdict::NotBeforeEnd:
            return sentence("{} is not before last at {}: left out.", at, deg(e.endDegrees));
        case Verdict::SameAngle:
            return sentence("{} has the same angle as {}, which is {}: dropped.", at,
                            names(e.rival),
                            e.farther > 0.0   ? "nearer"
                            : e.farther < 0.0 ? "farther"
                                              : "as near");
        default:
            return sentence("{} of {}: a candidate.", at, deg(e.endDegrees));
    }
}
std::string text(const LimitEvidence& e, const Names& names) {
    const std::string side = sideName(e.side);
    const std::string point = sentence("Point {} beyond {}", names(e.to), names.as(side, e.from));
    const std::string stays = ": " + side + " stays.";
    switch (e.verdict) {
        case Verdict::Moved:
            return sentence(e.turn > 0.0
                                ? "{} is listed, inside the limits, and the ring is "
                                  "concave there (turn {}): {} moves from {} to {}."
                                : "{} is listed, inside the limits, and the ring is convex "
                                  "there (turn {}), no obstacle now: {} moves from {} to "
                                  "{}.",
                            point, e.turn, side, deg(e.fromDegrees), deg(e.toDegrees));
        case Verdict::OtherLimit:
            return point + " is the other end" + stays;
        case Verdict::NotAnEdge:
            return point + " is not joined to it by an edge" + stays;
        case Verdict::NotListed:
            return point + " is not among the pivot's neighbors" + stays;
        case Verdict::Outside:
            return sentence("{} at {} is outside the limits", point, deg(e.toDegrees)) + stays;
        case Verdict::HalfTurn:
            return sentence("{} at {}: the triangle would span 180 degrees or more and be inverted",
                            point, deg(e.toDegrees)) +
                   stays;
        case Verdict::Blocked:
            return sentence("{}: neighbor {} lies in the triangle's sphere", point,
                            names(e.blocker)) +
                   stays;
        default:
            return sentence("{}: the ring is convex there (turn {})", point, e.turn) + stays;
    }
}
std::string text(const DropEvidence& e, const Names& names) {
    const std::string side = sideName(e.side);
    if (e.isLimit())
        return sentence("Candidate {} at {} is now {}.", names(e.point), deg(e.degrees), side);
    if (e.verdict == Verdict::Outside)
        return sentence("Candidate {} at {} is outside the moved {}: removed.", names(e.point),
                        deg(e.degrees), side);
    const std::string_view reason =
        e.verdict == Verdict::BeyondConvex     ? "the ring is convex there"
        : e.verdict == Verdict::BeyondHalfTurn ? "the triangle would span 180 degrees or more"
        : e.verdict == Verdict::BeyondBlocked  ? "a neighbor lies in the triangle's sphere"
                                               : "it did not move there";
    return sentence("Candidate {} is next on the ring beyond {}, and {}: removed.", names(e.point),
                    side, reason);
}
std::string text(const ReciprocalEvidence& e, const Names& names) {
    return sentence(
        "Seen from ring point {} (between {} and {}) the pivot is at {}, {} {}{}", names(e.point),
        names(e.pred), names(e.succ), deg(e.degrees),
        e.printed ? "the sector from efirst to elast" : "its free sector", deg(e.limitDegrees),
        e.verdict == Verdict::Kept           ? ": inside, kept."
        : e.verdict == Verdict::WallComplete ? "; it is complete along its walls: refused."
                                             : ": outside, refused.");
}
/// "three", "12".
std::string spelled(Index count) {
    constexpr std::array<std::string_view, 9> kWords{"none", "one", "two",   "three", "four",
                                                     "five", "six", "seven", "eight"};
    return count < kWords.size() ? str(kWords[count]) : std::to_string(count);
}
std::string text(const HoleEvidence& e, const Names& names) {
    return sentence(
        "Hole of {}: point {} is {} from the plane through start and end, the pivot {}: {}.",
        spelled(e.edges), names(e.point), e.side, e.pivotSide,
        e.verdict == Verdict::Kept ? "same side, kept" : "not the same side, removed");
}
std::string text(const SphereEvidence& e, const Names& names) {
    const std::string circle = sentence("of the pivot, {} and {}", names(e.t), names(e.s));
    if (e.verdict == Verdict::NoCircle)
        return sentence("Point {} is kept: there is no circle {}, they lie in line.", names(e.q),
                        circle);
    // As near as rounding is on the sphere, whatever side the rule took it for.
    constexpr double kRounding = 1e-12;
    const double d = e.distance - e.radius;
    const bool isOn =
        std::abs(d) <= kRounding * e.radius || (e.verdict == Verdict::InsideSphere && !(d < 0.0));
    const std::string place =
        isOn ? sentence("Point {} lies on the sphere {} ({} = {})", names(e.q), circle,
                        names.radius(), e.radius)
             : sentence("Point {} lies {} {} the sphere {} ({} = {}, {} = {})", names(e.q),
                        d < 0 ? -d : d, d < 0 ? "inside" : "outside", circle, names.distance(),
                        e.distance, names.radius(), e.radius);
    if (e.verdict == Verdict::InsideSphere) return place + ": kept.";
    return sentence(
        "{}, and removing it leaves a gap of {}{}", place, deg(e.gapDegrees),
        e.verdict == Verdict::GapTooWide ? ", more than the limit: kept." : ": removed.");
}
std::string text(const TwoPointEvidence& e, const Names&) {
    if (e.onePoint)
        return "Only first and last are left, and they are one point: the ring is discarded.";
    const bool over = e.degrees > 180.0;
    const bool isPrintedHalf = e.degrees > 179.94;  // As 180.0.
    const char* const ending =
        e.verdict == Verdict::Discarded
            ? (over ? "over 180, the ring is discarded" : "not under 180, the ring is discarded")
            : (over            ? "over 180 degrees, but a triangle is made anyway"
               : isPrintedHalf ? "not over 180, one triangle closes the gap"
                               : "under 180, one triangle closes the gap");
    return sentence("Only first and last are left, {} apart: {}.", deg(e.degrees), ending);
}
std::string text(const GuardEvidence& e, const Names& names) {
    const std::string what = e.b == kNone
                                 ? sentence("Spoke to {}", names(e.a))
                                 : sentence("Triangle over {} and {}", names(e.a), names(e.b));
    return sentence("{}: {}: ", what, verdictText(e.verdict)) +
           (e.dropped == kNone ? "the fan is refused."
                               : sentence("candidate {} is dropped.", names(e.dropped)));
}
std::string text(const FillEvidence& e, const Names& names) {
    return sentence(e.forced ? "Hole of {}: the ear at {} between {} and {} has the fewest faults, "
                               "and a least angle of {}; none without one is left."
                             : "Hole of {}: the ear at {} between {} and {} has the best least "
                               "angle of those without a fault, {}.",
                    e.ringLength, names(e.pivot), names(e.first), names(e.last),
                    deg(e.leastDegrees));
}
std::string text(const ReinsertEvidence& e, const Names& names) {
    if (e.replaced == 0)
        return sentence("Stranded point {} is put in beside the border.", names(e.point));
    return sentence("Stranded point {} is put in, in place of {}.", names(e.point),
                    counted(e.replaced, "triangle"));
}
std::string text(const DropPatchEvidence& e, const Names& names) {
    if (e.kept > 0)
        return sentence("Point {} keeps its fan of {}; its other fans, {}, are taken out.",
                        names(e.point), counted(e.kept, "triangle"),
                        counted(e.triangles, "triangle"));
    return sentence("A component of {} at point {} lies beside a larger one: taken out.",
                    counted(e.triangles, "triangle"), names(e.point));
}
std::string text(const CloseHoleEvidence& e, const Names& names) {
    return sentence("The hole of {} points at {} - {} is filled.", e.length, names(e.first),
                    names(e.second));
}
std::string text(const RemeshEvidence& e, const Names& names) {
    return sentence("Triangle ({}, {}, {}) has a fault: those about it are replaced.",
                    names(e.faulty.a), names(e.faulty.b), names(e.faulty.c));
}
std::string text(const FlipEvidence& e, const Names& names) {
    return sentence("Edge {} - {} is better as {} - {}, by {}: flipped.", names(e.u), names(e.v),
                    names(e.x), names(e.y), e.forAngles ? "its least angle" : "fewer faults there");
}
std::string text(const EmitEvidence& e, const Names& names) {
    const Triangle& t = e.corners;
    return sentence("Triangle {} = ({}, {}, {}).", e.triangle, names(t.a), names(t.b), names(t.c));
}
std::string text(const RingEvidence& e, const Names& names) {
    const std::string status =
        e.status < 0 ? "DONE" : (e.status == 0 ? "UNUSED" : "USED " + std::to_string(e.status));
    return sentence("Point {} {} the ring: now {}.", names(e.point),
                    e.inserted ? "enters" : "leaves", status);
}
std::string text(const SplitEvidence& e, const Names& names) {
    return sentence(
        "Point {} is met again in the same ring, which splits: {} entries go on, {} go on the "
        "stack (depth {}).",
        names(e.point), e.activeLength, e.stackedLength, e.stackDepth);
}
std::string text(const JoinEvidence& e, const Names& names) {
    return sentence("Point {} is met again in {}: the rings join, {} entries.", names(e.point),
                    e.depthFromTop == kNone
                        ? "the active ring"
                        : sentence("stacked ring {} from the top", e.depthFromTop + 1),
                    e.length);
}
std::string text(const CloseEvidence& e, const Names& names) {
    if (e.b == kNone) return sentence("A lone entry of point {} is left: closed.", names(e.a));
    if (e.rest > 0) {
        return sentence("Point {} lies between two entries of {}: one finished edge, closed.",
                        names(e.a), names(e.b));
    }
    return sentence("The ring of {} and {} is one finished edge: closed.", names(e.a), names(e.b));
}
std::string text(const AdvanceEvidence& e, const Names& names) {
    if (e.to == kNone)
        return e.shelved == 0
                   ? "No ring is left."
                   : sentence("No ring is left but {} on the shelf.", counted(e.shelved, "ring"));
    if (e.whatIf) return sentence("What if: the next pivot is {}.", names(e.to));
    if (e.popped)
        return sentence("The next ring comes off the stack; the next pivot is {}.", names(e.to));
    if (e.circuit == 0) return sentence("The next pivot is {}.", names(e.to));
    return sentence("No triangle; the next pivot is {} ({} of this circuit without one).",
                    names(e.to), counted(e.circuit, "pivot"));
}
std::string text(const ShelveEvidence& e, const Names&) {
    return sentence("A full circuit of {} without a triangle: the ring waits on the shelf.",
                    e.length);
}
std::string text(const TakeUpEvidence& e, const Names& names) {
    return sentence("No seed is left: {} on the shelf taken up; the next pivot is {}.",
                    counted(e.rings, "ring"), names(e.to));
}
std::string text(const FreeEvidence& e, const Names&) {
    if (e.seed)
        return "A full circuit of the seed without a triangle: the ring is freed, and its points "
               "are UNUSED again.";
    return sentence("A full circuit of {} without a triangle: the ring is freed", e.length) +
           (e.interior == 0 ? "."
                            : sentence(", with {} on it.", counted(e.interior, "interior point")));
}
std::string text(const ComponentEvidence& e, const Names&) {
    return sentence("Component {} is complete; {} so far.", e.component,
                    counted(e.triangles, "triangle"));
}
std::string text(const AlertEvidence& e, const Names& names) {
    if (e.kind == AlertKind::TriangleCap)
        return "Alert: too many triangles for the number of points; the run is stopped.";
    return sentence(e.kind == AlertKind::Hole
                        ? "Alert: a hole is left open at point {}."
                        : "Alert: the ring of two at point {} got no triangle.",
                    names(e.point));
}

std::string text(const FinishedEvidence& e, const Names&) {
    return sentence("{}: {} in {}, {} unused, {}.",
                    e.capped ? "The run is stopped, since it has too many triangles"
                             : "The run is finished, since every point is DONE",
                    counted(e.triangles, "triangle"), counted(e.components, "component"),
                    counted(e.unused, "point"), counted(e.loops, "open loop"));
}

std::string fanText(const GuardEvidence& e, bool kept, const Names& names) {
    if (!kept) return "What if: no triangle is made.";
    return (e.b == kNone
                ? sentence("What if: the spoke to {}", names(e.a))
                : sentence("What if: the triangle over {} and {}", names(e.a), names(e.b))) +
           " is made, regardless of the rules on fans.";
}

/// The end of a sentence about a what-if that overrides the numbers; empty without one.
template <typename Evidence>
std::string whatIfText(const Evidence& e, const Event& event, const Names& names) {
    if constexpr (requires { e.verdict; }) {
        const bool kept = e.verdict == Verdict::WhatIfKept;
        if (!kept && e.verdict != Verdict::WhatIfDropped) return {};
        if (event.address.stage == Stage::TwoPoint) {
            return kept ? "What if: the triangle is made." : "What if: no triangle is made.";
        }
        const std::string point = "What if: point " + names(testedPoint(event));
        if constexpr (std::is_same_v<Evidence, LimitEvidence>)
            return point +
                   (kept ? " is advanced to, regardless of the test." : " is not advanced to.");
        if constexpr (std::is_same_v<Evidence, GuardEvidence>) return fanText(e, kept, names);
        return point + (kept ? " is kept" : " is dropped") + ", regardless of the test.";
    }
    return {};
}

}  // namespace

std::string describe(const Event& event, std::span<const PointName> pointNames) {
    const Names names(pointNames);
    return std::visit(
        [&](const auto& evidence) {
            const std::string whatIf = whatIfText(evidence, event, names);
            return whatIf.empty() ? text(evidence, names) : whatIf;
        },
        event.evidence);
}

std::string_view endingText(const Event& event) {
    const auto verdict = verdictOf(event);
    return verdict ? verdictText(*verdict) : std::string_view{};
}

std::string_view alertName(AlertKind kind) {
    constexpr std::array<std::string_view, 3> kNames{"triangle_cap", "hole", "lost_seed"};
    static_assert(kNames.size() == static_cast<std::size_t>(AlertKind::LostSeed) + 1);
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace se
