#include "spiraling_edge/why/trial.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>

#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/other_preparations.h"
#include "support/clouds.h"
#include "support/open_surfaces.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

const SpecChange kRobust = specChange({{"rules", "robust"}});
Trials triedOn(const PointFile& file, const RunSpec& spec = {}) {
    Result<Trials> trials = tryChanges(file, spec);
    REQUIRE(trials.ok());
    return std::move(trials.value());
}

const MeshVerdict& bestOf(const Trials& trials) { return trials.tried[trials.best].verdict; }

PointFile sceneFile(const char* id) { return findScene(id)->build(); }

}  // namespace

TEST_CASE("trials: losses against the open run are named") {
    MeshVerdict mesh;
    CHECK(lossesText(mesh, mesh).empty());
    MeshVerdict before;
    before.lost = 3;
    CHECK(lossesText(mesh, before).empty());
    mesh.lost = 8;
    CHECK(lossesText(mesh, before) == "more points lost (8, before 3)");
}

TEST_CASE("trials: a sound mesh without a change needs no other") {
    RunSpec spec;
    spec.rules = "robust";
    const Trials trials = triedOn(sceneFile("torus"), spec);
    CHECK(trials.tried.size() == 1);
    CHECK(trials.best == 0);
    CHECK(describe(bestOf(trials)).starts_with("sound; distances up to 0"));
}

TEST_CASE("trials: a mesh without a triangle is neither sound nor good enough") {
    // From two points no run makes a triangle.
    PointFile file;
    file.position = {Vec3(0.0), Vec3(1.0, 0.0, 0.0)};
    file.normal.assign(2, Vec3(0.0, 0.0, 1.0));
    const Trials trials = triedOn(file);
    CHECK(trials.best == 0);
    CHECK_FALSE(bestOf(trials).isSound());
    CHECK(describe(bestOf(trials)).starts_with("not sound: no triangle"));
}

TEST_CASE("trials: the rules of robust come first, and a sound mesh ends the search") {
    const Trials trials = triedOn(sceneFile("sharp-crease"));
    REQUIRE(trials.tried.size() >= 2);
    CHECK(trials.tried[0].change.empty());
    CHECK(trials.tried[1].change == kRobust);
    CHECK(bestOf(trials).isSound());
    CHECK(trials.best + 1 == trials.tried.size());
}

TEST_CASE("trials: what is better than the open run is found within the first three") {
    const Trials trials = triedOn(sceneFile("uneven-density"));
    REQUIRE(trials.best > 0);
    std::size_t first = 1;
    while (!isBetter(trials.tried[first].verdict, trials.tried[0].verdict)) ++first;
    CHECK(first < 3);
}

TEST_CASE("trials: on garbled points all of them cost at most 25 times the dearest") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    PointFile file = fibonacciSphere(800);
    for (std::size_t i = 0; i < 800; i += 4) {
        const Vec3 place = file.position[i];
        const Vec3 wrong[] = {place, 50.0 * place, Vec3(nan), 1.02 * place};
        file.position.push_back(wrong[i / 4 % 4]);
    }
    file.normal.clear();
    const Trials trials = triedOn(file);
    std::uint64_t all = 0, dearest = 0;
    for (const Trial& trial : trials.tried) {
        all += trial.work;
        dearest = std::max<std::uint64_t>(dearest, trial.work);
    }
    CHECK(dearest > 0);
    CHECK(all <= 25 * dearest);
}

TEST_CASE("trials: every one is made as the settings after its change are run") {
    const PointFile file = sceneFile("uneven-density");
    const Trials trials = triedOn(file);
    CHECK(trials.tried.size() <= kMaxTrials);
    for (const Trial& trial : trials.tried) {
        CAPTURE(wordsOf(trial.change));
        const RunSpec spec = changed({}, trial.change);
        const Params params = paramsOf(spec).value();
        PrepareOptions options = prepareOptionsOf(spec, params, file).value();
        options.leaveOut = trial.leaveOut;
        const Prepared made = prepare(file, options).value();
        const Run run = runAll(made.points, params);
        PointSet points = made.points;
        points.judge = judgeFor(file).value();
        const MeshInspection found = inspectWithTotals(points, run.state.mesh());
        CHECK(faultCount(found.totals) == faultCount(trial.verdict.totals));
        CHECK(run.state.mesh().size() == trial.verdict.triangles);
        const std::size_t number = static_cast<std::size_t>(&trial - trials.tried.data());
        REQUIRE((trial.mesh != nullptr) == (number == 0 || number == trials.best));
        if (trial.mesh) CHECK(*trial.mesh == run.state.mesh());
    }
    // Equal input, equal trials.
    const Trials again = triedOn(file);
    CHECK(again.best == trials.best);
    REQUIRE(again.tried.size() == trials.tried.size());
    for (std::size_t i = 0; i < again.tried.size(); ++i) {
        CHECK(again.tried[i].change == trials.tried[i].change);
        CHECK(describe(again.tried[i].verdict) == describe(trials.tried[i].verdict));
    }
}

