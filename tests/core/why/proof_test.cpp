#include "spiraling_edge/why/proof.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/rig.h"
#include "support/subjects.h"

using namespace se;
using namespace se::test;

namespace {

Ledger proved(const PointSet& points, const Params& params, const Subject& subject) {
    const Result<Ledger> ledger = provedWhy(points, params, subject);
    REQUIRE(ledger.ok());
    CAPTURE(ledger.value().answer);
    REQUIRE(ledger.value().cause < ledger.value().lines.size());
    return ledger.value();
}

/// True if the answer is proved by an inversion; then the run with its what-if has the other
/// answer.
bool isProved(const PointSet& points, const Params& params, const Subject& subject) {
    const Ledger ledger = proved(points, params, subject);
    if (ledger.provedBy != ProvedBy::Inversion) return false;
    REQUIRE_FALSE(ledger.inversions.empty());
    CAPTURE(ledger.answer);
    CAPTURE(lineOf(ledger.inversions.back()));
    CHECK(ledger.answer.find(" would ") != std::string::npos);
    Params inverted = params;
    for (const WhatIf& each : ledger.inversions) inverted.whatIf.push_back(each);
    if (ledger.undoneBy != nullptr) ledger.undoneBy->turnOff(inverted);
    CHECK(hasSubject(runAll(points, params).state.mesh(), subject) == ledger.present);
    CHECK(hasSubject(runAll(points, inverted).state.mesh(), subject) != ledger.present);
    return true;
}

std::vector<Index> unusedOf(const PointSet& points, const std::vector<Triangle>& mesh) {
    std::vector<bool> used(points.size(), false);
    for (const Triangle& t : mesh) used[t.a] = used[t.b] = used[t.c] = true;
    std::vector<Index> unused;
    for (Index p = 0; p < points.size(); ++p) {
        if (!used[p]) unused.push_back(p);
    }
    return unused;
}

}  // namespace

TEST_CASE("proof: nine of ten unused points come into the mesh with their decision inverted" *
          doctest::test_suite("long")) {
    std::size_t asked = 0;
    std::size_t found = 0;
    const auto ask = [&](const Scene& scene) {
        CAPTURE(scene.id);
        const PointSet points = prepared(scene.build());
        const std::vector<Index> unused = unusedOf(points, runAll(points, paper()).state.mesh());
        const std::size_t step = unused.size() / 8 + 1;
        for (std::size_t i = 0; i < unused.size(); i += step) {
            if (points.isAside(unused[i])) continue;
            ++asked;
            found += isProved(points, paper(), Subject::point(unused[i])) ? 1 : 0;
        }
    };
    for (const Scene& scene : scenes()) {
        if (scene.start == nullptr) ask(scene);
    }
    for (const FailureScene& each : failureScenes()) ask(each.scene);
    MESSAGE("proved: ", found, " of ", asked, " unused points");
    CHECK(asked > 20);
    CHECK(10 * found >= 9 * asked);
}

TEST_CASE("proof: a triangle of a fan is there by a test of its pivot, and away without it") {
    const PointSet points = prepared(failureScenes().front().scene.build());
    const std::vector<Triangle> mesh = runAll(points, paper()).state.mesh();
    std::size_t asked = 0;
    std::size_t found = 0;
    for (std::size_t i = 0; i < mesh.size(); i += 1 + mesh.size() / 20) {
        const Subject subject = Subject::triangle(mesh[i].a, mesh[i].b, mesh[i].c);
        ++asked;
        found += isProved(points, paper(), subject) ? 1 : 0;
    }
    CHECK(10 * found >= 9 * asked);
}

