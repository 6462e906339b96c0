/// Changes of rules during a look at a run: cursor position, undo, session file.
#include "spiraling_edge/spec/spec_fields.h"

#include <doctest/doctest.h>

#include "headless_app.h"
#include "open_session.h"
#include "panel_state/what_if_offers.h"
#include "rows/rule_rows.h"

using namespace se;
using namespace se::view;
using test::HeadlessApp;
using test::OpenSession;

namespace {

/// Re-runs as a panel does, up to the end.
void ask(HeadlessApp& app, const RunSpec& rules) {
    app.document.rerun(rules);
    app.waitUntilDone();
}

std::uint64_t hashAtEnd(const Session& session) {
    Stepper stepper(session.model().points, session.model().params);
    stepper.run();
    return stateHash(stepper.state());
}

WhatIf offeredAt(Session& session, const char* address) {
    REQUIRE(session.moves().goToText(address).ok());
    session.waitUntilDone();
    REQUIRE(session.event() != nullptr);
    const auto offers = offersAt(*session.event(), session.picture().pivot);
    REQUIRE(offers.size() == 1);
    return offers[0].what;
}

/// The first test of a run with that outcome.
std::string firstAddress(const Session& session, Verdict verdict) {
    EventLog log;
    Stepper stepper(session.model().points, session.model().params, &log);
    while (stepper.stepPivot()) {
        for (const Event& event : log.events()) {
            const auto* sphere = std::get_if<SphereEvidence>(&event.evidence);
            if (sphere != nullptr && sphere->verdict == verdict) return toString(event.address);
        }
        log.clear();
    }
    return "none";
}

}  // namespace

TEST_CASE("A rule with the value of its set is no choice") {
    RunSpec rules;
    rules = withRule(rules, "maxgap", 100.0);
    rules = withRule(rules, "tie", 1.0);
    CHECK(rules.choices == std::vector<RuleValue>{{"tie", 1.0}, {"maxgap", 100.0}});
    CHECK(valueOf(rules, *findRuleSetting("maxgap")) == 100.0);
    CHECK(usualValueOf(rules, *findRuleSetting("maxgap")) == 120.0);
    CHECK(differingCount(rules) == 2);
    rules = withRule(rules, "tie", 0.0);
    CHECK(rules.choices == std::vector<RuleValue>{{"maxgap", 100.0}});
    CHECK(differenceText({}, rules) == "maxgap 100");
    CHECK(withRule(withSet({}, "robust"), "fill", 1.0).choices.empty());
    CHECK(withRule(withSet({}, "robust"), "fill", 0.0).choices.size() == 1);
}

TEST_CASE("The rows have all rules by section, words of name, section and sentence find them") {
    std::size_t count = 0;
    for (const RuleGroup& group : ruleGroups({}, "")) count += group.rows.size();
    CHECK(count == ruleSettings().size());
    const auto found = [](const RunSpec& rules, const char* filter) {
        std::string names;
        for (const RuleGroup& group : ruleGroups(rules, filter)) {
            for (const RuleRow& row : group.rows) names += std::string(row.setting->name) + " ";
        }
        return names;
    };
    CHECK(found({}, "120 DEGREES s and t").find("maxgap") != std::string::npos);
    CHECK(found({}, "7.2") == "corners bothwalls ");
    CHECK(found({}, "no such word") == "");
    CHECK(found({}, "differs") == "");
    CHECK(found(withRule({}, "walls", 0.0), "differs") == "walls ");
    for (const RuleGroup& group : ruleGroups({}, "")) {
        for (const RuleRow& row : group.rows) {
            CHECK(ruleHelp(row).find("--rule " + std::string(row.setting->name)) !=
                  std::string::npos);
        }
    }
}

TEST_CASE("The help of a rule says whether the sentence that it quotes is in force") {
    const auto help = [](const RunSpec& rules, std::string_view name) {
        return ruleHelp(ruleGroups(rules, name).front().rows.front());
    };
    RunSpec printed;
    printed.rules = "printed";
    CHECK(help({}, "instance").find("Not in force; --rule instance=first sets it.") !=
          std::string::npos);
    CHECK(help(printed, "instance").find("is in force.") != std::string::npos);
    CHECK(help({}, "twopoint").find("is in force.") != std::string::npos);
    CHECK(help({}, "sameangle").find("in force") == std::string::npos);
}

TEST_CASE("A rule without effect before the cursor leaves it at the same test") {
    OpenSession open;
    REQUIRE(open.session.moves().goToText("30.sphere.1").ok());
    REQUIRE(open.place() == "30.sphere.1");
    open.session.select(5);
    // No two-point ring of over 180 degrees comes so early on a sphere.
    open.session.rerun(withRule(open.session.input().rules(), "cap", 9.0));
    CHECK(open.session.input().isRerunning());
    CHECK(open.place() == "30.sphere.1");
    CHECK_FALSE(open.session.input().isRerunning());
    CHECK(open.session.model().params.maxTrianglesPerPoint == 9);
    CHECK(open.session.messages().last() ==
          "This is the same decision; the runs do not differ before it.");
    CHECK(open.session.selected() == 5);
}

TEST_CASE("Where the runs diverge the cursor stays at the same pivot of the same component") {
    OpenSession open("scene:torus");
    for (const std::uint32_t pivot : {40U, 90U, 200U}) {
        open.session.rerun({});
        open.session.waitUntilDone();
        open.session.moves().goToPivot(pivot);
        open.session.waitUntilDone();
        const Index point = open.session.picture().pivot;
        open.session.rerun(withRule({}, "maxgap", 100.0));
        open.session.waitUntilDone();
        CHECK_FALSE(open.session.messages().last().empty());
        const std::string& said = open.session.messages().last();
        const bool same = said.starts_with("Same pivot") || said.starts_with("This is the same");
        if (same) CHECK(open.session.picture().pivot == point);
        if (!same)
            CHECK(open.session.messages().last().find("last shared state") != std::string::npos);
    }
}

