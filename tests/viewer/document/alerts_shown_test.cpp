#include "commands/commands.h"
#include "document/actions.h"
#include "document/alert_actions.h"
#include "document/ask_actions.h"
#include "headless_app.h"
#include "jobs/mesh_export.h"
#include "jobs/questions.h"
#include "layers/layer.h"
#include "panel_state/side_panels.h"
#include "point_files.h"
#include "run/model.h"
#include "run/strings.h"
#include "spiraling_edge/mesh/mesh_compare.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/proof.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <glm/geometric.hpp>
#include <utility>

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

/// A program without a window that opens a source like the command line.
struct AlertApp : HeadlessApp {
    AlertsShown alerts{context};

    explicit AlertApp(const std::string& source, const std::string& alert = {},
                      const std::string& goTo = {})
        : HeadlessApp("alerts") {
        Options options;
        options.input.source = source;
        options.alert = alert;
        options.goTo = goTo;
        document.begin(options);
        alerts.begin(options);
        arrive();
    }
    void arrive() {
        waitUntilDone();
        alerts.poll();
        session.waitUntilDone();
    }
    std::string place() const {
        return session.event() == nullptr ? "start" : toString(session.address());
    }
};

/// The change that prevents the alert that is shown, as W answers. Requires one.
FieldValue changeThatPrevents(AlertApp& app) {
    actions::askWhySelected(app.context);
    app.session.waitUntilDone();
    const Ledger* answer = app.session.questions().why();
    REQUIRE(answer != nullptr);
    REQUIRE(answer->preventedBy);
    return *answer->preventedBy;
}

/// A file whose mesh has a hole of four, in a folder of its own.
struct FailingFile {
    OwnFolder folder;
    std::filesystem::path path = folder / "failing.xyz";
    FailingFile() { writePoints(path, findScene("four-edge-hole")->build()); }
};

}  // namespace

TEST_CASE("Alerts are all failures of the run, by class, and known once the run is complete") {
    OpenSession open("scene:noise");
    const RunAlerts& alerts = open.session.alerts();
    REQUIRE(alerts.done());
    const auto all = failuresOfRun(open.session.model().points, open.session.model().params);
    REQUIRE(all.ok());
    REQUIRE(alerts.failures().size() == all.value().size());
    std::size_t next = 0;
    for (const AlertGroup& group : alerts.groups()) {
        CHECK(group.first == next);
        CHECK(group.count > 0);
        for (std::size_t i = 0; i < group.count; ++i)
            CHECK(alerts.failures()[next++].failure.kind == group.kind);
    }
    CHECK(next == alerts.failures().size());
    CHECK(open.session.alerts().takeNews());
    CHECK_FALSE(open.session.alerts().takeNews());
}

TEST_CASE("A search that was stopped has no results until it is resumed") {
    RunAlerts alerts;
    alerts.start();
    CHECK_FALSE(alerts.busy());
    alerts.open(sphereModel());
    alerts.start();
    alerts.stop();
    CHECK(alerts.stopped());
    alerts.start();
    CHECK_FALSE(alerts.busy());
    CHECK_FALSE(alerts.done());
    alerts.resume();
    alerts.waitUntilDone();
    CHECK(alerts.poll());
    CHECK(alerts.done());
}

TEST_CASE("An alert is named by its class and its number in it") {
    OpenSession open("scene:noise");
    const RunAlerts& alerts = open.session.alerts();
    REQUIRE(alerts.failures().size() > 2);
    for (std::size_t i = 0; i < alerts.failures().size(); ++i)
        CHECK(alertNamed(alerts, alertName(alerts, i)) == i);
    CHECK(alertNamed(alerts, alerts.groups()[0].kind->name) == 0U);
    CHECK(alertNamed(alerts, "first") == alerts.inOrder().front());
    for (const char* name :
         {"dragons", "slivers:x", "", "duplicate_triangles:0", "duplicate_triangles:999"})
        CHECK_FALSE(alertNamed(alerts, name));
}

