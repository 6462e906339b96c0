/// Random access by keyframes. A keyframe holds the rings and a few numbers; triangles, alerts and
/// DONE points are append-only, so that moving to it only cuts or extends them. When the byte
/// budget is full the spacing of keyframes doubles and every second one is dropped. A seek costs
/// the changes to the nearest keyframe and at most one spacing of pivots; after the last pivot, the
/// changes of the mesh on the way.
#include "spiraling_edge/run/timeline.h"

#include <limits>
#include <utility>

namespace se {

namespace {

/// Pivots between two calls of keepGoing: well under a millisecond.
constexpr std::uint32_t kAskEvery = 32;

std::size_t bytesOf(const NeighborRing& ring) {
    return (ring.listed.size() + ring.candidates.size() + ring.pool.size()) * sizeof(Candidate) +
           ring.fan.size() * sizeof(FanPoint) + ring.spokes.size() * sizeof(Index);
}

/// Exchanges the parts that a keyframe does not hold.
void swapLarge(State& a, State& b) {
    std::swap(a.triangles, b.triangles);
    std::swap(a.alerts, b.alerts);
    std::swap(a.done, b.done);
    std::swap(a.status, b.status);
    std::swap(a.edges, b.edges);
    std::swap(a.rings, b.rings);
    std::swap(a.repair, b.repair);
}

/// Removes the statuses of the points on the rings, or restores them.
void countEntries(State& state, bool present) {
    for (Index entry = 0; entry < state.rings.entryCapacity(); ++entry) {
        if (!state.rings.alive(entry)) continue;
        PointStatus& status = state.status[state.rings.point(entry)];
        status = present ? status + 1 : kUnused;
    }
}

}  // namespace

std::size_t Timeline::defaultBudget(const PointSet& points) {
    constexpr std::size_t kLeast = std::size_t{32} << 20U;
    const std::size_t input = points.size() * (2 * sizeof(Vec3) + 1 + sizeof(Index)) +
                              points.neighbors.ids.size() * sizeof(Index);
    const std::size_t run =
        points.size() * (sizeof(PointStatus) + 2 * sizeof(Index) + 2 * sizeof(Triangle));
    return std::max(kLeast, (input + run) / 5);
}

Timeline::Timeline(SharedPoints points, const Params& params, std::size_t byteBudget)
    : stepper_(std::move(points), params), byteBudget_(byteBudget) {
    storeKeyframe();
}

bool Timeline::stepPivot(EventLog* log) {
    if (state().finished()) {
        endKnown_ = true;
        return false;
    }
    if (log == nullptr && !repairs_.empty() && position() + 1 >= repairs_.firstPosition()) {
        const std::size_t next = inRepairs() ? repairs_.placeOf(state()) + 1 : 0;
        if (next < repairs_.size()) return goToRepair(next);
    }
    const bool isFirst = visit_ && !endKnown_ && position() == farthest_;
    if (isFirst && log == nullptr) log = &firstLog_;
    firstLog_.clear();
    const std::size_t logged = log == nullptr ? 0 : log->events().size();
    const Counters before = state().counters;
    const std::size_t triangles = state().triangles.size();
    const std::size_t alerts = state().alerts.size();
    const std::size_t done = state().done.size();
    stepper_.setLog(log);
    // The steps after the last pivot go to their next kind without counting a pivot.
    while (stepper_.stepPivot() && position() == before.pivots) {
    }
    stepper_.setLog(nullptr);
    const bool complete = position() > before.pivots;
    triangles_.appended(state().triangles.size() - triangles);
    alerts_.appended(state().alerts.size() - alerts);
    done_.appended(state().done.size() - done);
    farthest_ = std::max(farthest_, position());
    noteRepair();
    if (!complete) {
        // After the last pivot; all steps there are counted.
        endKnown_ = true;
        beyondLast_ = true;
        tail_ = true;  // The event of the end, at least.
    } else if (position() % spacing_ == 0) {
        storeKeyframe();
    }
    if (isFirst) {
        const std::span<const Event> events = std::span(log->events()).subspan(logged);
        if (!events.empty()) visit_({pivotPoint(events), events, state()});
    }
    return complete;
}

void Timeline::seek(std::uint32_t pivot, const std::function<bool()>& keepGoing) {
    if (std::exchange(passes_, false) && inRepairs()) restore(keyframes_.rbegin()->second);
    if (!repairs_.empty() && pivot >= repairs_.firstPosition()) {
        const std::size_t place = pivot - repairs_.firstPosition();
        goToRepair(std::min(place, repairs_.size() - 1));
    } else if (pivot < position() || (beyondLast_ && pivot == position())) {
        restore(std::prev(keyframes_.upper_bound(pivot))->second);
    } else if (const auto nearest = std::prev(keyframes_.upper_bound(pivot));
               nearest->first > position() + spacing_) {
        restore(nearest->second);
    }
    stepTo(pivot, keepGoing);
}

void Timeline::makeRest(const std::function<bool()>& keepGoing) {
    bool goesOn = true;
    const auto asked = [&] { return goesOn = !keepGoing || keepGoing(); };
    if (!passes_) seek(farthest_, asked);
    if (!goesOn) return;
    passes_ = repairs_.empty();
    stepTo(std::numeric_limits<std::uint32_t>::max(), asked);
}

void Timeline::stepTo(std::uint32_t pivot, const std::function<bool()>& keepGoing) {
    for (std::uint32_t asked = 0; position() < pivot; ++asked) {
        if (asked % kAskEvery == kAskEvery - 1 && keepGoing && !keepGoing()) return;
        if (!stepPivot()) return;
    }
}

/// Changes the state of the stepper in place.
void Timeline::changeState(const std::function<void(State&)>& change) {
    State state = stepper_.exchangeState({});
    change(state);
    stepper_.setState(std::move(state));
}

/// Goes to a known place after the last pivot. False if it is the end of the run.
bool Timeline::goToRepair(std::size_t place) {
    if (!inRepairs()) {
        restore(firstRepair_);
        changeState([&](State& state) { repairs_.takeUp(state); });
    }
    changeState([&](State& state) { repairs_.moveTo(state, place); });
    beyondLast_ = state().finished();
    return !beyondLast_;
}

/// Keeps the place after a step, if it is after the last pivot.
void Timeline::noteRepair() {
    if (!inRepairs() || passes_) return;
    if (repairs_.empty()) {
        firstRepair_ = makeKeyframe();
        changeState([&](State& state) { repairs_.add(state); });
    } else if (!state().repair.triangles.hasJournal()) {
        // The step to the first place was made again, with a log.
        changeState([&](State& state) { repairs_.takeUp(state); });
    } else {
        changeState([&](State& state) { repairs_.add(state); });
    }
}

/// The present state without its triangles.
RunState Timeline::runState() {
    recorded_.assign(state().status);
    RunState copy{recorded_,
                  state().rings.withoutPoints(),
                  state().triangles.size(),
                  state().counters,
                  state().finished(),
                  nullptr};
    if (!state().repair.empty()) {
        copy.repaired = std::make_shared<const std::vector<Triangle>>(state().repair.triangles);
    }
    return copy;
}

std::shared_ptr<const PivotRecord> Timeline::record(std::uint32_t pivot) {
    if (endKnown_) pivot = std::min(pivot, lastPivot());
    seek(pivot == 0 ? 0 : pivot - 1);
    if (endKnown_ && pivot > lastPivot()) return this->record(lastPivot());
    auto record = std::make_shared<PivotRecord>();
    record->pivot = pivot;
    record->rules = params().paper;
    record->before = runState();
    EventLog log;
    if (pivot > 0) {
        const bool endWasKnown = endKnown_;
        stepPivot(&log);
        if (log.events().empty() && endKnown_ && !endWasKnown)
            return this->record(pivot);  // the last one
        record->events = log.events();
    }
    record->after = runState();
    if (record->after.repaired && !record->before.repaired) {
        // The list of emitted triangles stays unchanged while a copy of it is edited.
        record->unrepaired = std::make_shared<const std::vector<Triangle>>(state().triangles);
    }
    record->isLast = endKnown_ && pivot == lastPivot();
    return record;
}

Timeline::Keyframe Timeline::makeKeyframe() {
    // The parts that a keyframe does not hold are moved aside during the copy.
    State state = stepper_.exchangeState({});
    State large;
    swapLarge(large, state);
    Keyframe keyframe{state, large.triangles.size(), large.alerts.size(), large.done.size()};
    keyframe.rest.rings = large.rings.withoutPoints();
    keyframe.bytes = sizeof(Keyframe) + large.rings.bytesWithoutPoints() + bytesOf(state.pivot);
    swapLarge(large, state);
    stepper_.setState(std::move(state));
    return keyframe;
}

void Timeline::storeKeyframe() {
    if (keyframes_.contains(position()) || inRepairs()) return;
    Keyframe keyframe = makeKeyframe();
    keyframeBytes_ += keyframe.bytes;
    keyframes_.emplace(position(), std::move(keyframe));
    while (keyframeBytes_ > byteBudget_ && keyframes_.size() > 2) thinOut();
}

void Timeline::thinOut() {
    spacing_ *= 2;
    keyframeBytes_ = 0;
    for (auto it = keyframes_.begin(); it != keyframes_.end();) {
        if (it->first % spacing_ != 0) {
            it = keyframes_.erase(it);
        } else {
            keyframeBytes_ += it->second.bytes;
            ++it;
        }
    }
}

void Timeline::restore(const Keyframe& keyframe) {
    State old = stepper_.exchangeState({});
    repairs_.putAside(old);
    countEntries(old, false);
    const std::size_t doneBefore = old.done.size();
    for (std::size_t i = keyframe.done; i < doneBefore; ++i) old.status[old.done[i]] = kUnused;
    done_.resize(old.done, keyframe.done);
    for (std::size_t i = doneBefore; i < old.done.size(); ++i) old.status[old.done[i]] = kDone;
    triangles_.resize(old.triangles, keyframe.triangles);
    alerts_.resize(old.alerts, keyframe.alerts);
    if (!old.edges.empty()) old.edges.moveTo(keyframe.triangles);
    State state = keyframe.rest;
    swapLarge(old, state);
    state.rings.restore(keyframe.rest.rings);
    countEntries(state, true);
    stepper_.setState(std::move(state));
    beyondLast_ = false;
}

}  // namespace se
