/// The table of all settings of the rules, and the effect of each.
#include "spiraling_edge/stepper/rule_settings.h"
#include "spiraling_edge/run/event_text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/spec/spec_fields.h"
#include "spiraling_edge/stepper/rules.h"
#include "support/clouds.h"
#include "support/open_surfaces.h"
#include "support/random_points.h"
#include "support/rig.h"
#include "support/rule_values.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

using Level = InvariantChecker::Level;

Params with(std::string_view text, std::string_view set = "paper") {
    Params params = *paramsByName(set);
    const auto value = ruleValueFromText(text);
    REQUIRE_MESSAGE(value.ok(), text);
    CHECK(applyRuleValues({&value.value(), 1}, params).ok());
    return params;
}

/// The number of events of a run that match.
template <typename Matches>
std::size_t count(const PointSet& points, const Params& params, const Matches& matches) {
    std::size_t found = 0;
    sweep(points, params, [&](const SweptPivot& pivot) {
        found += static_cast<std::size_t>(
            std::count_if(pivot.events.begin(), pivot.events.end(), matches));
    });
    return found;
}
auto at(Stage stage) {
    return [stage](const Event& event) { return event.address.stage == stage; };
}

PointSet closedPoints() { return prepared(closedFamilies(0.45)[1].sample(3)); }
PointSet boxedPoints() { return prepared(sampleSheet(wavySheet(), 8, 80, 2)); }

}  // namespace

TEST_CASE("settings have names of their own, a section, a sentence, and a usual value in range") {
    std::set<std::string_view> names;
    for (const RuleSetting& each : ruleSettings()) {
        names.insert(each.name);
        CHECK(findRuleSetting(each.name) == &each);
        CHECK_FALSE(each.section.empty());
        CHECK(each.summary.size() > 10);
        for (const std::string_view set : paramSetNames()) {
            CHECK_MESSAGE(isValue(each, each.get(*paramsByName(set))), each.name);
        }
        const bool isPaper = !each.paper.empty();
        const bool silent = each.name == "sameangle";
        CHECK_MESSAGE(isPaper != (each.beyondPaper || silent), each.name);
    }
    CHECK(names.size() == ruleSettings().size());
}

TEST_CASE("every value of a setting reads back from its text, and sets nothing else") {
    const Params usual;
    for (const RuleSetting& each : ruleSettings()) {
        for (const double value : valuesOf(each)) {
            const auto read = valueFromText(each, valueText(each, value));
            REQUIRE_MESSAGE(read.ok(), each.name);
            CHECK(read.value() == value);
            Params params = usual;
            each.set(params, value);
            CHECK_MESSAGE(each.get(params) == doctest::Approx(value), each.name);
            for (const RuleValue& differing : differingRules(params, usual)) {
                CHECK(differing.name == each.name);
            }
            each.set(params, each.get(usual));
            CHECK_MESSAGE(params == usual, each.name);
        }
        CHECK_FALSE(valueFromText(each, "").ok());
        CHECK_FALSE(valueFromText(each, "nonsense").ok());
        CHECK_FALSE(isValue(each, each.high + 1.0));
        CHECK_FALSE(isValue(each, each.low - 1.0));
    }
    CHECK_FALSE(ruleValueFromText("nosuchrule=on").ok());
    CHECK_FALSE(ruleValueFromText("hole").ok());
    CHECK_FALSE(ruleValueFromText("holesize=2.5").ok());
    CHECK(lineOf(ruleValueFromText("tie=farthest").value()) == "tie=farthest");
}

TEST_CASE("the angle of 6.3 is exact at 120 degrees, and a cosine elsewhere") {
    CHECK(with("maxgap=120").maxGapCosine == -0.5);
    CHECK(with("maxgap=120") == Params{});
    for (const double degrees : {90.0, 100.0, 133.3, 171.25, 180.0}) {
        Params params;
        findRuleSetting("maxgap")->set(params, degrees);
        CHECK(params.maxGapCosine ==
              doctest::Approx(std::cos(degrees * 3.14159265358979323846 / 180.0)).epsilon(1e-15));
    }
}