TEST_CASE("A click goes to the moment, selects its subject, and each moment is in the run") {
    AlertApp app("scene:four-edge-hole");
    const RunAlerts& alerts = app.session.alerts();
    REQUIRE(alerts.done());
    for (std::size_t i = 0; i < alerts.failures().size(); ++i) {
        for (const AlertMoment moment : kAlertMoments) {
            showAlert(app.context, i, moment);
            app.session.waitUntilDone();
            CHECK(app.place() == toString(momentOf(alerts.failures()[i], moment).event.address));
            CHECK(app.session.alerts().chosen() == i);
            CHECK(app.session.selection() == subjectOf(alerts.failures()[i]));
            CHECK(app.ui.frame == FrameRequest::Fault);
        }
    }
}

TEST_CASE("The next place is the most severe one, then the next, always on the finished mesh") {
    AlertApp app("scene:uneven-density", {}, "0");
    const RunAlerts& alerts = app.session.alerts();
    REQUIRE(alerts.places().size() > 2);
    app.session.alerts().choose({});
    nextPlace(app.context, 1);
    CHECK(alerts.place() == 0U);
    const auto worst = alerts.alertsAt(0);
    REQUIRE_FALSE(worst.empty());
    CHECK(alerts.chosen() == worst.front());
    CHECK(app.session.selection() == subjectOf(alerts.failures()[worst.front()]));
    CHECK(app.ui.frame == FrameRequest::Fault);
    CHECK(app.ui.column.part == kAlertsPart);
    CHECK(app.session.messages().last() ==
          "Place 1 of " + std::to_string(alerts.places().size()) + ": " +
              describe(alerts.places()[0], alerts.found()->all) + ".");
    app.session.waitUntilDone();
    CHECK(app.session.atEnd());
    nextPlace(app.context, 1);
    CHECK(alerts.place() == 1U);
    nextPlace(app.context, -1);
    CHECK(alerts.place() == 0U);
    nextPlace(app.context, -1);
    CHECK(app.session.messages().last() == "This is the first place.");
    // A single fault leads on from its place.
    app.session.alerts().choose(alerts.alertsAt(1).front());
    CHECK_FALSE(alerts.place());
    nextPlace(app.context, 1);
    CHECK(alerts.place() == 2U);
    app.session.alerts().choosePlace(alerts.places().size() - 1);
    nextPlace(app.context, 1);
    CHECK(app.session.messages().last() == "This is the last place.");
    app.session.alerts().choose({});
    nextPlace(app.context, -1);
    CHECK(alerts.place() == alerts.places().size() - 1);
    OpenSession open("scene:sphere", "robust");
    CommandContext sound = app.context.of(open.session);
    REQUIRE(open.session.alerts().done());
    runCommand(*findCommand("step.alert.next"), sound);
    CHECK(open.session.messages().last() == "No faults found.");
}

TEST_CASE("A place is looked at straight, with all of its faults on half of the view") {
    AlertApp app("scene:uneven-density", {}, "0");
    const RunAlerts& search = app.session.alerts();
    REQUIRE(search.places().size() > 2);
    const Model& model = app.session.model();
    int seen = 0;
    for (std::size_t i = 0; i < search.places().size(); ++i) {
        showPlace(app.context, i);
        app.session.waitUntilDone();
        for (const float covered : {0.0F, 0.2F}) {
            app.ui.coveredBelow = covered;
            frameRequested(app.context, FrameRequest::Fault);
            glm::vec2 low(1.0F);
            glm::vec2 high(0.0F);
            for (const std::size_t fault : search.places()[i].faults) {
                for (const Index p : search.found()->all[fault].points) {
                    const CameraMatrices camera = app.camera.matrices(app.ui.viewAspect);
                    const glm::vec2 at(project(camera, model.place[p], glm::vec2(1.0F)));
                    low = glm::min(low, at);
                    high = glm::max(high, at);
                }
            }
            const float free = 1.0F - covered;
            const glm::vec2 size = (high - low) / glm::vec2(1.0F, free);
            // Of smaller ones the surroundings are shown.
            // The whole input is not shown smaller than by itself.
            CHECK((std::max(size.x, size.y) < 0.51F || app.camera.distance() > 3.0F));
            seen += std::max(size.x, size.y) > 0.49F ? 1 : 0;
            CHECK(glm::distance(0.5F * (low + high), glm::vec2(0.5F, 0.5F * free)) < 0.1F);
        }
    }
    CHECK(seen > 2);
}

