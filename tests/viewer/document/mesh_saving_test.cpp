#include "document/mesh_saving.h"

#include <doctest/doctest.h>

#include <fstream>

#include "commands/commands.h"
#include "document/actions.h"
#include "headless_app.h"
#include "run/strings.h"
#include "spiraling_edge/io/write_mesh.h"

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

/// A program with the dialog Save mesh open.
struct SavingApp : test::HeadlessApp {
    explicit SavingApp(const char* source = "scene:sphere") : test::HeadlessApp("saving-test") {
        document.open(source);
        waitUntilDone();
        actions::saveMesh(context);
    }
    /// All that has been asked for is done.
    void settle() {
        mesh.poll();
        mesh.waitUntilDone();
    }
    void save(const fs::path& path) {
        mesh.save(path.string());
        settle();
    }
    FinishedMesh finished() const {
        return finishMesh(session.model(), *session.input().file(), session.runEnd());
    }
};

PointFile read(const fs::path& path) {
    const Result<PointFile> file = readPoints(path);
    REQUIRE_MESSAGE(file.ok(), file.error().message);
    return file.value();
}

}  // namespace

TEST_CASE("A saved mesh reads back as the final mesh of the run, in each format read here") {
    SavingApp app("scene:sheet");
    app.settle();
    REQUIRE(app.mesh.mesh() != nullptr);
    const FinishedMesh mesh = app.finished();
    REQUIRE(!mesh.triangles->empty());
    CHECK(*app.mesh.mesh()->triangles == *mesh.triangles);
    for (const char* name : {"a.ply", "a.obj", "a.off"}) {
        CAPTURE(name);
        actions::saveMesh(app.context);
        app.save(app.folder / name);
        CHECK_FALSE(app.ui.fileBrowser);
        CHECK(app.session.messages().last().find(name) != std::string::npos);
        const PointFile file = read(app.folder / name);
        CHECK(file.faces == *mesh.triangles);
        CHECK(file.position == mesh.points->position);
        // OFF is written plain: most programs refuse normals there.
        const bool plain = fs::path(name).extension() == ".off";
        CHECK(file.normal == (plain ? std::vector<Vec3>{} : mesh.points->normal));
    }
    CHECK(read(app.folder / "a.ply").type == mesh.points->type);
    for (const char* name : {"a.stl", "a.glb"}) {
        actions::saveMesh(app.context);
        app.save(app.folder / name);
        CHECK(fs::file_size(app.folder / name) > 50 * mesh.triangles->size() / 4);
    }
}

TEST_CASE("Used points only: the file has no other points, and the same triangles in space") {
    SavingApp app("scene:stranded-point");
    app.ui.mesh.usedOnly = true;
    app.save(app.folder / "used.ply");
    const FinishedMesh mesh = app.finished();
    REQUIRE(mesh.usedPoints < mesh.points->position.size());
    const PointFile file = read(app.folder / "used.ply");
    CHECK(file.position.size() == mesh.usedPoints);
    REQUIRE(file.faces.size() == mesh.triangles->size());
    for (std::size_t i = 0; i < file.faces.size(); ++i) {
        const Triangle& given = (*mesh.triangles)[i];
        CHECK(file.position[file.faces[i].b] == mesh.points->position[given.b]);
    }
}

TEST_CASE("The mesh that is saved is that of the end of the run, wherever the cursor is") {
    SavingApp app;
    app.session.moves().goToPivot(3);
    app.waitUntilDone();
    app.save(app.folder / "a.ply");
    CHECK(app.session.record().pivot == 3);
    CHECK(read(app.folder / "a.ply").faces == *app.finished().triangles);
}

TEST_CASE("A write error is reported in the dialog, which stays open") {
    SavingApp app;
    app.save(app.folder / "none" / "a.ply");
    CHECK(app.ui.fileBrowser);
    CHECK(app.ui.mesh.complaint.find("there is no folder") != std::string::npos);
    fs::create_symlink("/dev/full", app.folder / "full.ply");
    app.save(app.folder / "full.ply");
    CHECK(app.ui.fileBrowser);
    CHECK(app.ui.mesh.complaint.find("full.ply: cannot be written") != std::string::npos);
    // The next attempt begins without it.
    app.save(app.folder / "a.ply");
    CHECK(app.ui.mesh.complaint.empty());
    CHECK(fs::exists(app.folder / "a.ply"));
}

