#include "spiraling_edge/stepper/state.h"

#include <doctest/doctest.h>

#include <functional>
#include <set>

using namespace se;

namespace {

/// A state with an active ring, one on the stack and one on the shelf, one triangle and one alert.
State sample() {
    State s(9);
    EdgeRings& rings = s.rings;
    const auto ring = [&](Index a, Index b, Index c) {
        const Index head = rings.start(a, b);
        rings.insertAfter(rings.next(head), c);
        for (Index p : {a, b, c}) s.status[p] = 1;
        return head;
    };
    rings.shelve(ring(0, 1, 2));
    const Index stacked = ring(3, 4, 5);
    rings.push(rings.ringOf(stacked), stacked);
    s.pivot.pivot = ring(6, 7, 8);
    s.pivot.first = s.pivot.start = rings.prev(s.pivot.pivot);
    s.pivot.last = s.pivot.end = rings.next(s.pivot.pivot);
    s.phase = Phase::Sphere;
    s.triangles = {{6, 7, 8}};
    s.repair.triangles = std::vector<Triangle>{{0, 1, 2}};
    s.alerts = {{AlertKind::Hole, 3, 4}};
    s.pivot.candidates.resize(1);
    s.pivot.candidates[0].point = 2;
    return s;
}

}  // namespace

TEST_CASE("state hash: equal for equal states, and another one after any change of a part") {
    CHECK(stateHash(sample()) == stateHash(sample()));
    const std::vector<std::function<void(State&)>> changes{
        [](State&) {},
        [](State& s) { s.phase = Phase::TwoPoint; },
        [](State& s) { s.startPointer = 1; },
        [](State& s) { s.circuit = 1; },
        [](State& s) { s.retryLevel = 1; },
        [](State& s) { s.seedsSpent = true; },
        [](State& s) { s.status[0] = kDone; },
        [](State& s) { ++s.counters.pivots; },
        [](State& s) { ++s.counters.stranded; },
        [](State& s) { ++s.counters.shelved; },
        [](State& s) { ++s.counters.failedSeeds; },
        [](State& s) { s.pivot.candidates[0].point = 5; },
        [](State& s) { s.pivot.candidates.clear(); },
        [](State& s) { s.pivot.end = s.pivot.start; },
        // A step of the active ring, and one of the stacked ring.
        [](State& s) { s.rings.setOpen(s.pivot.pivot, !s.rings.open(s.pivot.pivot)); },
        [](State& s) {
            const Index e = s.rings.head(s.rings.stack().back());
            s.rings.setOpen(e, !s.rings.open(e));
        },
        [](State& s) { s.rings.insertAfter(s.pivot.end, 0); },
        [](State& s) { s.rings.insertAfter(s.rings.head(s.rings.stack().back()), 0); },
        [](State& s) { s.rings.insertAfter(s.rings.head(s.rings.stack().front()), 0); },
        [](State& s) { s.rings.unshelve(); },
        [](State& s) {
            s.triangles[0] = {7, 8, 6};
        },
        [](State& s) {
            s.triangles.push_back({0, 1, 2});
        },
        [](State& s) {
            s.repair.triangles.set(0, {1, 2, 0});
        },
        [](State& s) { s.alerts[0].point = 5; },
        [](State& s) { s.alerts[0].kind = AlertKind::LostSeed; },
        [](State& s) { s.alerts.clear(); },
    };
    std::set<std::uint64_t> hashes;
    for (const auto& change : changes) {
        State s = sample();
        change(s);
        hashes.insert(stateHash(s));
    }
    CHECK(hashes.size() == changes.size());
}

TEST_CASE("state hash: the order of entries in memory does not count") {
    State a = sample();
    State b = sample();
    // The same ring again, by another entry.
    const Index next = b.rings.next(b.pivot.pivot);
    const bool open = b.rings.open(b.pivot.pivot);
    const bool after = b.rings.open(next);
    const Index point = b.rings.point(next);
    b.rings.erase(next);
    const Index again = b.rings.insertAfter(b.pivot.pivot, point);
    b.rings.setOpen(b.pivot.pivot, open);
    b.rings.setOpen(again, after);
    b.pivot.last = b.pivot.end = again;
    CHECK(stateHash(a) == stateHash(b));
}
