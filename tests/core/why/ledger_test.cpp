#include "spiraling_edge/why/ledger.h"
#include "spiraling_edge/run/event_text.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "spiraling_edge/run/timeline.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/rig.h"
#include "support/subjects.h"

using namespace se;
using namespace se::test;

namespace {

Ledger ask(const PointSet& points, const Params& params, const Subject& subject) {
    const Result<Ledger> ledger = why(points, params, subject);
    REQUIRE(ledger.ok());
    return ledger.value();
}

/// Checks that a pass which passes over no pivot finds the same lines.
void checkNothingMissed(const PointSet& points, const Params& params, const Subject& subject,
                        const Ledger& ledger) {
    Question<Ledger> question = whyQuestion(points, params, subject).value();
    question.wants = {};
    const Ledger whole = se::ask(points, params, question).value();
    CHECK(ledger.answer == whole.answer);
    REQUIRE(ledger.lines.size() == whole.lines.size());
    for (std::size_t i = 0; i < ledger.lines.size(); ++i) {
        CAPTURE(i);
        CHECK(toString(ledger.lines[i].event.address) == toString(whole.lines[i].event.address));
        CHECK(ledger.lines[i].role == whole.lines[i].role);
    }
}

/// Checks of an answer for a subject: it agrees with the mesh, and its cause is a decision of
/// that run at its address and about the subject.
void checkAnswer(Timeline& timeline, const std::vector<Triangle>& mesh, const Subject& subject,
                 const Ledger& ledger) {
    CAPTURE(ledger.answer);
    CHECK(ledger.present == hasSubject(mesh, subject));
    REQUIRE(ledger.cause < ledger.lines.size());
    const LedgerLine& cause = ledger.lines[ledger.cause];
    const Address address = cause.event.address;
    const std::vector<Event> events = timeline.record(address.pivot)->events;
    const auto found = std::find_if(events.begin(), events.end(),
                                    [&](const Event& e) { return e.address == address; });
    REQUIRE(found != events.end());
    CHECK(describe(*found) == describe(cause.event));
    CHECK(ledger.answer.ends_with("(" + toString(address) + ")"));
    CHECK(ledger.present == (cause.role == LineRole::Made));
}

/// `count` random points, edges and triangles; edges and triangles mostly of near points, as in
/// most queries.
void checkRandomSubjects(const PointSet& points, const Params& params, std::size_t count) {
    Timeline timeline(points, params);
    timeline.seek(0xffffffffU);
    const std::vector<Triangle> mesh = timeline.state().mesh();
    const auto check = [&](const Subject& subject) {
        const Ledger ledger = ask(points, params, subject);
        checkAnswer(timeline, mesh, subject, ledger);
        checkNothingMissed(points, params, subject, ledger);
    };
    Random random(7);
    for (std::size_t i = 0; i < count; ++i) {
        const auto a = static_cast<Index>(random.below(points.size()));
        check(Subject::point(a));
        const auto list = points.neighbors[a];
        const auto near = [&] {
            return list.empty() || random.below(8) == 0
                       ? static_cast<Index>(random.below(points.size()))
                       : list[random.below(list.size())];
        };
        const Index b = near();
        const Index c = near();
        if (a == b) continue;
        check(Subject::edge(a, b));
        if (c == a || c == b) continue;
        check(Subject::triangle(a, b, c));
    }
}

}  // namespace

TEST_CASE("ledger: the answer for any subject is a decision of the run, on every scene") {
    for (const Scene& scene : scenes()) {
        CAPTURE(scene.id);
        if (scene.start != nullptr) continue;  // the next test
        checkRandomSubjects(prepared(scene.build()), paper(), kSanitized ? 3 : 12);
    }
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        checkRandomSubjects(prepared(each.scene.build()), paper(), kSanitized ? 2 : 8);
    }
}

TEST_CASE("ledger: of a given mesh no decision is told, of triangles made from it on one is") {
    const Scene& scene = *findScene("figure-4");
    const PointSet points = prepared(scene.build());
    const Params params = withStartOf(scene, paper());
    const auto answer = [&](const Subject& subject) { return why(points, params, subject); };
    const auto given = answer(Subject::edge(0, 3));
    REQUIRE_FALSE(given.ok());
    CHECK(given.error().message ==
          "Edge 0-3 is in the mesh that the run begins with: no decision made it.");
    Timeline timeline(points, params);
    timeline.seek(0xffffffffU);
    const std::vector<Triangle> mesh = timeline.state().mesh();
    const Subject triangle = Subject::triangle(0, 5, 7);
    checkAnswer(timeline, mesh, triangle, answer(triangle).value());
    const Subject edge = Subject::edge(0, 8);
    checkAnswer(timeline, mesh, edge, answer(edge).value());
    CHECK(answer(edge).value().answer.ends_with("removed. (1.limits.5)"));
}