TEST_CASE("every run ends and keeps the invariants of any input, whatever is set") {
    const PointSet closed = closedPoints();
    const PointSet boxed = boxedPoints();
    for (const RuleSetting& each : ruleSettings()) {
        for (const double value : valuesOf(each)) {
            Params params;
            each.set(params, value);
            const std::string what = lineOf(RuleValue{std::string(each.name), value});
            CHECK_MESSAGE(firstBreach(closed, params, Level::AnyInput) == "", what);
            CHECK_MESSAGE(firstBreach(boxed, params, Level::AnyInput) == "", what);
            for (std::uint64_t seed = 1; seed <= 4; ++seed) {
                CHECK_MESSAGE(firstBreach(randomPoints(seed), params, Level::AnyInput) == "", what);
            }
        }
    }
}

TEST_CASE("what is off does not happen") {
    const PointSet points = closedPoints();
    const auto moved = [](const Event& event) {
        const auto* limit = std::get_if<LimitEvidence>(&event.evidence);
        return limit != nullptr && limit->verdict == Verdict::Moved;
    };
    CHECK(count(points, Params{}, moved) > 0);
    CHECK(count(points, with("limits=off"), moved) == 0);
    CHECK(count(points, Params{}, at(Stage::Sphere)) > 0);
    CHECK(count(points, with("sphere=off"), at(Stage::Sphere)) == 0);
    CHECK(count(points, Params{}, at(Stage::Reciprocal)) > 0);
    CHECK(count(points, with("reciprocal=off"), at(Stage::Reciprocal)) == 0);
    CHECK(count(points, with("convex=off"), at(Stage::Convex)) == 0);
    CHECK(count(points, with("holesize=0"), at(Stage::Hole)) == 0);
    const PointSet boxed = boxedPoints();
    CHECK(count(boxed, Params{}, at(Stage::Skip)) > 0);
    CHECK(count(boxed, with("walls=off"), at(Stage::Skip)) == 0);
    const auto inserted = [](bool corner) {
        return [corner](const Event& event) {
            const auto* insert = std::get_if<InsertEvidence>(&event.evidence);
            return insert != nullptr && insert->corner == corner;
        };
    };
    CHECK(count(boxed, Params{}, inserted(true)) > 0);
    CHECK(count(boxed, with("corners=off"), inserted(true)) == 0);
    CHECK(count(boxed, with("thirdpoint=off"), inserted(false)) == 0);
}

TEST_CASE("6.3 matters most: without it fans hold more points, and thin triangles") {
    const PointSet points = closedPoints();
    // Triangles with an angle below 15 degrees.
    const auto thin = [&](const Params& params) {
        const Run run = runAll(points, params);
        std::size_t found = 0;
        for (const Triangle& t : run.state.triangles) {
            for (const auto [a, b, c] :
                 {std::array{t.a, t.b, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b}}) {
                const Vec3 u = glm::normalize(points.position[b] - points.position[a]);
                const Vec3 v = glm::normalize(points.position[c] - points.position[a]);
                found += glm::dot(u, v) > std::cos(15.0 * 3.14159265358979323846 / 180.0) ? 1 : 0;
            }
        }
        return found;
    };
    const std::size_t usual = thin(Params{});
    CHECK(thin(with("sphere=off")) > 2 * usual);
    // A wider gap lets more be removed than the sphere keeps, never less.
    CHECK(thin(with("maxgap=180")) <= thin(with("sphere=off")));
}

TEST_CASE("convexity off: the reciprocal test drops the same points, the mesh is as it was") {
    for (const Family& family : closedFamilies(0.45)) {
        const PointSet points = prepared(family.sample(3));
        const Run usual = runAll(points, Params{});
        const Run without = runAll(points, with("convex=off"));
        CHECK_MESSAGE(without.mesh.boundaryEdges == usual.mesh.boundaryEdges, family.name);
    }
}

TEST_CASE("which ring goes on first has no effect on whether a surface closes") {
    for (const Family& family : closedFamilies(0.45)) {
        const PointSet points = prepared(family.sample(3));
        const Run usual = runAll(points, Params{});
        for (const char* rule :
             {"stack=first", "active=other", "active=longer", "active=shorter"}) {
            const Run other = runAll(points, with(rule));
            CHECK_MESSAGE(other.mesh.boundaryEdges == usual.mesh.boundaryEdges, family.name, rule);
        }
    }
}

