#include "compare/comparison.h"

#include <doctest/doctest.h>

#include "open_session.h"
#include "scene/difference.h"
#include "spiraling_edge/io/write_mesh.h"

using namespace se;
using namespace se::view;

namespace {

/// A run of the torus, and another beside it.
struct Pair {
    test::OpenSession open{"scene:torus"};
    Session& run = open.session;
    Comparison comparison;

    void beside(const std::string& rules, std::vector<RuleValue> choices = {}) {
        RunSpec spec = run.input().spec();
        spec.rules = rules;
        spec.choices = std::move(choices);
        comparison.start(run, CompareWith::otherRun(spec));
        waitUntilDone();
    }
    void waitUntilDone() {
        run.waitUntilDone();
        comparison.waitUntilDone(run);
    }
    std::string there() { return toString(comparison.other()->address()); }
};

}  // namespace

TEST_CASE("Two timelines: equal up to the first difference, then by shares of the rest") {
    const RunAlignment alignment{99, true, 500, 300};
    CHECK(matchingPivot(alignment, 0) == 0);
    CHECK(matchingPivot(alignment, 100) == 100);
    CHECK(matchingPivot(alignment, 500) == 300);
    CHECK(matchingPivot(alignment, 300) == 200);
    CHECK(inStep(alignment, 100));
    CHECK_FALSE(inStep(alignment, 101));
    std::uint32_t last = 0;
    for (std::uint32_t pivot = 0; pivot <= 500; ++pivot) {
        CHECK(matchingPivot(alignment, pivot) >= last);
        last = matchingPivot(alignment, pivot);
    }
    // Equal runs have the same pivots; one that ends where they diverge stays there.
    CHECK(matchingPivot({700, false, 700, 700}, 650) == 650);
    CHECK(matchingPivot({99, true, 500, 100}, 400) == 100);
    CHECK(matchingPivot({99, true, 100, 300}, 101) == 300);
}

TEST_CASE("The other run follows: decision by decision, then pivot by pivot, to its own end") {
    Pair pair;
    pair.beside("paper", {{"freesector", 0.0}});
    const Compared* found = pair.comparison.result();
    REQUIRE(found != nullptr);
    REQUIRE(found->runs.first);
    CHECK(found->runs.commonPivots == 199);
    pair.run.moves().goTo({50, Stage::Sort, 2});
    pair.waitUntilDone();
    CHECK(pair.there() == "50.sort.2");
    pair.run.moves().stepEvent(1);
    pair.waitUntilDone();
    CHECK(pair.there() == "50.sort.3");
    pair.run.moves().toEnd();
    pair.waitUntilDone();
    CHECK(pair.comparison.other()->atEnd());
    pair.run.moves().toStart();
    pair.waitUntilDone();
    CHECK(pair.comparison.other()->atStart());
}

TEST_CASE("The first difference brings both runs to their own decision") {
    Pair pair;
    pair.beside("paper", {{"stepback", 1.0}});
    const RunDifference first = *pair.comparison.result()->runs.first;
    pair.comparison.goTo(pair.run, {first.a.line->event.address, first.b.line->event.address});
    pair.waitUntilDone();
    CHECK(toString(pair.run.address()) == toString(first.a.line->event.address));
    CHECK(pair.there() == toString(first.b.line->event.address));
    CHECK(pair.run.address().n != pair.comparison.other()->address().n);
    // After a move the other one follows again.
    pair.run.moves().goTo({3, Stage::Sort, 1});
    pair.waitUntilDone();
    CHECK(pair.there() == "3.sort.1");
    // Reaching the same decision by steps has the same effect as the jump.
    pair.run.moves().goTo(first.a.line->event.address);
    pair.waitUntilDone();
    CHECK(pair.there() == toString(first.b.line->event.address));
}

