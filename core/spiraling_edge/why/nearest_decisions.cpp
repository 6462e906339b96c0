/// One run with a sorted list of the nearest decisions: of every test with a number the least
/// margin is kept per point, and the moves that would invert decisions are computed only for those
/// that enter the list. A move is found by Newton steps: the compared number is a function of the
/// position of one point, and steps along its gradient (by differences) lead to its zero. O(run).
#include "spiraling_edge/why/nearest_decisions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>

#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/stepper/rules.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {
namespace {

/// The context of a decision.
struct FlippingMoveContext {
    const PointSet& points;
    const Params& params;
    Index pivot, first, last;  ///< Points.
};

/// The compared number as a function of the position of one point: > 0 where that point is taken.
struct Compared {
    Index point = kNone;
    std::function<double(const Vec3&)> value;
};

/// The difference of two angles in degrees, in [-180, 180).
double wrapped(double degrees) {
    while (degrees >= 180.0) degrees -= 360.0;
    while (degrees < -180.0) degrees += 360.0;
    return degrees;
}

/// Distance to the nearer limit of a sector from 0 to `end`: above 0 inside.
double insideSector(double degrees, double end) {
    const double toEnd = wrapped(end - degrees);
    const double toStart = wrapped(degrees);
    return std::abs(toEnd) < std::abs(toStart) ? toEnd : toStart;
}

class Comparison {
  public:
    /// `decidedByGap`: the angle of §6.3 decided, not the sphere.
    Comparison(const FlippingMoveContext& context, bool decidedByGap)
        : c_(context), decidedByGap_(decidedByGap) {}

    Compared operator()(const SortEvidence& e) const {
        if (e.verdict == Verdict::SameAngle) {
            return {e.point, [this, e](const Vec3& x) {
                        return std::abs(wrapped(angleAtPivot(x) - e.degrees)) - 1e-5;
                    }};
        }
        return {e.point,
                [this, e](const Vec3& x) { return insideSector(angleAtPivot(x), e.endDegrees); }};
    }
    Compared operator()(const LimitEvidence& e) const {
        return {e.to, [this, e](const Vec3& x) {
                    const bool atStart = e.side == Side::Start;
                    const Vec3& p = at(c_.pivot);
                    return testConcave(at(e.from), c_.points.normal[e.from], atStart ? x : p,
                                       atStart ? p : x)
                        .turn;
                }};
    }
    Compared operator()(const ReciprocalEvidence& e) const {
        return {e.point, [this, e](const Vec3& x) {
                    const bool free = c_.params.readings.freeSector;
                    const ReciprocalTest test =
                        testReciprocal(x, c_.points.normal[e.point], at(free ? e.pred : e.succ),
                                       at(free ? e.succ : e.pred), e.pred == e.succ, at(c_.pivot),
                                       c_.params.sameAngle, c_.params.robust.tangent);
                    return insideSector(test.pivot.degrees(), test.limit.degrees());
                }};
    }
    Compared operator()(const HoleEvidence& e) const {
        const double offset = e.side - glm::dot(e.planeNormal, at(e.point));
        return {e.point, [e, offset](const Vec3& x) {
                    const double side = glm::dot(e.planeNormal, x) + offset;
                    return e.pivotSide < 0.0 ? -side : side;
                }};
    }
    Compared operator()(const SphereEvidence& e) const {
        if (decidedByGap_) {
            const bool moveT = e.s == c_.first;
            const double fixed = angleAtPivot(at(moveT ? e.s : e.t));
            const double limit = std::acos(c_.params.maxGapCosine) * 180.0 / kPi;
            return {moveT ? e.t : e.s, [this, moveT, fixed, limit](const Vec3& x) {
                        const double gap =
                            moveT ? fixed - angleAtPivot(x) : angleAtPivot(x) - fixed;
                        return (gap < 0.0 ? gap + 360.0 : gap) - limit;
                    }};
        }
        const Vec3 t = at(e.t) - at(c_.pivot);
        const Vec3 s = at(e.s) - at(c_.pivot);
        return {e.q, [this, t, s](const Vec3& x) {
                    const Vec3 q = x - at(c_.pivot);
                    const SphereTest test =
                        testSphere(t, glm::dot(t, t), s, glm::dot(s, s), q, glm::dot(q, q));
                    return test.noCircle ? 0.0 : test.radius() - test.distance();
                }};
    }
    Compared operator()(const TwoPointEvidence&) const {
        return {c_.last, [this](const Vec3& x) { return 180.0 - angleAtPivot(x); }};
    }
    template <typename Other>
    Compared operator()(const Other&) const {
        return {};
    }

  private:
    static constexpr double kPi = 3.14159265358979323846;

    const Vec3& at(Index p) const { return c_.points.position[p]; }
    double angleAtPivot(const Vec3& x) const {
        const Frame frame = makeFrame(at(c_.pivot), c_.points.normal[c_.pivot], at(c_.first),
                                      c_.params.robust.tangent);
        return angleOf(frame, x - frame.origin).degrees();
    }

