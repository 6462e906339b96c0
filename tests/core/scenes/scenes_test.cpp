#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/run/event_text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "spiraling_edge/run/reading.h"
#include "support/clouds.h"

using namespace se;
using namespace se::test;

namespace {

struct Watched {
    Run run;
    EventLog log;
};
Watched watch(std::string_view id, const Params& params = paper()) {
    Watched watched;
    const Scene& scene = *findScene(id);
    watched.run = runAll(prepared(scene.build()), withStartOf(scene, params), &watched.log);
    return watched;
}

/// True if a pivot has fitting evidence of one kind.
template <typename E, typename Fits>
bool happens(const Watched& watched, std::uint32_t pivot, Fits&& fits) {
    for (const Event& event : watched.log.events()) {
        const E* e = std::get_if<E>(&event.evidence);
        if (e != nullptr && event.address.pivot == pivot && fits(*e)) return true;
    }
    return false;
}

/// Points that enter the ring in a pivot.
Points entering(const Watched& watched, std::uint32_t pivot) {
    Points points;
    for (const Event& event : watched.log.events()) {
        const auto* e = std::get_if<RingEvidence>(&event.evidence);
        if (e != nullptr && event.address.pivot == pivot && e->inserted) points.push_back(e->point);
    }
    return points;
}

}  // namespace

TEST_CASE("scenes are found by an id of their own, the default first") {
    std::set<std::string_view> ids;
    for (const Scene& scene : scenes()) {
        ids.insert(scene.id);
        CHECK(findScene(scene.id) == &scene);
        CHECK(scene.title.size() > 3);
        CHECK(scene.watch.back() == '.');
    }
    CHECK(ids.size() == scenes().size());
    CHECK(scenes()[0].id == "sphere");
    CHECK(findScene("no such scene") == nullptr);
}

TEST_CASE("scenes need no repair") {
    for (const Scene& scene : scenes()) {
        const PointFile file = scene.build();
        const auto result = prepare(file, {});
        REQUIRE(result.ok());
        const PrepareReport& report = result.value().report;
        CHECK(report.count(Aside::NotFinite) + report.count(Aside::NoNormal) +
                  report.count(Aside::Copy) ==
              0);
        CHECK(report.unscaledNormals + report.droppedListEntries == 0);
    }
}

TEST_CASE("scenes are equal on every machine: pinned coordinates") {
    const auto hashOf = [](std::string_view id) {
        std::uint64_t hash = 0xCBF29CE484222325ULL;
        for (const Vec3& x : findScene(id)->build().position) {
            for (const double c : {x.x, x.y, x.z}) {
                std::uint64_t bits = 0;
                std::memcpy(&bits, &c, sizeof bits);
                hash = (hash ^ bits) * 0x100000001B3ULL;
            }
        }
        return hash;
    };
    CHECK(hashOf("sphere") == 17022089214157544501ULL);
    CHECK(hashOf("figure-12") == 12226539399958568179ULL);
    CHECK(hashOf("sheet") == 8746616412449034750ULL);
}

TEST_CASE("closed scenes become closed manifolds of their genus") {
    struct Closed {
        std::string_view id;
        long long euler;
    };
    const Closed expected[] = {
        {"sphere", 2}, {"torus", 0}, {"linked-tori", 0}, {"genus-2", -2}, {"figure-12", 0}};
    for (const Closed& e : expected) {
        const Watched w = watch(e.id);
        CHECK_MESSAGE(w.run.mesh.closedManifold(), e.id);
        CHECK_MESSAGE(w.run.mesh.eulerCharacteristic == e.euler, e.id);
        const auto used = static_cast<long long>(w.run.mesh.usedPoints);
        CHECK(static_cast<long long>(w.run.mesh.triangles) == 2 * used - 2 * e.euler);
    }
    CHECK(watch("linked-tori").run.mesh.components == 2);
}

TEST_CASE("typed scenes become sheets that end at their walls") {
    struct Sheet {
        std::string_view id;
        std::size_t rim;
    };
    const Sheet expected[] = {
        {"sheet", 64}, {"grid", 32}, {"figure-2", 32}, {"figure-8", 24}, {"figure-14", 24}};
    for (const Sheet& e : expected) {
        const MeshReport mesh = watch(e.id).run.mesh;
        CHECK_MESSAGE(mesh.boundaryEdges == e.rim, e.id);
        CHECK(mesh.boundaryLoops == 1);
        CHECK(mesh.eulerCharacteristic == 1);
        CHECK(mesh.unusedPoints == 0);
        CHECK(mesh.nonManifoldEdges + mesh.nonManifoldVertices + mesh.flippedTriangles == 0);
        CHECK(mesh.triangles == 2 * mesh.points - e.rim - 2);
    }
}