TEST_CASE("Every alert of a class that is a fault is at one place, and no other is") {
    OpenSession open("scene:noise");
    const RunAlerts& alerts = open.session.alerts();
    std::vector<int> seen(alerts.failures().size(), 0);
    for (std::size_t place = 0; place < alerts.places().size(); ++place) {
        for (const std::size_t alert : alerts.alertsAt(place)) {
            ++seen[alert];
            CHECK(alerts.placeOf(alert) == place);
        }
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
        CHECK(seen[i] == (alerts.failures()[i].failure.kind->fault ? 1 : 0));
        if (seen[i] == 0) CHECK_FALSE(alerts.placeOf(i));
    }
}

TEST_CASE("The alert at a point, an edge or a triangle is the most severe fault it is part of") {
    OpenSession open("scene:uneven-density");
    const RunAlerts& alerts = open.session.alerts();
    std::size_t asked = 0;
    for (const RunFailure& each : alerts.failures()) {
        if (!each.failure.kind->fault) continue;
        const std::vector<Index>& points = each.failure.points;
        const Selection what = points.size() == 1 ? Selection::ofPoint(points[0])
                                                  : Selection::ofEdge(points[0], points[1]);
        const auto found = alertAt(alerts, what);
        REQUIRE(found);
        CHECK(alerts.failures()[*found].failure.kind->severity <= each.failure.kind->severity);
        ++asked;
    }
    CHECK(asked > 100);
    CHECK_FALSE(alertAt(alerts, Selection{}));
    std::vector<bool> faulty(open.session.model().points.size(), false);
    for (const MeshFailure& each : alerts.found()->all) {
        if (!each.kind->fault) continue;
        for (const Index p : each.points) faulty[p] = true;
    }
    for (Index p = 0; p < faulty.size(); ++p)
        CHECK(alertAt(alerts, Selection::ofPoint(p)).has_value() == faulty[p]);
}

TEST_CASE(
    "A file with faults opens on its finished mesh, if no position was named, and only once") {
    const FailingFile file;
    AlertApp app(file.path.string());
    const RunAlerts& alerts = app.session.alerts();
    REQUIRE_FALSE(alerts.places().empty());
    CHECK(app.session.atEnd());
    CHECK_FALSE(app.session.alerts().chosen());
    CHECK(app.alerts.takeOpened());
    const std::string places = placesText(alerts.found()->verdict);
    CHECK(endText(app.session) == places);
    app.session.moves().toStart();
    app.session.waitUntilDone();
    CHECK(endText(app.session) == "at end: " + places);
    app.session.moves().toEnd();
    app.session.waitUntilDone();
    // Re-run, with another rule or unchanged: the cursor stays at the end.
    app.document.reload();
    app.arrive();
    CHECK_FALSE(app.alerts.takeOpened());
}

