/// Forks: overrides of the rules at one place of a run.
#include "spiraling_edge/stepper/what_if.h"
#include "spiraling_edge/run/event_text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/run/timeline.h"
#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/what_if_check.h"
#include "support/clouds.h"
#include "support/open_surfaces.h"
#include "support/random_points.h"

using namespace se;
using namespace se::test;

namespace {

using Level = InvariantChecker::Level;

Params withWhatIfs(std::vector<WhatIf> whatIf, std::string_view set = "paper") {
    Params params = *paramsByName(set);
    params.whatIf = std::move(whatIf);
    return params;
}

WhatIf whatIf(const std::string& text) {
    const auto what = whatIfFromText(text);
    REQUIRE_MESSAGE(what.ok(), text);
    return what.value();
}

Status answer(const PointSet& points, const Params& params) {
    const auto answers = checkWhatIfs(points, params);
    REQUIRE(answers.has_value());
    return answers->back();
}

template <typename Matches>
Event firstEvent(const PointSet& points, const Params& params, const Matches& matches) {
    const auto all = eventsOf(points, params);
    const auto found = std::find_if(all.begin(), all.end(), matches);
    REQUIRE(found != all.end());
    return *found;
}

template <typename Evidence>
auto verdictIs(Verdict verdict) {
    return [verdict](const Event& event) {
        const auto* evidence = std::get_if<Evidence>(&event.evidence);
        return evidence != nullptr && evidence->verdict == verdict;
    };
}

std::string at(const Event& event, const char* verb, Index point) {
    return std::to_string(event.address.pivot) + "." + std::string(stageName(event.address.stage)) +
           " " + verb + " " + std::to_string(point);
}

PointSet sphere() { return prepared(closedFamilies(0.45)[0].sample(3)); }

std::uint64_t hashOf(const PointSet& points, const Params& params) {
    return runHash(runAll(points, params).state, params);
}

/// A random what-if about an event, valid or not.
WhatIf anyWhatIf(const PointSet& points, const Event& event, std::mt19937& random) {
    const auto number = [&](std::size_t below) { return static_cast<Index>(random() % below); };
    WhatIf what{static_cast<WhatIfKind>(number(5)),
                event.address.pivot,
                event.address.stage,
                testedPoint(event),
                Vec3(0.0),
                {}};
    if (what.point == kNone) what.point = number(points.size());
    if (what.kind >= WhatIfKind::Pivot) {
        what.stage = what.kind == WhatIfKind::Pivot ? Stage::Advance : Stage::Pivot;
        what.point = number(points.size());
    }
    if (what.kind == WhatIfKind::Move) {
        what.to = points.position[what.point] + 0.1 * points.normal[what.point];
    }
    for (Index i = 0; what.kind == WhatIfKind::List && i < 7; ++i) {
        const Index q = number(points.size());
        const bool twice = std::find(what.list.begin(), what.list.end(), q) != what.list.end();
        if (q != what.point && !twice) what.list.push_back(q);
    }
    return what;
}

}  // namespace

TEST_CASE("what-ifs read back from their text") {
    for (const char* text :
         {"137.sphere keep 812", "137.reciprocal drop 812", "12.limits drop 3", "9.twopoint keep 4",
          "12.limits keep 3", "7.guard keep 5", "7.guard drop 2", "137.advance pivot 640",
          "137 move 812 0.1 -2 3.5e-05", "1 list 812 5 7 9", "1 list 812"}) {
        CHECK(lineOf(whatIf(text)) == text);
        CHECK_FALSE(describe(whatIf(text)).empty());
    }
    CHECK(whatIf("137.sphere.3 keep 812") == whatIf("137.sphere keep 812"));
    CHECK(whatIf("137 move 1 1,2,3") == whatIf("137 move 1 1 2 3"));
    for (const char* text : {"", "137", "137 keep 812", "0.sphere keep 1", "137.emit keep 3",
                             "137.sphere keep", "137.sphere keep -1", "137 move 812 1 2",
                             "137 move 812 1 2 nan", "137.sphere push 4", "137 list 812 x"}) {
        const auto what = whatIfFromText(text);
        CHECK_MESSAGE(!what.ok(), text);
    }
}

