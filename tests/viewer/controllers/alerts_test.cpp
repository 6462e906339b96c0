#include "controllers/alerts.h"
#include "commands/alert_actions.h"
#include "headless_app.h"
#include "layers/layer.h"
#include "run/gallery.h"
#include "run/strings.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

/// A program without a window that opens a source like the command line.
struct AlertDesk : Desk {
    Alerting alerting{context, filing};

    explicit AlertDesk(const std::string& source, const std::string& alert = {},
                       const std::string& goTo = {})
        : Desk("alerts") {
        Options options;
        options.input.source = source;
        options.alert = alert;
        options.goTo = goTo;
        filing.begin(options);
        alerting.begin(options);
        arrive();
    }
    void arrive() {
        settle();
        alerting.poll();
        session.settle();
    }
    std::string place() const {
        return session.event() == nullptr ? "start" : toString(session.address());
    }
};

/// A file with a hole: the sphere scene without a few points around a pole, read with short lists.
std::string holedFile(const std::filesystem::path& path) {
    const PointFile sphere = findScene("four-edge-hole")->build();
    std::FILE* out = std::fopen(path.c_str(), "w");
    for (std::size_t p = 0; p < sphere.position.size(); ++p) {
        const Vec3& x = sphere.position[p];
        const Vec3& n = sphere.normal[p];
        std::fprintf(out, "%.17g %.17g %.17g %.17g %.17g %.17g\n", x.x, x.y, x.z, n.x, n.y, n.z);
    }
    std::fclose(out);
    return path.string();
}

struct FailingFile {
    std::filesystem::path path = ownPlace("failing.xyz");
    FailingFile() { holedFile(path); }
    ~FailingFile() {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
    FailingFile(const FailingFile&) = delete;
    FailingFile& operator=(const FailingFile&) = delete;
};

}  // namespace

TEST_CASE("Alerts are all failures of the run, by class, and known once the run is complete") {
    OpenSession open("scene:noise");
    const AlertSearch& alerts = open.session.alerts();
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
    CHECK(open.session.takeAlertNews());
    CHECK_FALSE(open.session.takeAlertNews());
}

TEST_CASE("A search that was stopped has no results until it is resumed") {
    AlertSearch alerts;
    alerts.begin();
    CHECK_FALSE(alerts.busy());
    alerts.wait(sphereModel());
    alerts.begin();
    alerts.stop();
    CHECK(alerts.stopped());
    alerts.begin();
    CHECK_FALSE(alerts.busy());
    CHECK_FALSE(alerts.done());
    alerts.resume();
    alerts.finish();
    CHECK(alerts.poll());
    CHECK(alerts.done());
}

TEST_CASE("An alert is named by its class and its number in it") {
    OpenSession open("scene:noise");
    const AlertSearch& alerts = open.session.alerts();
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
    AlertDesk desk("scene:four-edge-hole");
    const AlertSearch& alerts = desk.session.alerts();
    REQUIRE(alerts.done());
    for (std::size_t i = 0; i < alerts.failures().size(); ++i) {
        for (const AlertMoment moment : kAlertMoments) {
            showAlert(desk.context, i, moment);
            desk.session.settle();
            CHECK(desk.place() == toString(momentOf(alerts.failures()[i], moment).event.address));
            CHECK(desk.session.chosenAlert() == i);
            CHECK(desk.session.selection() == subjectOf(alerts.failures()[i]));
            CHECK(desk.ui.requests.frameAlert);
        }
    }
}

TEST_CASE("The next alert is the next in the order of the run, from the cursor or the last one") {
    AlertDesk desk("scene:noise", {}, "0");
    const AlertSearch& alerts = desk.session.alerts();
    REQUIRE(alerts.failures().size() > 2);
    desk.session.chooseAlert({});
    nextAlert(desk.context, 1);
    CHECK(desk.session.chosenAlert() == alerts.inOrder()[0]);
    nextAlert(desk.context, 1);
    CHECK(desk.session.chosenAlert() == alerts.inOrder()[1]);
    nextAlert(desk.context, -1);
    CHECK(desk.session.chosenAlert() == alerts.inOrder()[0]);
    nextAlert(desk.context, -1);
    CHECK(desk.session.message() == "There is no alert before this one.");
    desk.session.settle();
    desk.session.chooseAlert({});
    desk.session.toEnd();
    desk.session.settle();
    nextAlert(desk.context, 1);
    CHECK(desk.session.message() == "There is no alert after this one.");
    OpenSession open("scene:sphere", "robust");
    CommandContext sound{open.session, desk.playback, desk.camera, desk.ui};
    REQUIRE(open.session.alerts().done());
    REQUIRE(open.session.alerts().failures().empty());
    nextAlert(sound, 1);
    CHECK(open.session.message() == "No failures found.");
}

