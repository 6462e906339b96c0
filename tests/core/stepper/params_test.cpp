#include <doctest/doctest.h>

#include <set>
#include <string>

#include "spiraling_edge/stepper/rule_settings.h"

using namespace se;

namespace {

bool beyondThePaper(const RuleSetting& rule) { return !rule.isOn(*paramsByName("paper")); }

}  // namespace

TEST_CASE("every named set of params exists, and no other") {
    for (const std::string_view name : paramSetNames()) CHECK(paramsByName(name));
    CHECK(paramsByName("paper"));
    CHECK(paramsByName("printed"));
    CHECK_FALSE(paramsByName("Paper"));
    CHECK_FALSE(paramsByName(""));
}

TEST_CASE("printed has every setting that quotes the paper at the value of its quotation") {
    const Params printed = *paramsByName("printed");
    std::size_t quoted = 0;
    for (const RuleSetting& rule : ruleSettings()) {
        CHECK_MESSAGE(rule.printed.has_value() == !rule.paper.empty(), rule.name);
        if (!rule.printed) {
            // Without a sentence: as it is by default, and nothing of the rules beyond the paper.
            CHECK_MESSAGE(rule.get(printed) == rule.get(Params{}), rule.name);
            continue;
        }
        ++quoted;
        CHECK_MESSAGE(isValue(rule, *rule.printed), rule.name);
        CHECK_MESSAGE(rule.get(printed) == *rule.printed, rule.name);
    }
    CHECK(quoted == 29);
}

TEST_CASE("eleven quotations of the paper are not in force by default: those are read otherwise") {
    std::set<std::string_view> read;
    for (const RuleSetting& rule : ruleSettings()) {
        if (rule.printed && rule.get(Params{}) != *rule.printed) read.insert(rule.name);
    }
    CHECK(read == std::set<std::string_view>{"opposing", "limitsfirst", "halfturn", "convexshared",
                                             "freesector", "realhole", "closetwo", "instance",
                                             "opensteps", "keepseeds", "stayinside"});
}

TEST_CASE("paper has the seven readings of the paper on, and nothing beyond it") {
    const Readings rules = paramsByName("paper")->readings;
    CHECK(rules.freeSector);
    CHECK(rules.limitsFirst);
    CHECK(rules.belowHalfTurn);
    CHECK(rules.realHole);
    CHECK(rules.closeTwo);
    CHECK(rules.openSteps);
    CHECK(rules.keepSeeds);
    int on = 0;
    for (const RuleSetting& rule : ruleSwitches()) on += beyondThePaper(rule) ? 0 : 1;
    CHECK(on == 7);
    CHECK(paramsByName("paper")->maxGapCosine == -0.5);  // 120 degrees
}

TEST_CASE("switches are off in printed, and each turns on itself alone") {
    for (const RuleSetting& rule : ruleSwitches()) {
        CHECK_FALSE(rule.isOn(*paramsByName("printed")));
        Params one = *paramsByName("printed");
        rule.turnOn(one);
        int on = 0;
        for (const RuleSetting& other : ruleSwitches()) on += other.isOn(one) ? 1 : 0;
        CHECK(on == 1);
    }
}