TEST_CASE("5 Figure 2: the first five pivots add the points of the figure") {
    const Watched w = watch("figure-2");
    // Numbers of the figure less one.
    CHECK(entering(w, 1) == Points{2, 3, 4, 5, 6});
    CHECK(entering(w, 2) == Points{7, 8, 9});
    CHECK(entering(w, 3) == Points{10});
    CHECK(entering(w, 4) == Points{11, 12});
    CHECK(entering(w, 5) == Points{13, 14, 15});
    const PointSet points = prepared(findScene("figure-2")->build());
    Stepper stepper(points, paper());
    for (Index pivot = 0; pivot < 5; ++pivot) {
        stepper.stepPivot();
        CHECK(stepper.state().status[pivot] == kDone);
        CHECK(stepper.state().rings.point(stepper.state().pivot.pivot) == pivot + 1);
    }
    CHECK(ringFrom(stepper.state(), stepper.state().pivot.pivot) ==
          Points{5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
}

TEST_CASE("small samples show their rules at the pivots they name") {
    const auto moved = [](Side side) {
        return [side](const LimitEvidence& e) {
            return e.side == side && e.verdict == Verdict::Moved;
        };
    };
    const Watched four = watch("figure-8");
    CHECK(happens<LimitEvidence>(four, 8, moved(Side::Start)));
    CHECK(happens<LimitEvidence>(four, 8, moved(Side::End)));
    CHECK(happens<DropEvidence>(four, 8,
                                [](const auto& e) { return e.verdict == Verdict::NowStart; }));
    CHECK(happens<DropEvidence>(watch("small-torus"), 6,
                                [](const auto& e) { return e.verdict == Verdict::BeyondConvex; }));
    CHECK(happens<ReciprocalEvidence>(watch("small-sheet"), 20, [](const auto& e) {
        return e.verdict == Verdict::NotReciprocal;
    }));
    CHECK(happens<HoleEvidence>(watch("long-lists"), 95,
                                [](const auto& e) { return e.verdict == Verdict::FarSide; }));
    CHECK(happens<TwoPointEvidence>(watch("coarse-torus"), 87, [](const auto& e) {
        return e.verdict == Verdict::Discarded && e.degrees > 180;
    }));
    const auto any = [](const auto&) { return true; };
    CHECK(happens<SplitEvidence>(watch("figure-12"), 35, any));
    CHECK(happens<JoinEvidence>(watch("figure-12"), 74, any));
    CHECK(happens<InsertEvidence>(watch("figure-14"), 1,
                                  [](const auto& e) { return !e.corner && e.third != kNone; }));
}

TEST_CASE("6.1, 6.5 scenes of the readings: end stays, and a finished edge leaves a longer ring") {
    CHECK(happens<LimitEvidence>(watch("half-turn"), 30, [](const auto& e) {
        return e.side == Side::End && e.verdict == Verdict::HalfTurn;
    }));
    const PointSet points = prepared(findScene("half-turn")->build());
    const auto flipped = [&](const Params& params) {
        const auto counts = countFaults(findFaults(points, runAll(points, params).state.mesh()));
        return counts[static_cast<std::size_t>(FaultKind::Flipped)];
    };
    CHECK(flipped(paper()) == 0);
    CHECK(flipped(paperBut(&Readings::belowHalfTurn)) > 0);
    CHECK(happens<CloseEvidence>(watch("finished-edge"), 129, [](const auto& e) {
        return e.a == 4 && e.b == 130 && e.rest > 0;
    }));
}

TEST_CASE("scenes name the decision that they are about, and their run has it") {
    CHECK(addressOfScene("sphere").empty());
    CHECK(addressOfScene("no such scene").empty());
    CHECK(addressOfScene("four-edge-hole") == failureScenes().front().address);
    for (const Scene& scene : scenes()) {
        CAPTURE(scene.id);
        CHECK(addressOfScene(scene.id) == scene.address);
        if (scene.address.empty()) continue;
        const auto address = addressFromString(scene.address);
        REQUIRE(address.has_value());
        CHECK(toString(*address) == scene.address);
        const EventLog log = watch(scene.id).log;
        CHECK(std::count_if(log.events().begin(), log.events().end(),
                            [&](const Event& event) { return event.address == *address; }) == 1);
    }
}

TEST_CASE("6.1 the new start and end are no longer candidates, but are not refused") {
    int limits = 0;
    const Watched four = watch("figure-8");
    for (const Event& event : four.log.events()) {
        const auto* drop = std::get_if<DropEvidence>(&event.evidence);
        if (drop == nullptr || event.address.pivot != 8) continue;
        const bool start = drop->side == Side::Start;
        CHECK(drop->verdict == (start ? Verdict::NowStart : Verdict::NowEnd));
        CHECK(toString(event.address) == (start ? "8.limits.5" : "8.limits.6"));
        CHECK(drop->point == (start ? 17 : 15));
        CHECK(endingText(event) == (start ? "now start" : "now end"));
        CHECK(outcomeOf(event) == Outcome::None);
        ++limits;
    }
    CHECK(limits == 2);
}