TEST_CASE(
    "Fix runs again with the best settings tried, ends at the end, and says what became of the "
    "faults") {
    const FailingFile file;
    AlertApp app(file.path.string());
    const std::string before = verdictText(app.session.alerts());
    CHECK(before.find(" of ") != std::string::npos);
    const MeshVerdict alertsBefore = app.session.alerts().found()->verdict;
    app.session.moves().toEnd();
    app.session.waitUntilDone();
    const std::size_t trianglesBefore = app.session.shownTriangles().size();
    const std::size_t placesBefore = app.session.alerts().places().size();
    // Before all settings are tried it waits for them.
    const RunSpec& spec = app.session.input().spec();
    app.session.trials().open(app.session.input().file(), withFixesAsOptions(spec));
    CHECK(canFix(app.context));
    fixByTrials(app.context);
    CHECK(app.ui.verdict.fixing);
    app.session.waitUntilDone();
    REQUIRE(app.session.trials().best() != nullptr);
    const Trial best = *app.session.trials().best();
    app.alerts.poll();
    CHECK_FALSE(app.ui.verdict.fixing);
    app.arrive();
    const std::string after = verdictText(app.session.alerts());
    CHECK(app.session.atEnd());
    CHECK(faultCount(app.session.alerts().found()->verdict.totals) ==
          faultCount(best.verdict.totals));
    const std::string places = placesText(alertsBefore);
    CHECK(after == "the mesh is sound");
    CHECK(app.session.messages().last().find("The mesh now is sound; before, it had faults at " +
                                             places + ".") != std::string::npos);
    // The mesh of before is shown while the user looks back, with its faults.
    CHECK_FALSE(app.session.showsEarlierMesh());
    app.session.showBefore(true);
    CHECK(app.session.showsEarlierMesh());
    CHECK(app.session.shownTriangles().size() == trianglesBefore);
    REQUIRE(app.session.finishedFaults() != nullptr);
    CHECK(app.session.finishedFaults()->places.size() == placesBefore);
    app.session.showBefore(false);
    CHECK(app.session.finishedFaults() == app.session.alerts().found());
    // What the trials were about is gone.
    CHECK(app.session.trials().trials().tried.empty());
}

TEST_CASE("While the pointer is on Fix, the finished mesh shows the triangles that it changes") {
    const FailingFile file;
    AlertApp app(file.path.string());
    app.session.moves().toEnd();
    app.session.trials().open(app.session.input().file(),
                              withFixesAsOptions(app.session.input().spec()));
    CHECK(app.session.trials().change() == nullptr);
    app.session.trials().start();
    app.session.waitUntilDone();
    REQUIRE(app.session.trials().change() != nullptr);
    const MeshChange change = *app.session.trials().change();
    CHECK(change.before == app.session.shownTriangles().size());
    CHECK(change.made->size() > change.gone->size());
    CHECK(fixText(app.session.trials()) ==
          "Run again, to the end: " + wordsOf(app.session.trials().best()->change) + ". " +
              wordsOf(change)[0] + ", " + wordsOf(change)[1]);
    // Only there, and only at the end of the run.
    CHECK(shownChange(app.context) == nullptr);
    app.ui.verdict.pointedAt = true;
    REQUIRE(shownChange(app.context) == app.session.trials().change());
    LayerInput input{app.session.model(), app.session.picture(), paletteOf(Theme::Dark)};
    input.triangles = app.session.triangles();
    input.faults = app.session.alerts().found();
    DrawList faults;
    addTriangles(input, faults);
    CHECK(faults.tinted[0].triangles == nullptr);
    input.change = shownChange(app.context);
    DrawList list;
    addTriangles(input, list);
    CHECK(list.tinted[0].triangles == change.gone);
    CHECK(list.tinted[0].count == change.gone->size());
    CHECK(list.tinted[0].color == input.palette.rejected);
    CHECK(list.tinted[1].triangles == change.made);
    CHECK(list.tinted[1].count == change.made->size());
    CHECK(list.tinted[1].color == input.palette.used);
    CHECK(list.lines.size() == faults.lines.size() + change.edges.gone.size());
    CHECK(list.labels.size() == faults.labels.size());
    // Faulty triangles that stay are not filled as those that go.
    CHECK(std::none_of(list.faces.begin(), list.faces.end(),
                       [&](const Face& each) { return each.color == input.palette.rejected; }));
    app.session.moves().goTo({1, Stage::Pivot, 0});
    app.session.waitUntilDone();
    CHECK(shownChange(app.context) == nullptr);
    app.session.moves().toEnd();
    app.session.waitUntilDone();
    // Fix makes exactly that change.
    const TriangleSet gone(*change.gone);
    std::vector<Triangle> expected = *change.made;
    for (const Triangle& t : app.session.shownTriangles()) {
        if (gone.find(t) != Match::Same) expected.push_back(t);
    }
    fixByTrials(app.context);
    app.arrive();
    REQUIRE(app.session.atEnd());
    CHECK(compareMeshes(app.session.model().points.position, expected, app.session.shownTriangles())
              .same());
    CHECK(shownChange(app.context) == nullptr);
}

