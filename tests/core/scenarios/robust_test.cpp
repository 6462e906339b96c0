/// The rules beyond the paper, all together (docs/robust.md): an oriented manifold from any input,
/// and the numbers measured on the shared data. robust_clean_test.cpp has the clean clouds.
#include <doctest/doctest.h>

#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/spec/run_spec.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/rig.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

/// The shared points; nothing, with a message, where they are absent.
std::optional<PointSet> shared(const std::string& name) {
    const auto file = sharedPoints("points/" + name + ".ply");
    if (!file) return std::nullopt;
    return preparedBy("robust", *file).points;
}

/// No edge of three triangles, and none passed twice in one direction.
bool isOrientedManifold(const MeshReport& mesh) {
    return mesh.nonManifoldEdges == 0 && mesh.inconsistentEdges == 0;
}

}  // namespace

// ---- any input ----------------------------------------------------------------------------------

TEST_CASE("robust: an oriented manifold from random points, lists, normals and types") {
    std::size_t triangles = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const PointSet points = randomPoints(seed);
        CHECK_MESSAGE(firstBreach(points, robust(), InvariantChecker::Level::Guarded) == "",
                      "seed ", seed);
        const Run run = runAll(points, robust());
        CHECK_MESSAGE(run.state.finished(), "seed ", seed);
        CHECK_MESSAGE(run.stop == StopReason::Finished, "seed ", seed);
        CHECK_MESSAGE(isOrientedManifold(run.mesh), "seed ", seed);
        CHECK_MESSAGE(run.mesh.nonManifoldVertices == 0, "seed ", seed);
        CHECK_MESSAGE(isOrientedManifold(reportMesh(points, run.state.triangles)), "seed ", seed);
        triangles += run.mesh.triangles;
    }
    CHECK(triangles > 1000);  // They did something.
}

TEST_CASE("guard: alone, it keeps random points an oriented manifold, without it they are none") {
    std::size_t tangled = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const PointSet points = randomPoints(seed);
        const Params guarded = paperBut(&RobustRules::guard);
        CHECK_MESSAGE(firstBreach(points, guarded, InvariantChecker::Level::Guarded) == "", "seed ",
                      seed);
        const Run run = runAll(points, guarded);
        CHECK_MESSAGE(isOrientedManifold(run.mesh), "seed ", seed);
        CHECK_MESSAGE(run.stop == StopReason::Finished, "seed ", seed);
        tangled += isOrientedManifold(runAll(points, paper()).mesh) ? 0 : 1;
    }
    CHECK(tangled > 0);
}

// ---- shared data --------------------------------------------------------------------------------

TEST_CASE("robust: the numbers of Table 1, on stand-ins") {
    struct Expected {
        const char* name;
        std::size_t triangles;
    };
    for (const Expected& e :
         {Expected{"table1_hydrogen", 3024}, Expected{"table1_blast_wave", 2662},
          Expected{"table1_hyperboloid", 365}}) {
        const auto points = shared(e.name);
        if (!points) continue;
        const Run run = runAll(*points, robust());
        CHECK_MESSAGE(run.mesh.triangles == e.triangles, e.name);
        CHECK_MESSAGE(describeFaults(*points, run.state.mesh()) == "", e.name);
        CHECK_MESSAGE(run.mesh.unusedPoints == 0, e.name);
    }
    const auto cloud = shared("table1_electron_cloud");
    if (!cloud) return;
    const Run run = runAll(*cloud, robust());
    CHECK(run.mesh.unusedPoints == 0);
    // What is left: three loops inside.
    CHECK(describeFaults(*cloud, run.state.mesh()) == "holes 3 ");
}

TEST_CASE("robust: the lobster is a manifold, nearly all used, with few crossings" *
          doctest::test_suite("long")) {
    const auto points = shared("table1_lobster");
    if (!points) return;
    const Run run = runAll(*points, robust());
    const auto counts = countFaults(findFaults(*points, run.state.mesh()));
    const std::size_t crossings = counts[static_cast<std::size_t>(FaultKind::Intersecting)];
    MESSAGE("unused ", run.mesh.unusedPoints, ", intersecting ", crossings);
    CHECK(isOrientedManifold(run.mesh));
    CHECK(100 * run.mesh.unusedPoints < points->size());
    CHECK(crossings < 40);
    CHECK(counts[static_cast<std::size_t>(FaultKind::SecondLayer)] < 60);
    CHECK(counts[static_cast<std::size_t>(FaultKind::Flipped)] < 20);
}

