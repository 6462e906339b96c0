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

TEST_CASE("printed is the paper word for word: every switch off, no filter") {
    const Params printed = *paramsByName("printed");
    for (const RuleSetting& rule : ruleSwitches()) CHECK_FALSE(rule.isOn(printed));
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