TEST_CASE("a fork changes the run, and taking it back gives the same hash") {
    const PointSet points = sphere();
    const std::uint64_t before = hashOf(points, Params{});
    CHECK(before == stateHash(runAll(points, Params{}).state));
    const Event removed = firstEvent(points, Params{}, verdictIs<SphereEvidence>(Verdict::Removed));
    const Params fork = withWhatIfs({whatIf(at(removed, "keep", testedPoint(removed)))});
    CHECK(answer(points, fork).ok());
    CHECK(hashOf(points, fork) != before);
    CHECK(hashOf(points, fork) == hashOf(points, fork));
    CHECK(stateHash(runAll(points, fork).state) != before);
    CHECK(hashOf(points, withWhatIfs({})) == before);
}

TEST_CASE("a kept neighbor is in the fan, a dropped one is not, and nothing before it changes") {
    const PointSet points = sphere();
    const auto usual = eventsOf(points, Params{});
    const auto inFan = [&](const std::vector<Event>& events, std::uint32_t pivot, Index point) {
        return std::any_of(events.begin(), events.end(), [&](const Event& event) {
            const auto* made = std::get_if<EmitEvidence>(&event.evidence);
            return made != nullptr && event.address.pivot == pivot &&
                   (made->corners.b == point || made->corners.c == point);
        });
    };
    const auto fork = [&](Verdict verdict, const char* verb, bool expected) {
        const Event event = firstEvent(points, Params{}, verdictIs<SphereEvidence>(verdict));
        const Index point = testedPoint(event);
        const std::uint32_t pivot = event.address.pivot;
        CHECK(inFan(usual, pivot, point) != expected);
        const auto events = eventsOf(points, withWhatIfs({whatIf(at(event, verb, point))}));
        CHECK(inFan(events, pivot, point) == expected);
        for (std::size_t i = 0; i < usual.size() && usual[i].address.pivot < pivot; ++i) {
            CHECK(describe(events[i]) == describe(usual[i]));
        }
    };
    fork(Verdict::Removed, "keep", true);
    fork(Verdict::InsideSphere, "drop", false);
}

TEST_CASE("start and end do not advance to a point that is held off") {
    const PointSet points = sphere();
    const Event moved = firstEvent(points, Params{}, verdictIs<LimitEvidence>(Verdict::Moved));
    const Params fork = withWhatIfs({whatIf(at(moved, "drop", testedPoint(moved)))});
    CHECK(answer(points, fork).ok());
    const auto events = eventsOf(points, fork);
    CHECK(std::none_of(events.begin(), events.end(), [&](const Event& event) {
        return event.address.pivot == moved.address.pivot &&
               verdictIs<LimitEvidence>(Verdict::Moved)(event) &&
               testedPoint(event) == testedPoint(moved);
    }));
}

TEST_CASE("the traversal continues at the given point") {
    const PointSet points = sphere();
    Stepper stepper(points, Params{});
    for (int i = 0; i < 5; ++i) stepper.stepPivot();
    const State& state = stepper.state();
    const Index entry = state.rings.next(state.rings.next(state.pivot.pivot));
    const Index point = state.rings.point(entry);
    const Params fork = withWhatIfs({whatIf("5.advance pivot " + std::to_string(point))});
    CHECK(answer(points, fork).ok());
    Stepper forked(points, fork);
    for (int i = 0; i < 5; ++i) forked.stepPivot();
    CHECK(forked.state().rings.point(forked.state().pivot.pivot) == point);
    CHECK(firstBreach(points, fork, Level::AnyInput) == "");
    // A point that is DONE is on no ring.
    const Index done = state.done.front();
    const Status refused =
        answer(points, withWhatIfs({whatIf("5.advance pivot " + std::to_string(done))}));
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.error().message.find("no edge ring") != std::string::npos);
}

TEST_CASE("moved from the first pivot on, a point is as if it had been there") {
    const PointSet points = sphere();
    PointSet moved = points;
    moved.position[20] += 0.3 * (points.position[points.neighbors[20][0]] - points.position[20]);
    WhatIf what{WhatIfKind::Move, 1, Stage::Pivot, 20, moved.position[20], {}};
    CHECK(whatIf(lineOf(what)) == what);
    // Its list, and those that hold it, are by distance again.
    const auto edited = editedPoints(points, withWhatIfs({what}));
    REQUIRE(edited.size() == 1);
    CHECK(validate(edited[0].points).ok());
    moved.neighbors = edited[0].points.neighbors;
    CHECK(stateHash(runAll(points, withWhatIfs({what})).state) ==
          stateHash(runAll(moved, Params{}).state));
    // Later, all events before are unchanged.
    what.pivot = 30;
    Stepper plain(points, Params{});
    Stepper fork(points, withWhatIfs({what}));
    for (int i = 0; i < 29; ++i) {
        plain.stepPivot();
        fork.stepPivot();
    }
    CHECK(stateHash(plain.state()) == stateHash(fork.state()));
}

