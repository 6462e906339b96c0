/// Points that take no part in the run are listed by reason, and points that were left out change
/// nothing but the run.
#include "run/aside.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "open_session.h"
#include "run/strings.h"
#include "spiraling_edge/base/random.h"
#include "spiraling_edge/scenes/scenes.h"

using namespace se;
using namespace se::view;

namespace {

/// The points of a file in memory, with the options of `spec`.
Result<Loaded> loadPoints(const PointFile& file, RunSpec spec = {}) {
    spec.source = std::string(kStandardInput);
    spec.points = std::make_shared<const PointFile>(file);
    LoadProgress progress;
    return loadInput(spec, progress);
}

PointFile plainSphere() {
    PointFile file = findScene("sphere")->build();
    file.neighbors = {};
    return file;
}

/// A sphere with a copy of point 3, point 7 without a normal, and point 9 without a position.
PointFile flawedSphere() {
    PointFile file = plainSphere();
    file.type.clear();
    file.normal[7] = Vec3(0.0);
    file.position[9].x = std::numeric_limits<double>::quiet_NaN();
    file.position.push_back(file.position[3]);
    file.normal.push_back(file.normal[3]);
    return file;
}

/// The group of that name; fails if there is none.
AsidePoints groupOf(const Model& model, const std::string& name) {
    for (const AsidePoints& each : model.aside) {
        if (nameOf(each) == name) return each;
    }
    FAIL("no group ", name);
    return {};
}

}  // namespace

TEST_CASE("Points that the preparation sets aside are listed by reason, with their indices") {
    const PointFile file = flawedSphere();
    const Result<Loaded> loaded = loadPoints(file);
    REQUIRE(loaded);
    const Model& model = *loaded.value().model;
    const auto copy = static_cast<Index>(file.position.size() - 1);
    CHECK(model.aside.size() == 2);
    CHECK(countOf(model.aside) == 2);
    CHECK(groupOf(model, "non_finite").points == std::vector<Index>{9});
    CHECK(groupOf(model, "duplicates").points == std::vector<Index>{copy});
    CHECK(returnText({Aside::NotFinite}).empty());
    RunSpec derived;
    derived.normals = NormalSource::Derived;
    CHECK(countOf(loadPoints(file, derived).value().model->aside) == 2);
    CHECK(loadPoints(plainSphere()).value().model->aside.empty());
}

TEST_CASE("Missing values, near or far, change nothing in the scale and in what is framed") {
    PointFile file = plainSphere();
    for (Vec3& x : file.position) x += Vec3(0.0, 0.0, 4.0);
    const std::size_t count = file.position.size();
    const Result<Loaded> without = loadPoints(file);
    REQUIRE(without);
    for (int i = 0; i < 20; ++i) {
        file.position.emplace_back(0.0, 0.0, 0.0);
        file.normal.emplace_back(0.0, 0.0, 1.0);
        file.type.resize(file.position.size(), kInterior);
    }
    file.position.back() = Vec3(1e7, 0.0, 0.0);
    const Result<Loaded> loaded = loadPoints(file);
    REQUIRE(loaded);
    const Model& model = *loaded.value().model;
    CHECK(groupOf(model, "sentinels").count == 20);
    CHECK(model.scale == without.value().model->scale);
    CHECK(model.center == without.value().model->center);
    REQUIRE(model.sample.size() == count);
    CHECK(model.sample == without.value().model->sample);
}

TEST_CASE("Points set aside for noise are as many as the report counts") {
    SplitMix random(3);
    PointFile file;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 out = glm::normalize(random.inBox(Vec3(-1.0), Vec3(1.0)));
        const Vec3 a = random.inBox(Vec3(-1.0), Vec3(1.0));
        file.position.push_back(out * (1.0 + 0.1 * (a.x + a.y + a.z)));
        file.normal.push_back(out);
    }
    RunSpec spec;
    spec.rules = "robust";
    const Result<Loaded> loaded = loadPoints(file, spec);
    REQUIRE(loaded);
    const Model& model = *loaded.value().model;
    REQUIRE(model.report.count(Aside::Noise) > 100);
    CHECK(groupOf(model, "noise").count == model.report.count(Aside::Noise));
    spec = withRule(spec, "noise", 0.0);
    CHECK(loadPoints(file, spec).value().model->aside.empty());
}