TEST_CASE("the other sign of n makes the mirror image: triangles that turn the other way") {
    const PointSet points = closedPoints();
    const Run mirrored = runAll(points, with("turn=clockwise"));
    std::size_t against = 0;
    for (const Triangle& t : mirrored.state.triangles) {
        const Vec3 u = points.position[t.b] - points.position[t.a];
        const Vec3 v = points.position[t.c] - points.position[t.a];
        against += glm::dot(glm::cross(u, v), points.normal[t.a]) < 0 ? 1 : 0;
    }
    CHECK(against * 100 > mirrored.state.triangles.size() * 99);
    CHECK(mirrored.mesh.boundaryEdges == 0);
}

namespace {

/// The points and their walls seen in a mirror at x = 0.
PointSet mirrored(PointSet points) {
    for (Vec3& each : points.position) each.x = -each.x;
    for (Vec3& each : points.normal) each.x = -each.x;
    constexpr unsigned kBoth = kPositiveX | kNegativeX;
    for (std::uint8_t& type : points.type) {
        const bool onOne = (type & kBoth) != 0 && (type & kBoth) != kBoth;
        if (onOne) type = static_cast<std::uint8_t>(type ^ kBoth);
    }
    for (RimGap& gap : points.rim) std::swap(gap.from, gap.to);
    return points;
}

}  // namespace

TEST_CASE("the mirror image of an input, clockwise, is the mirror of the run, by all rules") {
    std::size_t runs = 0;
    const auto compare = [&](std::string_view name, const PointSet& points, Params params) {
        const State usual = runAll(points, params).state;
        params.paper.turn = TurnRule::Clockwise;
        // The mirror turns the corners of a triangle around, and so does the turn of the fan.
        const State turned = runAll(mirrored(points), params).state;
        CHECK_MESSAGE(turned.triangles == usual.triangles, name);
        CHECK_MESSAGE(turned.mesh() == usual.mesh(), name);
        ++runs;
    };
    for (const std::string_view set : paramSetNames()) {
        CAPTURE(set);
        const Params params = *paramsByName(set);
        for (const Scene& scene : scenes())
            compare(scene.id, prepared(scene.build()), withStartOf(scene, params));
        for (const std::uint64_t seed : {1UL, 2UL, 3UL, 4UL, 164UL})
            compare("random", randomPoints(seed), params);
        const PointSet patch = withRim(disc(8.2).file).points;
        REQUIRE(std::any_of(patch.type.begin(), patch.type.end(), isRimPoint));
        compare("a rim", patch, params);
        for (const char* name : {"points/fin90.ply", "points/nefertiti.ply", "points/oni.ply"}) {
            if (const auto file = kSanitized ? std::nullopt : sharedPoints(name))
                compare(name, prepared(*file), params);
        }
    }
    CHECK(runs > 140);
}

