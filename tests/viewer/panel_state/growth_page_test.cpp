#include "panel_state/forms.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "commands/commands.h"
#include "headless_app.h"

using namespace se;
using namespace se::view;

TEST_CASE("The form specifies the samples, and restores them") {
    GrowthForm form;
    CHECK(form.spec().value() == sampleFromSource("sample:torus,n=2000").value());
    form.choose("gyroid");
    form.count = " 1500 ";
    form.seed = "4";
    form.cutByOwnBox();
    CHECK(form.box[0] == "-4");
    form.box[0] = "-2.5";
    form.isovalue = "0.25";
    const Result<SampleSpec> spec = form.spec();
    REQUIRE(spec.ok());
    CHECK(spec.value().box->low.x == -2.5);
    GrowthForm other;
    other.take(spec.value());
    CHECK(other.spec().value() == spec.value());
    // Settings of one surface do not hold for another.
    other.choose("sphere");
    CHECK_FALSE(other.spec().value().box.has_value());
    CHECK_FALSE(other.spec().value().isovalue.has_value());
}

TEST_CASE("A field that is wrong is named") {
    const auto complaint = [](auto change) {
        GrowthForm form;
        change(form);
        const Result<SampleSpec> spec = form.spec();
        return spec ? std::string("none") : spec.error().message;
    };
    CHECK(complaint([](GrowthForm& f) { f.count = "many"; }).starts_with("Points:"));
    CHECK(complaint([](GrowthForm& f) { f.count = "0"; }).starts_with("Points:"));
    CHECK(complaint([](GrowthForm& f) {
              f.bySpacing = true, f.spacing = "-1";
          }).starts_with("Spacing:"));
    CHECK(complaint([](GrowthForm& f) { f.seed = "1.5"; }).starts_with("Seed:"));
    CHECK(complaint([](GrowthForm& f) { f.isovalue = "high"; }).starts_with("Isovalue:"));
    CHECK(complaint([](GrowthForm& f) { f.curvature = "101"; }).starts_with("Curvature:"));
    CHECK(complaint([](GrowthForm& f) { f.cut = true; }).starts_with("Box:"));
    CHECK(complaint([](GrowthForm& f) {
              f.from = GrowthSource::Volume;
          }).starts_with("Choose a volume"));
    CHECK(complaint([](GrowthForm& f) { f.chooseVolume("scan.ply"); }).find("not a volume") !=
          std::string::npos);
}

TEST_CASE("On the page with new points keys act on them, keys of the run have no effect") {
    test::HeadlessApp app("growth-keys");
    UiState& ui = app.ui;
    app.sampling.openPage(GrowthSource::Shape);
    CHECK(ui.growth.open);
    const auto presses = [&](const char* id) {
        runCommand(*findCommand(id), app.context);
        app.sampling.poll();
        return app.sampling.growth().phase();
    };
    CHECK(presses("view.home") == GrowthPhase::Finding);
    presses("run.play");
    CHECK_FALSE(app.playback.playing());
    app.sampling.waitUntilDone();
    CHECK(app.sampling.growth().phase() == GrowthPhase::Paused);
    const int step = app.sampling.growth().picture()->step;
    presses("step.event.next");
    app.sampling.waitUntilDone();
    CHECK(app.sampling.growth().picture()->step == step + 1);
    presses("run.end");
    app.sampling.waitUntilDone();
    CHECK(app.sampling.growth().phase() == GrowthPhase::Done);
    const LayerModes before = ui.settings.layers;
    presses("layer.normals");
    CHECK(ui.settings.layers == before);
    presses("view.theme");
    CHECK(ui.settings.theme == Theme::Light);
    CHECK(app.sampling.growth().phase() == GrowthPhase::Done);
    presses("help.leave");
    CHECK_FALSE(ui.growth.open);
    runCommand(*findCommand("layer.normals"), app.context);
    CHECK(ui.settings.layers != before);
}

TEST_CASE("A volume is chosen in a browser, and starts at once") {
    test::HeadlessApp app("growth-volume");
    app.sampling.openPage(GrowthSource::Volume);
    CHECK(app.ui.fileBrowser);
    CHECK(app.ui.browser == BrowserTask::Volume);
    CHECK(app.sampling.growth().phase() == GrowthPhase::Idle);
    CHECK(rowOf(BrowserTask::Volume).lists("a.nhdr"));
    CHECK_FALSE(rowOf(BrowserTask::Volume).lists("a.ply"));
    CHECK(rowOf(BrowserTask::SavePoints).lists("a.ply"));
    // Opened like any file it leads there as well, and the open input stays.
    app.ui.growth = {};
    app.ui.fileBrowser = false;
    app.ui.notes = "not saved";
    app.document.drop({"/data/scan.nhdr"});
    CHECK_FALSE(app.ui.leaving.asked);
    CHECK(app.ui.growth.open);
    CHECK(app.ui.growth.form.volume == "/data/scan.nhdr");
    app.sampling.poll();
    CHECK(app.sampling.growth().phase() != GrowthPhase::Idle);
    CHECK(app.session.input().phase() == SessionPhase::Empty);
}

