/// The doctor's advice, tried on files with planted faults: the effect that is reported of a
/// command is that of another run of it.
#include "spiraling_edge/why/tried_fixes.h"
#include "spiraling_edge/spec/run_spec.h"

#include <limits>

#include "core/doctor/doctor_support.h"
#include "spiraling_edge/mesh/mesh_verdict.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/prepare/piece.h"
#include "spiraling_edge/run/reconstruct.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// The verdict on the mesh of a file, by plain calls.
std::string endOfRun(const PointFile& file, const char* rules, NormalSource normals) {
    const Params params = *paramsByName(rules);
    RunSpec spec;
    spec.normals = normals;
    const PrepareOptions options = prepareOptionsOf(spec, params, file).value();
    Prepared prepared = prepare(file, options).value();
    prepared.points.judge = judgeOfRun(file, options, params, prepared.points).value();
    const State state = reconstruct(prepared.points, params).state;
    const MeshVerdict verdict = judgeMesh(prepared.points, state.mesh()).verdict;
    if (verdict.triangles == 0) return "no triangle";
    if (verdict.isSound()) return "sound";
    return std::to_string(verdict.amiss) + (verdict.amiss == 1 ? " point amiss" : " points amiss");
}

std::string effectOf(const PointFile& before, const PointFile& after, NormalSource normals) {
    std::string text;
    for (const char* rules : {"paper", "robust"}) {
        text += (text.empty() ? "by " : ", by ") + std::string(rules) + " " +
                endOfRun(after, rules, normals) + " (before " +
                endOfRun(before, rules, NormalSource::AsGiven) + ")";
    }
    return text;
}

Diagnosis diagnosisTriedOn(const PointFile& file) {
    Diagnosis diagnosis = examined(file);
    REQUIRE(tryFixes(file, diagnosis).ok());
    return diagnosis;
}

/// Each point a second time, a little to the side.
PointFile inPairs(PointFile file, double apart) {
    const PointFile first = file;
    append(file, moved(first, Vec3(apart, 0.5 * apart, 0.0)));
    return file;
}

}  // namespace

TEST_CASE("tried fixes: the effect of a command is that of another run of it" *
          doctest::test_suite("long")) {
    for (const Family& family : closedFamilies(kTubesApart)) {
        PointFile alike = family.sample(1);
        for (Vec3& n : alike.normal) n = Vec3(0.0, 0.0, 1.0);
        const Diagnosis unfit = diagnosisTriedOn(alike);
        const Finding* derive = findingOf(unfit, "unfit_normals");
        REQUIRE(derive != nullptr);
        REQUIRE(derive->tried);
        CHECK(derive->tried->text == effectOf(alike, alike, NormalSource::Derived));

        const PointFile pairs = inPairs(family.sample(2), 0.002);
        const Diagnosis twins = diagnosisTriedOn(pairs);
        const Finding* thin = findingOf(twins, "twins");
        REQUIRE(thin != nullptr);
        REQUIRE(thin->tried);
        const PointFile left = applyFixes(pairs, thin->toDrop(), thin->dropReason).file;
        CHECK(thin->tried->text == effectOf(pairs, left, NormalSource::AsGiven));
        CHECK(thin->tried->helps == !remedyFor(*thin, "a.ply").empty());
    }
}

TEST_CASE("tried fixes: the effect of --scale-by is that of a run of the scaled points") {
    PointFile file = fibonacciSphere(600);
    for (Vec3& x : file.position) x.z *= 1000.0;
    file.normal.clear();
    file.positionType = ScalarType::Double;
    const Diagnosis units = diagnosisTriedOn(file);
    const Finding* scale = findingOf(units, "mixed_units");
    REQUIRE(scale != nullptr);
    REQUIRE(scale->tried);
    CHECK(scale->tried->helps);
    CHECK(scale->tried->text ==
          effectOf(file, scaled(file, Vec3(1.0, 1.0, 0.001)), NormalSource::AsGiven));
    CHECK(scale->tried->text.starts_with("by paper sound"));
    CHECK(remedyFor(*scale, "'a b.ply'") ==
          "spiraling-edge run 'a b.ply' --scale-by 1,1,0.001 -o OUT.ply");
}

TEST_CASE("tried fixes: a command without gain is not named as a remedy") {
    PointFile file = fibonacciSphere(600);
    file.position.emplace_back(0.0, 0.0, 3.0);
    file.normal.emplace_back(0.0, 0.0, 1.0);
    Diagnosis diagnosis = examined(file);
    const Finding* stray = findingOf(diagnosis, "isolated_points");
    REQUIRE(stray != nullptr);
    CHECK_FALSE(stray->tried);
    CHECK_FALSE(remedyFor(*stray, "a.ply").empty());
    REQUIRE(tryFixes(file, diagnosis).ok());
    CHECK(stray->tried->text == "by paper sound (before sound), by robust sound (before sound)");
    CHECK_FALSE(stray->tried->helps);
    CHECK(remedyFor(*stray, "a.ply").empty());
}

