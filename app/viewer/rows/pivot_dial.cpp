#include "pivot_dial.h"

#include <algorithm>
#include <cmath>

#include "run/strings.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "spiraling_edge/stepper/rules.h"

namespace se::view {

namespace {

/// Fills a Dial step by step.
class Maker {
  public:
    Maker(const PointSet& points, const Params& params, const DecisionState& picture)
        : points_(points),
          picture_(picture),
          gapLimit_(gapLimitDegrees(params)),
          frame_(makeFrame(points_.position[picture.pivot], points_.normal[picture.pivot],
                           points_.position[picture.first], params.robust.tangent)) {}

    Dial make() {
        dial_.pivot = picture_.pivot;
        addTicks();
        addRange();
        addRanks();
        for (const Triangle& t : picture_.newTriangles) addTriangle(t);
        if (picture_.event) {
            stage_ = picture_.event->address.stage;
            std::visit([this](const auto& e) { show(e); }, picture_.event->evidence);
            addReason(*picture_.event);
        }
        return std::move(dial_);
    }

  private:
    double degreesOf(Index point) const {
        if (point == picture_.first) return 0.0;
        return angleOf(frame_, points_.position[point] - frame_.origin).degrees();
    }

    void add(Index point, DialRole role) {
        if (DialTick* known = tickOf(point)) {
            known->role = role;
            return;
        }
        const Vec3 offset = points_.position[point] - frame_.origin;
        const double height = glm::dot(offset, frame_.normal);
        const double lengthSq = glm::dot(offset, offset);
        DialTick tick;
        tick.point = point;
        tick.degrees = degreesOf(point);
        tick.reach = static_cast<float>(std::sqrt(std::max(0.0, lengthSq - height * height)));
        tick.height = static_cast<float>(height);
        tick.role = role;
        tick.underTest = point == picture_.underTest;
        dial_.ticks.push_back(tick);
    }

    void addTicks() {
        for (const Index q : points_.neighbors[picture_.pivot]) {
            add(q, picture_.status[q] == kDone ? DialRole::Done : DialRole::Neighbor);
        }
        for (const CandidateMark& mark : picture_.candidates) {
            const bool rejected = mark.state == CandidateState::Rejected;
            add(mark.point, rejected ? DialRole::Rejected : DialRole::Candidate);
            if (rejected) tickOf(mark.point)->note = std::string(verdictText(mark.verdict));
        }
        addEnd(picture_.first, DialRole::First);
        addEnd(picture_.last, DialRole::Last);
        addEnd(picture_.end, DialRole::End);
        addEnd(picture_.start, DialRole::Start);
        float farthest = 0.0F;
        for (const DialTick& t : dial_.ticks) farthest = std::max(farthest, t.reach);
        for (DialTick& t : dial_.ticks) {
            if (farthest <= 0.0F) continue;
            t.reach /= farthest;
            t.height = std::clamp(t.height / farthest, -1.0F, 1.0F);
        }
    }

    void addEnd(Index point, DialRole role) {
        if (point == kNone) return;
        add(point, role);
        name(point);
    }

    DialTick* tickOf(Index point) {
        const auto found = std::find_if(dial_.ticks.begin(), dial_.ticks.end(),
                                        [&](const DialTick& t) { return t.point == point; });
        return found == dial_.ticks.end() ? nullptr : &*found;
    }
    void name(Index point, const char* sign = "") {
        DialTick* tick = tickOf(point);
        if (tick == nullptr) return;
        tick->named = true;
        tick->sign = sign;
    }

    void addRange() {
        const bool moved = picture_.start != picture_.first || picture_.end != picture_.last;
        if (moved) dial_.arcs.push_back({DialArc::Kind::OldRange, 0.0, picture_.sectorDegrees});
        dial_.arcs.push_back({DialArc::Kind::Range, picture_.startDegrees, picture_.endDegrees});
    }

