
#include <doctest/doctest.h>

#include <variant>

#include "spiraling_edge/scenes/scenes.h"

using namespace se;
using namespace se::view;

TEST_CASE("The options of an input are the settings of its run, fixes included") {
    RunSpec spec;
    spec.rules = "robust";
    spec.choices = {{"delay", 0.0}};
    spec.keepNoise = true;
    spec.neighbors.reach = KNearest{9};
    spec.fixes = {"flipped_normals", "open_border"};
    const RunSettings settings = settingsOf(spec, findScene("torus")->build());
    const Params params = paramsOf(settings).value();
    CHECK(params == paramsOf(spec).value());
    CHECK(settings.prepare.normals == NormalSource::Oriented);
    CHECK(settings.prepare.rim);
    CHECK(std::get<KNearest>(settings.prepare.neighbors.reach).k == 9);
}

TEST_CASE("A change of settings is the same change of the options of an input") {
    const SettingsChange change{.rules = "robust",
                                .ruleOff = "fill",
                                .nearest = 10,
                                .normals = NormalSource::Derived,
                                .symmetric = true,
                                .rim = true,
                                .drop = "noise"};
    const PointFile file = findScene("torus")->build();
    const RunSpec after = withChange({}, change);
    CHECK(after.fixes == std::vector<std::string>{"noise"});
    const RunSettings same = changed(settingsOf({}, file), change);
    const RunSettings settings = settingsOf(after, file);
    CHECK(paramsOf(settings).value() == paramsOf(same).value());
    CHECK(settings.prepare.neighbors.reach == same.prepare.neighbors.reach);
    CHECK(settings.prepare.neighbors.recompute);
    CHECK(settings.prepare.neighbors.symmetric);
    CHECK(settings.prepare.normals == NormalSource::Derived);
    CHECK(settings.prepare.rim);
}