TEST_CASE("A comparison is repeated with the run, and ends with its input") {
    Pair pair;
    pair.beside("robust");
    const std::uint32_t revision = pair.comparison.revision();
    CHECK_FALSE(pair.comparison.result()->meshes.same());
    RunSpec spec = pair.run.input().spec();
    spec.rules = "robust";
    pair.run.open(spec);
    pair.waitUntilDone();
    CHECK(pair.comparison.revision() != revision);
    REQUIRE(pair.comparison.result() != nullptr);
    CHECK(pair.comparison.result()->meshes.same());
    pair.run.open(RunSpec{"scene:sphere"});
    pair.waitUntilDone();
    CHECK_FALSE(pair.comparison.chosen());
    CHECK(pair.comparison.other() == nullptr);
}

TEST_CASE("A mesh of another program is matched with the points, one without triangles is not") {
    Pair pair;
    pair.run.moves().toEnd();
    pair.waitUntilDone();
    PointFile file;
    const auto& position = pair.run.model().points.position;
    file.position.assign(position.rbegin(), position.rend());
    const auto last = static_cast<Index>(position.size() - 1);
    for (const Triangle& t : pair.run.triangles())
        file.faces.push_back({last - t.b, last - t.c, last - t.a});
    file.faces.pop_back();
    const std::filesystem::path path = test::ownPlace("other.ply");
    REQUIRE(writeMeshPly(path, file, file.faces).ok());
    pair.comparison.start(pair.run, CompareWith::otherMesh(path.string()));
    pair.waitUntilDone();
    REQUIRE(pair.comparison.result() != nullptr);
    CHECK(pair.comparison.result()->meshes.onlyA == 1);
    CHECK(pair.comparison.result()->meshes.onlyB == 0);
    CHECK(pair.comparison.other() == nullptr);
    REQUIRE(writeMeshPly(path, file, {}).ok());
    pair.comparison.start(pair.run, CompareWith::otherMesh(path.string()));
    pair.waitUntilDone();
    CHECK(pair.comparison.result() == nullptr);
    CHECK(pair.comparison.complaint().find("no triangles") != std::string::npos);
    std::filesystem::remove(path);
}

