#include "spiraling_edge/scenes/figures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "spiraling_edge/why/figure_check.h"
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
    {"keepseeds", "off"},    // graph_paper_test
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
        std::set<std::string> names;
        for (const PointName& each : figure.pointNames()) {
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
    CHECK(checked[1].found.starts_with(
        "Point q lies 0.26303 outside the sphere of the pivot, t and s"));
    const Event made{{1, Stage::Emit, 1}, EmitEvidence{0, {15, 20, 7}}};
    CHECK(describe(made, figure.pointNames()) == "Triangle 0 = (p, first, 7).");
    CHECK(describe(made) == "Triangle 0 = (15, 20, 7).");
    CHECK(nameOf(kNone, figure.pointNames()) == "none");
    // A point is called r: the measures of the sphere are written out.
    CHECK(checked[1].found.find("(distance = ") != std::string::npos);
    CHECK(checked[1].found.find(", radius = ") != std::string::npos);
}

TEST_CASE("figures: what is said of the run without the rule is a decision of that run") {
    for (const Figure& figure : figures()) {
        if (!figure.hasScene()) continue;
        CAPTURE(figure.number);
        CHECK((figure.number == 10 || !figure.without.empty()));
        for (const CheckedExpectation& each : checkFigure(figure).without) {
            CAPTURE(each.expected.address);
            CAPTURE(each.found);
            CHECK(each.holds);
        }
        Figure wrong = figure;
        const FigureExpectation stays[] = {{"1.pivot.1", "", "kept"}};
        wrong.without = stays;
        CHECK_FALSE(checkFigure(wrong).holds());
        const FigureExpectation absent[] = {{"1.pivot.1", "", ""}};
        wrong.without = absent;
        CHECK_FALSE(checkFigure(wrong).holds());
    }
}

TEST_CASE("figures: degrees in a caption are those of a decision") {
    for (const Figure& figure : figures()) {
        if (!figure.hasScene()) continue;
        CAPTURE(figure.number);
        std::vector<long> known;
        for (const CheckedExpectation& each : checkFigure(figure).expectations) {
            for (std::size_t at = each.found.find(" deg"); at != std::string::npos;
                 at = each.found.find(" deg", at + 1)) {
                const std::size_t from = each.found.rfind(' ', at - 1) + 1;
                known.push_back(std::lround(std::stod(each.found.substr(from, at - from))));
            }
        }
        const std::string caption(figure.scene.watch);
        for (std::size_t at = caption.find(" degrees"); at != std::string::npos;
             at = caption.find(" degrees", at + 1)) {
            const std::size_t from = caption.rfind(' ', at - 1) + 1;
            const long said = std::stol(caption.substr(from, at - from));
            CAPTURE(said);
            CHECK(std::count(known.begin(), known.end(), said) > 0);
        }
    }
}

TEST_CASE("figure 4: without the limits s and r are removed anyway") {
    const Figure& figure = *findFigure(4);
    for (const CheckedExpectation& each : checkFigure(figure).without) {
        const bool isOfSphere = each.expected.address.find("sphere") != std::string_view::npos;
        if (isOfSphere) CHECK(each.expected.outcome == "removed");
    }
    CHECK(figure.absence.find("stay:") == std::string_view::npos);
}

TEST_CASE("figure 6: e's first is after it on the ring, e's last before it, as printed") {
    const Figure& figure = *findFigure(6);
    const auto pointCalled = [&](std::string_view name) {
        for (const PointName& each : figure.pointNames()) {
            if (each.name == name) return each.point;
        }
        return kNone;
    };
    std::optional<ReciprocalEvidence> test;
    Params params = paper();
    params.start = figure.scene.start();
    sweep(sceneNamed("figure-6"), params, [&](const SweptPivot& pivot) {
        for (const Event& event : pivot.events) {
            const auto* found = std::get_if<ReciprocalEvidence>(&event.evidence);
            if (found != nullptr && !test) test = *found;
        }
    });
    REQUIRE(test.has_value());
    CHECK(test->point == pointCalled("e"));
    CHECK(test->pred == pointCalled("elast"));
    CHECK(test->succ == pointCalled("efirst"));
}

