#include "spiraling_edge/run/breakpoint.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "spiraling_edge/run/timeline.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// One line for each kind of breakpoint, with points that occur in the run.
std::vector<std::string> kindsFor(const PointSet& points) {
    const Run run = runAll(points, paper());
    const Triangle t = run.state.triangles.at(run.state.triangles.size() / 2);
    const std::string p = std::to_string(t.a);
    const std::string q = std::to_string(t.b);
    return {"used=" + p,
            "done=" + p,
            "stranded",
            "pivot=" + p + " stage=pivot",
            "edge=" + p + "," + q,
            "stage=split",
            "stage=join",
            "closes",
            "component",
            "stage=twopoint refused",
            "stage=hole refused",
            "margin<0.01",
            "angle<25",
            "failure",
            "among=" + p + "," + q + ",0..9",
            "point=" + p,
            "alert"};
}

PointSet sceneOf(const char* id) { return prepared(findScene(id)->build()); }

HitList hitsOf(const PointSet& points, const std::string& line) {
    HitList list;
    const auto query = DecisionQuery::parse(line);
    REQUIRE(query.ok());
    const Params params = paper();
    const auto add = [&](std::size_t, const Hit& hit, const Decision&) { list.add(hit); };
    CHECK(sweep(points, params, hitVisitor(points, params, {query.value()}, add)).has_value());
    return list;
}

/// All decisions of the run, with their places.
std::vector<Hit> everything(const PointSet& points) { return hitsOf(points, "").hits; }

std::vector<Hit> forward(std::span<const ArmedBreakpoint> armed) {
    std::vector<Hit> stops;
    for (auto at = nextStop(armed, {}); at; at = nextStop(armed, at->hit.place))
        stops.push_back(at->hit);
    return stops;
}
std::vector<Hit> backward(std::span<const ArmedBreakpoint> armed, RunPosition end) {
    std::vector<Hit> stops;
    for (auto at = previousStop(armed, end); at; at = previousStop(armed, at->hit.place))
        stops.push_back(at->hit);
    std::reverse(stops.begin(), stops.end());
    return stops;
}
constexpr RunPosition kBehindAll{0xffffffffU, 0};

/// The matches of a line, searched in the log itself.
std::vector<Hit> matching(const PointSet& points, const std::string& line) {
    std::vector<Hit> found;
    const auto query = DecisionQuery::parse(line);
    REQUIRE(query.ok());
    const Params params = paper();
    const auto add = [&](const Decision& decision, RunPosition place) {
        if (query.value().matches(decision)) found.push_back({place, decision.event.address});
    };
    sweep(points, params, decisionVisitor(points, params, query.value().needsFailures(), add));
    return found;
}

/// Adds the hits of each kind to `hits`: a kind that never stops would be tested in vain.
void checkBothSides(const PointSet& points, std::map<std::size_t, std::size_t>& hits) {
    const std::vector<std::string> kinds = kindsFor(points);
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        const std::string& line = kinds[kind];
        CAPTURE(line);
        const HitList list = hitsOf(points, line);
        const Breakpoint breakpoint{"", line};
        const ArmedBreakpoint armed{&breakpoint, &list};
        const std::vector<Hit> there = forward({&armed, 1});
        CHECK(there == matching(points, line));
        CHECK(there == backward({&armed, 1}, kBehindAll));
        CHECK(list.total == there.size());
        hits[kind] += there.size();
    }
}

/// Directed steps of all rings that are edges of the mesh.
std::set<std::pair<Index, Index>> finishedSteps(const EdgeRings& rings) {
    std::set<std::pair<Index, Index>> steps;
    for (Index e = 0; e < rings.entryCapacity(); ++e) {
        if (rings.alive(e) && !rings.open(e))
            steps.insert({rings.point(e), rings.point(rings.next(e))});
    }
    return steps;
}

}  // namespace

TEST_CASE("breakpoints: every kind stops at the same addresses from both sides") {
    std::map<std::size_t, std::size_t> hits;
    for (const char* id : {"torus", "sheet", "long-lists", "coarse-torus", "figure-12",
                           "linked-tori", "four-edge-hole", "noise", "stranded-point"}) {
        CAPTURE(id);
        checkBothSides(sceneOf(id), hits);
    }
    checkBothSides(prepared(closedFamilies(4.0)[3].sample(5)), hits);
    for (const auto& [kind, count] : hits) {
        CAPTURE(kind);
        CHECK(count > 0);
    }
}

