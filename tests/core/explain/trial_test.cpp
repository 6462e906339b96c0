#include "spiraling_edge/explain/trial.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/open_surfaces.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

/// The numbers of a mesh of 1,000 points with some unused points as its only faults.
MeshNumbers numbersWith(std::size_t faults, std::size_t lost = 0, std::size_t closed = 0) {
    MeshNumbers numbers;
    numbers.points = 1000;
    numbers.lost = lost;
    numbers.openings = 2;
    numbers.closed = closed;
    numbers.triangles = 100;
    numbers.totals.resize(failureClasses().size());
    const auto unused = findFailureClass("unused_points") - failureClasses().data();
    numbers.totals[static_cast<std::size_t>(unused)] = {faults, faults, true};
    return numbers;
}

Trials triedOn(const PointFile& file, const RunSettings& settings = {}) {
    Result<Trials> trials = tryChanges(file, settings);
    REQUIRE(trials.ok());
    return std::move(trials.value());
}

const MeshNumbers& bestOf(const Trials& trials) { return trials.tried[trials.best].numbers; }

PointFile sceneFile(const char* id) { return findScene(id)->build(); }

}  // namespace

TEST_CASE("trials: fewer faults are better, and of equal ones fewer points lost") {
    const MeshNumbers present = numbersWith(10);
    CHECK(isBetter(numbersWith(9), present, present));
    CHECK_FALSE(isBetter(numbersWith(10), present, present));
    CHECK_FALSE(isBetter(numbersWith(11), present, present));
    CHECK(isBetter(numbersWith(10), numbersWith(10, 1), present));
}

TEST_CASE("trials: a mesh that closes an opening is not better, whatever its faults") {
    const MeshNumbers present = numbersWith(10, 0, 1);
    CHECK_FALSE(isBetter(numbersWith(0, 0, 2), present, present));
    CHECK(isBetter(numbersWith(0, 0, 1), present, present));
}

TEST_CASE("trials: a mesh that loses one point in 200 more is not better") {
    const MeshNumbers present = numbersWith(10, 2);
    CHECK(isBetter(numbersWith(0, 7), present, present));
    CHECK_FALSE(isBetter(numbersWith(0, 8), present, present));
}

TEST_CASE("trials: points set aside count before points lost, distances last") {
    const MeshNumbers present = numbersWith(10);
    MeshNumbers aside = numbersWith(3);
    aside.setAside = 1;
    CHECK(isBetter(numbersWith(3, 2), aside, present));
    MeshNumbers far = numbersWith(3);
    far.fidelity.greatestDistance = 0.5;
    CHECK(isBetter(numbersWith(3), far, present));
    MeshNumbers mean = numbersWith(3);
    mean.fidelity.meanDistance = 0.1;
    CHECK(isBetter(mean, far, present));
    CHECK(isBetter(numbersWith(3), mean, present));
}

TEST_CASE("trials: a run that was stopped, or made nothing, is not better") {
    const MeshNumbers present = numbersWith(10);
    MeshNumbers stopped = numbersWith(0);
    stopped.capped = true;
    CHECK_FALSE(isBetter(stopped, present, present));
    MeshNumbers nothing = numbersWith(0);
    nothing.triangles = 0;
    CHECK_FALSE(isBetter(nothing, present, present));
    CHECK(isBetter(numbersWith(20), stopped, stopped));
}

TEST_CASE("trials: a sound mesh without a change needs no other") {
    RunSettings settings;
    settings.rules = "robust";
    const Trials trials = triedOn(sceneFile("torus"), settings);
    CHECK(trials.tried.size() == 1);
    CHECK(trials.best == 0);
    CHECK(describe(bestOf(trials)).starts_with("sound; 0 points lost"));
}

TEST_CASE("trials: a mesh without a triangle is neither sound nor good enough") {
    MeshNumbers nothing = numbersWith(0);
    nothing.triangles = 0;
    CHECK_FALSE(isSound(nothing));
    CHECK(describe(nothing).starts_with("no triangle; "));
    // Of two points no run makes one.
    PointFile file;
    file.position = {Vec3(0.0), Vec3(1.0, 0.0, 0.0)};
    file.normal.assign(2, Vec3(0.0, 0.0, 1.0));
    const Trials trials = triedOn(file);
    CHECK(trials.best == 0);
    CHECK_FALSE(isSound(bestOf(trials)));
}

TEST_CASE("trials: the rules of robust come first, and a sound mesh ends the search") {
    const Trials trials = triedOn(sceneFile("sharp-crease"));
    REQUIRE(trials.tried.size() >= 2);
    CHECK(trials.tried[0].change == SettingsChange{});
    CHECK(trials.tried[1].change == SettingsChange{.rules = "robust"});
    CHECK(faultCount(bestOf(trials).totals) < faultCount(trials.tried[0].numbers.totals));
    for (std::size_t i = 0; i + 1 < trials.tried.size(); ++i)
        CHECK_FALSE((isSound(trials.tried[i].numbers) && trials.tried[i].numbers.lost == 0));
}

