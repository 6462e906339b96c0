/// Events of small runs, made by hand and passed one by one: the ones that are the moments of a
/// failure.
#include "spiraling_edge/why/moment_finder.h"

#include <doctest/doctest.h>

#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

constexpr Index kOnCircle = 10;

/// Points on a circle, each of which lists the next one.
PointSet circle() {
    PointSet points;
    for (Index p = 0; p < kOnCircle; ++p) {
        points.position.push_back(polar(36.0 * p));
        points.normal.emplace_back(0, 0, 1);
        points.type.push_back(kInterior);
        points.neighbors.append(Points{(p + 1) % kOnCircle});
    }
    return points;
}

/// A failure of the points of circle() and what its finder makes of events.
class Followed {
  public:
    /// The triangles of the failure are all of the mesh.
    Followed(std::string_view kind, Points at, Triangles mesh = {}) : mesh_(std::move(mesh)) {
        failure_.kind = findFailureClass(kind);
        REQUIRE(failure_.kind != nullptr);
        failure_.points = std::move(at);
        for (Index t = 0; t < mesh_.size(); ++t) failure_.triangles.push_back(t);
        finder_.emplace(input_, failure_);
    }
    Followed(const Followed&) = delete;
    Followed& operator=(const Followed&) = delete;

    Followed& add(std::string_view address, Index pivot, const Evidence& evidence) {
        const LedgerLine line = lineAt(address, pivot, evidence);
        addTest(line, tests_);
        finder_->add(std::make_shared<const LedgerLine>(line));
        return *this;
    }
    Followed& addFreed(std::string_view address, Index pivot, const Evidence& evidence) {
        finder_->addFreed(std::make_shared<const LedgerLine>(lineAt(address, pivot, evidence)));
        return *this;
    }

    std::string created() const { return toString(moments().created.event.address); }
    std::string decided() const { return toString(moments().decided.event.address); }
    Index alone() const { return finder_->alone(); }

  private:
    LedgerLine lineAt(std::string_view address, Index pivot, const Evidence& evidence) const {
        const auto at = addressFromString(address);
        REQUIRE(at.has_value());
        return lineOf({*at, evidence}, {points_, params_, pivot});
    }
    FailureMoments moments() const {
        const auto found = finder_->found();
        REQUIRE(found.has_value());
        return *found;
    }

    PointSet points_ = circle();
    Params params_ = paper();
    Triangles mesh_;
    std::vector<LedgerLine> moves_;
    std::vector<LedgerLine> tests_;
    FinderInput input_{points_, params_, mesh_, moves_, tests_};
    MeshFailure failure_;
    std::optional<MomentFinder> finder_;
};

Evidence sorted(Index p, Verdict verdict) {
    return SortEvidence{p, 0.5, false, 60.0, 300.0, verdict, kNone};
}
Evidence fanOfTwo(double degrees, Verdict verdict) { return TwoPointEvidence{degrees, verdict}; }
Evidence emitted(Index number, const Triangle& t) { return EmitEvidence{number, t}; }
Evidence onRing(Index p) { return RingEvidence{p, true, 1}; }
Evidence offRing(Index p) { return RingEvidence{p, false, kDone}; }
Evidence stranded(Index p) { return StrandEvidence{p, false}; }

}  // namespace

// ---- points in no triangle ----------------------------------------------------------------------

TEST_CASE("moment finder: a point was lost at its last test, not where it was found DONE later") {
    Followed lost("lost_points", {4});
    lost.add("1.sort.1", 0, sorted(4, Verdict::Kept));
    lost.add("1.sort.2", 0, sorted(4, Verdict::SameAngle));
    lost.add("2.strand.1", kNone, stranded(4));
    lost.add("3.sort.1", 5, sorted(4, Verdict::AlreadyDone));
    CHECK(lost.decided() == "1.sort.2");
    CHECK(lost.created() == "2.strand.1");
}

TEST_CASE("moment finder: a full turn of the point itself counts only where no test refused it") {
    Followed refused("lost_points", {4});
    refused.add("1.sort.1", 0, sorted(4, Verdict::SameAngle));
    refused.add("2.twopoint.1", 4, fanOfTwo(360.0, Verdict::Discarded));
    refused.add("3.done.1", 5, offRing(4));
    CHECK(refused.decided() == "1.sort.1");

    Followed alone("lost_points", {4});
    alone.add("2.seed.1", kNone, SeedEvidence{4, 5, 1.0});
    alone.add("2.twopoint.1", 4, fanOfTwo(360.0, Verdict::Discarded));
    alone.add("3.done.1", 5, offRing(4));
    CHECK(alone.decided() == "2.twopoint.1");

    // A fan of its own over 180 degrees is a refusal like any other.
    Followed wide("lost_points", {4});
    wide.add("1.sort.1", 0, sorted(4, Verdict::SameAngle));
    wide.add("2.twopoint.1", 4, fanOfTwo(200.0, Verdict::Discarded));
    wide.add("3.done.1", 5, offRing(4));
    CHECK(wide.decided() == "2.twopoint.1");
}

