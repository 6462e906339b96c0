/// The steps after the last pivot, in both directions of time.
#pragma once

#include <cstdint>
#include <vector>

#include "spiraling_edge/stepper/state.h"

namespace se {

/// The places of a run after its last pivot: each after one step, the last at the end of the run.
/// They differ in few triangles, so that the journal of the mesh leads from any to any: O(changes
/// between them). Pivots before them have no such mesh; it is put aside while the cursor is there.
class RepairHistory {
  public:
    /// No step after the last pivot was reached so far.
    bool empty() const { return places_.empty(); }
    /// Number of places known so far.
    std::size_t size() const { return places_.size(); }
    /// The position of the first place: pivots completed there, or one more if it is the end, since
    /// no step was possible.
    std::uint32_t firstPosition() const {
        const Place& first = places_.front();
        return first.counters.pivots + (first.phase == Phase::Finished ? 1U : 0U);
    }
    /// The place of `state`, which is one of these.
    std::size_t placeOf(const State& state) const;

    /// Adds the place of `state`, just after a step or at the end of the run, unless it is known.
    void add(State& state);
    /// Brings `state`, which is at one of the places, to another.
    void moveTo(State& state, std::size_t place);
    /// Takes the mesh out of a state that leaves the places, or steps that were not added, for a
    /// pivot before them.
    void putAside(State& state);
    /// Brings a state to the first place, with the mesh that was put aside.
    void takeUp(State& state);

  private:
    struct Place {
        Counters counters;
        Phase phase;
        RepairPlace mesh;
    };
    std::vector<Place> places_;
    RepairState aside_;
};

}  // namespace se