namespace {

/// Whether the triangles that the first `pivots` pivots of a torus about z make hold a closed path
/// around the tube, and one around the hole.
struct Around {
    bool tube = false;
    bool hole = false;
    friend bool operator==(const Around&, const Around&) = default;
};

double turned(double from, double to) { return std::remainder(to - from, 2.0 * std::numbers::pi); }

/// True if some closed path along edges of the triangles goes around: the way from the root of its
/// tree to a point turns by another angle than along another edge.
bool goesAround(const std::vector<Triangle>& mesh, const std::vector<double>& angle) {
    std::vector<std::optional<double>> way(angle.size());
    if (mesh.empty()) return false;
    way[mesh.front().a] = 0.0;
    bool around = false;
    for (bool grows = true; grows;) {
        grows = false;
        for (const Triangle& t : mesh) {
            const Index corners[] = {t.a, t.b, t.c};
            for (int i = 0; i < 3; ++i) {
                const Index from = corners[i];
                const Index to = corners[(i + 1) % 3];
                const double step = turned(angle[from], angle[to]);
                if (way[from] && !way[to]) way[to] = *way[from] + step, grows = true;
                if (way[to] && !way[from]) way[from] = *way[to] - step, grows = true;
                if (way[from] && way[to]) around |= std::abs(*way[from] + step - *way[to]) > 1.0;
            }
        }
    }
    return around;
}

Around aroundAfter(const char* scene, std::uint32_t pivots) {
    const PointSet points = sceneNamed(scene);
    std::vector<Triangle> mesh;
    sweep(points, paper(), [&](const SweptPivot& pivot) {
        for (const Event& event : pivot.events) {
            const auto* emit = std::get_if<EmitEvidence>(&event.evidence);
            if (emit != nullptr && event.address.pivot <= pivots) mesh.push_back(emit->corners);
        }
    });
    std::vector<double> tube;
    std::vector<double> hole;
    for (const Vec3& x : points.position) {
        tube.push_back(std::atan2(x.z, std::hypot(x.x, x.y) - 1.0));
        hole.push_back(std::atan2(x.y, x.x));
    }
    return {goesAround(mesh, tube), goesAround(mesh, hole)};
}

}  // namespace

TEST_CASE("figure 12 and the lessons: rings split around the tube, and join around the hole") {
    CHECK(aroundAfter("figure-12", 34) == Around{false, false});
    CHECK(aroundAfter("figure-12", 35) == Around{true, false});
    CHECK(aroundAfter("figure-12", 73) == Around{true, false});
    CHECK(aroundAfter("figure-12", 74) == Around{true, true});
    CHECK(aroundAfter("torus", 199) == Around{false, false});
    CHECK(aroundAfter("torus", 200) == Around{true, false});
    CHECK(aroundAfter("torus", 559) == Around{true, false});
    CHECK(aroundAfter("torus", 560) == Around{true, true});
}

TEST_CASE(
    "figure 14: p and first are the whole ring, and the unmodified one joins the wall points") {
    const Figure& figure = *findFigure(14);
    const PointSet points = sceneNamed("figure-14");
    std::vector<Triangle> first;
    sweep(points, withoutRule(figure, paper()), [&](const SweptPivot& pivot) {
        for (const Event& event : pivot.events) {
            const auto* found = std::get_if<PivotEvidence>(&event.evidence);
            if (found != nullptr && event.address.pivot == 1) CHECK(found->first == found->last);
            const auto* emit = std::get_if<EmitEvidence>(&event.evidence);
            if (emit != nullptr && event.address.pivot == 1) first.push_back(emit->corners);
        }
    });
    REQUIRE_FALSE(first.empty());
    const Triangle& wrong = first.back();
    CHECK(isDegenerate(points, wrong));
    for (const Index corner : {wrong.a, wrong.b, wrong.c}) CHECK(isBoundary(points.type[corner]));
}

TEST_CASE("figure 17: the ring runs from a wall over the corner to the next wall") {
    const Figure& figure = *findFigure(17);
    const std::vector<PointName> names = figure.pointNames();
    REQUIRE(names.size() == 3);
    const Index p = names[0].point;
    const Index t = names[1].point;
    const Index q = names[2].point;
    const PointSet points = sceneNamed("figure-17");
    CHECK(points.type[p] == kPositiveX);
    CHECK(points.type[t] == withCornerBit(kPositiveX | kPositiveY));
    CHECK(points.type[q] == kPositiveY);
    std::vector<Index> next;  // The points after p on the ring, from where the figure is seen.
    sweep(points, paper(), [&](const SweptPivot& pivot) {
        const auto* at = std::get_if<PivotEvidence>(&pivot.events.front().evidence);
        if (at == nullptr) return;
        const bool begins = toString(pivot.events.front().address) == figure.scene.address;
        if (begins) CHECK(at->pivot == p);
        if (begins || next.size() == 1) next.push_back(at->last);
    });
    CHECK(next == std::vector<Index>{t, q});
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