TEST_CASE("trials: an opening that the mesh covers counts as closed") {
    for (const Open& open : openSurfaces()) {
        CAPTURE(open.name);
        const Trials trials = triedOn(open.file);
        CHECK(trials.tried[0].verdict.openings == open.rims);
        CHECK(bestOf(trials).closed <= trials.tried[0].verdict.closed);
        if (bestOf(trials).isSound()) CHECK(bestOf(trials).closed == 0);
    }
    // A rim of a disc: the paper's rules close it like a tent, or leave it open.
    const Open holes = sphereWithHoles({Vec3(0.0, 0.0, 1.0)}, 0.5, 3);
    const Trials trials = triedOn(holes.file);
    CHECK(trials.tried[0].verdict.closed == 1);
    CHECK(bestOf(trials).closed == 0);
}

TEST_CASE("trials: points that the doctor drops are set aside, and keep their numbers") {
    const PointFile file = sceneFile("near-duplicates");
    Result<Trials> trials = tryChanges(file, {});
    REQUIRE(trials.ok());
    const auto dropped =
        std::find_if(trials.value().tried.begin(), trials.value().tried.end(),
                     [](const Trial& t) { return !textOf(t.change, "doctor").empty(); });
    if (dropped == trials.value().tried.end()) return;
    CHECK_FALSE(dropped->leaveOut.empty());
    CHECK(dropped->verdict.usedPoints + dropped->leaveOut.size() <= file.position.size());
    CHECK(dropped->verdict.points == file.position.size());
}

TEST_CASE("trials: lines of a scanner are thinned, and no point between those that stay is lost") {
    // Points of a cylinder in rings, ten times as near along them.
    PointFile file;
    for (int ring = 0; ring < 16; ++ring) {
        for (int i = 0; i < 320; ++i) {
            const double a = 2.0 * std::numbers::pi * (i + 0.37 * ring) / 320.0;
            file.normal.emplace_back(std::cos(a), std::sin(a), 0.0);
            file.position.push_back(file.normal.back() + Vec3(0.0, 0.0, 0.2 * ring));
        }
    }
    const Trials trials = triedOn(file);
    REQUIRE(trials.best > 0);
    const Trial& best = trials.tried[trials.best];
    CHECK(textOf(best.change, "doctor") == "lines");
    CHECK(best.verdict.isSound());
    CHECK(best.verdict.lost == 0);
    CHECK(best.verdict.openings == 2);
    CHECK(best.verdict.closed == 0);
    CHECK(best.verdict.twins == best.leaveOut.size());
    CHECK(best.verdict.fidelity.greatestDistance < 0.05);
}

TEST_CASE("trials: given normals that fit and agree are never turned, nor others derived") {
    const auto normalsTried = [](const PointFile& file) {
        std::set<std::string> tried;
        for (const Trial& each : triedOn(file).tried) {
            const std::string_view normals = textOf(each.change, "normals");
            if (!normals.empty()) tried.emplace(normals);
        }
        return tried;
    };
    // No set of rules makes a sound mesh of these, so that all changes are tried.
    PointFile file = sceneFile("uneven-density");
    CHECK(normalsTried(file).empty());
    PointFile flipped = file;
    for (std::size_t p = 0; p < 40; ++p) flipped.normal[p] = -flipped.normal[p];
    CHECK(normalsTried(flipped).count("derived") == 0);
    for (Vec3& n : file.normal) n = Vec3(0.0, 0.0, 1.0);
    CHECK(normalsTried(file).count("oriented") == 0);
}

TEST_CASE("trials: all of them are judged by the points as they are given") {
    const auto file = sharedPoints("points/coupling.ply");
    if (!file) return;
    const Trials trials = triedOn(*file);
    const Trial& best = trials.tried[trials.best];
    const RunSpec spec = changed({}, best.change);
    const Params params = paramsOf(spec).value();
    PrepareOptions options = prepareOptionsOf(spec, params, *file).value();
    options.leaveOut = best.leaveOut;
    PointSet points = prepare(*file, options).value().points;
    points.judge = judgeFor(*file).value();
    const MeshInspection found = inspectWithTotals(points, runAll(points, params).state.mesh());
    CHECK(faultCount(found.totals) == faultCount(best.verdict.totals));
    CHECK(found.report.flippedTriangles < 100);
}

