#include "spiraling_edge/run/live_check.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/failure_moments.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rig.h"
#include "support/subjects.h"

using namespace se;
using namespace se::test;

namespace {

struct Watched {
    std::vector<LiveFailure> failures;
    std::vector<Triangle> mesh;
};

Watched watch(const PointSet& points, const Params& params) {
    Watched result;
    LiveCheck check(points);
    const auto end = sweep(points, params, [&](const SweptPivot& pivot) {
        for (LiveFailure& each : check.check(pivot.events)) result.failures.push_back(each);
    });
    result.mesh = end->mesh();
    return result;
}

/// True for a class that a single triangle or point decides.
bool isLive(const MeshFailure& failure) {
    constexpr std::array<std::string_view, 8> kLive{
        "non_manifold_edges",     "inconsistent_edges",
        "duplicate_triangles",    "degenerate_triangles",
        "intersecting_triangles", "folded_edges",
        "flipped_triangles",      "lost_points"};
    return std::find(kLive.begin(), kLive.end(), failure.kind->name) != kLive.end();
}

/// The failures of given triangles, as if made by a run.
std::vector<LiveFailure> seeAll(const PointSet& points, const std::vector<Triangle>& triangles) {
    LiveCheck check(points);
    std::vector<LiveFailure> all;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto n = static_cast<Index>(i);
        const Event event{{1, Stage::Emit, n + 1}, EmitEvidence{n, triangles[i]}};
        for (LiveFailure& each : check.check(event)) all.push_back(std::move(each));
    }
    return all;
}

/// All list point 0, which lists point 1.
PointSet flatFan(std::vector<Vec3> position) {
    std::vector<Points> lists(position.size(), Points{0});
    lists[0] = {1};
    return pointsAt(std::move(position), lists);
}

}  // namespace

TEST_CASE("live: what the inspection finds at the end was noticed when it was created") {
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        const PointSet points = prepared(each.scene.build());
        const Watched run = watch(points, paper());
        const std::vector<RunFailure> all = failuresOf(points, paper());
        std::size_t asked = 0;
        for (const auto& [failure, position, corners, moments] : all) {
            if (!isLive(failure)) continue;
            ++asked;
            CAPTURE(describe(failure));
            const Address created = moments.created.event.address;
            CAPTURE(toString(created));
            const bool noticed =
                std::any_of(run.failures.begin(), run.failures.end(), [&](const LiveFailure& live) {
                    return live.kind == failure.kind && live.address == created;
                });
            CHECK(noticed);
        }
        CHECK(asked > 0);
    }
}

TEST_CASE("live: what is noticed is still there at the end, if no rule mends") {
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        const PointSet points = prepared(each.scene.build());
        const Watched run = watch(points, paper());
        const auto failures = inspectMesh(points, run.mesh);
        for (const LiveFailure& live : run.failures) {
            // A fold is at an edge of two triangles, which a third may join later.
            if (live.kind->name == "folded_edges" || live.triangle == kNone) continue;
            CAPTURE(describe(live));
            CHECK(std::any_of(failures.begin(), failures.end(), [&](const MeshFailure& failure) {
                return failure.kind == live.kind &&
                       std::binary_search(failure.triangles.begin(), failure.triangles.end(),
                                          live.triangle);
            }));
        }
    }
}

TEST_CASE("live: a point whose triangles are more than one fan is noticed when it is DONE") {
    std::size_t looked = 0;
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        const PointSet points = prepared(each.scene.build());
        const Watched run = watch(points, paper());
        std::vector<Index> noticed;
        for (const LiveFailure& live : run.failures) {
            if (live.kind->name == "non_manifold_vertices") noticed.push_back(live.points[0]);
        }
        std::sort(noticed.begin(), noticed.end());
        std::vector<Index> found;
        for (const MeshFailure& failure : inspectMesh(points, run.mesh)) {
            if (failure.kind->name == "non_manifold_vertices") found.push_back(failure.points[0]);
        }
        CHECK(noticed == found);
        looked += found.size();
    }
    CHECK(looked > 0);
}

TEST_CASE("live: a sound run has no failures") {
    const PointSet points = prepared(findScene("sphere")->build());
    CHECK(watch(points, *paramsByName("robust")).failures.empty());
}

TEST_CASE("live: the third triangle at an edge, not the fourth") {
    const PointSet points =
        flatFan({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    const auto found = seeAll(points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}});
    const auto many = [](const LiveFailure& f) { return f.kind->name == "non_manifold_edges"; };
    REQUIRE(std::count_if(found.begin(), found.end(), many) == 1);
    const LiveFailure& first = *std::find_if(found.begin(), found.end(), many);
    CHECK(first.triangle == 2);
    CHECK(first.points == std::vector<Index>{0, 1});
    CHECK(describe(first) == "Triangle 2 is the third at the edge 0, 1: non-manifold.");
}