TEST_CASE("A mesh without a triangle is not called sound, and other settings are tried") {
    const HeadlessApp other("no-triangle");
    const std::filesystem::path path = other.folder / "two.xyz";
    std::ofstream(path) << "0 0 0 0 0 1\n1 0 0 0 0 1\n";
    AlertApp app(path.string());
    const RunAlerts& alerts = app.session.alerts();
    REQUIRE(alerts.done());
    CHECK(alerts.found()->verdict.triangles == 0);
    CHECK_FALSE(alerts.sound());
    CHECK(verdictText(alerts).find("the mesh is sound") == std::string::npos);
    CHECK(app.session.trials().trials().tried.size() > 1);
}

namespace {

void requireEqual(const MeshVerdict& verdict, const MeshVerdict& check) {
    CHECK(headlineOf(verdict) == headlineOf(check));
    for (const VerdictCount& count : verdictCounts()) {
        CAPTURE(count.name);
        CHECK(count.of(verdict) == count.of(check));
    }
}

}  // namespace

TEST_CASE(
    "The verdict counts what check counts of the saved mesh beside the points, also after Fix") {
    const HeadlessApp other("verdict-and-check");
    const std::filesystem::path path = other.folder / "points.xyz";
    // A patch that contradicts the rest, and others that are right.
    PointFile sphere = findScene("sphere")->build();
    for (std::size_t p = 0; p < sphere.position.size(); ++p) {
        if (sphere.position[p].x > 0.6) sphere.normal[p] *= -1.0;
    }
    writePoints(path, sphere);
    AlertApp app(path.string());
    const auto counted = [&] {
        const FinishedMesh mesh =
            finishMesh(app.session.model(), *app.session.input().file(), app.session.runEnd());
        REQUIRE(saveMesh(app.session.model(), mesh, {(other.folder / "mesh.ply").string()}).ok());
        const PointFile saved = readPoints(other.folder / "mesh.ply").value();
        const auto judge = judgeFor(readPoints(path).value()).value();
        PointSet points = judge->points;
        points.judge = judge;
        return judgeMesh(points, saved.faces).verdict;
    };
    const auto judged = [&] { return app.session.alerts().found()->verdict; };
    requireEqual(judged(), counted());
    app.session.moves().toEnd();
    app.session.trials().start();
    app.session.waitUntilDone();
    REQUIRE(app.session.trials().best() != nullptr);
    fixByTrials(app.context);
    app.arrive();
    requireEqual(judged(), counted());
}

TEST_CASE("Faults are colored on the finished mesh, and places numbered as F8 walks them") {
    OpenSession open("scene:noise");
    Session& session = open.session;
    session.moves().toEnd();
    session.waitUntilDone();
    LayerInput input{session.model(), session.picture(), paletteOf(Theme::Dark)};
    input.triangles = session.triangles();
    input.faults = session.alerts().found();
    REQUIRE(input.faults != nullptr);
    DrawList all;
    addTriangles(input, all);
    DrawList list;
    addFaults(input, list);
    std::size_t points = 0;
    for (const MeshFailure& each : input.faults->all) {
        if (each.kind->fault && each.triangles.empty()) points += each.points.size();
    }
    CHECK(list.sprites.size() == points);
    REQUIRE_FALSE(list.labels.empty());
    CHECK(list.labels.front().text == "1");
    CHECK(list.labels.front().position == session.model().toView(input.faults->places[0].center));
    input.faults = nullptr;
    DrawList none;
    addTriangles(input, none);
    CHECK(all.faces.size() == none.faces.size() + list.faces.size());
    CHECK(list.faces.size() > 10);
}