TEST_CASE("An input opens on its first alert, if no position was named, and only once") {
    const FailingFile file;
    AlertDesk desk(file.path.string());
    const AlertSearch& alerts = desk.session.alerts();
    REQUIRE_FALSE(alerts.failures().empty());
    const std::size_t first = alerts.inOrder().front();
    CHECK(desk.session.chosenAlert() == first);
    CHECK(desk.place() == toString(alerts.failures()[first].moments.created.event.address));
    CHECK(desk.ui.wantedTab == kAlertsTab);
    CHECK(desk.alerting.takeOpened());
    // Re-run, with another rule or unchanged: the cursor stays at the start.
    desk.ui.requests.reload = true;
    desk.filing.carryOut(desk.ui.requests);
    desk.arrive();
    CHECK(desk.place() == "start");
    CHECK_FALSE(desk.session.chosenAlert());
}

TEST_CASE("A named position, a correct input and a lesson are left unchanged") {
    const FailingFile file;
    CHECK(AlertDesk(file.path.string(), {}, "0").place() == "start");
    CHECK(AlertDesk(file.path.string(), {}, "7").session.record().pivot == 7);
    AlertDesk sound("scene:sphere");
    CHECK(sound.place() == "start");
    CHECK(sound.ui.wantedTab.empty());
    AlertDesk learn("scene:torus");
    learn.ui.arrangement = Arrangement::Learn;
    learn.filing.open(file.path.string());
    learn.arrive();
    CHECK(learn.place() == "start");
}

TEST_CASE("--alert opens on any alert, at a position if one is named too, and fails otherwise") {
    AlertDesk desk("scene:noise", "duplicate_triangles:2");
    REQUIRE(desk.session.chosenAlert());
    CHECK(alertName(desk.session.alerts(), *desk.session.chosenAlert()) == "duplicate_triangles:2");
    CHECK(desk.place() == "285.emit.2");
    AlertDesk there("scene:noise", "duplicate_triangles:2", "5");
    CHECK(there.session.record().pivot == 5);
    CHECK(there.session.chosenAlert());
    AlertDesk none("scene:sphere", "slivers");
    REQUIRE_FALSE(none.alerting.status());
    // The number that it names is that of the class.
    AlertDesk other("scene:stranded-point", "holes:1");
    REQUIRE_FALSE(other.alerting.status());
    CHECK(other.alerting.status().error().message.find("0 of this class and 3 in all") !=
          std::string::npos);
    AlertDesk unknown("scene:sphere", "dragons:1");
    REQUIRE_FALSE(unknown.alerting.status());
    CHECK(unknown.alerting.status().error().message.find("no such class") != std::string::npos);
}

TEST_CASE("A scene that fails opens on the decision that is the cause, with its alert") {
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        AlertDesk desk(sceneSource(each.scene.id));
        CHECK(desk.place() == each.address);
        REQUIRE(desk.session.alert() != nullptr);
        CHECK(desk.session.alert()->failure.kind->name == each.failure);
        CHECK(galleryScene(sceneSource(each.scene.id)) == &each);
    }
    CHECK(galleryScene("scene:sphere") == nullptr);
}

TEST_CASE("A scene opens at the decision that it demonstrates, in every layout") {
    for (const Scene& each : scenes()) {
        CAPTURE(each.id);
        const std::string expected = each.address.empty() ? "start" : std::string(each.address);
        CHECK(AlertDesk(sceneSource(each.id)).place() == expected);
    }
    AlertDesk desk("scene:sphere");
    for (const ArrangementRow& row : arrangements()) {
        CAPTURE(row.name);
        desk.ui.arrangement = row.id;
        desk.filing.open("scene:figure-4");
        desk.arrive();
        CHECK(desk.place() == findScene("figure-4")->address);
        CHECK(desk.filing.takeFocus());
        desk.filing.open("scene:sphere");
        desk.arrive();
    }
    // A named position takes precedence.
    AlertDesk named("scene:figure-4", {}, "3.sort.1");
    CHECK(named.place() == "3.sort.1");
    CHECK_FALSE(named.filing.takeFocus());
    CHECK(AlertDesk("scene:figure-4", {}, "0").place() == "start");
}