TEST_CASE("trials: every one is made as the settings after its change are run") {
    const PointFile file = sceneFile("uneven-density");
    const Trials trials = triedOn(file);
    CHECK(trials.tried.size() <= kMaxTrials);
    for (const Trial& trial : trials.tried) {
        CAPTURE(wordsOf(trial.change));
        const RunSettings settings = changed({}, trial.change);
        const Params params = paramsOf(settings).value();
        PrepareOptions options = prepareOptionsFor(settings.prepare, params);
        options.leaveOut = trial.leaveOut;
        const Prepared made = prepare(file, options).value();
        const Run run = runAll(made.points, params);
        const MeshInspection found = inspectWithTotals(made.points, run.state.mesh());
        CHECK(faultCount(found.totals) == faultCount(trial.numbers.totals));
        CHECK(run.state.mesh().size() == trial.numbers.triangles);
    }
    // Equal input, equal trials.
    const Trials again = triedOn(file);
    CHECK(again.best == trials.best);
    REQUIRE(again.tried.size() == trials.tried.size());
    for (std::size_t i = 0; i < again.tried.size(); ++i) {
        CHECK(again.tried[i].change == trials.tried[i].change);
        CHECK(describe(again.tried[i].numbers) == describe(trials.tried[i].numbers));
    }
}

TEST_CASE("trials: an opening that the mesh covers counts as closed") {
    for (const Open& open : openSurfaces()) {
        CAPTURE(open.name);
        const Trials trials = triedOn(open.file);
        CHECK(trials.tried[0].numbers.openings == open.rims);
        CHECK(bestOf(trials).closed <= trials.tried[0].numbers.closed);
        if (isSound(bestOf(trials))) CHECK(bestOf(trials).closed == 0);
    }
    // A rim of a disc: the paper's rules close it like a tent, or leave it open.
    const Open holes = sphereWithHoles({Vec3(0.0, 0.0, 1.0)}, 0.5, 3);
    const Trials trials = triedOn(holes.file);
    CHECK(trials.tried[0].numbers.closed == 1);
    CHECK(bestOf(trials).closed == 0);
}

TEST_CASE("trials: points that the doctor drops are set aside, and keep their numbers") {
    const PointFile file = sceneFile("near-duplicates");
    Result<Trials> trials = tryChanges(file, {});
    REQUIRE(trials.ok());
    const auto dropped = std::find_if(trials.value().tried.begin(), trials.value().tried.end(),
                                      [](const Trial& t) { return !t.change.drop.empty(); });
    if (dropped == trials.value().tried.end()) return;
    CHECK_FALSE(dropped->leaveOut.empty());
    CHECK(dropped->numbers.setAside >= dropped->leaveOut.size());
    CHECK(dropped->numbers.points == file.position.size());
}

TEST_CASE("trials: given normals that fit and agree are never turned, nor others derived") {
    const auto normalsTried = [](const PointFile& file) {
        std::set<NormalSource> tried;
        for (const Trial& each : triedOn(file).tried) {
            if (each.change.normals) tried.insert(*each.change.normals);
        }
        return tried;
    };
    // No set of rules makes a sound mesh of these, so that all changes are tried.
    PointFile file = sceneFile("uneven-density");
    CHECK(normalsTried(file).empty());
    PointFile flipped = file;
    for (std::size_t p = 0; p < 40; ++p) flipped.normal[p] = -flipped.normal[p];
    CHECK(normalsTried(flipped).count(NormalSource::Derived) == 0);
    for (Vec3& n : file.normal) n = Vec3(0.0, 0.0, 1.0);
    CHECK(normalsTried(file).count(NormalSource::Oriented) == 0);
}

TEST_CASE("trials: all of them are judged by the points as they are given") {
    const auto file = sharedPoints("points/coupling.ply");
    if (!file) return;
    const Trials trials = triedOn(*file);
    const Trial& best = trials.tried[trials.best];
    const RunSettings settings = changed({}, best.change);
    const Params params = paramsOf(settings).value();
    PrepareOptions options = prepareOptionsFor(settings.prepare, params);
    options.leaveOut = best.leaveOut;
    PointSet points = prepare(*file, options).value().points;
    points.judge = judgeFor(*file).value().points;
    const MeshInspection found = inspectWithTotals(points, runAll(points, params).state.mesh());
    CHECK(faultCount(found.totals) == faultCount(best.numbers.totals));
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
    std::vector<SettingsChange> shown;
    const Result<Trials> trials = tryChanges(sceneFile("close-sheets"), {},
                                             [&](const Trials& soFar, const SettingsChange& next) {
                                                 CHECK(soFar.tried.size() == shown.size());
                                                 shown.push_back(next);
                                             });
    REQUIRE(trials.ok());
    REQUIRE(shown.size() == trials.value().tried.size());
    for (std::size_t i = 0; i < shown.size(); ++i)
        CHECK(trials.value().tried[i].change == shown[i]);
}