TEST_CASE("6.1 a tie keeps the nearest, the farthest or both") {
    // From point 0 with point 1 as reference, 3 and 4 lie in one direction.
    const auto sorted = [](TieRule tie) {
        Params params;
        params.paper.tie = tie;
        Rig rig({{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {-0.5, 0.5, 0}, {-1, 1, 0}}, params);
        rig.listAll().ring({0, 2, 1});
        REQUIRE(rig.runTo(Phase::Limits));
        return rig.candidates();
    };
    CHECK(sorted(TieRule::Nearest) == std::vector<Index>{3});
    CHECK(sorted(TieRule::Farthest) == std::vector<Index>{4});
    CHECK(sorted(TieRule::Both) == std::vector<Index>{3, 4});
}

TEST_CASE(
    "the limits of the rules beyond the paper are settings, with the values of docs/robust.md") {
    const Params robust = *paramsByName("robust");
    for (const char* usual :
         {"foldangle=150", "steepangle=60", "rimgap=120", "rimangle=120", "openingwidth=2.5",
          "flatangle=45", "flipflat=0.9", "flipnarrow=0.94"}) {
        CHECK_MESSAGE(with(usual, "robust") == robust, usual);
    }
    CHECK(with("foldangle=150").thresholds.foldCosine == -0.8660254037844386);
    CHECK(with("flatangle=45").thresholds.flatCosine == 0.70710678118654752);
    CHECK(with("steepangle=60").thresholds.steepCosine == 0.5);
    CHECK(with("rimgap=120").thresholds.rimGapCosine == -0.5);
}

TEST_CASE(
    "a rule beyond the paper objects more where its limit is narrower, never where it has none") {
    const auto objections = [](const PointSet& points, const char* rule, Verdict verdict) {
        return count(points, with(rule, "robust"), [verdict](const Event& event) {
            const auto* guard = std::get_if<GuardEvidence>(&event.evidence);
            return guard != nullptr && guard->verdict == verdict;
        });
    };
    const PointSet closed = closedPoints();
    const std::size_t usual = objections(closed, "steepangle=60", Verdict::Steep);
    CHECK(objections(closed, "steepangle=20", Verdict::Steep) > usual);
    CHECK(objections(closed, "steepangle=180", Verdict::Steep) == 0);
    const PointSet random = randomPoints(5);
    CHECK(objections(random, "foldangle=150", Verdict::FoldsOver) > 0);
    CHECK(objections(random, "foldangle=180", Verdict::FoldsOver) == 0);
    const auto ends = [&](const char* rule) {
        std::size_t found = 0;
        for (Index p = 0; p < random.size(); ++p)
            found += isRim(random, p, with(rule).thresholds.rimGapCosine) ? 1 : 0;
        return found;
    };
    CHECK(ends("rimgap=60") > ends("rimgap=120"));
    CHECK(ends("rimgap=120") > ends("rimgap=180"));
}

TEST_CASE("the robust rules keep the mesh a manifold, whatever their limits") {
    const PointSet closed = closedPoints();
    const PointSet boxed = boxedPoints();
    for (const RuleSetting& each : ruleSettings()) {
        if (!each.beyondPaper || each.kind != SettingKind::Number) continue;
        for (const double value : valuesOf(each)) {
            Params params = *paramsByName("robust");
            each.set(params, value);
            const std::string what = lineOf(RuleValue{std::string(each.name), value});
            CHECK_MESSAGE(firstBreach(closed, params, Level::Guarded) == "", what);
            CHECK_MESSAGE(firstBreach(boxed, params, Level::Guarded) == "", what);
        }
    }
}

TEST_CASE("sentences state what the rule in force did") {
    const PointSet points = closedPoints();
    const PointSet uneven = prepared(findScene("long-lists")->build());
    const auto saysOf = [&](const PointSet& on, const char* rule, std::string_view words) {
        return count(on, with(rule), [&](const Event& event) {
            return describe(event).find(words) != std::string::npos;
        });
    };
    const auto says = [&](const char* rule, std::string_view words) {
        return saysOf(points, rule, words);
    };
    CHECK(saysOf(uneven, "holesize=3", "Hole of three") > 0);
    CHECK(saysOf(uneven, "holesize=3", "Hole of four") == 0);
    CHECK(saysOf(uneven, "holesize=4", "Hole of four") > 0);
    CHECK(says("concave=on", "no obstacle now") == 0);
    CHECK(says("concave=off", "no obstacle now") > 0);
    CHECK(says("freesector=on", "its free sector") > 0);
    CHECK(says("freesector=off", "its free sector") == 0);
    CHECK(says("freesector=off", "the sector from efirst to elast") > 0);
    const auto tied = [](TieRule tie) {
        Params params;
        params.paper.tie = tie;
        Rig rig({{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {-0.5, 0.5, 0}, {-1, 1, 0}}, params);
        rig.listAll().ring({0, 2, 1});
        REQUIRE(rig.runTo(Phase::Limits));
        for (const auto& e : rig.all<SortEvidence>()) {
            if (e.verdict == Verdict::SameAngle) return describe({{1, Stage::Sort, 1}, e});
        }
        return std::string{};
    };
    CHECK(tied(TieRule::Nearest).find("as 3, which is nearer: dropped.") != std::string::npos);
    CHECK(tied(TieRule::Farthest).find("as 4, which is farther: dropped.") != std::string::npos);
}

TEST_CASE("A rule that is gone is accepted by its old name, and changes nothing") {
    RunSpec spec;
    spec.rules = "robust";
    const RunSpec before = spec;
    const auto fields = specFields();
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [](const SpecField& f) { return f.type == SpecType::Rule; });
    REQUIRE(field != fields.end());
    for (const char* text : {"reseat=on", "reseat=off"}) {
        CHECK(isFormerRule(text));
        CHECK(setField(*field, spec, text).ok());
        CHECK(spec == before);
    }
    CHECK_FALSE(isFormerRule("remesh=off"));
    CHECK_FALSE(setField(*field, spec, "reseats=off").ok());
}