TEST_CASE("tried fixes: a repair says how many points a run uses") {
    PointFile file = fibonacciSphere(600);
    append(file, moved(fibonacciSphere(600), Vec3(0.0)));
    file.position[3].x = std::numeric_limits<double>::quiet_NaN();
    const Diagnosis diagnosis = diagnosisTriedOn(file);
    for (const char* name : {"non_finite", "duplicates"}) {
        const Finding* finding = findingOf(diagnosis, name);
        REQUIRE(finding != nullptr);
        CHECK(finding->tried->helps);
        CHECK(finding->tried->text == "writes 600 points, without those that every run sets aside");
    }
}

TEST_CASE("tried fixes: a sound file needs no change, and advice without a command is not tried") {
    PointFile bare = fibonacciSphere(600);
    bare.normal.clear();
    const Diagnosis diagnosis = diagnosisTriedOn(bare);
    const Finding* none = findingOf(diagnosis, "no_normals");
    REQUIRE(none != nullptr);
    CHECK(none->tried->text == "sound as given");
    PointFile two = fibonacciSphere(600);
    two.position.resize(2);
    two.normal.resize(2);
    const Diagnosis few = diagnosisTriedOn(two);
    const Finding* tooFew = findingOf(few, "too_few_points");
    REQUIRE(tooFew != nullptr);
    CHECK_FALSE(tooFew->tried);
}

TEST_CASE(
    "tried fixes: what takes too much work is not tried, the dearest first, and no effect "
    "changes") {
    PointFile file = inPairs(fibonacciSphere(300), 0.002);
    file.normal.clear();
    const Diagnosis all = diagnosisTriedOn(file);
    REQUIRE(findingOf(all, "twins")->tried);
    REQUIRE(findingOf(all, "no_normals")->tried);
    std::size_t before = 2;
    for (const std::uint64_t work : {1'000'000ULL, 4'000ULL, 0ULL}) {
        Diagnosis diagnosis = examined(file);
        REQUIRE(tryFixes(file, diagnosis, {}, work).ok());
        const Finding* twins = findingOf(diagnosis, "twins");
        const Finding* none = findingOf(diagnosis, "no_normals");
        const std::size_t tried = (twins->tried ? 1U : 0U) + (none->tried ? 1U : 0U);
        CHECK(tried <= before);
        before = tried;
        if (twins->tried) CHECK(twins->tried->text == findingOf(all, "twins")->tried->text);
        if (none->tried) CHECK(none->tried->text == findingOf(all, "no_normals")->tried->text);
        // Not tried, it is still named.
        CHECK_FALSE(remedyFor(*none, "a.ply").empty());
        if (none->tried) CHECK(twins->tried);
    }
    CHECK(before < 2);
}

TEST_CASE("tried fixes: once the work is done, neither a pair of runs nor --best is tried") {
    // --best comes first in the report, and is tried last.
    PointFile file = inPairs(fibonacciSphere(300), 0.002);
    for (Vec3& normal : file.normal) normal = glm::normalize(Vec3(0.2, 0.3, 1.0));
    Diagnosis diagnosis = examined(file);
    Finding best;
    best.check = findDoctorCheck("no_normals");
    diagnosis.findings.insert(diagnosis.findings.begin(), best);
    REQUIRE(tryFixes(file, diagnosis, {}, 1).ok());
    CHECK_FALSE(diagnosis.findings.front().tried);
    const Finding* twins = findingOf(diagnosis, "twins");
    const Finding* unfit = findingOf(diagnosis, "unfit_normals");
    REQUIRE(twins != nullptr);
    REQUIRE(unfit != nullptr);
    CHECK(twins->tried.has_value());
    CHECK_FALSE(unfit->tried.has_value());
    // Even where --best would take a single run.
    PointFile strayed = fibonacciSphere(300);
    strayed.position.emplace_back(0.0, 0.0, 6.0);
    strayed.normal.emplace_back(0.0, 0.0, 1.0);
    diagnosis = examined(strayed);
    diagnosis.findings.insert(diagnosis.findings.begin(), best);
    REQUIRE(tryFixes(strayed, diagnosis, {}, 1000).ok());
    const Finding* stray = findingOf(diagnosis, "isolated_points");
    REQUIRE(stray != nullptr);
    CHECK(stray->tried.has_value());
    CHECK_FALSE(diagnosis.findings.front().tried);
}

TEST_CASE("tried fixes: cancelled at any share, and the findings stay as they were") {
    const PointFile pairs = inPairs(fibonacciSphere(300), 0.002);
    for (const double limit : {0.0, 0.3, 0.7}) {
        Diagnosis diagnosis = examined(pairs);
        const Status tried =
            tryFixes(pairs, diagnosis, [limit](double share) { return share <= limit; });
        CHECK_FALSE(tried.ok());
        const Finding* thin = findingOf(diagnosis, "twins");
        REQUIRE(thin != nullptr);
        CHECK_FALSE(thin->tried);
    }
}
