#include "rows/paper_text.h"

#include <doctest/doctest.h>

#include <set>

#include "open_session.h"

using namespace se;
using namespace se::view;

TEST_CASE("Paper: every stage has a rule with words and code") {
    for (std::size_t i = 0; i < kStageCount; ++i) {
        const PaperRule& rule = paperRule(static_cast<Stage>(i));
        CHECK(rule.title.size() > 3);
        CHECK(rule.words.size() > 20);
        CHECK(rule.code.size() >= 2);
    }
}

TEST_CASE("Paper: words and lines are joined as in the file") {
    const PaperRule& rule = paperRule(Stage::Split);
    CHECK(rule.title == "The edge ring");
    CHECK(rule.words ==
          "The ring now runs outside of the new fan. Where it meets itself it splits, where it "
          "meets another ring the two join.");
    REQUIRE(rule.code.size() == 6);
    CHECK(rule.code[3] == "if an inserted point was on a ring already:");
    CHECK(rule.code[4] == "  on the active ring: split it in two, push one");
    CHECK(&rule == &paperRule(Stage::Ring));
}

TEST_CASE("Paper: every event of a run has a line of its rule") {
    std::set<std::pair<std::string, std::size_t>> seen;
    for (const char* scene :
         {"scene:sphere", "scene:sheet", "scene:long-lists", "scene:coarse-torus"}) {
        for (const char* rules : {"paper", "robust"}) {
            LoadProgress progress;
            const auto model = test::loadModel(withSet({scene}, rules), progress);
            REQUIRE(model.ok());
            EventLog log;
            Stepper stepper(model.value()->points, model.value()->params, &log);
            stepper.run();
            for (const Event& event : log.events()) {
                CAPTURE(toString(event.address));
                const PaperRule& rule = paperRule(event.address.stage);
                REQUIRE(presentLine(event) < rule.code.size());
                seen.insert({rule.title, presentLine(event)});
            }
        }
    }
    CHECK(seen.size() > 25);
}

TEST_CASE("Paper: the numbers of a sphere test are those that decided it") {
    const SphereEvidence evidence{1, 2, 3, Vec3(0.0), 0.25, 0.5, 45.9, Verdict::Removed};
    const Event event{{7, Stage::Sphere, 1}, evidence};
    CHECK(paperRule(Stage::Sphere).code[presentLine(event)] == "  else: remove q");
    CHECK(liveNumbers(event) == "|q - c| = 0.5, r = 0.25, gap 45.9\xC2\xB0");
}