TEST_CASE("ledger: the same on points that no surface gave, with and without the robust rules") {
    for (std::uint64_t seed = 1; seed <= (kSanitized ? 5U : 30U); ++seed) {
        CAPTURE(seed);
        const PointSet points = randomPoints(seed);
        checkRandomSubjects(points, paper(), 6);
        checkRandomSubjects(points, *paramsByName("robust"), 6);
    }
}

TEST_CASE("ledger: a neighbor that a what-if puts on the list of a pivot is not missed") {
    const PointSet points = sceneNamed("sphere");
    Timeline timeline(points, paper());
    timeline.seek(60);
    const Index pivot = timeline.state().rings.point(timeline.state().pivot.pivot);
    const auto list = points.neighbors[pivot];
    Index far = 0;
    while (timeline.state().status[far] != kUnused ||
           std::find(list.begin(), list.end(), far) != list.end())
        ++far;
    WhatIf longer{WhatIfKind::List, 1, Stage::Pivot, pivot, Vec3(0.0), {}};
    longer.list.assign(list.begin(), list.end());
    longer.list.push_back(far);
    Params params = paper();
    params.whatIf = {longer};
    const Ledger ledger = ask(points, params, Subject::point(far));
    checkNothingMissed(points, params, Subject::point(far), ledger);
    CHECK(std::any_of(ledger.lines.begin(), ledger.lines.end(),
                      [&](const LedgerLine& line) { return line.pivot == pivot; }));
}

TEST_CASE("ledger: a point in no triangle was refused by a test, and the ledger names the last") {
    // Every tenth point has a twin a little above it: one of the two is usually left over.
    PointFile file = closedFamilies()[0].sample(3);
    for (std::size_t p = 0, count = file.position.size(); p < count; p += 10) {
        file.position.push_back(1.02 * file.position[p] + Vec3(0.02, 0.01, 0.0));
        file.normal.push_back(file.normal[p]);
    }
    const PointSet points = prepared(file);
    const Run run = runAll(points, paper());
    std::size_t unused = 0;
    for (Index p = 0; p < points.size(); ++p) {
        if (hasSubject(run.state.mesh(), Subject::point(p))) continue;
        ++unused;
        const Ledger ledger = ask(points, paper(), Subject::point(p));
        CAPTURE(ledger.answer);
        const LedgerLine& cause = ledger.lines[ledger.cause];
        CHECK(cause.role == LineRole::Refused);
        CHECK((testedPoint(cause.event) == p || testedPoint(cause.event) == kNone));
        // Later refusals are only that it was DONE.
        for (std::size_t i = ledger.cause + 1; i < ledger.lines.size(); ++i) {
            if (ledger.lines[i].role != LineRole::Refused) continue;
            const auto* sort = std::get_if<SortEvidence>(&ledger.lines[i].event.evidence);
            REQUIRE(sort != nullptr);
            CHECK(sort->verdict == Verdict::AlreadyDone);
        }
    }
    CHECK(unused > 0);
}

TEST_CASE("ledger: invalid subjects") {
    const PointSet points = sceneNamed("grid");
    CHECK_FALSE(why(points, paper(), Subject::point(100000)).ok());
    CHECK_FALSE(why(points, paper(), Subject::edge(3, 3)).ok());
    CHECK_FALSE(why({}, paper(), Subject::point(0)).ok());
    CHECK_FALSE(why(points, paper(), Subject::point(0), [](double) { return false; }).ok());
}

TEST_CASE("ledger: a triangle of a third point names the test of first and last that made it") {
    const PointSet points = sceneNamed("figure-14");
    const Params params = paper();
    const Event* insert = nullptr;
    const Event* alone = nullptr;
    int asked = 0;
    const std::vector<Event> events = eventsOf(points, params);
    for (const Event& event : events) {
        const auto isHere = [&](const Event* other) {
            return other != nullptr && other->address.pivot == event.address.pivot;
        };
        if (const auto* e = std::get_if<InsertEvidence>(&event.evidence))
            insert = e->third != kNone ? &event : nullptr;
        if (std::holds_alternative<TwoPointEvidence>(event.evidence)) alone = &event;
        const auto* emit = std::get_if<EmitEvidence>(&event.evidence);
        if (emit == nullptr || !isHere(insert) || !isHere(alone)) continue;
        const Triangle& t = emit->corners;
        const Ledger ledger = ask(points, params, Subject::triangle(t.a, t.b, t.c));
        CAPTURE(ledger.answer);
        const auto line = std::find_if(
            ledger.lines.begin(), ledger.lines.end(),
            [&](const LedgerLine& each) { return each.event.address == alone->address; });
        REQUIRE(line != ledger.lines.end());
        CHECK(line->role == LineRole::Indirect);
        ++asked;
    }
    CHECK(asked > 0);
}