TEST_CASE("Saving waits for the run and can be cancelled meanwhile: no file is left") {
    SavingApp app;
    app.mesh.save(app.folder / "a.ply");  // the run has only just begun
    CHECK(app.ui.mesh.saving);
    app.mesh.cancel();
    app.settle();
    CHECK_FALSE(app.ui.mesh.saving);
    CHECK(app.ui.mesh.complaint.find("Cancelled") != std::string::npos);
    CHECK(app.ui.fileBrowser);
    CHECK_FALSE(fs::exists(app.folder / "a.ply"));
    // So does closing the dialog.
    actions::saveMesh(app.context);
    app.mesh.save(app.folder / "a.ply");
    actions::escape(app.context);
    app.settle();
    CHECK_FALSE(app.mesh.busy());
}

TEST_CASE("A line about the last attempt goes with the next one") {
    SavingApp app;
    const MeshForm& form = app.ui.mesh;
    app.mesh.save((app.folder / "a.ply").string());  // the run has only just begun
    actions::copyCommand(app.context);
    app.mesh.cancel();
    CHECK(form.note.empty());
    CHECK(form.complaint == "Cancelled: nothing was saved.");
    actions::copyCommand(app.context);
    CHECK(form.complaint.empty());
    CHECK_FALSE(form.note.empty());
    app.save(app.folder / "b.ply");
    CHECK(form.note.empty());
    CHECK(form.complaint.empty());
}

TEST_CASE(
    "Without an input, or without a triangle, a sentence says that there is nothing to save") {
    test::HeadlessApp empty("saving-empty-test");
    runCommand(*findCommand("file.savemesh"), empty.context);
    CHECK_FALSE(empty.ui.fileBrowser);
    CHECK(empty.session.messages().last().find("no run") != std::string::npos);
    runCommand(*findCommand("file.copycommand"), empty.context);
    CHECK(empty.ui.clipboard.copied().empty());

    const fs::path two = test::ownPlace("two-points.xyz");
    std::ofstream(two) << "0 0 0 0 0 1\n1 0 0 0 0 1\n";
    SavingApp app(two.c_str());
    fs::remove(two);
    app.settle();
    app.save(app.folder / "a.ply");
    CHECK(app.ui.mesh.complaint.find("makes no triangle") != std::string::npos);
    CHECK_FALSE(fs::exists(app.folder / "a.ply"));
}

TEST_CASE("Another run, other rules: the mesh is made again") {
    SavingApp app("scene:noise");
    app.settle();
    const std::size_t paper = app.mesh.mesh()->triangles->size();
    app.session.rerun(withSet({}, "robust"));
    app.waitUntilDone();
    app.settle();
    CHECK(*app.mesh.mesh()->triangles == *app.finished().triangles);
    CHECK(app.mesh.mesh()->triangles->size() != paper);
}

TEST_CASE("For an STL far from the origin the notice reports the offset of its positions") {
    const SavingApp app;
    FinishedMesh mesh = app.finished();
    PointFile far = *mesh.points;
    far.positionType = ScalarType::Double;
    for (Vec3& place : far.position) place += Vec3(500000, 5400000, 300);
    mesh.points = std::make_shared<const PointFile>(std::move(far));
    const auto noticeOf = [&](const char* name) {
        const Result<SavedMesh> saved =
            saveMesh(app.session.model(), mesh, {(app.folder / name).string(), false});
        REQUIRE(saved.ok());
        return savedText(saved.value());
    };
    CHECK(noticeOf("a.stl").find("relative to (500000, 5400000, 300)") != std::string::npos);
    CHECK(noticeOf("a.ply").find("relative") == std::string::npos);
}
