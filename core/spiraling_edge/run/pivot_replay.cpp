#include "spiraling_edge/run/pivot_replay.h"

#include <algorithm>

#include "spiraling_edge/base/overloaded.h"
#include "spiraling_edge/mesh/mesh_compare.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/ring_replay.h"
#include "spiraling_edge/stepper/verdict_table.h"

namespace se {

namespace {

/// Applies events to a state, one after the other.
class EventReplay {
  public:
    explicit EventReplay(DecisionState& state) : state_(state) {}

    void apply(const Event& event) {
        stage_ = event.address.stage;
        remember(event);
        std::visit([this](const auto& evidence) { on(evidence); }, event.evidence);
    }

  private:
    void remember(const Event& event) {
        auto& latest = state_.latest;
        std::erase_if(latest,
                      [&](const Event& each) { return each.address.stage == event.address.stage; });
        latest.push_back(event);
    }
    void on(const SeedEvidence& e) {
        setStatus(e.first, 1);
        setStatus(e.second, 1);
    }
    void on(const StrandEvidence& e) { setStatus(e.point, kDone); }
    void on(const PivotEvidence& e) { begin(e); }
    void on(const InsertEvidence& e) {
        if (e.verdict == Verdict::Before) {
            state_.first = state_.start = e.third;
        } else if (e.verdict == Verdict::After) {
            state_.last = state_.end = e.third;
        }
        state_.sectorDegrees = state_.endDegrees = e.sectorDegrees;
        if (e.third != kNone) setStatus(e.third, 1);
    }
    void on(const SortEvidence& e) { mark(e.point, e.degrees, e.verdict); }
    void on(const LimitEvidence& e) {
        if (!e.moves()) return;
        const bool start = e.side == Side::Start;
        (start ? state_.start : state_.end) = e.to;
        (start ? state_.startDegrees : state_.endDegrees) = e.toDegrees;
        (start ? state_.startPath : state_.endPath).push_back({e.to, e.toDegrees});
    }
    void on(const DropEvidence& e) {
        // Start and end have marks of their own.
        if (!e.isLimit()) mark(e.point, e.degrees, e.verdict);
    }
    void on(const ReciprocalEvidence& e) {
        // One entry of the point whose test passes is enough.
        const CandidateMark* known = find(e.point);
        const bool passed = known != nullptr && known->stage == Stage::Reciprocal &&
                            known->state == CandidateState::Kept;
        if (!passed) mark(e.point, {}, e.verdict);
    }
    void on(const HoleEvidence& e) {
        state_.hole = e;
        if (e.point != kNone) mark(e.point, {}, e.verdict);
    }
    void on(const SphereEvidence& e) {
        if (pool_.empty()) pool_ = state_.candidates;
        mark(e.q, {}, e.verdict);
    }
    void on(const GuardEvidence& e) {
        if (e.dropped == kNone || e.dropped == state_.pivot) return;
        // §6.3 is repeated with the candidates that it had before.
        const bool repeats = !isTaken(e.verdict) && !pool_.empty();
        if (repeats) state_.candidates = pool_;
        mark(e.dropped, {}, e.verdict);
        if (repeats) pool_ = state_.candidates;
    }
    void on(const FillEvidence& e) { begin(e); }
    void on(const EmitEvidence& e) { state_.newTriangles.push_back(e.corners); }
    void on(const RingEvidence& e) {
        state_.ringChanges.push_back(e);
        setStatus(e.point, e.status);
    }
    void on(const AdvanceEvidence& e) { state_.nextPivot = e.to; }
    template <typename Other>
    void on(const Other&) {}

    /// The pivot, with first and last alone.
    void begin(const auto& e) {
        state_.pivot = e.pivot;
        state_.first = state_.start = e.first;
        state_.last = state_.end = e.last;
        state_.sectorDegrees = state_.endDegrees = e.sectorDegrees;
    }
    void setStatus(Index point, PointStatus status) {
        if (point < state_.status.size()) state_.status.set(point, status);
    }
    CandidateMark* find(Index point) {
        auto& list = state_.candidates;
        const auto found = std::find_if(list.begin(), list.end(), [&](const CandidateMark& each) {
            return each.point == point;
        });
        return found == list.end() ? nullptr : &*found;
    }
    void mark(Index point, std::optional<double> degrees, Verdict verdict) {
        // Skipped before any test: never candidates.
        if (verdict == Verdict::AlreadyDone || verdict == Verdict::OnRingEnd) return;
        CandidateMark* found = find(point);
        if (found == nullptr) found = &state_.candidates.emplace_back(CandidateMark{point, 0.0});
        if (degrees) found->degrees = *degrees;
        found->verdict = verdict;
        found->stage = stage_;
        found->state = rowOf(verdict).outcome == Outcome::Refused ? CandidateState::Rejected
                                                                  : CandidateState::Kept;
    }