TEST_CASE("proof: the tests that made way for a triangle are lines of its ledger") {
    const PointSet points = prepared(fibonacciSphere(600));
    const std::vector<Triangle> mesh = runAll(points, paper()).state.mesh();
    const Subject subject = Subject::triangle(mesh[9].a, mesh[9].b, mesh[9].c);
    const Ledger ledger = proved(points, paper(), subject);
    const auto made = std::find_if(ledger.lines.begin(), ledger.lines.end(),
                                   [](const auto& line) { return line.role == LineRole::Made; });
    REQUIRE(made != ledger.lines.end());
    for (const LedgerLine& line : ledger.lines) {
        if (line.role != LineRole::Indirect) continue;
        CHECK(line.event.address.pivot == made->event.address.pivot);
        CHECK_FALSE(subject.has(testedPoint(line.event)));
    }
}

TEST_CASE("proof: an edge that no inversion brings in may come in by two") {
    std::size_t found = 0;
    for (const char* id : {"noise", "torus"}) {
        const PointSet points = prepared(findScene(id)->build());
        const std::vector<Triangle> mesh = runAll(points, paper()).state.mesh();
        for (Index p = 0; p < points.size() && found < 3; p += 5) {
            const auto list = points.neighbors[p];
            const auto q = std::find_if(list.begin(), list.end(), [&](Index x) {
                return !hasSubject(mesh, Subject::edge(p, x));
            });
            if (q == list.end()) continue;
            const Subject subject = Subject::edge(p, *q);
            const Ledger ledger = proved(points, paper(), subject);
            if (ledger.inversions.size() < 2) continue;
            ++found;
            CHECK(isProved(points, paper(), subject));
            CHECK(ledger.answer.find("two decisions inverted") != std::string::npos);
            CHECK(ledger.answer.find(" Then: ") != std::string::npos);
            CHECK(ledger.inversions[0].pivot <= ledger.inversions[1].pivot);
            Params alone = paper();
            alone.whatIf.push_back(ledger.inversions.front());
            CHECK_FALSE(hasSubject(runAll(points, alone).state.mesh(), subject));
        }
    }
    CHECK(found > 0);
}

TEST_CASE("proof: an inversion that steps after the last pivot undo is run without their rule") {
    const PointSet points = prepared(findScene("noise")->build());
    const std::vector<Triangle> mesh = runAll(points, robust()).state.mesh();
    std::size_t found = 0;
    for (std::size_t i = 0; i < mesh.size() && found < 2; i += 3) {
        const Subject subject = Subject::triangle(mesh[i].a, mesh[i].b, mesh[i].c);
        const Ledger ledger = proved(points, robust(), subject);
        if (ledger.undoneBy == nullptr) continue;
        ++found;
        CHECK(isProved(points, robust(), subject));
        CHECK(isRepair(*stageFromName(ledger.undoneBy->name)));
        CHECK(ledger.answer.find("which undoes that after the last pivot") != std::string::npos);
        Params alone = robust();
        for (const WhatIf& each : ledger.inversions) alone.whatIf.push_back(each);
        const State end = runAll(points, alone).state;
        CHECK_FALSE(hasSubject(end.triangles, subject));
        CHECK(hasSubject(end.mesh(), subject));
    }
    CHECK(found > 0);
}

TEST_CASE("proof: a triangle that no inversion keeps out may be kept out by two, in two pivots") {
    const PointSet points = prepared(findScene("noise")->build());
    const std::vector<Triangle> mesh = runAll(points, paper()).state.mesh();
    std::size_t found = 0;
    for (std::size_t i = 0; i < mesh.size() && found == 0; ++i) {
        const Subject subject = Subject::triangle(mesh[i].a, mesh[i].b, mesh[i].c);
        const Ledger ledger = proved(points, paper(), subject);
        if (ledger.inversions.size() < 2) continue;
        ++found;
        CHECK(isProved(points, paper(), subject));
        CHECK(ledger.inversions[0].pivot < ledger.inversions[1].pivot);
        CHECK(ledger.answer.find("would not be with two decisions inverted") != std::string::npos);
    }
    CHECK(found > 0);
}

TEST_CASE("proof: a copy is proved by preparation, without an inversion") {
    PointFile file = fibonacciSphere(100);
    file.position.push_back(file.position[7]);
    file.normal.push_back(file.normal[7]);
    const PointSet points = prepared(file);
    const Ledger ledger = proved(points, paper(), Subject::point(100));
    CHECK(ledger.provedBy == ProvedBy::Preparation);
    CHECK(ledger.inversions.empty());
    CHECK(ledger.answer.find("inver") == std::string::npos);
}