    const FlippingMoveContext& c_;
    bool decidedByGap_;
};

Vec3 gradientOf(const std::function<double(const Vec3&)>& value, const Vec3& x, double step) {
    Vec3 gradient(0.0);
    for (int i = 0; i < 3; ++i) {
        Vec3 to = x;
        Vec3 from = x;
        to[i] += step;
        from[i] -= step;
        gradient[i] = (value(to) - value(from)) / (2.0 * step);
    }
    return gradient;
}

/// The shortest move, by Newton steps along the gradient of the compared number, enlarged by a
/// thousandth to be beyond; empty if the event has no reading, or if no small move inverts it.
std::optional<FlippingMove> flippingMoveOf(const Event& event, const FlippingMoveContext& context) {
    const auto reading = readingOf(event, {context.points, context.params, context.pivot});
    if (!reading || context.pivot == kNone || context.first == kNone) return {};
    const Comparison comparison(context, reading->quantity == "gap");
    const Compared compared = std::visit(comparison, event.evidence);
    if (compared.point == kNone) return {};
    const Vec3& from = context.points.position[compared.point];
    const Vec3 arm = from - context.points.position[context.pivot];
    const double size = std::sqrt(glm::dot(arm, arm));
    const bool taken = outcomeOf(event) == Outcome::Taken;
    const auto turned = [&](double value) { return taken ? value < 0.0 : value > 0.0; };
    constexpr int kSteps = 12;
    constexpr double kBeyond = 1.001;  // Newton converges to the border itself
    Vec3 x = from;
    for (int i = 0; i < kSteps; ++i) {
        const Vec3 gradient = gradientOf(compared.value, x, 1e-6 * size);
        const double slopeSq = glm::dot(gradient, gradient);
        if (!(slopeSq > 0.0)) return {};
        const double least = 1e-9 * size * std::sqrt(slopeSq);  // not less than rounding
        const double value = compared.value(x);
        x += (-value + (taken ? -least : least)) / slopeSq * gradient;
        const Vec3 beyond = from + kBeyond * (x - from);
        if (turned(compared.value(beyond))) return FlippingMove{compared.point, beyond - from};
    }
    return {};
}

/// The nearest decisions so far.
class Shortlist {
  public:
    Shortlist(const PointSet& points, const Params& params, std::size_t count)
        : points_(turnedPoints(points, params)),
          params_(params),
          count_(count),
          least_(points.size(), std::numeric_limits<double>::infinity()) {}

    void add(const SweptPivot& pivot) {
        Index first = kNone;
        Index last = kNone;
        for (const Event& event : pivot.events) {
            if (const auto* p = as<PivotEvidence>(event)) {
                first = p->first;
                last = p->last;
            } else if (const auto* insert = as<InsertEvidence>(event);
                       insert != nullptr && insert->third != kNone) {
                (insert->verdict == Verdict::Before ? first : last) = insert->third;
            }
            const auto reading = readingOf(event, {*points_, params_, pivot.point});
            if (!reading) continue;
            if (const Index p = testedPoint(event); p != kNone)
                least_[p] = std::min(least_[p], std::abs(reading->margin));
            consider({event, pivot.point, *reading, {}}, first, last);
        }
    }

    NearestDecisions take() {
        NearestDecisions result{{}, std::move(least_)};
        for (const auto& [key, decision] : best_) result.decisions.push_back(decision);
        return result;
    }

  private:
    void consider(NearestDecision decision, Index first, Index last) {
        const std::pair key(std::abs(decision.reading.margin), number_++);
        if (best_.size() == count_ && (count_ == 0 || key > best_.rbegin()->first)) return;
        const auto move =
            flippingMoveOf(decision.event, {*points_, params_, decision.pivot, first, last});
        if (!move) return;
        decision.move = *move;
        best_.emplace(key, decision);
        if (best_.size() > count_) best_.erase(std::prev(best_.end()));
    }

    const SharedPoints points_;
    const Params& params_;
    std::size_t count_;
    std::vector<double> least_;
    /// By the margin, then in the order of the run.
    std::map<std::pair<double, std::uint64_t>, NearestDecision> best_;
    std::uint64_t number_ = 0;
};

}  // namespace

Question<NearestDecisions> nearestQuestion(const PointSet& points, const Params& params,
                                           std::size_t count) {
    const auto list = std::make_shared<Shortlist>(points, params, count);
    return {[list](const SweptPivot& pivot) { list->add(pivot); },
            [list](const State&) -> Result<NearestDecisions> { return list->take(); }};
}

Result<NearestDecisions> nearestDecisions(const PointSet& points, const Params& params,
                                          std::size_t count, const Progress& progress) {
    return ask(points, params, nearestQuestion(points, params, count), progress);
}

}  // namespace se