TEST_CASE("a list that is edited from the first pivot on is the list") {
    const PointSet points = sphere();
    WhatIf what{WhatIfKind::List, 1, Stage::Pivot, 20, Vec3(0.0), {}};
    const auto list = points.neighbors[20];
    what.list.assign(list.begin(), list.begin() + 6);
    std::reverse(what.list.begin(), what.list.end());
    const auto edited = editedPoints(points, withWhatIfs({what}));
    REQUIRE(edited.size() == 1);
    const auto made = edited[0].points.neighbors[20];
    CHECK(std::equal(made.begin(), made.end(), list.begin(), list.begin() + 6));
    CHECK(stateHash(runAll(points, withWhatIfs({what})).state) ==
          stateHash(runAll(edited[0].points, Params{}).state));
}

namespace {

/// The events of one pivot.
std::vector<Event> eventsAt(const PointSet& points, const Params& params, std::uint32_t pivot) {
    std::vector<Event> all = eventsOf(points, params);
    std::erase_if(all, [&](const Event& event) { return event.address.pivot != pivot; });
    return all;
}

template <typename Evidence>
std::size_t countOf(const std::vector<Event>& events) {
    return static_cast<std::size_t>(std::count_if(
        events.begin(), events.end(),
        [](const Event& event) { return std::holds_alternative<Evidence>(event.evidence); }));
}

Index pivotOf(const std::vector<Event>& events) {
    for (const Event& event : events) {
        if (const auto* e = std::get_if<PivotEvidence>(&event.evidence)) return e->pivot;
    }
    return kNone;
}

}  // namespace

TEST_CASE("a pivot makes no triangle where a what-if drops it, under any rules") {
    const PointSet points = sphere();
    for (const char* set : {"paper", "robust"}) {
        const Params usual = *paramsByName(set);
        const auto before = eventsAt(points, usual, 20);
        REQUIRE(countOf<EmitEvidence>(before) > 0);
        const std::string line = "20.guard drop " + std::to_string(pivotOf(before));
        const Params fork = withWhatIfs({whatIf(line)}, set);
        CHECK(answer(points, fork).ok());
        const auto after = eventsAt(points, fork, 20);
        CHECK(countOf<EmitEvidence>(after) == 0);
        const auto guard = std::find_if(after.begin(), after.end(), [](const Event& event) {
            return event.address.stage == Stage::Guard;
        });
        REQUIRE(guard != after.end());
        CHECK(describe(*guard) == "What if: no triangle is made.");
        CHECK_FALSE(answer(points, withWhatIfs({whatIf("20.guard drop 99")}, set)).ok());
    }
}

TEST_CASE("start or end advances against a convex ring by a what-if") {
    const PointSet points = sphere();
    std::size_t advanced = 0;
    for (const Event& event : eventsOf(points, Params{})) {
        const auto* limit = std::get_if<LimitEvidence>(&event.evidence);
        if (limit == nullptr || limit->verdict != Verdict::NotConcave) continue;
        const Params fork = withWhatIfs({whatIf(at(event, "keep", limit->to))});
        if (!answer(points, fork)) continue;
        for (const Event& now : eventsAt(points, fork, event.address.pivot)) {
            const auto* moved = std::get_if<LimitEvidence>(&now.evidence);
            if (moved == nullptr || moved->verdict != Verdict::WhatIfKept) continue;
            CHECK(moved->to == limit->to);
            CHECK(moved->moves());
            ++advanced;
        }
        if (advanced > 3) break;
    }
    CHECK(advanced > 0);
}

