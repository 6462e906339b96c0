#include "spiraling_edge/run/repair_history.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace se {

std::size_t RepairHistory::placeOf(const State& state) const {
    // The end has as many pivots as the place before it.
    if (state.finished()) return places_.size() - 1;
    return state.counters.pivots - firstPosition();
}

void RepairHistory::add(State& state) {
    if (places_.empty()) {
        state.repair.beginJournal();
    } else if (state.finished() ? places_.back().phase == Phase::Finished
                                : placeOf(state) < places_.size()) {
        return;
    }
    places_.push_back({state.counters, state.phase, state.repair.place()});
}

void RepairHistory::moveTo(State& state, std::size_t place) {
    assert(place < places_.size());
    const Place& to = places_[place];
    state.counters = to.counters;
    state.phase = to.phase;
    state.repair.moveTo(to.mesh);
}

void RepairHistory::putAside(State& state) {
    if (state.repair.empty()) return;
    RepairState mesh = std::exchange(state.repair, {});
    if (!empty()) aside_ = std::move(mesh);
}

void RepairHistory::takeUp(State& state) {
    state.repair = std::exchange(aside_, {});
    moveTo(state, 0);
}

}  // namespace se