TEST_CASE("A named position, a correct input and a lesson are left unchanged") {
    const FailingFile file;
    CHECK(AlertApp(file.path.string(), {}, "0").place() == "start");
    CHECK(AlertApp(file.path.string(), {}, "7").session.record().pivot == 7);
    AlertApp sound("scene:sphere");
    CHECK(sound.place() == "start");
    CHECK(sound.ui.column.part.empty());
    AlertApp present("scene:torus");
    present.ui.layoutPreset = LayoutPreset::Present;
    present.document.open(file.path.string());
    present.arrive();
    CHECK(present.place() == "start");
}

TEST_CASE("--alert opens on any alert, at a position if one is named too, and fails otherwise") {
    AlertApp app("scene:noise", "duplicate_triangles:2");
    REQUIRE(app.session.alerts().chosen());
    CHECK(alertName(app.session.alerts(), *app.session.alerts().chosen()) ==
          "duplicate_triangles:2");
    CHECK(app.place() == "286.emit.2");
    AlertApp there("scene:noise", "duplicate_triangles:2", "5");
    CHECK(there.session.record().pivot == 5);
    CHECK(there.session.alerts().chosen());
    AlertApp none("scene:sphere", "slivers");
    REQUIRE_FALSE(none.alerts.status());
    // The number that it names is that of the class.
    AlertApp other("scene:stranded-point", "holes:1");
    REQUIRE_FALSE(other.alerts.status());
    CHECK(other.alerts.status().error().message.find("0 of this class and 6 in all") !=
          std::string::npos);
    AlertApp unknown("scene:sphere", "dragons:1");
    REQUIRE_FALSE(unknown.alerts.status());
    CHECK(unknown.alerts.status().error().message.find("no such class") != std::string::npos);
}

TEST_CASE("A scene that fails opens on the decision that is the cause, with its alert") {
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        AlertApp app(sceneSource(each.scene.id));
        CHECK(app.place() == each.address);
        REQUIRE(app.session.alerts().shown() != nullptr);
        CHECK(app.session.alerts().shown()->failure.kind->name == each.failure);
        CHECK(galleryScene(sceneSource(each.scene.id)) == &each);
    }
    CHECK(galleryScene("scene:sphere") == nullptr);
}

TEST_CASE("A scene opens at the decision that it demonstrates, in every layout") {
    for (const Scene& each : scenes()) {
        CAPTURE(each.id);
        const std::string expected = each.address.empty() ? "start" : std::string(each.address);
        CHECK(AlertApp(sceneSource(each.id)).place() == expected);
    }
    AlertApp app("scene:sphere");
    for (const LayoutPresetRow& row : layoutPresets()) {
        CAPTURE(row.name);
        app.ui.layoutPreset = row.id;
        app.document.open("scene:figure-8");
        app.arrive();
        CHECK(app.place() == findScene("figure-8")->address);
        CHECK(std::exchange(app.ui.frame, FrameRequest::None) == FrameRequest::Decision);
        app.document.open("scene:sphere");
        app.arrive();
    }
    // A named position takes precedence, and is framed as well.
    AlertApp named("scene:figure-8", {}, "3.sort.1");
    CHECK(named.place() == "3.sort.1");
    CHECK(named.ui.frame == FrameRequest::Decision);
    CHECK(AlertApp("scene:figure-8", {}, "0").place() == "start");
}

