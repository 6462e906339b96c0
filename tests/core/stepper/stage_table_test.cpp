#include "spiraling_edge/stepper/stage_table.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

#include "spiraling_edge/stepper/what_if.h"

using namespace se;

TEST_CASE("stages have different names, and sections 3 to 7 or none if they are not the paper's") {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < kStageCount; ++i) {
        const auto stage = static_cast<Stage>(i);
        names.insert(stageName(stage));
        CHECK(stageFromName(stageName(stage)) == stage);
        const bool beyond = stage == Stage::Guard || stage == Stage::Fill ||
                            stage == Stage::Reinsert || stage == Stage::Flip ||
                            stage == Stage::RemoveFolded;
        CHECK(stageSection(stage).empty() == beyond);
        if (beyond) continue;
        CHECK(stageSection(stage)[0] >= '3');
        CHECK(stageSection(stage)[0] <= '7');
    }
    CHECK(names.size() == kStageCount);
    CHECK_FALSE(stageFromName("spheres"));
    CHECK(stageSection(Stage::Sphere) == "6.3");
    CHECK(stageSection(Stage::Seed) == "4");
}

TEST_CASE("Stages: a test can be kept or dropped by a what-if where the table has tests") {
    for (const StageRow& row : stageTable()) {
        CAPTURE(row.name);
        const std::string at = "137." + std::string(row.name);
        const bool tests = row.tests != StageTests::None;
        CHECK(whatIfFromText(at + " keep 812").ok() == tests);
        CHECK(whatIfFromText(at + " drop 812").ok() == tests);
    }
    CHECK(rowOf(Stage::Sphere).tests == StageTests::OfPoints);
    CHECK(rowOf(Stage::Guard).tests == StageTests::OfFans);
    CHECK(rowOf(Stage::Emit).tests == StageTests::None);
}