    /// Ranks by angle, and marks of the candidates that have passed the test of §6.3.
    void addRanks() {
        std::vector<DialTick*> kept;
        for (const CandidateMark& mark : picture_.candidates) {
            DialTick* tick = tickOf(mark.point);
            if (tick == nullptr || tick->role != DialRole::Candidate) continue;
            tick->passed = mark.stage == Stage::Sphere && mark.state == CandidateState::Kept;
            kept.push_back(tick);
        }
        std::stable_sort(kept.begin(), kept.end(), [](const DialTick* a, const DialTick* b) {
            return a->degrees < b->degrees;
        });
        for (std::size_t i = 0; i < kept.size(); ++i) kept[i]->rank = static_cast<int>(i) + 1;
    }

    /// Reason of a refusal in words, once per point, or that a what-if decided.
    void addReason(const Event& event) {
        const std::optional<Verdict> verdict = verdictOf(event);
        if (!verdict || dial_.caption.empty()) return;
        if (outcomeOf(event) != Outcome::Refused && !isWhatIf(*verdict)) return;
        const std::string reason(verdictText(*verdict));
        if (dial_.caption.find(reason) == std::string::npos) dial_.caption += ": " + reason;
    }

    /// The sector of a triangle at the pivot, from its second corner to its third.
    void addTriangle(const Triangle& t) {
        const double from = degreesOf(t.b);
        double to = degreesOf(t.c);
        if (to < from) to += 360.0;
        dial_.arcs.push_back({DialArc::Kind::Triangle, from, to});
    }