TEST_CASE("a rule on fans can be overruled, and the mesh stays a manifold") {
    std::size_t made = 0;
    for (const PointSet& points : {sphere(), randomPoints(3), randomPoints(5)}) {
        const auto events = eventsOf(points, *paramsByName("robust"));
        std::size_t tried = 0;
        for (const Event& event : events) {
            const auto* guard = std::get_if<GuardEvidence>(&event.evidence);
            if (guard == nullptr || ++tried > 12) continue;
            const std::uint32_t pivot = event.address.pivot;
            std::vector<Event> here = events;
            std::erase_if(here, [&](const Event& each) { return each.address.pivot != pivot; });
            const Index subject = guard->dropped == kNone ? pivotOf(here) : guard->dropped;
            const Params fork = withWhatIfs({whatIf(at(event, "keep", subject))}, "robust");
            const std::string what = lineOf(fork.whatIf[0]);
            if (!answer(points, fork)) continue;
            const auto after = eventsAt(points, fork, pivot);
            CHECK_MESSAGE(std::any_of(after.begin(), after.end(),
                                      verdictIs<GuardEvidence>(Verdict::WhatIfKept)),
                          what);
            CHECK_MESSAGE(firstBreach(points, fork, Level::Guarded) == "", what);
            made += countOf<EmitEvidence>(after) > countOf<EmitEvidence>(here) ? 1 : 0;
        }
    }
    CHECK(made > 5);
}

TEST_CASE("a what-if that would break an invariant is refused with its name") {
    const PointSet points = sphere();
    const auto reason = [&](const Event& event) {
        const Status status =
            answer(points, withWhatIfs({whatIf(at(event, "keep", testedPoint(event)))}));
        REQUIRE_FALSE(status.ok());
        return status.error().message;
    };
    const auto sorted = [&](Verdict verdict) {
        return firstEvent(points, Params{}, verdictIs<SortEvidence>(verdict));
    };
    CHECK(reason(sorted(Verdict::AlreadyDone)).find("invariant 7") != std::string::npos);
    CHECK(reason(sorted(Verdict::NotBeforeEnd)).find("invariant 8") != std::string::npos);
    CHECK_FALSE(answer(points, withWhatIfs({whatIf("99999.sphere keep 1")})).ok());
    CHECK_FALSE(answer(points, withWhatIfs({whatIf("5.sphere keep 99999")})).ok());
    CHECK_FALSE(answer(points, withWhatIfs({whatIf("5 list 20 20")})).ok());
    const Vec3 taken = points.position[7];
    const WhatIf onto{WhatIfKind::Move, 3, Stage::Pivot, 20, taken, {}};
    const Status there = answer(points, withWhatIfs({onto}));
    REQUIRE_FALSE(there.ok());
    CHECK(there.error().message.find("section 3") != std::string::npos);
    CHECK_FALSE(requireWhatIfs(points, withWhatIfs({onto})).ok());
}

TEST_CASE("forks are the same with a log and without, stepped, run, and revisited") {
    const PointSet points = sphere();
    const Event removed = firstEvent(points, Params{}, verdictIs<SphereEvidence>(Verdict::Removed));
    WhatIf moved{WhatIfKind::Move, 12, Stage::Pivot, 20, points.position[20] * 1.01, {}};
    const Params fork = withWhatIfs({whatIf(at(removed, "keep", testedPoint(removed))), moved});
    const std::uint64_t hash = stateHash(runAll(points, fork).state);
    EventLog log;
    CHECK(stateHash(runAll(points, fork, &log).state) == hash);
    Stepper phases(points, fork);
    while (phases.advance()) {
    }
    CHECK(stateHash(phases.state()) == hash);
    Timeline timeline(points, fork);
    timeline.seek(40);
    const std::uint64_t there = stateHash(timeline.state());
    timeline.seek(0xffffffffU);
    CHECK(stateHash(timeline.state()) == hash);
    timeline.seek(3);
    timeline.seek(40);
    CHECK(stateHash(timeline.state()) == there);
}

TEST_CASE(
    "every fork that is not refused keeps the invariants and ends, taken back, all is as before") {
    std::mt19937 random(20);
    std::size_t accepted = 0;
    std::size_t refused = 0;
    const PointSet sheet = prepared(sampleSheet(wavySheet(), 8, 80, 2));
    for (const PointSet& points : {sphere(), sheet}) {
        for (const std::string_view set : {"paper", "robust"}) {
            const auto events = eventsOf(points, *paramsByName(set));
            const std::uint64_t hash = hashOf(points, withWhatIfs({}, set));
            for (int i = 0; i < 40; ++i) {
                const Event& event = events[random() % events.size()];
                const Params fork = withWhatIfs({anyWhatIf(points, event, random)}, set);
                const std::string what = lineOf(fork.whatIf[0]);
                const Status status = answer(points, fork);
                if (!status) {
                    ++refused;
                    CHECK_MESSAGE(status.error().message.size() > 10, what);
                    continue;
                }
                ++accepted;
                const Level level = set == "robust" ? Level::Guarded : Level::AnyInput;
                CHECK_MESSAGE(firstBreach(points, fork, level) == "", what);
                CHECK_MESSAGE(hashOf(points, fork) != hash, what);
            }
            CHECK(hashOf(points, withWhatIfs({}, set)) == hash);
        }
    }
    CHECK(accepted > 30);
    CHECK(refused > 20);
}