TEST_CASE("trials: progress grows to 1, and false cancels") {
    const PointFile file = sceneFile("close-sheets");
    double last = 0.0;
    const auto grows = [&last](double share) {
        const bool fine = share >= last && share <= 1.0;
        last = share;
        return fine;
    };
    CHECK(tryChanges(file, {}, {}, grows).ok());
    CHECK(last == 1.0);
    int calls = 0;
    CHECK_FALSE(tryChanges(file, {}, {}, [&](double) { return ++calls < 3; }).ok());
}

TEST_CASE("trials: each change is shown before it is tried, with the trials so far") {
    std::vector<SpecChange> shown;
    const Result<Trials> trials =
        tryChanges(sceneFile("close-sheets"), {}, [&](const Trials& soFar, const SpecChange& next) {
            CHECK(soFar.tried.size() == shown.size());
            shown.push_back(next);
        });
    REQUIRE(trials.ok());
    REQUIRE(shown.size() == trials.value().tried.size());
    for (std::size_t i = 0; i < shown.size(); ++i)
        CHECK(trials.value().tried[i].change == shown[i]);
}

TEST_CASE("trials: other preparations leave the numbers of points, and normals that are right") {
    const PointFile file = sceneFile("wrong-lists");
    const PointSet points = prepared(file);
    const auto judge = judgeFor(file).value();
    REQUIRE(judge->facts.normalsFit);
    const auto keys = [&](const RunSpec& spec, const MeshJudge& by) {
        std::vector<std::string> texts;
        for (const OtherPreparation& each : otherPreparations(file, spec, by)) {
            texts.push_back(std::string(each.change.field->key) + "=" + each.change.text);
            const auto other = each.points({});
            REQUIRE(other);
            CHECK(other->position == points.position);
            CHECK_FALSE(each.points([](double) { return false; }));
        }
        return texts;
    };
    const std::vector<std::string> all{"rim=on",      "neighbors=10", "neighbors=16",
                                       "neighbors=8", "neighbors=12", "neighbors=20",
                                       "symmetric=on"};
    CHECK(keys({}, *judge) == all);
    RunSpec spec;
    spec.rim = true;
    CHECK(keys(spec, *judge) == std::vector<std::string>(all.begin() + 1, all.end()));
    MeshJudge unfit = *judge;
    unfit.facts.normalsFit = false;
    CHECK(keys({}, unfit).front() == "normals=derived");
    // What-ifs name decisions of the run as it is prepared.
    spec.whatIf.push_back(whatIfFromText("5.sphere drop 7").value());
    CHECK(keys(spec, *judge).empty());
}

TEST_CASE("trials: what is so already is no change") {
    RunSpec spec;
    spec.rules = "robust";
    spec.rim = spec.neighbors.symmetric = true;
    spec.fixes = {"noise"};
    PointFile file = sceneFile("torus");
    file.neighbors = {};
    const auto left = [&](std::string_view key, std::string_view text) {
        return withoutPresent(specChange({{key, text}}), spec, file);
    };
    CHECK(left("rules", "robust").empty());
    CHECK(left("rim", "on").empty());
    CHECK(left("symmetric", "on").empty());
    CHECK(left("doctor", "noise").empty());
    CHECK(left("neighbors", "12").empty());
    CHECK(textOf(left("neighbors", "10"), "neighbors") == "10");
    CHECK(textOf(left("switches", "fill=off"), "switches") == "fill=off");
    spec.choices = {{"fill", 0.0}};
    CHECK(left("switches", "fill=off").empty());
    // Normals that are derived are oriented.
    CHECK_FALSE(left("normals", "oriented").empty());
    file.normal.clear();
    CHECK(left("normals", "oriented").empty());
}

TEST_CASE("trials: two changes are joined unless they set one thing to two values") {
    const SpecChange ten = specChange({{"rules", "robust"}, {"neighbors", "10"}});
    const auto both = bothOf(ten, specChange({{"rules", "robust"}, {"rim", "on"}}));
    REQUIRE(both);
    CHECK(*both == specChange({{"rules", "robust"}, {"neighbors", "10"}, {"rim", "on"}}));
    CHECK_FALSE(bothOf(ten, specChange({{"neighbors", "16"}})));
    CHECK_FALSE(bothOf(ten, specChange({{"rules", "corrected"}})));
}
