#include "jobs/doctor_job.h"
#include "layers/layer.h"
#include "open_session.h"
#include "point_files.h"
#include "scene/draw_list.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "spiraling_edge/scenes/scenes.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

std::shared_ptr<const PointFile> sphere() {
    return std::make_shared<const PointFile>(findScene("sphere")->build());
}

/// The sphere scene with two zero normals, as a file that is removed with this object.
struct FlawedFile {
    OwnFolder folder;
    std::filesystem::path path = folder / "flawed.xyz";

    FlawedFile() {
        PointFile file = *sphere();
        file.normal[7] = file.normal[9] = Vec3(0.0);
        writePoints(path, file);
    }
};

}  // namespace

TEST_CASE("The doctor starts only on request, and its findings come once") {
    DoctorJob doctorJob;
    doctorJob.start();
    CHECK_FALSE(doctorJob.busy());
    doctorJob.enqueue(sphere());
    CHECK_FALSE(doctorJob.busy());
    doctorJob.start();
    CHECK(doctorJob.busy());
    doctorJob.waitUntilDone();
    CHECK(doctorJob.poll());
    CHECK_FALSE(doctorJob.poll());
    CHECK(doctorJob.done());
    CHECK(doctorJob.findings().empty());
    doctorJob.start();
    CHECK_FALSE(doctorJob.busy());
}

TEST_CASE("Another input cancels the examination of the last one") {
    DoctorJob doctorJob;
    for (int i = 0; i < 5; ++i) {
        doctorJob.enqueue(sphere());
        doctorJob.start();
    }
    doctorJob.enqueue(nullptr);
    CHECK_FALSE(doctorJob.busy());
    CHECK_FALSE(doctorJob.done());
    doctorJob.enqueue(std::make_shared<const PointFile>(findScene("grid")->build()));
    doctorJob.start();
    doctorJob.waitUntilDone();
    REQUIRE(doctorJob.poll());
    REQUIRE(doctorJob.findings().size() == 1);
    CHECK(doctorJob.findings()[0].check->name == "ties");
}

TEST_CASE("An input is examined once the run is complete, and problems are reported once") {
    const FlawedFile file;
    OpenSession open(file.path.c_str());
    REQUIRE(open.session.ready());
    CHECK(open.session.overview().complete);
    REQUIRE(open.session.doctorJob().done());
    REQUIRE(open.session.doctorJob().findings().size() == 1);
    const Finding& finding = open.session.doctorJob().findings()[0];
    CHECK(finding.check->name == "zero_normals");
    CHECK(finding.points == std::vector<Index>{7, 9});
    CHECK(open.session.takeProblemFound());
    CHECK_FALSE(open.session.takeProblemFound());
    open.session.highlights().mark(finding.points);
    open.session.open(RunSpec{"scene:figure-8"});
    open.session.waitUntilDone();
    CHECK(open.session.highlights().marked().empty());
    REQUIRE(open.session.doctorJob().findings().size() == 1);  // A note is no problem.
    CHECK_FALSE(open.session.takeProblemFound());
}

TEST_CASE("Of a large finding evenly chosen points are marked, and none without a position") {
    const auto model = sphereModel();
    REQUIRE(model);
    Finding finding;
    for (Index p = 0; p < model->points.size(); ++p) finding.points.push_back(p);
    CHECK(pointsToMark(*model, finding) == finding.points);
    const std::vector<Index> some = pointsToMark(*model, finding, 60);
    REQUIRE(some.size() == 60);
    CHECK(std::adjacent_find(some.begin(), some.end(),
                             [](Index a, Index b) { return b != a + 10; }) == some.end());
    Model holed = *model;
    holed.drawable[3] = false;
    const std::vector<Index> drawn = pointsToMark(holed, finding);
    CHECK(drawn.size() + 1 == finding.points.size());
    CHECK(std::find(drawn.begin(), drawn.end(), 3U) == drawn.end());
}

TEST_CASE("Marked points get a diamond each, over everything else") {
    OpenSession open;
    open.session.highlights().mark({4, 8, 15});
    const LayerInput input{.model = open.session.model(),
                           .picture = open.session.picture(),
                           .palette = paletteOf(Theme::Dark),
                           .marked = open.session.highlights().marked()};
    DrawList out;
    addMarked(input, out);
    REQUIRE(out.sprites.size() == 3);
    for (const Sprite& sprite : out.sprites) CHECK(sprite.style.shape == view::Shape::OpenDiamond);
    CHECK(out.sprites[1].position == open.session.model().place[8]);
}
