#include "compare/compared_runs.h"

#include <doctest/doctest.h>

#include "document/actions.h"
#include "headless_app.h"

using namespace se;
using namespace se::view;

namespace {

constexpr const char* kStillRunning = "The comparison is still running.";

/// A run of the torus with another one beside it that is known.
struct ComparedApp : test::HeadlessApp {
    ComparedApp() : test::HeadlessApp("compared-test") {
        document.open("scene:torus");
        waitUntilDone();
        actions::applyLayoutPreset(context, LayoutPreset::Compare);
        compare.begin(otherRun("freesector"));
        compare.waitUntilDone();
        REQUIRE(compare.comparison().result() != nullptr);
        REQUIRE(compare.look() != nullptr);
        session.messages().clear();
    }
    CompareWith otherRun(const char* rule) const {
        return CompareWith::otherRun(withRule(session.input().spec(), rule, 0.0));
    }
};

}  // namespace

TEST_CASE("Keys before the next poll act on no result of the comparison before") {
    ComparedApp app;
    SUBCASE("Another one has begun") { app.compare.begin(app.otherRun("sphere")); }
    SUBCASE("It was stopped") { app.compare.stop(); }
    SUBCASE("The runs have changed places") { app.compare.swap(); }
    CHECK(app.compare.look() == nullptr);
    for (const auto act : {&ComparedRuns::toFirstDifference, &ComparedRuns::toFirstHarmless,
                           &ComparedRuns::toNextRegion}) {
        app.session.messages().clear();
        (app.compare.*act)();
        CHECK(app.session.messages().last() == kStillRunning);
    }
}

TEST_CASE("The colors of a comparison are those of its own result") {
    ComparedApp app;
    const std::uint32_t before = app.compare.look()->revision;
    app.compare.begin(app.otherRun("sphere"));
    app.compare.waitUntilDone();
    REQUIRE(app.compare.look() != nullptr);
    CHECK(app.compare.look()->revision != before);
}