TEST_CASE("proof: what a step after the last pivot made or removed is proved by the step") {
    const PointSet points = prepared(findScene("noise")->build());
    const State end = runAll(points, robust()).state;
    std::size_t steps = 0;
    for (std::size_t i = 0; i < end.triangles.size(); i += 1 + end.triangles.size() / 60) {
        const Triangle& t = end.triangles[i];
        const Subject subject = Subject::triangle(t.a, t.b, t.c);
        if (hasSubject(end.mesh(), subject)) continue;
        const Ledger ledger = proved(points, robust(), subject);
        CHECK(ledger.provedBy == ProvedBy::Step);
        CHECK(ledger.lines[ledger.cause].role == LineRole::Undone);
        ++steps;
    }
    CHECK(steps > 0);
}

TEST_CASE("proof: a third point that made an edge is inverted by a list without it") {
    const PointSet points = prepared(findScene("tee-at-wall")->build());
    CHECK(isProved(points, paper(), Subject::edge(50, 64)));
    const Ledger ledger = proved(points, paper(), Subject::edge(50, 64));
    CHECK(ledger.present);
    CHECK(ledger.answer.find("would not be with this decision inverted") != std::string::npos);
}

TEST_CASE("proof: ends that do not list each other get an edge if one lists the other") {
    const PointSet points = prepared(findScene("flipped-patch")->build());
    CHECK(isProved(points, paper(), Subject::edge(20, 133)));
    const Ledger ledger = proved(points, paper(), Subject::edge(20, 133));
    CHECK(ledger.answer.find("would be if 133 listed 20: ") != std::string::npos);
}

TEST_CASE("proof: a point that no list names is explained by preparation, without a run") {
    PointFile file = fibonacciSphere(600);
    file.position.emplace_back(0.0, 0.0, 3.0);
    file.normal.emplace_back(0.0, 0.0, 1.0);
    const Ledger ledger = proved(prepared(file), paper(), Subject::point(600));
    CHECK(ledger.provedBy == ProvedBy::Preparation);
}

TEST_CASE("proof: the limits end the search, and the answer says so") {
    const PointSet points = prepared(findScene("noise")->build());
    const std::vector<Triangle> mesh = runAll(points, robust()).state.mesh();
    ProofScope one;
    one.inversions = 1;
    std::size_t ended = 0;
    for (std::size_t i = 0; i < mesh.size() && ended == 0; i += 7) {
        const Subject subject = Subject::triangle(mesh[i].a, mesh[i].b, mesh[i].c);
        const Ledger ledger = provedWhy(points, robust(), subject, one).value();
        ended += ledger.answer.ends_with("Not proved: the first 1 inversion does not change it.");
    }
    CHECK(ended == 1);
}

TEST_CASE("ledger: its lines are in the order of the run, and each is there once") {
    const PointSet points = prepared(findScene("sharp-crease")->build());
    for (const Params& params : {paper(), robust()}) {
        for (Index p = 0; p < points.size(); p += 7) {
            const auto lines = why(points, params, Subject::point(p)).value().lines;
            for (std::size_t i = 1; i < lines.size(); ++i) {
                const Address& before = lines[i - 1].event.address;
                const Address& after = lines[i].event.address;
                CAPTURE(toString(after));
                const bool alike = before.pivot == after.pivot && before.stage == after.stage;
                CHECK((!alike || before.n < after.n));
            }
        }
    }
}

TEST_CASE("proof: it can be cancelled at any time") {
    const PointSet points = prepared(findScene("stranded-point")->build());
    for (const double limit : {0.0, 0.25, 0.5, 0.7}) {
        const Result<Ledger> ledger = provedWhy(points, paper(), Subject::point(32), {},
                                                [&](double share) { return share < limit; });
        CHECK_FALSE(ledger.ok());
    }
}
