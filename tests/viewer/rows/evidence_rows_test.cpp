#include "rows/evidence_rows.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "open_session.h"
#include "run/selection.h"
#include "run/strings.h"

using namespace se;
using namespace se::view;

namespace {

/// Calls `look` with every event of the first pivots of a run, its picture and its rows.
template <typename Look>
void forEachEvent(const char* scene, const char* rules, std::uint32_t pivots, Look&& look) {
    LoadProgress progress;
    const auto model = test::loadModel(withSet({scene}, rules), progress);
    REQUIRE(model.ok());
    Timeline timeline(model.value()->points, model.value()->params);
    for (std::uint32_t pivot = 1; pivot <= pivots; ++pivot) {
        const auto record = timeline.record(pivot);
        for (std::size_t i = 0; i < record->events.size(); ++i) {
            const Event& event = record->events[i];
            const DecisionState picture = PivotReplay(record).after(i);
            CAPTURE(scene);
            CAPTURE(toString(event.address));
            look(*model.value(), picture, event, evidenceRows({*model.value(), picture, event}));
        }
        if (record->isLast) return;
    }
}

const EvidenceRow* rowOf(const std::vector<EvidenceRow>& rows, std::string_view name) {
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const EvidenceRow& row) { return row.name == name; });
    return found == rows.end() ? nullptr : &*found;
}

bool says(const std::vector<EvidenceRow>& rows, std::string_view name, std::string_view part) {
    const EvidenceRow* row = rowOf(rows, name);
    return row != nullptr && row->value.find(part) != std::string::npos;
}

/// "-0" that is no part of a number such as -0.5 or 1e-05.
bool hasMinusZero(const std::string& text) {
    for (std::size_t at = text.find("-0"); at != std::string::npos; at = text.find("-0", at + 1)) {
        const char next = at + 2 < text.size() ? text[at + 2] : ' ';
        const char before = at > 0 ? text[at - 1] : ' ';
        if (next != '.' && std::isdigit(next) == 0 && before != 'e') return true;
    }
    return false;
}

/// Rows required for every event of a stage.
const std::map<Stage, std::vector<std::string>>& wanted() {
    static const std::map<Stage, std::vector<std::string>> kWanted = {
        {Stage::Seed, {"start point", "its neighbor", "distance"}},
        {Stage::Strand, {"point", "why"}},
        {Stage::Skip, {"wall", "why"}},
        {Stage::Insert, {"rule", "wall of pivot", "third point"}},
        {Stage::Convex, {"angle", "corner at", "margin", "height", "next on ring"}},
        {Stage::Reciprocal, {"its sector", "pivot seen at", "margin"}},
        {Stage::Hole, {"off the plane", "pivot off it", "margin"}},
        {Stage::Sphere, {"decided by", "between", "gap", "margin"}},
        {Stage::TwoPoint, {"angle", "margin"}},
        {Stage::Emit, {"corners", "least angle", "area", "orientation", "off a normal", "margin"}},
        {Stage::Advance, {"next pivot"}},
        {Stage::Guard, {"against it", "dropped"}},
        {Stage::Fill, {"ear", "hole", "least angle", "angle at p", "margin"}},
        {Stage::Flip, {"edge before", "edge after", "least angle", "margin"}},
        {Stage::Reinsert, {"point", "put", "triangles", "least angle"}},
    };
    return kWanted;
}

void checkWanted(const Event& event, const std::vector<EvidenceRow>& rows) {
    const auto found = wanted().find(event.address.stage);
    if (found == wanted().end()) return;
    for (const std::string& name : found->second) {
        CAPTURE(name);
        CHECK(std::any_of(rows.begin(), rows.end(),
                          [&](const EvidenceRow& row) { return row.name.starts_with(name); }));
    }
}

}  // namespace

TEST_CASE("Inspect: every event has the rows required for its stage, in names that fit") {
    std::set<Stage> seen;
    for (const auto& [scene, rules] : {std::pair{"scene:sphere", "paper"},
                                       {"scene:small-torus", "paper"},
                                       {"scene:long-lists", "paper"},
                                       {"scene:figure-12", "paper"},
                                       {"scene:figure-14", "paper"},
                                       {"scene:coarse-torus", "robust"},
                                       {"scene:genus-2", "robust"}}) {
        forEachEvent(scene, rules, 3000,
                     [&](const Model&, const DecisionState&, const Event& event,
                         const std::vector<EvidenceRow>& rows) {
                         seen.insert(event.address.stage);
                         CHECK_FALSE(rows.empty());
                         checkWanted(event, rows);
                         for (const EvidenceRow& row : rows) {
                             CAPTURE(row.name);
                             CAPTURE(row.value);
                             CHECK(row.name.size() <= 18);
                             CHECK_FALSE(row.value.empty());
                             CHECK_FALSE(hasMinusZero(row.value));
                             CHECK(row.value.find("nan") == std::string::npos);
                             if (row.gauge) CHECK(std::isfinite(row.gauge->threshold));
                         }
                     });
    }
    for (const Stage stage :
         {Stage::Seed, Stage::Skip, Stage::Insert, Stage::Sort, Stage::Limits, Stage::Convex,
          Stage::Reciprocal, Stage::Hole, Stage::Sphere, Stage::TwoPoint, Stage::Emit, Stage::Ring,
          Stage::Split, Stage::Join, Stage::Advance, Stage::Done, Stage::Guard, Stage::Flip}) {
        CAPTURE(std::string(stageName(stage)));
        CHECK(seen.contains(stage));
    }
}

