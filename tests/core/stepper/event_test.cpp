#include <doctest/doctest.h>

#include <set>

#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/what_if.h"
#include "support/clouds.h"
#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

template <std::size_t... I>
std::vector<Evidence> oneOfEach(std::index_sequence<I...>) {
    return {Evidence{std::variant_alternative_t<I, Evidence>{}}...};
}

}  // namespace

TEST_CASE("addresses go to text and back") {
    Random random(7);
    for (std::size_t stage = 0; stage < kStageCount; ++stage) {
        for (int i = 0; i < 20; ++i) {
            const Address address{static_cast<std::uint32_t>(random.bits() >> 32U),
                                  static_cast<Stage>(stage),
                                  static_cast<std::uint32_t>(1 + random.below(99))};
            CHECK((addressFromString(toString(address)) == address));
        }
    }
    CHECK(toString({137, Stage::Sphere, 3}) == "137.sphere.3");
    CHECK((addressFromString("137") == Address{137, Stage::Pivot, 0}));
    CHECK((addressFromString("137.sphere") == Address{137, Stage::Sphere, 0}));
}

TEST_CASE("what is no address is refused") {
    for (const char* text : {"", ".", "1.", ".sphere", "x", "1.x", "1.sphere.", "1.sphere.x", "-1",
                             "1..3", "1.sphere.3.4", "1 ", "99999999999", "1.sphere.-3", "+1"}) {
        CHECK_MESSAGE(!addressFromString(text), text);
    }
}

TEST_CASE("every kind of evidence has a sentence") {
    for (const Evidence& evidence :
         oneOfEach(std::make_index_sequence<std::variant_size_v<Evidence>>())) {
        const std::string text = describe({{1, Stage::Pivot, 1}, evidence});
        CHECK(text.size() > 10);
        CHECK(text.back() == '.');
    }
}

TEST_CASE("every kind of alert has its name") {
    CHECK(alertName(AlertKind::TriangleCap) == "triangle_cap");
    CHECK(alertName(AlertKind::Hole) == "hole");
    CHECK(alertName(AlertKind::LostSeed) == "lost_seed");
}

TEST_CASE("events are numbered from 1 within stage and pivot, in order, each address once") {
    EventLog log;
    const PointSet points = prepared(closedFamilies(0.35)[1].sample(1));
    runAll(points, paper(), &log);
    std::set<std::string> seen;
    std::uint32_t pivot = 0;
    bool ordered = true;
    for (const Event& event : log.events()) {
        ordered = ordered && event.address.pivot >= pivot && event.address.n > 0;
        pivot = event.address.pivot;
        ordered = ordered && seen.insert(toString(event.address)).second;
        if (event.address.n > 1) {
            const Address before{pivot, event.address.stage, event.address.n - 1};
            ordered = ordered && seen.count(toString(before)) == 1;
        }
    }
    CHECK(ordered);
    CHECK(seen.count("1.seed.1") == 1);
    log.clear();
    CHECK(log.events().empty());
}

TEST_CASE("stages have different names, and sections 3 to 7 or none if they are not the paper's") {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < kStageCount; ++i) {
        const auto stage = static_cast<Stage>(i);
        names.insert(stageName(stage));
        CHECK(stageFromName(stageName(stage)) == stage);
        const bool beyond = stage == Stage::Guard || stage == Stage::Fill || isRepair(stage);
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
