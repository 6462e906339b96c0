/// Golden event logs: every decision of a few small runs, one per line, "ADDRESS<TAB>SENTENCE".
/// They were checked against the paper by hand; a change here is a change of the algorithm. After a
/// deliberate one: SPIRALING_EDGE_UPDATE_GOLDEN=1 core_tests -tc="golden*", and review the diff.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"

using namespace se;
using namespace se::test;

namespace {

std::filesystem::path goldenFile(const std::string& name) {
#ifdef SPIRALING_EDGE_GOLDEN_DIR
    return std::filesystem::path(SPIRALING_EDGE_GOLDEN_DIR) / (name + ".txt");
#else
    return std::filesystem::path(__FILE__).parent_path().parent_path() / "golden" / (name + ".txt");
#endif
}

/// The log of a run, of the given pivots only if there are any.
std::string logOf(const PointSet& points, const std::vector<std::uint32_t>& pivots = {}) {
    const std::vector<Event> events = eventsOf(points, paper());
    std::string text;
    for (const Event& event : events) {
        const auto chosen = std::find(pivots.begin(), pivots.end(), event.address.pivot);
        if (!pivots.empty() && chosen == pivots.end()) continue;
        text += toString(event.address) + '\t' + describe(event) + '\n';
    }
    return text;
}

void checkGolden(const std::string& name, const std::string& log) {
    const std::filesystem::path path = goldenFile(name);
    if (std::getenv("SPIRALING_EDGE_UPDATE_GOLDEN") != nullptr) {
        std::ofstream(path, std::ios::binary) << log;
        MESSAGE("written: ", path.string());
        return;
    }
    std::ifstream file(path, std::ios::binary);
    REQUIRE_MESSAGE(file.good(), path.string());
    std::istringstream now(log);
    std::string expected;
    std::string line;
    for (int number = 1; std::getline(file, expected); ++number) {
        std::getline(now, line);
        REQUIRE_MESSAGE(line == expected, name, ".txt line ", number);
    }
    CHECK_FALSE(std::getline(now, line));
}

/// Nine points in rows of three, slightly irregular; the eight outer ones on walls.
PointSet nine() {
    PointFile file;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x) {
            const bool middle = x == 1 && y == 1;
            file.position.emplace_back(middle ? 1.1 : x, middle ? 1.05 : y, 0.0);
            file.normal.emplace_back(0, 0, 1);
            const unsigned faces =
                (x == 0 ? unsigned{kNegativeX} : 0U) | (x == 2 ? unsigned{kPositiveX} : 0U) |
                (y == 0 ? unsigned{kNegativeY} : 0U) | (y == 2 ? unsigned{kPositiveY} : 0U);
            file.type.push_back(withCornerBit(static_cast<std::uint8_t>(faces)));
        }
    }
    // The middle point first.
    std::swap(file.position[0], file.position[4]);
    std::swap(file.type[0], file.type[4]);
    return prepared(file);
}

}  // namespace

TEST_CASE("golden: nine points on a square, eight of them on its walls") {
    checkGolden("nine", logOf(nine()));
}

TEST_CASE("golden: a sphere of twelve points") {
    checkGolden("sphere-12", logOf(prepared(sampleClosed(unitSphere(), 12, 1.1, 1), reach(8))));
}

TEST_CASE("golden: the limits of Figure 4, the split and the join of Figures 11 and 12") {
    checkGolden("figure-8", logOf(prepared(findScene("figure-8")->build()), {8}));
    checkGolden("figure-12", logOf(prepared(findScene("figure-12")->build()), {35, 74}));
}

TEST_CASE("golden: no move across 180 degrees, and a finished edge in a longer ring") {
    checkGolden("half-turn", logOf(prepared(findScene("half-turn")->build()), {30}));
    checkGolden("finished-edge", logOf(prepared(findScene("finished-edge")->build()), {129}));
}
