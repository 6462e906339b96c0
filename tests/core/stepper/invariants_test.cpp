#include "spiraling_edge/stepper/invariants.h"

#include <doctest/doctest.h>

#include <functional>

#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/rules.h"
#include "support/clouds.h"

using namespace se;
using namespace se::test;

namespace {

using Level = InvariantChecker::Level;

/// A scene stepped `pivots` pivots under a checker, then once more with a fault planted.
std::string found(const std::function<void(State&)>& plant, Level level = Level::WellSampled,
                  std::uint32_t pivots = 12) {
    const PointSet points = prepared(findScene("figure-12")->build());
    Stepper stepper(points, paper());
    InvariantChecker checker(points, paper(), level);
    std::string problem = checker.check(stepper.state());
    for (std::uint32_t i = 0; i < pivots && problem.empty(); ++i) {
        stepper.stepPivot();
        problem = checker.check(stepper.state());
    }
    CHECK(problem.empty());
    stepper.stepPivot();
    State state = stepper.state();
    plant(state);
    return checker.check(state);
}

bool begins(const std::string& text, const std::string& head) { return text.rfind(head, 0) == 0; }

Index anyEntry(const State& s) { return s.rings.head(s.rings.active()); }
Index firstDone(const State& s) {
    Index p = 0;
    while (s.status[p] != kDone) ++p;
    return p;
}
Index firstUnused(const State& s) {
    Index p = 0;
    while (s.status[p] != kUnused) ++p;
    return p;
}

}  // namespace

TEST_CASE("invariants: a sound run has no breach") {
    CHECK(found([](State&) {}) == "");
}

TEST_CASE("invariant 1: status counts live entries") {
    CHECK(begins(found([](State& s) { ++s.status[s.rings.point(anyEntry(s))]; }), "1:"));
    CHECK(begins(found([](State& s) { s.status[s.rings.point(anyEntry(s))] = kDone; }), "1:"));
    CHECK(begins(found([](State& s) { s.status[firstUnused(s)] = 1; }), "1:"));
    CHECK(begins(found([](State& s) { s.rings.insertAfter(anyEntry(s), firstUnused(s)); }), "1:"));
}

TEST_CASE("invariant 2: no ring of one, none of two finished edges, each ring in one place") {
    CHECK(begins(found([](State& s) {
                     while (s.rings.length(s.rings.active()) > 1) {
                         const Index e = s.rings.next(anyEntry(s));
                         s.status[s.rings.point(e)] = kDone;
                         s.rings.erase(e);
                     }
                 }),
                 "2:"));
    CHECK(begins(found([](State& s) {
                     while (s.rings.length(s.rings.active()) > 2) {
                         const Index e = s.rings.next(anyEntry(s));
                         s.status[s.rings.point(e)] = kDone;
                         s.rings.erase(e);
                     }
                 }),
                 "2:"));
    CHECK(begins(found([](State& s) {  // A detached part of the ring.
                     const Index x = anyEntry(s);
                     s.rings.exchangeSuccessors(x, s.rings.next(s.rings.next(x)));
                 }),
                 "1:"));
}

TEST_CASE("invariants 3 to 5: ring steps and mesh edges fit together") {
    CHECK(begins(found([](State& s) {  // A jump that is no edge of the mesh.
                     const Index p = firstUnused(s);
                     s.rings.insertAfter(anyEntry(s), p);
                     s.status[p] = 1;
                 }),
                 "3:"));
    CHECK(begins(found([](State& s) {  // The same triangle again.
                     s.triangles.push_back(s.triangles.back());
                     ++s.pivotTriangles;
                     s.triangles.back().b = s.triangles[s.triangles.size() - 2].c;
                     s.triangles.back().c = s.triangles[s.triangles.size() - 2].b;
                     ++s.pivotTriangles;
                     s.triangles.push_back(s.triangles[s.triangles.size() - 2]);
                 }),
                 "5:"));
    CHECK(found(
              [](State& s) {
                  const Index p = firstUnused(s);
                  s.rings.insertAfter(anyEntry(s), p);
                  s.status[p] = 1;
              },
              Level::AnyInput) == "");
}