TEST_CASE("Inspect: a triangle's least angle, area and orientation are those of its corners") {
    int triangles = 0;
    forEachEvent(
        "scene:sphere", "paper", 30,
        [&](const Model& model, const DecisionState&, const Event& event,
            const std::vector<EvidenceRow>& rows) {
            const auto* emit = std::get_if<EmitEvidence>(&event.evidence);
            if (emit == nullptr) return;
            const PointSet& points = model.points;
            CHECK(says(rows, "least angle", degreesText(leastDegrees(points, emit->corners))));
            CHECK(says(rows, "area", numberText(triangleArea(points, emit->corners))));
            CHECK(says(rows, "orientation", "counterclockwise"));
            CHECK(rowOf(rows, "off a normal")->gauge->value < 90.0);
            ++triangles;
        });
    CHECK(triangles > 50);
}

TEST_CASE("Inspect: a convex corner is over 180 degrees, and the height is off p's plane") {
    int tests = 0;
    forEachEvent("scene:small-torus", "paper", 130,
                 [&](const Model& model, const DecisionState& picture, const Event& event,
                     const std::vector<EvidenceRow>& rows) {
                     const auto* drop = std::get_if<DropEvidence>(&event.evidence);
                     if (drop == nullptr || drop->verdict != Verdict::BeyondConvex) return;
                     const char* name =
                         drop->side == Side::Start ? "corner at start" : "corner at end";
                     REQUIRE(rowOf(rows, name) != nullptr);
                     CHECK(rowOf(rows, name)->gauge->threshold == 180.0);
                     const double height = heightOver(model.points, picture.pivot, drop->point);
                     CHECK(says(rows, "height", signedText(height)));
                     ++tests;
                 });
    CHECK(tests > 0);
}

TEST_CASE("Inspect: the cross product is shown where it was computed, and only there") {
    int at71 = 0;
    int at72 = 0;
    forEachEvent("scene:figure-14", "paper", 60,
                 [&](const Model&, const DecisionState&, const Event& event,
                     const std::vector<EvidenceRow>& rows) {
                     const auto* insert = std::get_if<InsertEvidence>(&event.evidence);
                     if (insert == nullptr) return;
                     const bool taken = !insert->corner && insert->third != kNone;
                     CHECK((rowOf(rows, "N \xC3\x97 v") != nullptr) == taken);
                     CHECK(says(rows, "cross product", "not computed") != taken);
                     insert->corner ? ++at72 : ++at71;
                     CHECK(sectionOf(event) == (insert->corner ? "7.2" : "7.1"));
                     if (!insert->corner) return;
                     CHECK(says(rows, "transition",
                                insert->verdict == Verdict::After ? "leaving" : "entering"));
                 });
    CHECK(at71 > 0);
    CHECK(at72 > 0);
}

TEST_CASE(
    "Inspect: of the conditions of Figure 4 the first that fails is the last that is tested") {
    int moved = 0;
    int failed = 0;
    forEachEvent("scene:figure-8", "paper", 60,
                 [&](const Model&, const DecisionState&, const Event& event,
                     const std::vector<EvidenceRow>& rows) {
                     const auto* limit = std::get_if<LimitEvidence>(&event.evidence);
                     if (limit == nullptr) return;
                     const auto count = [&](const char* answer) {
                         return std::count_if(rows.begin(), rows.end(), [&](const EvidenceRow& r) {
                             return r.value.starts_with(answer);
                         });
                     };
                     if (limit->verdict == Verdict::Moved) {
                         CHECK(count("yes") == 6);
                         CHECK(count("not tested") == 0);
                         ++moved;
                     } else {
                         CHECK(count("no: it stays") == 1);
                         CHECK(count("yes") + count("not tested") == 5);
                         ++failed;
                     }
                 });
    CHECK(moved > 0);
    CHECK(failed > 0);
}

TEST_CASE("Inspect: a complete component counts its triangles, points, loops and its time") {
    for (const auto& [scene, closed] : {std::pair{"scene:sphere", true}, {"scene:sheet", false}}) {
        CAPTURE(scene);
        test::OpenSession open(scene);
        const RunOverview& run = open.session.overview();
        REQUIRE_FALSE(run.shapes.empty());
        open.session.moves().goTo({run.shapes.back().pivot, Stage::Done, 0});
        open.session.waitUntilDone();
        const PivotRecord& record = open.session.record();
        const Event& event = record.events.back();
        REQUIRE(std::holds_alternative<ComponentEvidence>(event.evidence));
        const DecisionState picture = open.session.replay().after(record.events.size() - 1);
        const auto rows = evidenceRows({open.session.model(), picture, event, &run});
        CHECK(says(rows, "triangles", std::to_string(run.triangles.back())));
        CHECK(says(rows, "points", std::to_string(run.shapes.back().points)));
        CHECK(says(rows, "open loops", closed ? "none" : "1"));
        CHECK(says(rows, "time", "s of the run"));
        CHECK(says(rows, "next seed", "none"));
    }
}