TEST_CASE("Failures of a decision are noticed at it, and drawn") {
    AlertDesk desk("scene:four-edge-hole", {}, "81.emit.1");
    REQUIRE_FALSE(desk.session.noticedHere().empty());
    CHECK(desk.session.noticedText().find(" Alert: Triangle 315 ") == 0);
    CHECK(noticedUpTo(desk.session.overview(), desk.session.address()) > 0);
    DrawList list;
    LayerInput input{desk.session.model(), desk.session.picture(), paletteOf(Theme::Dark)};
    input.triangles = desk.session.triangles();
    input.noticed = desk.session.noticedHere();
    addAlerts(input, list);
    CHECK(list.sheets.size() >= 2);
    REQUIRE_FALSE(list.labels.empty());
    CHECK(list.labels[0].text.starts_with("! "));
    // Before the decision there is no failure yet.
    desk.session.showBefore(true);
    CHECK(desk.session.noticedHere().empty());
    desk.session.showBefore(false);
    desk.session.goTo({1, Stage::Pivot, 0});
    desk.session.settle();
    CHECK(desk.session.noticedHere().empty());
}

TEST_CASE("A rule that would have prevented an alert is switched on by one click") {
    AlertDesk desk("scene:four-edge-hole");
    REQUIRE(desk.session.chosenAlert());
    const std::size_t before = desk.session.alerts().failures().size();
    desk.session.seekRemedies();
    CHECK(desk.session.remedies().busy());
    desk.session.settle();
    const Remedies* found = desk.session.remedies().found();
    REQUIRE(found != nullptr);
    REQUIRE(found->tried.front().prevents);
    const Remedy best = found->tried.front();
    REQUIRE(best.rule != nullptr);
    const MeshFailure failure = desk.session.alert()->failure;
    showBeside(desk.context, best);
    CHECK(desk.ui.arrangement == Arrangement::Compare);
    REQUIRE(desk.ui.compare.begin);
    CHECK(desk.ui.compare.begin->run.choices ==
          std::vector<RuleValue>{{std::string(best.rule->name), 1.0}});
    REQUIRE_FALSE(desk.session.atEnd());
    const CameraPose camera = desk.camera.pose();
    switchOn(desk.context, best);
    desk.filing.carryOut(desk.ui.requests);
    desk.arrive();
    // Its result is visible: the whole mesh, from the same camera.
    CHECK(desk.session.atEnd());
    CHECK(desk.camera.pose() == camera);
    CHECK_FALSE(desk.ui.requests.frameAlert);
    CHECK(desk.ui.requests.frame == FrameWish::None);
    CHECK(desk.session.model().params.rules.*best.rule->member);
    CHECK(desk.session.alerts().failures().size() == best.all);
    CHECK(best.all < before);
    std::vector<MeshFailure> now;
    for (const RunFailure& each : desk.session.alerts().failures()) now.push_back(each.failure);
    CHECK_FALSE(isStillThere(failure, now));
}

TEST_CASE("A session keeps the chosen alert") {
    AlertDesk desk("scene:noise", "duplicate_triangles:2");
    desk.ui.requests.saveSessionAs = (desk.folder / "alert.sesession").string();
    desk.filing.carryOut(desk.ui.requests);
    desk.session.chooseAlert({});
    desk.filing.open((desk.folder / "alert.sesession").string());
    desk.arrive();
    REQUIRE(desk.session.chosenAlert());
    CHECK(alertName(desk.session.alerts(), *desk.session.chosenAlert()) == "duplicate_triangles:2");
    CHECK(desk.place() == "285.emit.2");
}

TEST_CASE("alerts: a note tells if a run is too large to be checked during stepping") {
    CHECK(watchNote(kMostWatched, 0).empty());
    CHECK(watchNote(kMostWatched + 1, 0).find(grouped(kMostWatched) + " points") !=
          std::string::npos);
    CHECK(watchNote(20, kMostNoticed - 1).empty());
    CHECK(watchNote(20, kMostNoticed).find(grouped(kMostNoticed) + " failures") !=
          std::string::npos);
}

TEST_CASE("Alerts of a tangled run are the first of each class, with the number of all") {
    InputSpec spec{"sample:torus,n=400", {WithinRadius{1e300}, true, 0, true}, "paper"};
    Session session;
    session.open(spec);
    session.settle();
    REQUIRE(session.ready());
    const AlertSearch& alerts = session.alerts();
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