    void show(const PivotEvidence& e) {
        dial_.caption = formatted("free sector %.1f\xC2\xB0, from first to last", e.sectorDegrees);
    }
    void show(const SortEvidence& e) {
        if (e.verdict == Verdict::AlreadyDone || e.verdict == Verdict::OnRingEnd) {
            dial_.caption = std::string(verdictText(e.verdict)) + ": no candidate";
            return;
        }
        dial_.arcs.push_back({DialArc::Kind::Angle, 0.0, e.degrees});
        dial_.marks.push_back({e.endDegrees, "limit"});
        dial_.caption =
            formatted("angle %.1f\xC2\xB0, limit %.1f\xC2\xB0", e.degrees, e.endDegrees);
    }
    void show(const LimitEvidence& e) {
        const std::string side = e.side == Side::Start ? "start" : "end";
        if (e.moves()) {
            dial_.caption = side + formatted(" moved from %.1f\xC2\xB0 to %.1f\xC2\xB0",
                                             e.fromDegrees, e.toDegrees);
            return;
        }
        dial_.caption = side +
                        formatted(" stays at %.1f\xC2\xB0; the next point: ", e.fromDegrees) +
                        std::string(verdictText(e.verdict));
    }
    void show(const DropEvidence& e) {
        const bool start = e.side == Side::Start;
        if (e.isLimit()) {
            dial_.caption = formatted(
                start ? "now start, at %.1f\xC2\xB0" : "now end, at %.1f\xC2\xB0", e.degrees);
            return;
        }
        dial_.caption =
            stage_ == Stage::Convex
                ? formatted("angle %.1f\xC2\xB0, within the range", e.degrees)
                : formatted(start ? "angle %.1f\xC2\xB0, start at %.1f\xC2\xB0"
                                  : "angle %.1f\xC2\xB0, end at %.1f\xC2\xB0",
                            e.degrees, start ? picture_.startDegrees : picture_.endDegrees);
    }
    void show(const ReciprocalEvidence& e) {
        name(e.point);
        dial_.reciprocal = {e.point,  e.succ, e.pred, e.degrees, e.limitDegrees, isTaken(e.verdict),
                            e.printed};
        dial_.caption = formatted("seen from the point: %.1f\xC2\xB0 of %.1f\xC2\xB0", e.degrees,
                                  e.limitDegrees);
    }
    void show(const HoleEvidence& e) {
        dial_.chord = {picture_.startDegrees, picture_.endDegrees};
        dial_.caption = formatted("side %+.3g, that of the pivot %+.3g", e.side, e.pivotSide);
    }
    void show(const SphereEvidence& e) {
        for (const Index point : {e.q, e.t, e.s}) name(point);
        const double from = degreesOf(e.t);
        const double limit = gapLimit_;
        const bool wide = e.gapDegrees > limit;
        dial_.arcs.push_back(
            {wide ? DialArc::Kind::TooWide : DialArc::Kind::Gap, from, from + e.gapDegrees});
        dial_.marks.push_back({from + limit, formatted("%.4g\xC2\xB0", limit)});
        const std::string gap =
            formatted("gap %.1f\xC2\xB0 of %.4g\xC2\xB0; ", e.gapDegrees, limit);
        dial_.caption =
            gap + (hasSphere(e) ? formatted("d \xE2\x88\x92 r = %+.3g", e.distance - e.radius)
                                : "no circle");
    }
    void show(const TwoPointEvidence& e) {
        dial_.arcs.push_back(
            {!isTaken(e.verdict) ? DialArc::Kind::TooWide : DialArc::Kind::Gap, 0.0, e.degrees});
        dial_.marks.push_back({180.0, "180\xC2\xB0"});
        dial_.caption = formatted("angle %.1f\xC2\xB0, limit 180\xC2\xB0", e.degrees);
    }
    void show(const EmitEvidence&) {
        dial_.caption = withS(picture_.newTriangles.size(), "triangle");
    }
    void show(const InsertEvidence& e) {
        dial_.slots.push_back({0.0, "before", e.verdict == Verdict::Before});
        dial_.slots.push_back({degreesOf(picture_.last), "after", e.verdict == Verdict::After});
        dial_.caption = e.third == kNone               ? "no third point"
                        : e.verdict == Verdict::Before ? "joins before the pivot"
                                                       : "joins after the pivot";
    }
    void show(const GuardEvidence& e) {
        if (e.b != kNone && !isTaken(e.verdict)) {
            const double from = degreesOf(e.a);
            double to = degreesOf(e.b);
            if (to <= from) to += 360.0;
            dial_.arcs.push_back({DialArc::Kind::TooWide, from, to});
        }
        dial_.caption = isTaken(e.verdict)    ? std::string("the fan is made")
                        : isWhatIf(e.verdict) ? std::string("no triangle")
                        : e.dropped == kNone
                            ? std::string("the fan is refused")
                            : std::to_string(e.dropped) + " is dropped, 6.3 is repeated";
    }
    /// The ear of a hole.
    void show(const FillEvidence& e) {
        addTriangle({e.pivot, e.first, e.last});
        dial_.caption = formatted("ear of a hole of %.0f: least angle %.1f\xC2\xB0", e.ringLength,
                                  e.leastDegrees);
    }
    void show(const SkipEvidence&) { dial_.caption = "on a wall: passed over"; }
    void show(const RingEvidence&) {
        for (const RingEvidence& change : picture_.ringChanges) {
            name(change.point, change.inserted ? "+" : "\xE2\x88\x92");
        }
        dial_.caption = "+ enters the ring, \xE2\x88\x92 leaves it";
    }
    void show(const SplitEvidence& e) {
        name(e.point);
        dial_.caption =
            formatted("the ring splits: %.0f and %.0f entries", e.activeLength, e.stackedLength);
    }
    void show(const JoinEvidence& e) {
        name(e.point);
        dial_.caption = formatted("the rings join: %.0f entries", e.length);
    }
    void show(const AdvanceEvidence& e) {
        name(e.to);
        dial_.caption = e.to == kNone ? "no ring is left" : "the next pivot";
    }
    template <typename Other>
    void show(const Other&) {}

    const PointSet& points_;
    const DecisionState& picture_;
    double gapLimit_;  ///< §6.3, degrees.
    Frame frame_;
    Dial dial_;
    Stage stage_ = Stage::Pivot;
};

}  // namespace

Dial makeDial(const PointSet& points, const Params& params, const DecisionState& picture) {
    if (picture.pivot == kNone || picture.first == kNone) return {};
    return Maker(points, params, picture).make();
}

}  // namespace se::view