TEST_CASE(
    "Colors follow the time of the run: triangles that the other mesh lacks, as far as they are "
    "made") {
    const std::vector<Triangle> order{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    const auto other =
        std::make_shared<const TriangleSet>(std::vector<Triangle>{{1, 2, 0}, {0, 3, 2}, {0, 4, 5}});
    const DifferenceShade shade(order, other);
    const Color only{1.0F, 0.0F, 0.0F};
    const Color turned{0.0F, 1.0F, 0.0F};
    const auto atEnd = shade.at(4, nullptr, only, turned);
    REQUIRE(atEnd[0].count == 1);
    CHECK((*atEnd[0].triangles)[0] == order[2]);
    CHECK(atEnd[0].color == only);
    REQUIRE(atEnd[1].count == 1);
    CHECK((*atEnd[1].triangles)[0] == order[1]);
    CHECK(shade.at(2, nullptr, only, turned)[0].count == 0);
    CHECK(shade.at(3, nullptr, only, turned)[0].count == 1);
    CHECK(shade.at(1, nullptr, only, turned)[1].count == 0);
    const auto repaired = std::make_shared<const std::vector<Triangle>>(
        std::vector<Triangle>{{0, 1, 2}, {7, 8, 9}, {6, 7, 8}});
    CHECK(shade.at(1, repaired, only, turned)[0].count == 2);
    CHECK(shade.at(3, nullptr, only, turned)[0].count == 1);
}

TEST_CASE(
    "The form of the other run begins with the most informative rules, and takes every setting") {
    LoadProgress progress;
    const RunSpec base{"scene:torus"};
    const auto model = test::loadModel(base, progress);
    REQUIRE(model.ok());
    CompareForm form;
    form.take(base, *model.value());
    CHECK(form.rules.rules == "robust");
    CHECK(form.spec(base).value().choices.empty());
    CHECK(differenceText(base, form.spec(base).value()) == "robust rules");
    // Not only switches.
    for (const RuleSetting& setting : ruleSettings()) {
        CompareForm other = form;
        const double usual = usualValueOf(other.rules, setting);
        const double value = usual == setting.low ? setting.high : setting.low;
        other.rules = withRule(other.rules, setting.name, value);
        const auto spec = other.spec(base);
        REQUIRE(spec.ok());
        CHECK_MESSAGE(valueOf(spec.value(), setting) == doctest::Approx(value), setting.name);
    }
    form.rules = withRule(form.rules, "flip", 0.0);
    form.prepare.reach = PrepareForm::Reach::Nearest;
    form.prepare.count = "16";
    form.prepare.symmetric = true;
    form.prepare.normals = NormalSource::Oriented;
    form.prepare.walls = WallChoice::From::Around;
    form.prepare.rim = true;
    const auto spec = form.spec(base);
    REQUIRE(spec.ok());
    CHECK(
        differenceText(base, spec.value()) ==
        "robust rules, flip off, 16 neighbors, symmetric lists, normals oriented, walls of the box "
        "auto, rims derived");
    form.prepare.count = "many";
    CHECK_FALSE(form.spec(base).ok());
}

TEST_CASE("The form of the other run takes what-ifs, and offers the run without them") {
    LoadProgress progress;
    RunSpec fork{"scene:torus"};
    fork.whatIf = {whatIfFromText("9.sphere keep 4").value()};
    const auto model = test::loadModel(fork, progress);
    REQUIRE(model.ok());
    CompareForm form;
    form.take(fork, *model.value());
    CHECK(form.rules.whatIf == fork.whatIf);
    CHECK(differenceText(fork, trueRunOf(fork)) == "no what-ifs");
    form.whatIf = "nonsense";
    form.addWhatIf();
    CHECK_FALSE(form.complaint.empty());
    form.whatIf = "12.sphere drop 7";
    form.addWhatIf();
    CHECK(form.complaint.empty());
    CHECK(form.rules.whatIf.size() == 2);
    CHECK(form.spec(fork).value().whatIf.size() == 2);
}

TEST_CASE("Changes of the open run are applied to the form of the other one") {
    LoadProgress progress;
    const RunSpec before{"scene:torus"};
    const auto model = test::loadModel(before, progress);
    REQUIRE(model.ok());
    CompareForm form;
    form.take(before, *model.value());
    form.rules = withRule(form.rules, "maxgap", 100.0);
    RunSpec now = before;
    now.choices = {{"tie", 1.0}};
    form.prepare.rim = true;
    form.follow(before, now, *model.value());
    CHECK(form.prepare.rim);  // other rules: nothing of the input
    now.neighbors = {KNearest{16}, true, 0, true};
    form.follow(before, now, *model.value());
    CHECK_FALSE(form.prepare.rim);
    CHECK(differenceText(now, form.spec(now).value()) == "robust rules, maxgap 100");
}

TEST_CASE("The differences of the other run are described in words") {
    const RunSpec paper{"scene:torus"};
    RunSpec other = paper;
    CHECK(differenceText(paper, other) == "the same");
    other.rules = "robust";
    CHECK(differenceText(paper, other) == "robust rules");
    other.choices = {{"flip", 0.0}};
    CHECK(differenceText(paper, other) == "robust rules, flip off");
    other = paper;
    other.choices = {{"freesector", 0.0}};
    other.neighbors = {KNearest{16}, true, 0, true};
    CHECK(differenceText(paper, other) == "freesector off, 16 neighbors");
    CHECK(runTitle(other) == "paper rules, freesector off, 16 neighbors");
    CHECK(usualOther(paper).rules == "robust");
    RunSpec robust = paper;
    robust.rules = "robust";
    CHECK(usualOther(robust).rules == "paper");
}
