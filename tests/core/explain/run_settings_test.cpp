#include "spiraling_edge/explain/run_settings.h"

#include <doctest/doctest.h>

#include <variant>

#include "spiraling_edge/scenes/scenes.h"

using namespace se;

namespace {

using Options = std::vector<std::string>;

PointFile torusScene() { return findScene("torus")->build(); }

}  // namespace

TEST_CASE("settings: a change of rules, lists, normals and rims is in the settings after it") {
    const RunSettings after = changed({}, {.rules = "robust",
                                           .ruleOff = "fill",
                                           .nearest = 10,
                                           .normals = NormalSource::Oriented,
                                           .symmetric = true,
                                           .rim = true,
                                           .drop = "noise"});
    const Result<Params> params = paramsOf(after);
    REQUIRE(params.ok());
    Params expected = *paramsByName("robust");
    expected.robust.fill = false;
    CHECK(params.value() == expected);
    const PrepareOptions prepare = prepareOptionsFor(after.prepare, params.value());
    CHECK(std::get<KNearest>(prepare.neighbors.reach).k == 10);
    CHECK(prepare.neighbors.recompute);
    CHECK(prepare.neighbors.symmetric);
    CHECK(prepare.normals == NormalSource::Oriented);
    CHECK(prepare.rim);
    CHECK(prepare.setNoiseAside);
    CHECK(after.drops == std::vector<std::string>{"noise"});
}

TEST_CASE("settings: a single rule that the user chose stays under another set of rules") {
    RunSettings settings;
    settings.choices = {{"delay", 0.0}};
    const Result<Params> params = paramsOf(changed(settings, {.rules = "robust"}));
    REQUIRE(params.ok());
    CHECK(params.value().robust.fill);
    CHECK_FALSE(params.value().robust.delay);
}

TEST_CASE("settings: options override what the rules say of noise and opposing normals") {
    RunSettings settings;
    settings.rules = "robust";
    settings.keepNoise = settings.keepOpposing = true;
    const Result<Params> params = paramsOf(settings);
    REQUIRE(params.ok());
    const PrepareOptions prepare = prepareOptionsFor(settings.prepare, params.value());
    CHECK_FALSE(prepare.setNoiseAside);
    CHECK_FALSE(prepare.neighbors.dropOpposingNormals);
}

TEST_CASE("settings: an unknown set of rules is an error that names it") {
    RunSettings settings;
    settings.rules = "sturdy";
    REQUIRE_FALSE(paramsOf(settings).ok());
    CHECK(paramsOf(settings).error().message == "There is no rule set \"sturdy\".");
}

TEST_CASE("settings: what is so already is no change") {
    RunSettings settings;
    settings.rules = "robust";
    settings.prepare.rim = settings.prepare.neighbors.symmetric = true;
    settings.drops = {"noise"};
    PointFile file = torusScene();
    file.neighbors = {};
    const SettingsChange none{};
    CHECK(withoutPresent({.rules = "robust"}, settings, file) == none);
    CHECK(withoutPresent({.rim = true}, settings, file) == none);
    CHECK(withoutPresent({.symmetric = true}, settings, file) == none);
    CHECK(withoutPresent({.drop = "noise"}, settings, file) == none);
    CHECK(withoutPresent({.nearest = 12}, settings, file) == none);
    CHECK(withoutPresent({.nearest = 10}, settings, file).nearest == 10);
    CHECK(withoutPresent({.ruleOff = "fill"}, settings, file).ruleOff == "fill");
    settings.choices = {{"fill", 0.0}};
    CHECK(withoutPresent({.ruleOff = "fill"}, settings, file) == none);
    // Normals that are derived are oriented.
    CHECK(withoutPresent({.normals = NormalSource::Oriented}, settings, file).normals.has_value());
    file.normal.clear();
    CHECK(withoutPresent({.normals = NormalSource::Oriented}, settings, file) == none);
}

TEST_CASE("settings: two changes are joined unless they set one thing to two values") {
    const SettingsChange ten{.rules = "robust", .nearest = 10};
    const auto both = bothOf(ten, {.rules = "robust", .rim = true});
    REQUIRE(both);
    CHECK(*both == SettingsChange{.rules = "robust", .nearest = 10, .rim = true});
    CHECK_FALSE(bothOf(ten, {.nearest = 16}));
    CHECK_FALSE(bothOf(ten, {.rules = "corrected"}));
}

TEST_CASE("settings: a change in words and as options of run") {
    const SettingsChange change{.rules = "robust", .nearest = 10, .drop = "two_layers"};
    CHECK(wordsOf(change) == "rules of robust, 10 neighbors, without two layers");
    CHECK(optionsOf(change) == Options{"--rules robust", "--neighbors 10"});
    CHECK(wordsOf({}) == "no change");
    CHECK(optionsOf({.ruleOff = "fill", .normals = NormalSource::Derived, .rim = true}) ==
          Options{"--rule fill=off", "--derive-normals", "--derive-rim"});
}