TEST_CASE("Failures of a decision are noticed at it, and drawn") {
    AlertApp app("scene:four-edge-hole", {}, "54.emit.1");
    REQUIRE_FALSE(app.session.noticedHere().empty());
    CHECK(app.session.noticedText().find(" Alert: Triangle 196 ") == 0);
    DrawList list;
    LayerInput input{app.session.model(), app.session.picture(), paletteOf(Theme::Dark)};
    input.triangles = app.session.triangles();
    input.noticed = app.session.noticedHere();
    addAlerts(input, list);
    CHECK(list.sheets.size() >= 2);
    REQUIRE_FALSE(list.labels.empty());
    CHECK(list.labels[0].text.starts_with("! "));
    // Before the decision there is no failure yet.
    app.session.showBefore(true);
    CHECK(app.session.noticedHere().empty());
    app.session.showBefore(false);
    app.session.moves().goTo({1, Stage::Pivot, 0});
    app.session.waitUntilDone();
    CHECK(app.session.noticedHere().empty());
}

TEST_CASE("Of several alerts at a decision one is said, and the number of the others") {
    std::size_t most = 0;
    for (const FailureScene& scene : failureScenes()) {
        if (most > 1) break;
        const std::string source = "scene:" + std::string(scene.scene.id);
        OpenSession open(source.c_str());
        for (const RunFailure& each : open.session.alerts().failures()) {
            open.session.moves().goTo(each.moments.created.event.address);
            open.session.waitUntilDone();
            const std::size_t count = open.session.noticedHere().size();
            const std::string text = open.session.noticedText();
            const std::string others = " +" + std::to_string(count - 1) + " more.";
            if (count > 1) CHECK(text.ends_with(others));
            CHECK(text.find("Alert", 3) == std::string::npos);
            most = std::max(most, count);
        }
    }
    CHECK(most > 1);
}

TEST_CASE("A hole that is chosen is outlined, at any place of the run") {
    AlertApp app("scene:four-edge-hole");
    const auto& failures = app.session.alerts().failures();
    const auto hole = std::find_if(failures.begin(), failures.end(), [](const RunFailure& each) {
        return isLoop(each.failure) && each.failure.kind->fault;
    });
    REQUIRE(hole != failures.end());
    for (const char* address : {"20", "54.emit.1"}) {
        app.session.moves().goToText(address);
        app.session.waitUntilDone();
        DrawList list;
        LayerInput input{app.session.model(), app.session.picture(), paletteOf(Theme::Dark)};
        input.alert = &*hole;
        addAlerts(input, list);
        for (const auto& edge : hole->failure.edges) {
            CHECK(std::any_of(list.lines.begin(), list.lines.end(), [&](const Line& line) {
                return line.from == input.at(edge[0]) && line.to == input.at(edge[1]);
            }));
        }
    }
}

TEST_CASE("Why of the fault that is shown is its own story, not that of a point near it") {
    AlertApp app("scene:four-edge-hole");
    const RunFailureSearch& found = *app.session.alerts().found();
    const Model& model = app.session.model();
    for (std::size_t i = 0; i < found.failures.size(); i += 1 + found.failures.size() / 6) {
        const RunFailure& failure = found.failures[i];
        CAPTURE(describe(failure.failure));
        showAlert(app.context, i, {});
        actions::askWhySelected(app.context);
        app.session.waitUntilDone();
        CHECK(app.session.selection() == subjectOf(failure));
        CHECK(app.ui.column.part == kLedgerPart);
        const Ledger* answer = app.session.questions().why();
        REQUIRE(answer != nullptr);
        CHECK(answer->answer ==
              provedWhy(model.points, model.params, failure, found.all).value().answer);
        const auto at = [&](const LedgerLine& moment) {
            return std::any_of(
                answer->lines.begin(), answer->lines.end(),
                [&](const LedgerLine& each) { return each.event.address == moment.event.address; });
        };
        if (isLostPoint(failure.failure)) continue;
        CHECK(at(failure.moments.touched));
        CHECK(at(failure.moments.decided));
        CHECK(at(failure.moments.created));
    }
}

