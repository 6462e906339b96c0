#include "spiraling_edge/spec/run_spec.h"

#include <doctest/doctest.h>

#include <variant>

#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/spec/spec_fields.h"

using namespace se;

TEST_CASE("spec: a change of rules, lists, normals and rims is in the spec after it") {
    const PointFile file = findScene("torus")->build();
    const RunSpec after = changed({}, specChange({{"doctor", "noise"},
                                                  {"rules", "robust"},
                                                  {"switches", "fill=off"},
                                                  {"neighbors", "10"},
                                                  {"symmetric", "on"},
                                                  {"normals", "oriented"},
                                                  {"rim", "on"}}));
    const Result<Params> params = paramsOf(after);
    REQUIRE(params.ok());
    Params expected = *paramsByName("robust");
    expected.robust.fill = false;
    CHECK(params.value() == expected);
    const PrepareOptions prepare = prepareOptionsOf(after, params.value(), file).value();
    CHECK(std::get<KNearest>(prepare.neighbors.reach).k == 10);
    CHECK(prepare.neighbors.recompute);
    CHECK(prepare.neighbors.symmetric);
    CHECK(prepare.normals == NormalSource::Oriented);
    CHECK(prepare.rim);
    CHECK(prepare.setNoiseAside);
    CHECK(after.fixes == std::vector<std::string>{"noise"});
}

TEST_CASE("spec: a single rule that the user chose stays under another set of rules") {
    RunSpec spec;
    spec.choices = {{"delay", 0.0}};
    const Result<Params> params = paramsOf(changed(spec, specChange({{"rules", "robust"}})));
    REQUIRE(params.ok());
    CHECK(params.value().robust.fill);
    CHECK_FALSE(params.value().robust.delay);
}

TEST_CASE("spec: the rule rim finds the rims of files that bring none") {
    PointFile file;
    file.position = {Vec3(0.0)};
    const auto findsRims = [&](const char* rules, const char* key, const char* text) {
        const RunSpec spec = changed({}, specChange({{"rules", rules}, {key, text}}));
        return prepareOptionsOf(spec, paramsOf(spec).value(), file).value().rim;
    };
    CHECK(findsRims("robust", "neighbors", "12"));
    CHECK_FALSE(findsRims("robust", "switches", "rim=off"));
    CHECK_FALSE(findsRims("corrected", "neighbors", "12"));
    CHECK(findsRims("paper", "rim", "on"));
    file.type = {kRimPoint};
    CHECK_FALSE(findsRims("robust", "neighbors", "12"));
    CHECK(findsRims("robust", "rim", "on"));
}

TEST_CASE("spec: what is kept is a rule turned off, whatever the set says") {
    const RunSpec spec = changed({}, specChange({{"rules", "robust"},
                                                 {"keep_opposing", "on"},
                                                 {"keep_noise", "on"},
                                                 {"keep_strays", "on"}}));
    const Result<Params> params = paramsOf(spec);
    REQUIRE(params.ok());
    const PrepareOptions prepare = prepareOptionsOf(spec, params.value(), {}).value();
    CHECK_FALSE(prepare.setNoiseAside);
    CHECK_FALSE(prepare.setStraysAside);
    CHECK_FALSE(prepare.neighbors.dropOpposingNormals);
    const RunSpec same = changed({}, specChange({{"rules", "robust"},
                                                 {"switches", "opposing=off"},
                                                 {"switches", "noise=off"},
                                                 {"switches", "strays=off"}}));
    CHECK(spec == same);
}

TEST_CASE("spec: an unknown set of rules is an error that names it") {
    RunSpec spec;
    spec.rules = "sturdy";
    REQUIRE_FALSE(paramsOf(spec).ok());
    CHECK(paramsOf(spec).error().message == "There is no rule set \"sturdy\".");
}

TEST_CASE("spec: a scene begins with its start, unless another is given") {
    RunSpec spec;
    spec.source = "scene:figure-11";
    const GivenStart own = startOfScene("figure-11");
    REQUIRE_FALSE(own.empty());
    CHECK(paramsOf(spec).value().start == own);
    spec.start.rings = {{0, 1, 2}};
    CHECK(paramsOf(spec).value().start == spec.start);
}

TEST_CASE("spec: fixes that change no point become options") {
    RunSpec spec;
    spec.fixes = {"flipped_normals", "open_border", "duplicates"};
    const RunSpec with = withFixesAsOptions(spec);
    CHECK(with.fixes.empty());
    CHECK(with.normals == NormalSource::Oriented);
    CHECK(with.rim);
}

TEST_CASE("spec: options of the user come before those of fixes") {
    RunSpec spec = changed({}, specChange({{"normals", "derived"}, {"neighbors", "10"}}));
    for (const DoctorCheck& check : doctorChecks()) {
        if (check.fix == Fix::Orient || check.fix == Fix::NewLists)
            spec.fixes.emplace_back(check.name);
    }
    REQUIRE(spec.fixes.size() >= 2);
    const RunSpec with = withFixesAsOptions(spec);
    spec.fixes.clear();
    CHECK(with == spec);
}

TEST_CASE("spec: normals of the file cannot face a scanner") {
    const PointFile file = findScene("torus")->build();
    RunSpec spec;
    spec.scanner = Vec3(0.0, 0.0, 9.0);
    CHECK_FALSE(prepareOptionsOf(spec, {}, file).ok());
    spec.normals = NormalSource::Oriented;
    CHECK(prepareOptionsOf(spec, {}, file).value().scanner == spec.scanner);
}

TEST_CASE("spec: a rule of a set is no choice of its own") {
    RunSpec spec = withSet({}, "robust");
    spec = withRule(spec, "fill", 0.0);
    CHECK(spec.choices == std::vector<RuleValue>{{"fill", 0.0}});
    CHECK(valueOf(spec, *findRuleSetting("fill")) == 0.0);
    CHECK(usualValueOf(spec, *findRuleSetting("fill")) == 1.0);
    CHECK(withRule(spec, "fill", 1.0).choices.empty());
    CHECK(withSet(spec, "paper").choices.empty());
}
