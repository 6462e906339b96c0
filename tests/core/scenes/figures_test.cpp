#include "spiraling_edge/scenes/figures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/explain/figure_check.h"
#include "spiraling_edge/replay/event_text.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

std::size_t broken(const Figure& figure, const Params& params) {
    const auto checked = expectationsOf(figure, params);
    return static_cast<std::size_t>(
        std::count_if(checked.begin(), checked.end(),
                      [](const CheckedExpectation& each) { return !each.holds; }));
}

/// Values of the paper's rules that no row shows, and the test that does.
struct NotInARow {
    std::string_view rule;
    std::string_view value;
};
constexpr NotInARow kNotInARow[] = {
    {"opposing", "off"},     // a setting of neighbor lists: prepare_test
    {"halfturn", "off"},     // scene half-turn: "6.1 start and end do not advance across"
    {"convexshared", "on"},  // off in the paper: rule_settings_test
    {"instance", "first"},   // "6.5 of several entries"
    {"twopoint", "from"},    // at exactly 180 degrees a triangle has no area: emit_test
};

/// The values of a switch or choice other than the default.
std::vector<double> otherValues(const RuleSetting& rule) {
    std::vector<double> values;
    const bool counts = rule.kind == SettingKind::Switch || rule.kind == SettingKind::Option;
    for (double value = 0.0; counts && value <= rule.high; value += 1.0) {
        if (value != rule.get(paper())) values.push_back(value);
    }
    return values;
}

bool isInNoRow(const RuleSetting& rule, double value) {
    return std::any_of(std::begin(kNotInARow), std::end(kNotInARow), [&](const NotInARow& each) {
        return each.rule == rule.name && each.value == valueText(rule, value);
    });
}

}  // namespace

TEST_CASE("figures: the table has the paper's 25 figures in order, each with a scene or a sample") {
    REQUIRE(figures().size() == 25);
    for (std::size_t i = 0; i < figures().size(); ++i) {
        const Figure& figure = figures()[i];
        CAPTURE(figure.number);
        CHECK(figure.number == static_cast<int>(i) + 1);
        CHECK(figure.scene.title.starts_with("Figure " + std::to_string(figure.number) + ": "));
        CHECK(figure.scene.watch.ends_with("."));
        CHECK(findFigure(figure.number) == &figure);
        CHECK(figure.hasScene() == (figure.number <= 20));
        if (!figure.hasScene()) {
            CHECK(figure.counts.points > 0);
            CHECK(sourceOf(figure) == figure.sample);
            continue;
        }
        CHECK(figure.scene.id == "figure-" + std::to_string(figure.number));
        CHECK(figureOfScene(figure.scene.id) == &figure);
        REQUIRE(findScene(figure.scene.id) != nullptr);
        CHECK(addressOfScene(figure.scene.id) == figure.scene.address);
        CHECK(startOfScene(figure.scene.id).empty() == (figure.scene.start == nullptr));
        CHECK_FALSE(figure.expectations.empty());
        CHECK(findRuleSetting(figure.rule.name) != nullptr);
        CHECK(figure.absence.ends_with("."));
    }
    CHECK(findFigure(26) == nullptr);
    CHECK(figureOfScene("torus") == nullptr);
}

TEST_CASE("figures: names are those of points that exist, none twice") {
    for (const Figure& figure : figures()) {
        CAPTURE(figure.number);
        std::set<Index> points;
        std::set<std::string_view> names;
        for (const PointName& each : figure.names) {
            CHECK(each.point < figure.scene.build().position.size());
            CHECK(points.insert(each.point).second);
            CHECK(names.insert(each.name).second);
        }
    }
}

TEST_CASE("figures: every expectation holds, and the rule's absence shows") {
    for (const Figure& figure : figures()) {
        if (!figure.hasScene()) continue;
        CAPTURE(figure.number);
        const FigureCheck check = checkFigure(figure);
        for (const CheckedExpectation& each : check.expectations) {
            CAPTURE(each.expected.address);
            CAPTURE(each.found);
            CHECK(each.holds);
        }
        CHECK(check.brokenWithout > 0);
        CHECK(check.showsAbsence);
        CHECK(check.holds());
        CHECK(figure.fault.has_value() == (check.faultsWithout > 0));
    }
}