TEST_CASE("At the start and at the end of a run the cursor stays there") {
    OpenSession open;
    open.session.rerun(withRule({}, "maxgap", 90.0));
    CHECK(open.place() == "start");
    open.session.moves().toEnd();
    open.session.waitUntilDone();
    REQUIRE(open.session.atEnd());
    open.session.rerun({});
    open.session.waitUntilDone();
    CHECK(open.session.atEnd());
    CHECK(open.session.messages().last() == "The new run is at its end.");
}

TEST_CASE("Rules are undone and redone, and kept in the session file") {
    HeadlessApp app("rules");
    app.document.open("scene:sphere");
    app.waitUntilDone();
    UndoStack undo;
    undo.begin(captureEdits(app.context));
    ask(app, withRule(app.session.input().rules(), "tie", 1.0));
    CHECK(app.session.model().params.paper.tie == TieRule::Farthest);
    undo.observe(captureEdits(app.context), 10.0, false);
    const auto step = undo.undo(captureEdits(app.context));
    REQUIRE(step.has_value());
    CHECK(step->change == "rule tie");
    applyEdits(step->edits, app.context);
    app.waitUntilDone();
    CHECK(app.session.model().params == Params{});
    ask(app, withRule(withRule({}, "maxgap", 100.0), "walls", 0.0));
    const std::string path = (app.folder / "a.sesession").string();
    app.document.saveAs(path);
    ask(app, {});
    app.openInstead(path);
    const RunSpec rules = withRule(withRule({}, "maxgap", 100.0), "walls", 0.0);
    CHECK(withRulesOf(rules, app.session.input().spec()) == rules);
}

TEST_CASE("A fork at a test, and the way back to the same run") {
    HeadlessApp app("forks");
    app.document.open("scene:sphere");
    app.waitUntilDone();
    Session& session = app.session;
    const std::uint64_t before = hashAtEnd(session);
    const std::string address = firstAddress(session, Verdict::Removed);
    const WhatIf what = offeredAt(session, address.c_str());
    CHECK(what.kind == WhatIfKind::Keep);
    ask(app, withWhatIf(session.input().rules(), what));
    CHECK(session.input().spec().whatIf == std::vector<WhatIf>{what});
    CHECK(session.input().whatIfProblem(0).empty());
    CHECK(toString(session.address()) == address);
    const auto* sphere = std::get_if<SphereEvidence>(&session.event()->evidence);
    REQUIRE(sphere != nullptr);
    CHECK(sphere->verdict == Verdict::WhatIfKept);
    CHECK(hashAtEnd(session) != before);
    const std::string path = (app.folder / "fork.sesession").string();
    app.document.saveAs(path);
    RunSpec fewer = session.input().rules();
    fewer.whatIf.erase(fewer.whatIf.begin());
    ask(app, fewer);
    CHECK(session.input().spec().whatIf.empty());
    CHECK(hashAtEnd(session) == before);
    CHECK(toString(session.address()) == address);
    app.openInstead(path);
    CHECK(session.input().spec().whatIf == std::vector<WhatIf>{what});
    CHECK(toString(session.address()) == address);
}

TEST_CASE("A fork that would break an invariant is refused without any change") {
    OpenSession open;
    open.session.moves().goToPivot(20);
    open.session.waitUntilDone();
    const std::string place = open.place();
    const std::uint32_t generation = open.session.generation();
    open.session.rerun(withWhatIf({}, whatIfFromText("5 list 7 7").value()));
    open.session.waitUntilDone();
    CHECK(open.session.input().phase() == SessionPhase::Ready);
    CHECK(open.session.generation() == generation);
    CHECK(open.place() == place);
    CHECK(open.session.messages().last().find("refused") != std::string::npos);
    CHECK(open.session.input().spec().whatIf.empty());
}

TEST_CASE("A moved point is drawn at its new position from its pivot on, and not before") {
    OpenSession open;
    WhatIfForm form;
    form.take(open.session, 20);
    const Vec3 old = open.session.model().points.position[20];
    form.to[0] = "0.25";
    const auto what = form.move(10);
    REQUIRE(what.ok());
    CHECK(what.value().to == Vec3(0.25, old.y, old.z));
    open.session.rerun(withWhatIf({}, what.value()));
    open.session.waitUntilDone();
    const glm::vec3 before = open.session.shown().place[20];
    CHECK(before == open.session.model().place[20]);
    open.session.moves().goToPivot(10);
    open.session.waitUntilDone();
    CHECK(open.session.shown().place[20] != before);
    CHECK(open.session.shown().points.position[20].x == 0.25);
    open.session.moves().goToPivot(9);
    open.session.waitUntilDone();
    CHECK(open.session.shown().place[20] == before);
    // The run begins with the points of the input.
    CHECK(open.session.model().points.position[20] == old);
    form.to[1] = "far away";
    CHECK_FALSE(form.move(10).ok());
}

TEST_CASE("Every what-if offered at a test has its effect in the run") {
    OpenSession open("scene:torus");
    std::size_t offered = 0;
    for (std::uint32_t pivot = 3; pivot < 40; pivot += 4) {
        open.session.moves().goToPivot(pivot);
        open.session.waitUntilDone();
        const std::vector<Event> events = open.session.record().events;
        for (const Event& event : events) {
            for (const WhatIfOffer& each : offersAt(event, open.session.picture().pivot)) {
                CHECK(whatIfFromText(lineOf(each.what)).value() == each.what);
                CHECK_FALSE(each.label.empty());
                ++offered;
            }
        }
    }
    CHECK(offered > 50);
}