    DecisionState& state_;
    std::vector<CandidateMark> pool_;  ///< The candidates before §6.3, for NeighborRing::pool.
    Stage stage_ = Stage::Pivot;
};

/// The first event from which on the rings are those after the pivot.
std::size_t firstEventAfterRings(const std::vector<Event>& events) {
    const auto advance = std::find_if(events.begin(), events.end(), [](const Event& event) {
        return event.address.stage == Stage::Advance;
    });
    if (advance == events.end()) return events.size() - 1;
    return static_cast<std::size_t>(advance - events.begin());
}

/// §6.5 or §7: the ring loses or gets points.
bool updatesRings(const Event& event) {
    const Stage stage = event.address.stage;
    return stage == Stage::Ring || stage == Stage::Split || stage == Stage::Join ||
           stage == Stage::Done;
}

bool changesRings(const Event& event) {
    const Stage stage = event.address.stage;
    return updatesRings(event) || stage == Stage::Seed || stage == Stage::Insert;
}

/// A freed ring (§7) loses its points one by one, then an event reports it, and an alert may
/// follow: the ring shown is the one before the first of these.
void noteFreed(DecisionState& state, const Event& event, const RingReplay& replay) {
    if (event.address.stage != Stage::Done) return;
    if (!state.freed && std::holds_alternative<RingEvidence>(event.evidence)) {
        const std::vector<RingPath> rings = ringPaths(replay.rings());
        if (!rings.empty() && rings.front().active)
            state.freed = FreedRingState{rings.front(), {}, {}};
    }
    if (!state.freed) return;
    if (const auto* free = std::get_if<FreeEvidence>(&event.evidence))
        state.freed->evidence = *free;
    if (const auto* alert = std::get_if<AlertEvidence>(&event.evidence)) {
        state.freed->alert = alert->kind;
    }
}

/// The rings just after events[last], entry by entry.
void addRings(DecisionState& state, const PivotRecord& record, std::size_t last) {
    const std::vector<Event>& events = record.events;
    const auto end = events.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    // Most decisions do not change the rings.
    if (std::any_of(events.begin(), end, changesRings)) {
        RingReplay replay(record.before.rings, record.before.status.size(), record.rules);
        for (auto event = events.begin(); event != end; ++event) {
            if (updatesRings(*event) && state.oldRings.empty()) {
                state.oldRings = ringPaths(replay.rings());
            }
            noteFreed(state, *event, replay);
            replay.apply(*event);
        }
        state.rings = ringPaths(replay.rings());
        state.exchange = replay.exchange();
    }
    if (last >= firstEventAfterRings(events)) {
        state.status = record.after.status;
        state.rings = ringPaths(record.after.rings);
    }
}

/// Steps after the last pivot edit the mesh: each has one such event, which shows the new mesh.
/// Before that event, for example at a point that was stranded, the mesh is the old one.
void addRepaired(DecisionState& state, const PivotRecord& record) {
    const bool repairs = std::any_of(state.latest.begin(), state.latest.end(),
                                     [](const Event& e) { return isRepair(e.address.stage); });
    if (!repairs || record.after.repaired == nullptr) return;
    state.repaired = record.after.repaired;
    const auto& before = record.before.repaired ? record.before.repaired : record.unrepaired;
    if (before) {
        state.newTriangles = freshTriangles(*before, *record.after.repaired);
        state.goneTriangles = freshTriangles(*record.after.repaired, *before);
    }
    state.finishedTriangles = state.repaired->size() - state.newTriangles.size();
}

DecisionState stateBefore(const PivotRecord& record) {
    DecisionState state;
    state.status = record.before.status;
    state.rings = ringPaths(record.before.rings);
    state.repaired = record.before.repaired;
    state.finishedTriangles = state.repaired ? state.repaired->size() : record.before.triangleCount;
    return state;
}

}  // namespace

std::vector<RingPoint> DecisionState::neighborRing() const {
    std::vector<RingPoint> ring;
    if (pivot == kNone) return ring;
    for (const CandidateMark& each : candidates) {
        // A candidate that start or end moved to is no candidate any more.
        const bool isLimit = each.point == start || each.point == end;
        if (each.state == CandidateState::Kept && !isLimit)
            ring.push_back({each.point, each.degrees});
    }
    std::stable_sort(ring.begin(), ring.end(),
                     [](const RingPoint& a, const RingPoint& b) { return a.degrees < b.degrees; });
    ring.insert(ring.begin(), {start, startDegrees});
    ring.push_back({end, endDegrees});
    return ring;
}

std::vector<RingPoint> DecisionState::fan() const {
    std::vector<RingPoint> points = neighborRing();
    if (points.empty()) return points;
    if (!startPath.empty()) {
        points.insert(points.begin(), startPath.begin(), startPath.end() - 1);
        points.insert(points.begin(), {first, 0.0});
    }
    if (!endPath.empty()) {
        points.insert(points.end(), endPath.rbegin() + 1, endPath.rend());
        points.push_back({last, sectorDegrees});
    }
    return points;
}

DecisionState PivotReplay::before(std::size_t i) const {
    return i == 0 ? stateBefore(*record_) : after(i - 1);
}

DecisionState PivotReplay::after(std::size_t i) const {
    const PivotRecord& record = *record_;
    DecisionState state = stateBefore(record);
    if (record.events.empty()) return state;
    const std::size_t last = std::min(i, record.events.size() - 1);
    EventReplay replay(state);
    for (std::size_t k = 0; k <= last; ++k) replay.apply(record.events[k]);
    const Event& event = record.events[last];
    state.event = event;
    state.underTest = subjectOf(event);
    if (const auto* sphere = std::get_if<SphereEvidence>(&event.evidence)) state.sphere = *sphere;
    if (event.address.stage != Stage::Hole) state.hole.reset();
    state.complete = last + 1 == record.events.size();
    addRepaired(state, record);
    addRings(state, record, last);
    return state;
}

}  // namespace se
