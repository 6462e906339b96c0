#include "spiraling_edge/timeline.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace se {

namespace {

/// Pivots between two questions to keepGoing: well under a millisecond.
constexpr std::uint32_t kAskEvery = 32;

/// Of the edge table of a triangle: two words for each of its sides.
constexpr std::size_t kSideBytes = 6 * sizeof(Index);

std::size_t bytesOf(const State& state, std::size_t triangleCount) {
    const EdgeRings& rings = state.rings;
    return sizeof(State) + state.status.size() * sizeof(PointStatus) +
           rings.pointCount() * sizeof(Index) + rings.entryCapacity() * sizeof(RingEntry) +
           rings.ringCapacity() * 3 * sizeof(Index) +
           state.pivot.candidates.size() * sizeof(Candidate) +
           (state.edges.empty() ? 0
                                : rings.pointCount() * sizeof(Index) + triangleCount * kSideBytes) +
           (state.mend.empty() ? 0
                               : rings.pointCount() * sizeof(Index) +
                                     state.mend.triangles.size() * (sizeof(Triangle) + kSideBytes));
}

/// Makes `list` the first `count` elements of a run whose longest known list is `known`.
/// Both are beginnings of the same list, so only the difference is touched.
template <typename T>
void cutOrFill(std::vector<T>& list, const std::vector<T>& known, std::size_t count) {
    if (list.size() >= count) {
        list.resize(count);
    } else {
        const auto from = known.begin() + static_cast<std::ptrdiff_t>(list.size());
        list.insert(list.end(), from, known.begin() + static_cast<std::ptrdiff_t>(count));
    }
}

template <typename T>
void appendRest(std::vector<T>& known, const std::vector<T>& list) {
    if (list.size() > known.size()) {
        known.insert(known.end(), list.begin() + static_cast<std::ptrdiff_t>(known.size()),
                     list.end());
    }
}

}  // namespace

Timeline::Timeline(const PointSet& points, const Params& params, std::size_t byteBudget)
    : stepper_(points, params), byteBudget_(byteBudget) {
    rememberKeyframe();
}

bool Timeline::stepPivot() {
    if (state().finished()) {
        endKnown_ = true;
        return false;
    }
    const Counters before = state().counters;
    const bool complete = stepper_.stepPivot();
    appendRest(knownTriangles_, state().triangles);
    appendRest(knownAlerts_, state().alerts);
    farthest_ = std::max(farthest_, position());
    if (!complete) {
        // Behind the last pivot. Whatever happens there is counted.
        endKnown_ = true;
        beyondLast_ = true;
        tail_ = !(state().counters == before);
    } else if (position() % spacing_ == 0) {
        rememberKeyframe();
    }
    return complete;
}

void Timeline::seek(std::uint32_t pivot, const std::function<bool()>& keepGoing) {
    if (pivot < position() || (beyondLast_ && pivot == position())) {
        restore(std::prev(keyframes_.upper_bound(pivot))->second);
    } else if (const auto nearest = std::prev(keyframes_.upper_bound(pivot));
               nearest->first > position() + spacing_) {
        restore(nearest->second);
    }
    for (std::uint32_t asked = 0; position() < pivot; ++asked) {
        if (asked % kAskEvery == kAskEvery - 1 && keepGoing && !keepGoing()) return;
        if (!stepPivot()) return;
    }
}

std::vector<Event> Timeline::eventsOf(std::uint32_t pivot) {
    if (pivot == 0 || (endKnown_ && pivot > lastPivot())) return {};
    seek(pivot - 1);
    if (position() != pivot - 1 || state().finished()) return {};
    const Keyframe here = makeKeyframe();
    EventLog log;
    stepper_.setLog(&log);
    stepPivot();
    stepper_.setLog(nullptr);
    restore(here);
    return log.events();
}

Timeline::Keyframe Timeline::makeKeyframe() {
    // The lists are put aside while copying: they may be much larger than all the rest.
    State state = stepper_.takeState();
    std::vector<Triangle> triangles = std::exchange(state.triangles, {});
    std::vector<Alert> alerts = std::exchange(state.alerts, {});
    Keyframe keyframe{state, triangles.size(), alerts.size()};
    state.triangles = std::move(triangles);
    state.alerts = std::move(alerts);
    stepper_.setState(std::move(state));
    return keyframe;
}

void Timeline::rememberKeyframe() {
    if (keyframes_.contains(position())) return;
    Keyframe keyframe = makeKeyframe();
    keyframeBytes_ += bytesOf(keyframe.state, keyframe.triangleCount);
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
            keyframeBytes_ += bytesOf(it->second.state, it->second.triangleCount);
            ++it;
        }
    }
}

void Timeline::restore(const Keyframe& keyframe) {
    State old = stepper_.takeState();
    State state = keyframe.state;
    state.triangles = std::move(old.triangles);
    state.alerts = std::move(old.alerts);
    cutOrFill(state.triangles, knownTriangles_, keyframe.triangleCount);
    cutOrFill(state.alerts, knownAlerts_, keyframe.alertCount);
    stepper_.setState(std::move(state));
    beyondLast_ = false;
}

}  // namespace se