namespace {

/// A ring of five that makes no triangle, and another one on the stack.
Params continuesAt(Index point) {
    Params params = paper();
    params.whatIf = {{WhatIfKind::Pivot, 2, Stage::Advance, point, Vec3(0.0), {}}};
    return params;
}
std::vector<Vec3> pentagonAndTriangle() {
    std::vector<Vec3> position;
    for (int i = 0; i < 5; ++i) position.push_back(polar(72.0 * i));
    for (int i = 0; i < 3; ++i) position.push_back(polar(120.0 * i) + Vec3(9, 0, 0));
    return position;
}

}  // namespace

TEST_CASE("the traversal that continues elsewhere begins a circuit there") {
    Rig plain(pentagonAndTriangle());
    plain.ring({0, 1, 2, 3, 4}).pivot().pivot();
    CHECK(plain.activeRing() == Points{2, 3, 4, 0, 1});
    CHECK(plain.state().circuit == 2);
    Rig rig(pentagonAndTriangle(), continuesAt(4));
    rig.ring({0, 1, 2, 3, 4}).pivot().pivot();
    CHECK(rig.activeRing() == Points{4, 0, 1, 2, 3});
    CHECK(rig.state().circuit == 0);
}

TEST_CASE("the traversal that continues on a stacked ring leaves its own on the stack") {
    Rig rig(pentagonAndTriangle(), continuesAt(6));
    rig.stacked({5, 6, 7}).ring({0, 1, 2, 3, 4}).pivot().pivot();
    CHECK(rig.activeRing() == Points{6, 7, 5});
    REQUIRE(rig.state().rings.stack().size() == 1);
    CHECK(rig.stackedRing() == Points{2, 3, 4, 0, 1});
}

TEST_CASE("points are edited in the order of the pivots, and not by lists of themselves") {
    const PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{1, 2}, {0, 2}, {1, 0}});
    Params params = paper();
    params.whatIf = {{WhatIfKind::Move, 20, Stage::Pivot, 1, Vec3(3, 0, 0), {}},
                     {WhatIfKind::Move, 10, Stage::Pivot, 2, Vec3(-0.5, 0, 0), {}},
                     {WhatIfKind::List, 30, Stage::Pivot, 0, Vec3(0.0), {0, 1}},
                     {WhatIfKind::List, 40, Stage::Pivot, 0, Vec3(0.0), {2}}};
    const std::vector<EditedPoints> made = editedPoints(points, params);
    REQUIRE(made.size() == 3);
    CHECK(made[0].from == 10);
    CHECK(made[1].from == 20);
    CHECK(made[2].from == 40);
    // Lists that name a moved point are sorted again, and so is its own.
    const auto list = [&](std::size_t i, Index p) {
        const auto ids = made[i].points.neighbors[p];
        return Points(ids.begin(), ids.end());
    };
    CHECK(list(0, 0) == Points{2, 1});
    CHECK(list(0, 1) == Points{0, 2});
    CHECK(list(0, 2) == Points{0, 1});
    CHECK(list(1, 1) == Points{0, 2});
    CHECK(list(2, 0) == Points{2});
}

TEST_CASE("a neighbor that a what-if drops at the sort is no candidate") {
    const auto trianglesWith = [](std::vector<WhatIf> changes) {
        Rig rig({{0, 0, 0}, polar(0), polar(150), {-9, -9, 0}, {9, -9, 0}, polar(75, 0.8)},
                withWhatIfs(std::move(changes)));
        return rig.list(0, {5}).ring({0, 2, 3, 4, 1}).pivot().triangles();
    };
    CHECK(trianglesWith({}) == Triangles{{0, 1, 5}, {0, 5, 2}});
    CHECK(trianglesWith({whatIf("1.sort drop 5")}) == Triangles{{0, 1, 2}});
}