TEST_CASE("The rule that prevents an alert is tried beside the run, and switched on by one click") {
    AlertApp app("scene:four-edge-hole");
    REQUIRE(app.session.alerts().chosen());
    const std::size_t before = app.session.alerts().failures().size();
    const MeshFailure failure = app.session.alerts().shown()->failure;
    const FieldValue change = changeThatPrevents(app);
    const RuleSetting* rule = ruleOf(change);
    REQUIRE(rule != nullptr);
    showBeside(app.context, change);
    CHECK(app.ui.layoutPreset == LayoutPreset::Compare);
    REQUIRE(app.compare.comparison().chosen());
    CHECK(app.compare.comparison().with().run.choices ==
          std::vector<RuleValue>{{std::string(rule->name), 1.0}});
    REQUIRE_FALSE(app.session.atEnd());
    const CameraPose camera = app.camera.pose();
    app.ui.frame = FrameRequest::None;  // That of the opening.
    runWith(app.context, change);
    app.arrive();
    // Its result is visible: the whole mesh, from the same camera.
    CHECK(app.session.atEnd());
    CHECK(app.camera.pose() == camera);
    CHECK(app.ui.frame == FrameRequest::None);
    CHECK(rule->isOn(app.session.model().params));
    CHECK(app.session.alerts().failures().size() < before);
    std::vector<MeshFailure> now;
    for (const RunFailure& each : app.session.alerts().failures()) now.push_back(each.failure);
    CHECK_FALSE(isStillThere(failure, now));
}

TEST_CASE("Where no rule prevents an alert, the preparation that does is tried in the same way") {
    AlertApp app("scene:wrong-lists");
    app.document.rerun(withSet(app.session.input().spec(), "robust"), Resume::End);
    app.arrive();
    REQUIRE_FALSE(app.session.alerts().sound());
    showPlace(app.context, 0);
    app.arrive();
    const FieldValue change = changeThatPrevents(app);
    CHECK(change.field->key == "neighbors");
    showBeside(app.context, change);
    CHECK(differenceText(app.session.input().spec(), app.compare.comparison().with().run) ==
          wordsOf(SpecChange{change}));
    runWith(app.context, change);
    app.arrive();
    CHECK(app.session.atEnd());
    CHECK(app.session.alerts().sound());
}

TEST_CASE("The title of a class is its name in words") {
    CHECK(titleOf(*findFailureClass("non_manifold_edges")) == "non-manifold edges");
    CHECK(titleOf(*findFailureClass("second_layers")) == "second layers");
}

TEST_CASE("A session keeps the chosen alert") {
    AlertApp app("scene:noise", "duplicate_triangles:2");
    app.document.saveAs((app.folder / "alert.sesession").string());
    app.session.alerts().choose({});
    app.document.open((app.folder / "alert.sesession").string());
    app.arrive();
    REQUIRE(app.session.alerts().chosen());
    CHECK(alertName(app.session.alerts(), *app.session.alerts().chosen()) ==
          "duplicate_triangles:2");
    CHECK(app.place() == "286.emit.2");
}

TEST_CASE("alerts: a note tells if a run is too large to be checked during stepping") {
    CHECK(watchNote(kMaxWatched, 0).empty());
    CHECK(watchNote(kMaxWatched + 1, 0).find(grouped(kMaxWatched) + " points") !=
          std::string::npos);
    CHECK(watchNote(20, kMaxNoticed - 1).empty());
    CHECK(watchNote(20, kMaxNoticed).find(grouped(kMaxNoticed) + " failures") != std::string::npos);
}

TEST_CASE("Alerts of a tangled run are the first of each class, with the number of all") {
    RunSpec spec{"sample:torus,n=400"};
    spec.neighbors = {WithinRadius{1e300}, true, 0, true};
    Session session;
    session.open(spec);
    session.waitUntilDone();
    REQUIRE(session.ready());
    const RunAlerts& alerts = session.alerts();
    REQUIRE(alerts.done());
    CHECK_FALSE(alerts.complete());
    std::size_t next = 0;
    for (const AlertGroup& group : alerts.groups()) {
        CHECK(group.first == next);
        CHECK(group.count == group.total.listed);
        next += group.count;
        CHECK(alerts.failures()[group.first].failure.kind == group.kind);
    }
    CHECK(next == alerts.failures().size());
}