TEST_CASE("Other preparation opens the input in another way, and the form undoes it") {
    LoadProgress progress;
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    PrepareForm form;
    form.take(withSet({"scene:sphere"}, "robust"), *model);
    CHECK(form.open);
    CHECK(form.reach == PrepareForm::Reach::File);
    CHECK(form.count == "12");
    form.reach = PrepareForm::Reach::Nearest;
    form.count = "9";
    form.symmetric = true;
    form.normals = NormalSource::Derived;
    form.walls = WallChoice::From::Around;
    form.keepNoise = form.keepOpposing = true;
    const Result<RunSpec> spec = form.spec(withSet({"scene:sphere"}, "robust"));
    REQUIRE(spec.ok());
    CHECK(spec.value().rules == "robust");
    const Result<Loaded> loaded = loadInput(spec.value(), progress);
    REQUIRE(loaded.ok());
    const PrepareReport& report = loaded.value().model->report;
    CHECK(report.neighborsComputed);
    CHECK(report.derived.normals);
    CHECK_FALSE(loaded.value().model->params.dropOpposingNormals);
    CHECK_FALSE(loaded.value().model->params.setNoiseAside);
    CHECK(loaded.value().model->points.neighbors[0].size() >= 9);
    PrepareForm again;
    again.take(spec.value(), *model);
    CHECK(again.reach == PrepareForm::Reach::Nearest);
    CHECK(again.count == "9");
    CHECK(again.normals == NormalSource::Derived);
    CHECK(again.walls == WallChoice::From::Around);
    again.reach = PrepareForm::Reach::Radius;
    again.radius = "0";
    CHECK(again.spec(spec.value()).error().message.starts_with("Radius:"));
    again.reach = PrepareForm::Reach::File;
    again.walls = WallChoice::From::Box;
    again.box = {};
    CHECK(again.spec(spec.value()).error().message.starts_with("Box:"));
}

TEST_CASE("The form shows the choices of fixes, other choices there take precedence") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    RunSpec fixed{"scene:sphere"};
    fixed.fixes = {"zero_normals",  "flipped_normals",   "short_lists",
                   "types_off_box", "unsymmetric_lists", "open_border"};
    PrepareForm form;
    form.take(fixed, *model);
    CHECK(form.normals == NormalSource::Oriented);
    CHECK(form.reach == PrepareForm::Reach::Nearest);
    CHECK(form.count == "12");
    CHECK(form.walls == WallChoice::From::Around);
    CHECK(form.symmetric);
    CHECK(form.rim);
    // Unchanged, all of them stay.
    CHECK(form.spec(fixed).value().fixes == fixed.fixes);
    form.reach = PrepareForm::Reach::Spacings;
    form.spacings = "1.5";
    form.normals = NormalSource::AsGiven;
    const RunSpec chosen = form.spec(fixed).value();
    CHECK(std::get<WithinSpacings>(chosen.neighbors.reach).spacings == 1.5);
    CHECK(chosen.fixes == std::vector<std::string>{"zero_normals", "types_off_box",
                                                   "unsymmetric_lists", "open_border"});
    form.walls = WallChoice::From::File;
    form.symmetric = form.rim = false;
    CHECK(form.spec(fixed).value().fixes == std::vector<std::string>{"zero_normals"});
    form.spacings = "-1";
    CHECK(form.spec(fixed).error().message.starts_with("Reach:"));
}

TEST_CASE("The proposed box has as few digits as a wall's tolerance allows") {
    auto model = std::make_shared<Model>(*test::sphereModel());
    model->points.position.assign({Vec3(0.1F, 0.25, 1.0), Vec3(1.0, 2.0F / 3.0F, 2.0)});
    PrepareForm form;
    form.take(RunSpec{"scene:sphere"}, *model);
    CHECK(form.box == BoxFields{"0.1", "0.25", "1", "1", "0.6666667", "2"});
    form.walls = WallChoice::From::Box;
    const WallBox box = form.spec(RunSpec{"scene:sphere"}).value().walls.box;
    const WallBox around = boxAround(model->points.position);
    CHECK(glm::length(box.low - around.low) < around.tolerance);
    CHECK(glm::length(box.high - around.high) < around.tolerance);
}

TEST_CASE("7 the walls of a given box make boundary points of a sphere cut in half") {
    LoadProgress progress;
    RunSpec spec{"sample:sphere,n=400,box=0:-2:-2:2:2:2"};
    const Result<Loaded> cut = loadInput(spec, progress);
    REQUIRE(cut.ok());
    const auto walls = [](const Model& model) {
        return std::count_if(model.points.type.begin(), model.points.type.end(), isBoundary);
    };
    const auto own = walls(*cut.value().model);
    CHECK(own > 10);
    CHECK_FALSE(cut.value().model->report.derived.types);
    spec.walls = {WallChoice::From::Box, {{0, -2, -2}, {2, 2, 2}}};
    const Result<Loaded> derived = loadInput(spec, progress);
    REQUIRE(derived.ok());
    CHECK(walls(*derived.value().model) == own);
    CHECK(derived.value().model->report.derived.types);
}

TEST_CASE("Sampled points are opened at the camera's position, others discard the box") {
    test::HeadlessApp app("growth-open");
    const Result<PointFile> points =
        samplePoints(sampleFromSource("sample:torus,n=300").value(), {});
    REQUIRE(points.ok());
    app.ui.growth.open = true;
    CameraPose pose;
    pose.distance = 2.5F;
    app.camera.setPose(pose);
    RunSpec spec;
    spec.source = "sample:torus,n=300";
    spec.points = std::make_shared<const PointFile>(points.value());
    spec.walls = {WallChoice::From::Around, {}};
    app.document.openSpec(spec);
    app.waitUntilDone();
    REQUIRE(app.session.ready());
    CHECK(app.session.model().name == "torus, 300 points");
    CHECK(app.document.takeCamera()->distance == 2.5F);
    app.document.open("scene:sphere");
    app.waitUntilDone();
    CHECK(app.session.model().name == "scene:sphere");
    CHECK(app.session.input().spec().points == nullptr);
    CHECK(app.session.input().spec().walls == WallChoice{});
}
