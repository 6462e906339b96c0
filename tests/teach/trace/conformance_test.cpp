#include "teach/trace/conformance.h"

#include <doctest/doctest.h>

#include <iterator>
#include <set>

#include "spiraling_edge/prepare/prepare.h"
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
    CHECK(names.size() == 34);
}

TEST_CASE("one conformance input shows that neighbors with opposing normals are left out") {
    std::vector<std::string_view> shown;
    for (const ConformanceInput& input : conformanceInputs()) {
        const ConformanceCase made = conformanceCase(input);
        PrepareOptions all;
        all.neighbors.dropOpposingNormals = false;
        Params params;
        params.start = made.start;
        const SharedPoints kept(prepare(made.file, all).value().points);
        if (traceText(kept, params) != traceText(made.points, params)) shown.push_back(input.name);
    }
    CHECK(shown == std::vector<std::string_view>{"opposing-normals"});
}

}  // namespace se::teach