namespace {

/// Checks that the set gives an oriented manifold, and whether that is a sound mesh, with this many
/// borders.
void checkMesh(const std::string& name, bool isSound, std::optional<std::size_t> borders = {}) {
    const auto points = shared(name);
    if (!points) return;
    const Run run = runAll(*points, robust());
    CHECK_MESSAGE(isOrientedManifold(run.mesh), name);
    CHECK_MESSAGE(run.stop == StopReason::Finished, name);
    const std::string faults = describeFaults(*points, run.state.mesh());
    if (isSound) CHECK_MESSAGE(faults == "", name);
    if (borders) {
        CHECK_MESSAGE(run.mesh.boundaryLoops == *borders, name);
        CHECK_MESSAGE(run.state.counters.holes == 0, name);
    }
    MESSAGE(name, ": ", faults.empty() ? "sound" : faults);
}

}  // namespace

TEST_CASE("robust: every shared set gives an oriented manifold, most of them a sound mesh") {
    for (const char* name :
         {"sphere_even", "kitten", "torus_knot", "bunny_small", "elephant", "fandisk"})
        checkMesh(name, true, 0);
    for (const char* name : {"nefertiti", "three_peaks"}) checkMesh(name, true, 1);
    for (const char* name : {"hippo", "blobs", "oni"}) checkMesh(name, true);
    checkMesh("fin90", false);
}

TEST_CASE("robust: the large shared sets give an oriented manifold as well" *
          doctest::test_suite("long")) {
    checkMesh("armadillo", true);
    checkMesh("sphere_noisy", true, 0);
    checkMesh("mannequin_devil", false);
}

TEST_CASE("robust: the bunny keeps its five holes" * doctest::test_suite("long")) {
    const auto points = shared("bunny");
    if (!points) return;
    const Run run = runAll(*points, robust());
    CHECK(describeFaults(*points, run.state.mesh()) == "");
    CHECK(run.mesh.boundaryLoops == 5);
    CHECK(run.mesh.eulerCharacteristic == -3);
}

TEST_CASE("robust: the mannequin is open at its neck, with few faults elsewhere" *
          doctest::test_suite("long")) {
    const auto points = shared("mannequin_devil");
    if (!points) return;
    const Run run = runAll(*points, robust());
    CHECK(isOrientedManifold(run.mesh));
    // Spacings vary by a factor of 500. Closing all holes by triangles with faults would make
    // some 950 more.
    const MeshInspection found = inspectWithTotals(*points, run.state.mesh());
    CHECK(faultCount(found.totals) < 400);
    CHECK(run.mesh.components == 1);
    CHECK(run.mesh.nonManifoldVertices == 0);
    // The neck, and fifteen where triangles would have faults.
    CHECK(run.mesh.boundaryLoops <= 16);
}

// ---- the run as a run ---------------------------------------------------------------------------

namespace {

/// Inputs on which every rule beyond the paper takes effect.
std::vector<PointSet> eventful() {
    std::vector<PointSet> sets;
    sets.push_back(prepared(closedFamilies(0.5)[3].sample(1)));
    sets.push_back(prepared(sampleSheet(wavySheet(), 8, 80, 1)));
    for (std::uint64_t seed = 1; seed <= 40; ++seed) sets.push_back(randomPoints(seed));
    PointFile rough = closedFamilies(0.6)[2].sample(1);
    Random random(1);
    for (Vec3& x : rough.position) x += 0.3 * random.inCube();
    sets.push_back(prepared(rough));
    return sets;
}

}  // namespace

TEST_CASE("robust: a log changes nothing, and the same steps come twice" *
          doctest::test_suite("long")) {
    for (const PointSet& points : eventful()) {
        EventLog log;
        const std::uint64_t hash = stateHash(runAll(points, robust()).state);
        CHECK(stateHash(runAll(points, robust(), &log).state) == hash);
        Stepper one(points, robust());
        Stepper two(points, robust());
        bool equal = true;
        while (one.stepPivot()) {
            two.stepPivot();
            equal = equal && stateHash(one.state()) == stateHash(two.state());
        }
        CHECK_FALSE(two.stepPivot());
        CHECK(equal);
        CHECK(stateHash(one.state()) == hash);
    }
}