TEST_CASE("moment finder: a point that no test saw was lost with the last neighbor before it") {
    Followed lost("lost_points", {4});
    lost.add("1.ring.1", 0, offRing(5));
    lost.add("2.strand.1", kNone, stranded(4));
    lost.add("3.ring.1", 0, offRing(6));
    CHECK(lost.decided() == "1.ring.1");
    CHECK(lost.created() == "2.strand.1");
}

// ---- loops and rings ----------------------------------------------------------------------------

TEST_CASE("moment finder: a ring was lost at the last fan refused on it before it was freed") {
    Followed ring("leftover_rings", {1, 2, 3});
    ring.add("1.ring.1", 0, onRing(2));
    ring.add("2.twopoint.1", 1, fanOfTwo(200.0, Verdict::Discarded));
    ring.add("3.twopoint.1", 2, fanOfTwo(200.0, Verdict::Discarded));
    ring.addFreed("3.done.4", 2, FreeEvidence{3, 3});
    // One of its points has another entry, on a ring that is still there.
    ring.add("4.twopoint.1", 3, fanOfTwo(200.0, Verdict::Discarded));
    CHECK(ring.decided() == "3.twopoint.1");
    CHECK(ring.created() == "3.done.4");
}

TEST_CASE("moment finder: a hole exists once the last of its points is DONE") {
    Followed hole("holes", {1, 2, 3, 4});
    hole.add("1.ring.1", 0, onRing(2));
    hole.add("2.twopoint.1", 1, fanOfTwo(200.0, Verdict::Discarded));
    hole.add("3.done.1", 4, offRing(2));
    hole.add("3.done.2", 4, offRing(4));
    hole.add("3.done.3", 4, offRing(1));
    hole.add("3.done.4", 4, offRing(3));
    CHECK(hole.created() == "3.done.4");
    CHECK(hole.decided() == "2.twopoint.1");
}

// ---- triangles ----------------------------------------------------------------------------------

TEST_CASE("moment finder: a faulty triangle that a flip made has the flip as its cause") {
    Followed flipped("flipped_triangles", {1, 2, 3}, {{1, 2, 3}});
    flipped.add("1.sort.1", 1, sorted(2, Verdict::Kept));
    flipped.add("1.emit.1", 1, emitted(0, {1, 2, 5}));
    flipped.add("2.flip.1", kNone, FlipEvidence{1, 5, 2, 3, true});
    CHECK(flipped.created() == "2.flip.1");
    CHECK(flipped.decided() == "2.flip.1");
}

TEST_CASE("moment finder: a triangle comes from tests of its own pivot alone") {
    Followed filled("flipped_triangles", {1, 2, 3}, {{1, 2, 3}});
    filled.add("1.sort.1", 0, sorted(2, Verdict::Kept));
    filled.add("2.twopoint.1", 1, fanOfTwo(100.0, Verdict::Hole));
    filled.add("2.emit.1", 1, emitted(0, {1, 2, 3}));
    CHECK(filled.created() == "2.emit.1");
    CHECK(filled.decided() == "2.twopoint.1");
    CHECK(filled.alone() == 0);
}

TEST_CASE("moment finder: the third triangle at an edge comes from the test of that edge") {
    Followed edge("non_manifold_edges", {1, 2}, {{1, 2, 3}, {2, 1, 4}, {1, 2, 5}});
    edge.add("1.emit.1", 1, emitted(0, {1, 2, 3}));
    edge.add("2.emit.1", 2, emitted(1, {2, 1, 4}));
    edge.add("3.sort.1", 1, sorted(2, Verdict::Kept));
    edge.add("3.sort.2", 1, sorted(5, Verdict::Kept));
    edge.add("3.emit.1", 1, emitted(2, {1, 2, 5}));
    CHECK(edge.created() == "3.emit.1");
    CHECK(edge.decided() == "3.sort.1");
}

TEST_CASE("moment finder: an edge is inconsistent with the second triangle in one direction") {
    const auto createdBy = [](const Triangles& mesh) {
        Followed edge("inconsistent_edges", {1, 2}, mesh);
        edge.add("1.sort.1", 0, sorted(1, Verdict::Kept));
        for (Index t = 0; t < mesh.size(); ++t) {
            const std::string address = std::to_string(t + 1) + ".emit.1";
            edge.add(address, mesh[t].a, emitted(t, mesh[t]));
        }
        return edge.created();
    };
    CHECK(createdBy({{1, 2, 3}, {4, 1, 2}, {2, 1, 5}}) == "2.emit.1");
    CHECK(createdBy({{2, 1, 3}, {4, 2, 1}, {1, 2, 5}}) == "2.emit.1");
    CHECK(createdBy({{1, 2, 3}, {4, 2, 1}, {2, 5, 1}}) == "3.emit.1");
}