TEST_CASE("invariant 6: triangles are appended, in fans around the pivot") {
    CHECK(begins(found([](State& s) { s.triangles.pop_back(); }), "6:"));
    CHECK(begins(found([](State& s) { std::swap(s.triangles[0], s.triangles[1]); }), "6:"));
    CHECK(begins(found([](State& s) { s.triangles.resize(3); }), "6:"));
    CHECK(begins(found([](State& s) { ++s.pivotTriangles; }), "6:"));
    CHECK(begins(found([](State& s) {
                     s.triangles.push_back({1, 2, 3});
                     ++s.pivotTriangles;
                 }),
                 "6:"));
    CHECK(begins(found([](State& s) {
                     s.triangles.push_back({s.triangles.back().a, 0, 1});
                     ++s.pivotTriangles;
                 }),
                 "6:"));
}

TEST_CASE("invariant 7: DONE is final, and DONE or UNUSED points are in no new triangle") {
    CHECK(begins(found([](State& s) { s.status[firstDone(s)] = kUnused; }), "7:"));
    const auto extend = [](State& s, Index p) {
        s.triangles.push_back({s.triangles.back().a, s.triangles.back().c, p});
        ++s.pivotTriangles;
    };
    CHECK(begins(found([&](State& s) { extend(s, s.triangles[0].a); }), "7:"));
    CHECK(begins(found([&](State& s) { extend(s, firstUnused(s)); }), "7:"));
}

TEST_CASE("invariant 8: angles increase") {
    CHECK(begins(found([](State& s) {
                     Candidate c;
                     c.angle = makeAngle(0.5, false);
                     s.pivot.candidates = {c, c};
                     s.pivot.startAngle = Angle{};
                     s.pivot.endAngle = kFullTurn;
                 }),
                 "8:"));
    CHECK(begins(found([](State& s) {
                     Candidate c;
                     c.angle = makeAngle(-0.5, false);
                     s.pivot.candidates = {c};
                     s.pivot.startAngle = Angle{};
                     s.pivot.endAngle = makeAngle(0.0, false);
                 }),
                 "8:"));
}

TEST_CASE("invariant 9: a pivot without triangles changes no status") {
    const PointSet points = prepared(findScene("figure-8")->build());
    for (const bool stranded : {false, true}) {
        InvariantChecker checker(points, paper(), Level::AnyInput);
        State state(points.size());
        state.status[0] = kDone;
        state.counters.stranded = stranded ? 1 : 0;
        CHECK(begins(checker.check(state), "9:") == !stranded);
    }
}

TEST_CASE("invariant 10: rings come and go only by what is counted") {
    CHECK(begins(found([](State& s) { ++s.counters.splits; }), "10:"));
    CHECK(begins(found([](State& s) { ++s.counters.joins; }), "10:"));
    CHECK(begins(found([](State& s) { ++s.counters.closedRings; }), "10:"));
}

TEST_CASE("invariant 11: the circuit is shorter than the ring, the start pointer only advances") {
    CHECK(begins(found([](State& s) { s.circuit = s.rings.length(s.rings.active()); }), "11:"));
    const PointSet points = prepared(findScene("figure-8")->build());
    State state(points.size());
    state.startPointer = 1;
    CHECK(begins(checkInvariants(state, points, paper()), "11:"));
    // Each failed seed lets the pointer pass one UNUSED point.
    state.counters.failedSeeds = 1;
    CHECK(checkInvariants(state, points, paper()) == "");
    state.startPointer = 2;
    CHECK(begins(checkInvariants(state, points, paper()), "11:"));
    state.startPointer = 1;
    state.counters.failedSeeds = 0;
    InvariantChecker checker(points, paper(), Level::AnyInput);
    state.status[0] = kDone;
    state.counters.stranded = 1;
    CHECK(checker.check(state) == "");
    state.startPointer = 0;
    CHECK(begins(checker.check(state), "11:"));
}

TEST_CASE("invariant 12: what becomes DONE is surrounded") {
    CHECK(begins(found([](State& s) {
                     const Index e = anyEntry(s);
                     const Index p = s.rings.point(e);
                     s.rings.setOpen(s.rings.prev(e), true);
                     s.rings.erase(e);
                     s.status[p] = kDone;
                     s.pivot.pivot = anyEntry(s);
                 }),
                 "12:"));
}

TEST_CASE("invariant 13: at the end every point is DONE") {
    const PointSet points = prepared(findScene("figure-8")->build());
    State state = runAll(points, paper()).state;
    CHECK(checkInvariants(state, points, paper()) == "");
    state.status[7] = kUnused;
    CHECK(begins(checkInvariants(state, points, paper()), "13:"));
}