TEST_CASE("figures: without the rules of 3, 5, 6, 7, 9 and 14 the mesh has a fault") {
    for (const int number : {3, 5, 6, 7, 9, 14}) {
        CAPTURE(number);
        CHECK(findFigure(number)->fault.has_value());
    }
}

TEST_CASE("figures: no expectation holds with another verdict, point or address") {
    std::set<std::string_view> outcomes;
    for (const Figure& figure : figures()) {
        for (const FigureExpectation& each : figure.expectations) outcomes.insert(each.outcome);
    }
    CHECK(outcomes.size() > 20);
    for (const Figure& figure : figures()) {
        if (!figure.hasScene()) continue;
        CAPTURE(figure.number);
        std::vector<FigureExpectation> wrong;
        for (const FigureExpectation& each : figure.expectations) {
            for (const std::string_view other : outcomes) {
                if (other != each.outcome) wrong.push_back({each.address, each.points, other});
            }
            wrong.push_back({each.address, "nobody", each.outcome});
            wrong.push_back({"99999.sort.1", each.points, each.outcome});
        }
        Figure flipped = figure;
        flipped.expectations = wrong;
        CHECK(broken(flipped, paper()) == wrong.size());
        CHECK_FALSE(checkFigure(flipped).holds());
    }
}

TEST_CASE("figures: each of the paper's rules that is off or another breaks an expectation") {
    for (const RuleSetting& rule : ruleSettings()) {
        if (rule.beyondPaper) continue;
        for (const double value : otherValues(rule)) {
            CAPTURE(rule.name);
            CAPTURE(valueText(rule, value));
            Params params = paper();
            rule.set(params, value);
            std::size_t rows = 0;
            for (const Figure& figure : figures())
                rows += figure.hasScene() && broken(figure, params) > 0 ? 1 : 0;
            CHECK((rows > 0) == !isInNoRow(rule, value));
        }
    }
    Params noHoles = paper();
    noHoles.paper.holeSize = 0;
    CHECK(broken(*findFigure(7), noHoles) > 0);
    Params narrow = paper();
    narrow.maxGapCosine = 0.0;
    CHECK(broken(*findFigure(2), narrow) > 0);
}

TEST_CASE("sentences name the points of a figure") {
    const Figure& figure = *findFigure(8);
    const std::vector<CheckedExpectation> checked = expectationsOf(figure, paper());
    REQUIRE(checked.size() == 3);
    CHECK(checked[1].found.starts_with("q lies 0.26303 outside the sphere of the pivot, t and s"));
    const Event made{{1, Stage::Emit, 1}, EmitEvidence{0, {15, 20, 7}}};
    CHECK(describe(made, figure.names) == "Triangle 0 = (p, first, 7).");
    CHECK(describe(made) == "Triangle 0 = (15, 20, 7).");
    CHECK(nameOf(kNone, figure.names) == "none");
    // A point is called r: the measures of the sphere are written out.
    CHECK(checked[1].found.find("(distance = ") != std::string::npos);
    CHECK(checked[1].found.find(", radius = ") != std::string::npos);
}

TEST_CASE("figures 14 and 15 are mirror images: the third point is after, and before") {
    const PointFile a = findFigure(14)->scene.build();
    const PointFile b = findFigure(15)->scene.build();
    REQUIRE(a.position.size() == b.position.size());
    for (std::size_t p = 0; p < a.position.size(); ++p) {
        CHECK(a.position[p].x == -b.position[p].x);
        CHECK(a.position[p].y == b.position[p].y);
        CHECK(((a.type[p] & kNegativeX) != 0) == ((b.type[p] & kPositiveX) != 0));
    }
    CHECK(findFigure(14)->expectations[0].outcome == "after");
    CHECK(findFigure(15)->expectations[0].outcome == "before");
}