TEST_CASE("breakpoints: from any place, forward goes to the next hit and back to the one before") {
    const PointSet points = sceneOf("figure-12");
    const std::vector<Hit> all = everything(points);
    const HitList list = hitsOf(points, "stage=sphere refused");
    const Breakpoint breakpoint{"", "stage=sphere refused"};
    const ArmedBreakpoint armed{&breakpoint, &list};
    REQUIRE(list.hits.size() > 20);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto isHit = [&](const Hit& hit) {
            return std::find(list.hits.begin(), list.hits.end(), hit) != list.hits.end();
        };
        const auto ahead =
            std::find_if(all.begin() + static_cast<std::ptrdiff_t>(i) + 1, all.end(), isHit);
        const auto earlier = std::find_if(
            all.rbegin() + static_cast<std::ptrdiff_t>(all.size() - i), all.rend(), isHit);
        const auto next = nextStop({&armed, 1}, all[i].place);
        const auto previous = previousStop({&armed, 1}, all[i].place);
        REQUIRE(next.has_value() == (ahead != all.end()));
        REQUIRE(previous.has_value() == (earlier != all.rend()));
        if (next) CHECK(next->hit == *ahead);
        if (previous) CHECK(previous->hit == *earlier);
    }
}

TEST_CASE("breakpoints: hit counts run from the start, in both directions") {
    const PointSet points = sceneOf("torus");
    const HitList list = hitsOf(points, "stage=sort refused");
    REQUIRE(list.total > 100);
    for (const auto& [skip, every] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
             {0, 1}, {0, 7}, {10, 1}, {5, 3}, {1000000, 1}, {0, 1000000}, {3, 0}}) {
        CAPTURE(skip);
        CAPTURE(every);
        const Breakpoint breakpoint{"", "stage=sort refused", skip, every};
        const ArmedBreakpoint armed{&breakpoint, &list};
        std::vector<Hit> wanted;
        for (std::size_t i = 0; i < list.hits.size(); ++i) {
            const std::size_t number = i + 1;
            const bool stops = number > skip && (number - skip) % std::max(1U, every) == 0;
            CHECK(selectsHit(breakpoint, number) == stops);
            if (stops) wanted.push_back(list.hits[i]);
        }
        CHECK(forward({&armed, 1}) == wanted);
        CHECK(backward({&armed, 1}, kBehindAll) == wanted);
        if (!wanted.empty()) {
            const auto stop = nextStop({&armed, 1}, {});
            CHECK(list.hits[stop->number - 1] == stop->hit);
        }
    }
}

TEST_CASE("breakpoints: of several the nearest stops, those that are off or log-only do not") {
    const PointSet points = sceneOf("linked-tori");
    const HitList splits = hitsOf(points, "stage=split");
    const HitList ends = hitsOf(points, "component");
    REQUIRE(ends.total == 2);
    Breakpoint split{"", "stage=split"};
    const Breakpoint end{"", "component"};
    const auto armed = [&] {
        return std::vector<ArmedBreakpoint>{{&split, &splits}, {&end, &ends}};
    };
    CHECK(forward(armed()).size() == splits.total + 2);
    CHECK(forward(armed()) == backward(armed(), kBehindAll));
    split.logOnly = true;
    CHECK(forward(armed()) == ends.hits);
    split.logOnly = false;
    split.on = false;
    CHECK(backward(armed(), kBehindAll) == ends.hits);
    CHECK(nextStop(armed(), {})->breakpoint == 1);
    CHECK_FALSE(nextStop({}, {}).has_value());
}

TEST_CASE("breakpoints: places number the events of a pivot as the timeline lists them") {
    for (const char* rules : {"paper", "robust"}) {
        const PointSet points = sceneOf("uneven-density");
        std::map<std::uint32_t, std::vector<Address>> pivots;
        const Params params = *paramsByName(rules);
        const auto add = [&](const Decision& d, RunPosition place) {
            REQUIRE(place.event == pivots[place.pivot].size());
            pivots[place.pivot].push_back(d.event.address);
        };
        sweep(points, params, decisionVisitor(points, params, false, add));
        Timeline timeline(points, params);
        for (std::uint32_t pivot = 1; pivot <= pivots.rbegin()->first; ++pivot) {
            std::vector<Address> listed;
            const auto record = timeline.record(pivot);
            for (const Event& event : record->events) listed.push_back(event.address);
            CHECK((listed == pivots[pivot]));
        }
    }
}

TEST_CASE("query: used and done hold exactly where a status changes") {
    for (const char* id : {"sheet", "figure-14", "stranded-point", "torus"}) {
        CAPTURE(id);
        const PointSet points = sceneOf(id);
        const DecisionQuery used = DecisionQuery::parse("used").value();
        const DecisionQuery done = DecisionQuery::parse("done").value();
        std::vector<PointStatus> before(points.size(), kUnused);
        sweep(points, paper(), [&](const SweptPivot& pivot) {
            std::set<Index> usedNow;
            std::set<Index> doneNow;
            for (const Event& event : pivot.events) {
                const std::optional<Reading> none;
                const Decision decision{event, pivot.point, none, points, pivot.events};
                for (Index p = 0; p < points.size(); ++p) {
                    if (before[p] == pivot.after.status[p]) continue;
                    const auto is = [&](const char* term) {
                        return DecisionQuery::parse(term + std::to_string(p))
                            .value()
                            .matches(decision);
                    };
                    if (used.matches(decision) && is("used=")) usedNow.insert(p);
                    if (done.matches(decision) && is("done=")) doneNow.insert(p);
                }
            }
            for (Index p = 0; p < points.size(); ++p) {
                const PointStatus was = std::exchange(before[p], pivot.after.status[p]);
                if (was == kUnused && before[p] > 0) CHECK(usedNow.contains(p));
                CHECK(doneNow.contains(p) == (was != kDone && before[p] == kDone));
            }
        });
    }
}

