/// The margin of each kind of test from its evidence: an angle, a length over the distance to the
/// pivot, or for §6.3 the better of the two.
#include "spiraling_edge/run/reading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spiraling_edge/base/overloaded.h"

namespace se {
namespace {

constexpr double kRadians = 3.14159265358979323846 / 180.0;

/// A margin with the sign of the decision. Decisions compare numbers without an arccosine or a
/// root, so that those shown may differ from them by rounding.
double signedBy(bool taken, double margin) { return taken ? std::abs(margin) : -std::abs(margin); }

/// An angle in a sector from 0 to `end` (degrees, below 360), compared with the nearer of its two
/// limits. Angles beyond the end wrap at 360.
Reading inSector(double degrees, double end, bool inside) {
    const double fromStart = !inside && degrees > 180.0 ? degrees - 360.0 : degrees;
    const double toEnd = std::abs(end - degrees);
    const double toStart = std::abs(fromStart);
    const double margin = signedBy(inside, std::min(toEnd, toStart) * kRadians);
    if (toEnd <= toStart) return {"angle", "deg", degrees, end, margin};
    return {"angle", "deg", fromStart, 0.0, margin};
}

struct Reader {
    using Found = std::optional<Reading>;

    const ReadingContext& context;

    Found operator()(const SortEvidence& e) const {
        if (e.verdict == Verdict::SameAngle)
            return Reading{"angle", "deg", e.degrees, e.degrees, 0.0};
        const bool compared = e.verdict == Verdict::Kept || e.verdict == Verdict::NotBeforeEnd ||
                              e.verdict == Verdict::NotAfterStart;
        // On a fresh ring of two the sector is the full turn, and nothing is outside; nor is it
        // without PaperRules::maxAngle.
        if (!compared || e.endDegrees >= 360.0 || !context.params.paper.maxAngle) return {};
        return inSector(e.degrees, e.endDegrees, e.verdict == Verdict::Kept);
    }
    Found operator()(const LimitEvidence& e) const {
        const bool decided = context.params.paper.concave &&
                             (e.verdict == Verdict::Moved || e.verdict == Verdict::NotConcave);
        if (!decided || context.pivot == kNone) return {};
        const Vec3& s = context.points.position[e.from];
        const double size = glm::length(context.points.position[e.to] - s) *
                            glm::length(context.points.position[context.pivot] - s);
        if (!(size > 0.0)) return {};
        return Reading{"turn", "", e.turn, 0.0, e.turn / size};
    }
    Found operator()(const ReciprocalEvidence& e) const {
        if (e.verdict == Verdict::WallComplete || e.limitDegrees >= 360.0) return {};
        return inSector(e.degrees, e.limitDegrees, e.verdict == Verdict::Kept);
    }
    Found operator()(const HoleEvidence& e) const {
        // A pivot on the plane has no side.
        if (e.point == kNone || context.pivot == kNone || e.pivotSide == 0.0) return {};
        const double size =
            glm::length(e.planeNormal) *
            glm::length(context.points.position[e.point] - context.points.position[context.pivot]);
        if (!(size > 0.0)) return {};
        const double towards = e.pivotSide < 0.0 ? -e.side : e.side;
        return Reading{"side of the plane", "", towards, 0.0, towards / size};
    }
    Found operator()(const SphereEvidence& e) const {
        if (e.verdict == Verdict::NoCircle || context.pivot == kNone) return {};
        const double far =
            glm::length(context.points.position[e.q] - context.points.position[context.pivot]);
        if (!(far > 0.0)) return {};
        const bool inside = e.verdict == Verdict::InsideSphere;
        const Reading sphere{"distance from the center", "", e.distance, e.radius,
                             signedBy(inside, (e.radius - e.distance) / far)};
        const double limit = std::acos(context.params.maxGapCosine) / kRadians;
        const double over = (e.gapDegrees - limit) * kRadians;
        // The gap of a point inside the sphere is not tested.
        const Reading gap{"gap", "deg", e.gapDegrees, limit,
                          inside ? over : signedBy(e.verdict == Verdict::GapTooWide, over)};
        // Kept if either test keeps it: the larger margin decides.
        return gap.margin > sphere.margin ? gap : sphere;
    }
    Found operator()(const TwoPointEvidence& e) const {
        if (context.params.paper.twoPoint == TwoPointRule::None) return {};
        return Reading{"angle", "deg", e.degrees, 180.0,
                       signedBy(isTaken(e.verdict), (180.0 - e.degrees) * kRadians)};
    }
    template <typename Other>
    Found operator()(const Other&) const {
        return {};
    }
};

}  // namespace

std::optional<Verdict> verdictOf(const Event& event) {
    return std::visit(
        [](const auto& e) -> std::optional<Verdict> {
            if constexpr (requires { e.verdict; }) return e.verdict;
            return std::nullopt;
        },
        event.evidence);
}

Outcome outcomeOf(const Event& event) {
    const auto verdict = verdictOf(event);
    return verdict ? rowOf(*verdict).outcome : Outcome::None;
}

Index testedPoint(const Event& event) {
    return std::visit(Overloaded{
                          [](const SeedEvidence& e) { return e.second; },
                          [](const LimitEvidence& e) { return e.to; },
                          [](const SphereEvidence& e) { return e.q; },
                          [](const InsertEvidence& e) { return e.third; },
                          [](const GuardEvidence& e) { return e.dropped; },
                          [](const auto& e) {
                              if constexpr (requires { e.point; }) return e.point;
                              return kNone;
                          },
                      },
                      event.evidence);
}

Index subjectOf(const Event& event) {
    return std::visit(Overloaded{
                          [](const PivotEvidence& e) { return e.pivot; },
                          [](const SkipEvidence& e) { return e.pivot; },
                          [](const AdvanceEvidence& e) { return e.to; },
                          [](const FillEvidence& e) { return e.pivot; },
                          [](const FlipEvidence& e) { return e.x; },
                          [](const CloseHoleEvidence& e) { return e.first; },
                          [](const RemeshEvidence& e) { return e.faulty.a; },
                          [&](const auto&) { return testedPoint(event); },
                      },
                      event.evidence);
}

bool hasSphere(const SphereEvidence& evidence) {
    return evidence.radius > 0.0 && std::isfinite(evidence.radius);
}

std::optional<Reading> readingOf(const Event& event, const ReadingContext& context) {
    if (const auto verdict = verdictOf(event); verdict && isWhatIf(*verdict)) return std::nullopt;
    return std::visit(Reader{context}, event.evidence);
}

std::string_view roleName(LineRole role) {
    constexpr std::array<std::string_view, 6> kNames{"fact",     "taken", "refused",
                                                     "indirect", "made",  "undone"};
    return kNames[static_cast<std::size_t>(role)];
}

LedgerLine lineOf(const Event& event, const ReadingContext& context) {
    const Outcome outcome = outcomeOf(event);
    const LineRole role = outcome == Outcome::Taken ? LineRole::Taken
                          : isAgainst(outcome)      ? LineRole::Refused
                                                    : LineRole::Fact;
    return {event, context.pivot, role, readingOf(event, context)};
}

bool wasSettledBefore(const Event& event) {
    const auto* sort = as<SortEvidence>(event);
    return sort != nullptr &&
           (sort->verdict == Verdict::AlreadyDone || sort->verdict == Verdict::OnRingEnd);
}

bool editsMesh(const Event& event) { return isRepair(event.address.stage); }

}  // namespace se
