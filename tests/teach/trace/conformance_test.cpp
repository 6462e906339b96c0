#include "teach/trace/conformance.h"

#include <doctest/doctest.h>

#include <iterator>
#include <set>

#include "teach/trace/rule_guess.h"
#include "traced_scenes.h"

namespace se::teach {

TEST_CASE("the conformance inputs show every change of the paper's rules") {
    std::set<std::string> hidden;
    for (const RuleValue& each : singleSettings({})) hidden.insert(lineOf(each));
    for (const ConformanceInput& input : conformanceInputs()) {
        const ConformanceCase made = conformanceCase(input);
        Params params;
        params.start = made.start;
        const Trace trace = readTrace(traceText(made.points, params), "x").value();
        CHECK(matchTrace(trace, made.points, params, {}).whole);
        for (auto rule = hidden.begin(); rule != hidden.end();) {
            const bool shows = !matchTrace(trace, made.points, withRule(params, *rule), {}).whole;
            rule = shows ? hidden.erase(rule) : std::next(rule);
        }
    }
    for (const std::string& rule : hidden) FAIL_CHECK(rule);
}

TEST_CASE("conformance inputs have distinct names") {
    std::set<std::string_view> names;
    for (const ConformanceInput& input : conformanceInputs()) names.insert(input.name);
    CHECK(names.size() == conformanceInputs().size());
    CHECK(names.size() == 25);
}

}  // namespace se::teach