TEST_CASE("Points dropped by a fix are listed with the fix, at their places") {
    const PointFile file = flawedSphere();
    RunSpec spec;
    spec.fixes = {"duplicates"};
    const Result<Loaded> loaded = loadPoints(file, spec);
    REQUIRE(loaded);
    const Model& model = *loaded.value().model;
    const AsidePoints dropped = groupOf(model, "duplicates");
    CHECK(dropped.fix == "duplicates");
    CHECK(dropped.count == 2);
    CHECK(dropped.position.size() == 1);  // one is not finite
    CHECK(dropped.points.empty());
    CHECK(reasonText(dropped) == "dropped by the fix of duplicates");
    CHECK(model.pointsInPiece == file.position.size());
    REQUIRE(model.inPiece.size() == file.position.size() - 2);
    CHECK(model.numberInPiece(8) == 8);
    CHECK(model.numberInPiece(9) == 10);
    // The file of the run has no column of ours.
    CHECK(loaded.value().given->attributes.empty());
}

TEST_CASE("Points left out are not run, the others keep their index, place and scale") {
    const PointFile file = plainSphere();
    const Result<Loaded> whole = loadPoints(file);
    RunSpec spec;
    spec.leftOut = {{0, 4}, {20, 20}};
    const Result<Loaded> loaded = loadPoints(file, spec);
    REQUIRE(loaded);
    const Model& model = *loaded.value().model;
    CHECK(model.points.size() == file.position.size() - 6);
    CHECK(groupOf(model, "left_out").count == 6);
    CHECK(changesText(model).find("Left out: 6 of ") != std::string::npos);
    REQUIRE(loaded.value().given->attributes.size() == 1);
    const Attribute& index = loaded.value().given->attributes.front();
    CHECK(index.name == "index");
    for (Index p = 0; p < model.points.size(); ++p) {
        const Index q = model.numberInPiece(p);
        CHECK(index.values[p] == q);
        CHECK(model.place[p] == whole.value().model->place[q]);
    }
    CHECK(model.scale == whole.value().model->scale);
}

TEST_CASE("What is framed is the piece, and numbers in the file hold with fixes as well") {
    PointFile file = flawedSphere();
    const Result<Loaded> whole = loadPoints(file);
    std::vector<Index> below;
    for (Index p = 0; p < file.position.size(); ++p) {
        if (file.position[p].z < 0.0) below.push_back(p);
    }
    RunSpec spec;
    spec.leftOut = rangesOf(below);
    spec.fixes = {"duplicates"};
    const Result<Loaded> loaded = loadPoints(file, spec);
    REQUIRE(loaded);
    const Model& model = *loaded.value().model;
    CHECK(model.middle.z > 0.3F);
    CHECK(whole.value().model->radius == doctest::Approx(1.0));
    CHECK(glm::length(whole.value().model->middle) < 1e-6F);
    REQUIRE(loaded.value().given->attributes.size() == 1);
    for (Index p = 0; p < model.points.size(); ++p)
        CHECK(loaded.value().given->attributes.front().values[p] == model.numberInPiece(p));
}

TEST_CASE("A run without any point is refused, indices beyond the file are passed over") {
    const PointFile file = plainSphere();
    RunSpec spec;
    spec.leftOut = {{0, 100'000'000}};
    const Result<Loaded> none = loadPoints(file, spec);
    REQUIRE_FALSE(none);
    CHECK(none.error().message.find("points are left out.") != std::string::npos);
    spec.leftOut = {{50'000, 60'000}};
    CHECK(loadPoints(file, spec).value().model->points.size() == file.position.size());
}
