#include "panels/pages/scene_tiles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "jobs/open_lesson.h"

using namespace se;
using namespace se::view;

namespace {

/// The figures of the paper's results that are sampled: 21, 23 and 24.
constexpr std::size_t kSampled = 3;

void drawAll(StartPage& page) {
    page.prepare();
    page.sampling.waitUntilDone();
    page.poll();
}

}  // namespace

TEST_CASE("The start page has a tile with a picture for every scene") {
    StartPage page;
    drawAll(page);
    REQUIRE(page.tiles.size() ==
            lessonEntries().size() + scenes().size() + kSampled + failureScenes().size());
    for (const SceneTile& tile : page.tiles) {
        CAPTURE(std::string(tile.id));
        CHECK_FALSE(tile.title.empty());
        // Figures of the paper that begin in the middle of a run are a few points.
        const bool begins = tile.minutes > 0.0 || !startOfScene(tile.id).empty();
        CHECK(tile.dots.size() >= (begins ? 6U : 10U));
        float reach = 0.0F;
        for (const ThumbnailDot& dot : tile.dots) {
            reach = std::max({reach, std::abs(dot.at.x), std::abs(dot.at.y)});
        }
        CHECK(reach == doctest::Approx(1.0F));
    }
}

TEST_CASE("Lessons come first on the start page, with their length, the tour before all others") {
    StartPage page;
    page.prepare();
    CHECK(sourceOf(page.tiles.front()) == "lesson:tour");
    for (std::size_t i = 0; i < page.tiles.size(); ++i)
        CHECK((page.tiles[i].minutes > 0.0) == (i < lessonEntries().size()));
    CHECK(sourceOf(page.tiles[lessonEntries().size()]) == "scene:figure-1");
}

TEST_CASE("Tiles show a mesh half grown, and those of failures the failure") {
    StartPage page;
    drawAll(page);
    for (std::size_t i = 0; i < page.tiles.size(); ++i) {
        const SceneTile& tile = page.tiles[i];
        CAPTURE(std::string(tile.id));
        CHECK(tile.faces.size() >= 1);
        // A lesson may show a failure, as that on holes does.
        if (tile.minutes > 0.0) continue;
        const auto failing = std::count_if(tile.faces.begin(), tile.faces.end(),
                                           [](const ThumbnailFace& each) { return each.failure; });
        const bool shows = failing > 0 || !tile.marks.empty();
        CHECK(shows == (i >= lessonEntries().size() + scenes().size() + kSampled));
    }
}

TEST_CASE("Sampled figures of the results follow those with a scene, and are drawn later") {
    StartPage page;
    page.prepare();
    std::vector<int> numbers;
    for (const SceneTile& tile : page.tiles) {
        if (tile.figure != nullptr) numbers.push_back(tile.figure->number);
    }
    CHECK(std::is_sorted(numbers.begin(), numbers.end()));
    CHECK(numbers.back() == 24);
    const auto found = std::find_if(
        page.tiles.begin(), page.tiles.end(),
        [](const SceneTile& each) { return sourceOf(each) == "sample:hyperboloid,n=215"; });
    REQUIRE(found != page.tiles.end());
    CHECK(found->title == "Figure 23: hyperboloid");
}

TEST_CASE("A picture omits points without a position, and has at most the requested number") {
    PointFile points;
    for (int i = 0; i < 1000; ++i) points.position.emplace_back(i, 0.5 * i, 0.0);
    points.position[0] = Vec3(std::nan(""));
    const auto dots = thumbnail(points, 100, Vec3(1.0, 0.0, 1.0));
    CHECK(dots.size() <= 100);
    CHECK(dots.size() >= 90);
    for (const ThumbnailDot& dot : dots) CHECK(std::isfinite(dot.at.x + dot.at.y));
    CHECK(thumbnail({}, 100, Vec3(1.0, 0.0, 1.0)).empty());
}