namespace {

/// The only failure of these triangles, of points without lists and normals: "" if there is none,
/// "several" if there are more.
std::string onlyFailure(std::vector<Vec3> position, const std::vector<Triangle>& triangles) {
    const std::vector<Points> none(position.size());
    const auto found = seeAll(pointsAt(std::move(position), none, Vec3(0)), triangles);
    if (found.size() > 1) return "several";
    return found.empty() ? "" : describe(found[0]);
}

}  // namespace

TEST_CASE("live: a fault is told of the later triangle, at the limits of the inspection") {
    struct Row {
        std::vector<Vec3> position;
        Triangles triangles;
        const char* told;
    };
    // The large one lies over more cells than are kept.
    const std::vector<Vec3> crossing{{0, 0, 0},    {99, 0, 0},   {0, 99, 0},
                                     {20, 20, -1}, {21, 20, -1}, {20, 20, 1}};
    const char* const crosses = "Triangle 1 overlaps 0: they share more than their common corners.";
    const std::vector<Vec3> inLine{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
    const char* const needle = "Triangle 0 is a needle, or has a corner twice.";
    const auto foldedAt = [](double degrees) {
        const Vec3 tip = polar(180 - degrees);
        return std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {tip.x, 0, tip.y}};
    };
    // Half of the mean edge length is 0.569.
    const auto layerAt = [](double z) {
        return std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, z}, {1, 0, z}, {0, 1, z}};
    };
    const Triangles apart{{0, 1, 2}, {3, 4, 5}};
    const Triangles beside{{0, 1, 2}, {1, 0, 3}};
    for (const Row& row : {Row{crossing, apart, crosses},
                           {crossing, {{3, 4, 5}, {0, 1, 2}}, crosses},
                           {inLine, {{0, 1, 2}}, needle},
                           {inLine, {{0, 1, 1}}, needle},
                           {inLine, {{0, 1, 3}}, ""},
                           {foldedAt(9.9), beside, "Triangle 1 lies folded onto 0."},
                           {foldedAt(10.1), beside, ""},
                           {layerAt(0.56), apart, "Triangle 1 is a second layer of 0."},
                           {layerAt(0.58), apart, ""}}) {
        CAPTURE(row.triangles);
        CHECK(onlyFailure(row.position, row.triangles) == row.told);
    }
}

TEST_CASE("live: two triangles at a DONE point that share no edge there are more than one fan") {
    const PointSet points = flatFan({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}});
    const auto atEnd = [&](const std::vector<Triangle>& triangles) {
        LiveCheck check(points);
        for (Index i = 0; i < triangles.size(); ++i) {
            const Event made{{1, Stage::Emit, i + 1}, EmitEvidence{i, triangles[i]}};
            REQUIRE(check.check(made).empty());
        }
        std::string text;
        for (const LiveFailure& each :
             check.check(Event{{2, Stage::Ring, 1}, RingEvidence{0, false, kDone}}))
            text += describe(each);
        return text;
    };
    CHECK(atEnd({{0, 1, 2}, {0, 3, 4}}) == "The triangles about point 0 are more than one fan.");
    CHECK(atEnd({{0, 1, 2}, {0, 3, 4}, {0, 2, 3}}).empty());
    CHECK(atEnd({}) == "Point 0 is DONE and in no triangle.");
}

TEST_CASE("live: crossings are looked for up to a fixed amount of work") {
    // Slanted and parallel: all boxes meet, no two triangles do, but for the last.
    const auto complete = [](Index count) {
        std::vector<Vec3> position;
        for (Index i = 0; i < count; ++i) {
            const double z = 1e-4 * i;
            position.insert(position.end(), {{0, 0, z}, {1, 1, 1 + z}, {1, 0.5, 1 + z}});
        }
        const PointSet points = pointsAt(position, std::vector<Points>(3 * count), Vec3(0));
        LiveCheck check(points);
        for (Index i = 0; i < count; ++i) {
            const EmitEvidence made{i, {3 * i, 3 * i + 1, 3 * i + 2}};
            for (const LiveFailure& each : check.check(Event{{i + 1, Stage::Emit, 1}, made}))
                CHECK(each.kind->name != "intersecting_triangles");
        }
        return check.complete();
    };
    CHECK(complete(300));
    CHECK_FALSE(complete(5000));
}

TEST_CASE("live: triangles are compared with those of a given start") {
    const PointSet points = sceneNamed("figure-9");
    const Params params = withStartOf(*findScene("figure-9"), paper());
    Params off = params;
    off.paper.twoPoint = TwoPointRule::None;
    const auto kinds = [&](const GivenStart& start) {
        LiveCheck live(points, start);
        std::size_t crossings = 0;
        (void)sweep(points, off, [&](const SweptPivot& pivot) {
            for (const LiveFailure& each : live.check(pivot.events))
                crossings += each.kind->name == "intersecting_triangles" ? 1 : 0;
        });
        return crossings;
    };
    CHECK(kinds(off.start) > kinds({}));
}