TEST_CASE("robust: a restored state continues to the same end, including repair") {
    constexpr int kEvery = 11;
    for (const PointSet& points : eventful()) {
        Stepper stepper(points, robust());
        std::vector<State> kept;
        for (std::size_t steps = 1; stepper.stepPivot(); ++steps) {
            if (steps % kEvery == 0) kept.push_back(stepper.state());
        }
        const std::uint64_t hash = stateHash(stepper.state());
        const Triangles mesh = stepper.state().mesh();
        // From each to the next, and from some to the end, for errors that only a long run would
        // show.
        const std::size_t every = kept.size() / (kSanitized ? 4 : 8) + 1;
        bool equal = true;
        Stepper again(points, robust());
        for (std::size_t k = 0; k < kept.size(); ++k) {
            again.setState(kept[k]);
            for (int i = 0; k + 1 < kept.size() && i < kEvery; ++i) again.stepPivot();
            equal = equal &&
                    (k + 1 == kept.size() || stateHash(again.state()) == stateHash(kept[k + 1]));
            if (k % every != 0 && k + 1 != kept.size()) continue;
            again.run();
            equal = equal && stateHash(again.state()) == hash && again.state().mesh() == mesh;
        }
        CHECK(equal);
    }
}

TEST_CASE("robust: each step after the last pivot has a number and leaves the triangles alone") {
    const PointSet points = prepared(closedFamilies(1.0)[3].sample(1));
    Stepper stepper(points, robust());
    while (stepper.state().repair.empty() && stepper.stepPivot()) {
    }
    REQUIRE_FALSE(stepper.state().repair.empty());
    const Triangles emitted = stepper.state().triangles;
    std::size_t steps = 0;
    for (std::uint32_t before = stepper.state().counters.pivots; stepper.stepPivot(); ++steps) {
        const std::uint32_t now = stepper.state().counters.pivots;
        CHECK((now == before + 1 || now == before));
        before = now;
        CHECK(stepper.state().triangles == emitted);
    }
    CHECK(steps > 0);
    CHECK(stepper.state().repair.flipped > 0);
    CHECK(stepper.state().mesh() != emitted);
}

TEST_CASE("paper: has none of the rules beyond it, and keeps no edge table") {
    const RobustRules rules = paper().robust;
    CHECK_FALSE(rules.looksAtFan());
    CHECK_FALSE(rules.needsEdges());
    for (const auto rule :
         {&RobustRules::tangent, &RobustRules::unblocked, &RobustRules::stepBack,
          &RobustRules::wallsDone, &RobustRules::bothWalls, &RobustRules::guard, &RobustRules::gap,
          &RobustRules::noPillow, &RobustRules::noCross, &RobustRules::noFold, &RobustRules::noMeet,
          &RobustRules::rim, &RobustRules::delay, &RobustRules::fill, &RobustRules::dropPatches,
          &RobustRules::reinsert, &RobustRules::closeHoles, &RobustRules::flip,
          &RobustRules::remesh}) {
        CHECK_FALSE(rules.*rule);
        CHECK(robust().robust.*rule);
    }
    for (const PointSet& points : eventful()) {
        EventLog log;
        const Run run = runAll(points, paper(), &log);
        CHECK(run.state.edges.empty());
        CHECK(run.state.repair.empty());
        CHECK(run.state.retryLevel == 0);
        CHECK(run.state.counters.refused == 0);
        CHECK(run.state.counters.filled == 0);
        CHECK(run.state.counters.openings == 0);
        std::size_t beyond = 0;
        for (const Event& event : log.events()) {
            const Stage stage = event.address.stage;
            beyond += stage == Stage::Guard || stage == Stage::Fill || isRepair(stage) ? 1 : 0;
        }
        CHECK(beyond == 0);
    }
}

TEST_CASE("corrected: even closed surfaces come out whole without the guard") {
    for (const Family& family : closedFamilies(0.8)) {
        const Run run = runAll(prepared(family.sample(2)), *paramsByName("corrected"));
        CHECK_MESSAGE(run.mesh.closedManifold(), family.name);
        CHECK_MESSAGE(run.mesh.eulerCharacteristic == family.euler, family.name);
        CHECK_MESSAGE(run.state.repair.empty(), family.name);
    }
}