TEST_CASE("query: a finished step that is new on a ring was met as an edge in that pivot") {
    for (const char* id : {"torus", "sheet", "figure-12"}) {
        CAPTURE(id);
        const PointSet points = sceneOf(id);
        std::set<std::pair<Index, Index>> before;
        std::size_t fresh = 0;
        sweep(points, paper(), [&](const SweptPivot& pivot) {
            auto now = finishedSteps(pivot.after.rings);
            for (const auto& [a, b] : now) {
                if (before.contains({a, b})) continue;
                ++fresh;
                const DecisionQuery edge =
                    DecisionQuery::parse("edge=" + std::to_string(b) + "," + std::to_string(a))
                        .value();
                const std::optional<Reading> none;
                CHECK(std::any_of(pivot.events.begin(), pivot.events.end(), [&](const Event& e) {
                    return edge.matches({e, pivot.point, none, points, pivot.events});
                }));
            }
            before = std::move(now);
        });
        CHECK(fresh > 100);
    }
}

TEST_CASE("query: a failure appears in the run if its class is in the mesh of a gallery scene") {
    std::size_t looked = 0;
    for (const FailureScene& each : failureScenes()) {
        const FailureClass* kind = findFailureClass(each.failure);
        REQUIRE(kind != nullptr);
        if (!appearsInRun(*kind)) continue;
        CAPTURE(std::string(each.scene.id));
        const PointSet points = prepared(each.scene.build());
        const HitList list = hitsOf(points, "failure=" + std::string(kind->name));
        CHECK(list.total > 0);
        CHECK(list.total <= hitsOf(points, "failure").total);
        ++looked;
    }
    CHECK(looked > 5);
}

TEST_CASE("query: what is wrong with triangles appears in the run just if the mesh has it") {
    for (const char* id : {"torus", "sphere", "grid", "noise", "wrong-lists", "sharp-crease"}) {
        const PointSet points = sceneOf(id);
        const auto failures = inspectMesh(points, runAll(points, paper()).state.mesh());
        for (const FailureClass& kind : failureClasses()) {
            // Points and loops are examined before the end of the run: the final result may differ.
            // Classes that only a run has occur in no mesh.
            const bool ofTriangles = kind.name != "holes" && kind.name != "lost_points";
            if (!ofTriangles || !appearsInRun(kind) || kind.find == nullptr) continue;
            CAPTURE(id);
            CAPTURE(std::string(kind.name));
            const bool inMesh =
                std::any_of(failures.begin(), failures.end(),
                            [&](const MeshFailure& each) { return each.kind == &kind; });
            CHECK((hitsOf(points, "failure=" + std::string(kind.name)).total > 0) == inMesh);
        }
    }
}

TEST_CASE("query: a class that is known only at the end, or unknown, is an error with the others") {
    for (const char* bad : {"failure=dragons", "failure="})
        CHECK(DecisionQuery::parse(bad).error().message.find(bad) != std::string::npos);
    for (const FailureClass& kind : failureClasses()) {
        const std::string line = "failure=" + std::string(kind.name);
        CAPTURE(line);
        const auto query = DecisionQuery::parse(line);
        CHECK(query.ok() == appearsInRun(kind));
        const bool ofWholeMesh = kind.name == "small_components" ||
                                 kind.name == "isolated_points" || kind.name == "openings" ||
                                 kind.name == "inward_pieces" || kind.name == "spikes";
        CHECK(appearsInRun(kind) != ofWholeMesh);
        if (query.ok()) continue;
        const std::string& message = query.error().message;
        CHECK(message.find("known only when the run has ended") != std::string::npos);
        CHECK(message.find("intersecting_triangles") != std::string::npos);
    }
}

TEST_CASE("query: a ring that is left over can be stopped at, once for each") {
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(std::string(each.scene.id));
        const PointSet points = prepared(each.scene.build());
        const std::size_t rings = runAll(points, paper()).state.alerts.size();
        CHECK(hitsOf(points, "failure=leftover_rings").total == rings);
    }
}

TEST_CASE("query: points of a set may be given as ranges") {
    const PointSet points = sceneOf("sphere");
    CHECK(hitsOf(points, "among=3..6,40").hits == hitsOf(points, "among=3,4,5,6,40").hits);
    for (const char* bad : {"among=6..3", "among=3..", "among=..4", "among=0..4000000000"})
        CHECK_FALSE(DecisionQuery::parse(bad).ok());
}
