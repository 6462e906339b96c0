#include "teach/trace/rule_guess.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "traced_scenes.h"

namespace se::teach {
namespace {

RuleGuess guessFor(const TracedScene& scene, const Params& planted,
                   std::optional<TraceStage> upto = {}) {
    const TraceDetail detail = upto ? TraceDetail::Stages : TraceDetail::Fans;
    const Trace trace = readTrace(traceText(scene.points, planted, detail), "x").value();
    return guessRules(trace, scene.points, scene.params, upto).value();
}

}  // namespace

TEST_CASE("a planted change of one rule is named") {
    const TracedScene scene = tracedScene("figure-8");
    const RuleGuess guess = guessFor(scene, withRule(scene.params, "limits=off"));
    REQUIRE(guess.whole.size() == 1);
    CHECK(lineOf(guess.whole[0]) == "limits=off");
    Trace trace;
    trace.pivots.resize(83);
    CHECK(guessText(guess, trace) ==
          "your whole trace, 83 pivots, behaves like --rule limits=off\n");
}

TEST_CASE("two changes are no single one, and the one alike for longest is named") {
    const TracedScene scene = tracedScene("torus");
    const RuleGuess guess =
        guessFor(scene, withRule(withRule(scene.params, "stack=first"), "active=other"));
    CHECK(guess.whole.empty());
    REQUIRE(guess.nearest);
    CHECK(lineOf(*guess.nearest) == "active=other");
    Trace trace;
    trace.pivots.resize(9);
    CHECK(guessText(guess, trace)
              .starts_with("no single rule of the paper's, changed, gives your whole trace; --rule "
                           "active=other goes along for longest, "));
}

TEST_CASE("a half-built program is guessed by the stages that it has") {
    const TracedScene scene = tracedScene("figure-8");
    const RuleGuess guess =
        guessFor(scene, withRule(scene.params, "maxangle=off"), TraceStage::Sort);
    REQUIRE(guess.whole.size() >= 1);
    CHECK(lineOf(guess.whole[0]) == "maxangle=off");
}

TEST_CASE("a rule is named by the fans where stages differ from ours without the rule") {
    const TracedScene scene = tracedScene("figure-8");
    const Params without = withRule(scene.params, "limits=off");
    Trace trace = readTrace(traceText(scene.points, without, TraceDetail::Stages), "x").value();
    for (TracePivot& each : trace.pivots) {
        if (each.sort) std::reverse(each.sort->begin(), each.sort->end());
    }
    const RuleGuess guess = guessRules(trace, scene.points, scene.params, {}).value();
    REQUIRE(guess.whole.size() == 1);
    CHECK(lineOf(guess.whole[0]) == "limits=off");
}

TEST_CASE("every other value of the paper's switches is tried") {
    std::set<std::string> tried;
    for (const RuleValue& each : singleSettings({})) tried.insert(lineOf(each));
    for (const RuleSetting& setting : ruleSettings()) {
        if (setting.beyondPaper || setting.name == "opposing") continue;
        const double own = setting.get({});
        std::size_t found = 0;
        for (const RuleValue& each : singleSettings({}))
            found += each.name == setting.name && each.value != own ? 1 : 0;
        const bool isNumber =
            setting.kind == SettingKind::Number || setting.kind == SettingKind::Whole;
        CHECK_MESSAGE(found == (isNumber ? 2 : static_cast<std::size_t>(setting.high)),
                      setting.name);
    }
    CHECK(tried.count("twopoint=off") == 1);
    CHECK(tried.count("guard=on") == 0);
}

}  // namespace se::teach
