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

TEST_CASE("printed takes the letter for the other instance, Figure 5 and the third point's place") {
    const Params printed = *paramsByName("printed");
    for (const RuleSetting& rule : ruleSwitches()) CHECK_FALSE(rule.isOn(printed));
    CHECK(printed.paper.instance == InstanceRule::First);
    CHECK(printed.paper.convexShared);
    CHECK_FALSE(printed.paper.stayInside);
    CHECK_FALSE(printed.dropOpposingNormals);
    CHECK(printed.maxGapCosine == -0.5);
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

TEST_CASE("switches have names and members of their own, a section and a sentence") {
    std::set<std::string_view> names;
    for (const RuleSetting& rule : ruleSwitches()) {
        names.insert(rule.name);
        CHECK_FALSE(rule.section.empty());
        CHECK(rule.summary.size() > 10);
        Params one = *paramsByName("printed");
        rule.turnOn(one);
        int on = 0;
        for (const RuleSetting& other : ruleSwitches()) on += other.isOn(one) ? 1 : 0;
        CHECK(on == 1);
    }
    CHECK(names.size() == ruleSwitches().size());
}
