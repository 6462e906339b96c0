#include "controllers/mesh_saving.h"

#include <doctest/doctest.h>

#include <fstream>

#include "commands/command_actions.h"
#include "headless_app.h"
#include "run/strings.h"
#include "spiraling_edge/io/write_mesh.h"

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

/// A program with the dialog Save mesh open.
struct SavingDesk : test::Desk {
    MeshSaving saving{context};

    explicit SavingDesk(const char* source = "scene:sphere") : test::Desk("saving-test") {
        filing.open(source);
        settle();
        actions::saveMesh(context);
    }
    /// One frame with that request, and all its consequences.
    void ask(MeshAsk what, const fs::path& path = {}) {
        ui.mesh.ask = what;
        ui.mesh.path = path.string();
        saving.carryOut();
        saving.settle();
        saving.carryOut();
    }
    FinishedMesh mesh() const { return finishMesh(session.model(), *session.sharedFile()).value(); }
};

PointFile read(const fs::path& path) {
    const Result<PointFile> file = readPoints(path);
    REQUIRE_MESSAGE(file.ok(), file.error().message);
    return file.value();
}

}  // namespace

TEST_CASE("A saved mesh reads back as the final mesh of the run, in each format read here") {
    SavingDesk desk("scene:sheet");
    desk.ask(MeshAsk::None);
    REQUIRE(desk.ui.mesh.size.has_value());
    const FinishedMesh mesh = desk.mesh();
    REQUIRE(!mesh.triangles->empty());
    CHECK(desk.ui.mesh.size->triangles == mesh.triangles->size());
    for (const char* name : {"a.ply", "a.obj", "a.off"}) {
        CAPTURE(name);
        actions::saveMesh(desk.context);
        desk.ask(MeshAsk::Save, desk.folder / name);
        CHECK_FALSE(desk.ui.fileBrowser);
        CHECK(desk.session.message().find(name) != std::string::npos);
        const PointFile file = read(desk.folder / name);
        CHECK(file.faces == *mesh.triangles);
        CHECK(file.position == mesh.points->position);
        // OFF is written plain: most programs refuse normals there.
        const bool plain = fs::path(name).extension() == ".off";
        CHECK(file.normal == (plain ? std::vector<Vec3>{} : mesh.points->normal));
    }
    CHECK(read(desk.folder / "a.ply").type == mesh.points->type);
    for (const char* name : {"a.stl", "a.glb"}) {
        actions::saveMesh(desk.context);
        desk.ask(MeshAsk::Save, desk.folder / name);
        CHECK(fs::file_size(desk.folder / name) > 50 * mesh.triangles->size() / 4);
    }
}

TEST_CASE("Used points only: the file has no other points, and the same triangles in space") {
    SavingDesk desk("scene:stranded-point");
    desk.ui.mesh.usedOnly = true;
    desk.ask(MeshAsk::Save, desk.folder / "used.ply");
    const FinishedMesh mesh = desk.mesh();
    REQUIRE(mesh.usedPoints < mesh.points->position.size());
    const PointFile file = read(desk.folder / "used.ply");
    CHECK(file.position.size() == mesh.usedPoints);
    REQUIRE(file.faces.size() == mesh.triangles->size());
    for (std::size_t i = 0; i < file.faces.size(); ++i) {
        const Triangle& given = (*mesh.triangles)[i];
        CHECK(file.position[file.faces[i].b] == mesh.points->position[given.b]);
    }
}

TEST_CASE("The mesh that is saved is that of the end of the run, wherever the cursor is") {
    SavingDesk desk;
    desk.session.goToPivot(3);
    desk.settle();
    desk.ask(MeshAsk::Save, desk.folder / "a.ply");
    CHECK(desk.session.record().pivot == 3);
    CHECK(read(desk.folder / "a.ply").faces == *desk.mesh().triangles);
}

TEST_CASE("A file is replaced only after a question") {
    SavingDesk desk;
    const fs::path path = desk.folder / "a.ply";
    std::ofstream(path) << "old";
    desk.ask(MeshAsk::Save, path);
    CHECK(desk.ui.mesh.question == path.string());
    CHECK(readText(path) == "old");
    // Esc answers no, and the dialog stays.
    actions::escape(desk.context);
    desk.ask(desk.ui.mesh.ask);
    CHECK(desk.ui.mesh.question.empty());
    CHECK(desk.ui.fileBrowser);
    CHECK(readText(path) == "old");
    desk.ask(MeshAsk::Save, path);
    desk.ask(MeshAsk::Replace);
    CHECK_FALSE(desk.ui.fileBrowser);
    CHECK(read(path).faces == *desk.mesh().triangles);
}

TEST_CASE("A write error is reported in the dialog, which stays open") {
    SavingDesk desk;
    desk.ask(MeshAsk::Save, desk.folder / "none" / "a.ply");
    CHECK(desk.ui.fileBrowser);
    CHECK(desk.ui.mesh.complaint.find("there is no folder") != std::string::npos);
    fs::create_symlink("/dev/full", desk.folder / "full.ply");
    desk.ask(MeshAsk::Save, desk.folder / "full.ply");
    desk.ask(MeshAsk::Replace);
    CHECK(desk.ui.fileBrowser);
    CHECK(desk.ui.mesh.complaint.find("full.ply: cannot be written") != std::string::npos);
    // The next attempt begins without it.
    desk.ask(MeshAsk::Save, desk.folder / "a.ply");
    CHECK(desk.ui.mesh.complaint.empty());
    CHECK(fs::exists(desk.folder / "a.ply"));
}

TEST_CASE("Saving waits for the run and can be cancelled meanwhile: no file is left") {
    SavingDesk desk;
    desk.ui.mesh.ask = MeshAsk::Save;
    desk.ui.mesh.path = desk.folder / "a.ply";
    desk.saving.carryOut();  // the run has only just begun
    CHECK(desk.ui.mesh.saving);
    desk.ask(MeshAsk::Cancel);
    CHECK_FALSE(desk.ui.mesh.saving);
    CHECK(desk.ui.mesh.complaint.find("Cancelled") != std::string::npos);
    CHECK(desk.ui.fileBrowser);
    CHECK_FALSE(fs::exists(desk.folder / "a.ply"));
    // So does closing the dialog.
    actions::saveMesh(desk.context);
    desk.ui.mesh.ask = MeshAsk::Save;
    desk.saving.carryOut();
    actions::escape(desk.context);
    desk.saving.carryOut();
    desk.saving.settle();
    CHECK_FALSE(desk.saving.busy());
}

TEST_CASE(
    "Without an input, or without a triangle, a sentence says that there is nothing to save") {
    test::Desk empty("saving-empty-test");
    actions::saveMesh(empty.context);
    CHECK_FALSE(empty.ui.fileBrowser);
    CHECK(empty.session.message().find("no run") != std::string::npos);
    actions::copyCommand(empty.context);
    CHECK(empty.ui.mesh.ask == MeshAsk::None);

    const fs::path two = test::ownPlace("two-points.xyz");
    std::ofstream(two) << "0 0 0 0 0 1\n1 0 0 0 0 1\n";
    SavingDesk desk(two.c_str());
    fs::remove(two);
    desk.ask(MeshAsk::None);
    desk.ask(MeshAsk::Save, desk.folder / "a.ply");
    CHECK(desk.ui.mesh.complaint.find("makes no triangle") != std::string::npos);
    CHECK_FALSE(fs::exists(desk.folder / "a.ply"));
}

TEST_CASE("Another run, other rules: the mesh is made again") {
    SavingDesk desk("scene:noise");
    desk.ask(MeshAsk::None);
    const MeshSize paper = *desk.ui.mesh.size;
    desk.session.runAnew({"robust", {}, {}});
    desk.settle();
    desk.ask(MeshAsk::None);
    CHECK(desk.ui.mesh.size->triangles == desk.mesh().triangles->size());
    CHECK(desk.ui.mesh.size->triangles != paper.triangles);
}

TEST_CASE("For an STL far from the origin the notice reports the offset of its positions") {
    const SavingDesk desk;
    FinishedMesh mesh = desk.mesh();
    PointFile far = *mesh.points;
    far.positionType = ScalarType::Double;
    for (Vec3& place : far.position) place += Vec3(500000, 5400000, 300);
    mesh.points = std::make_shared<const PointFile>(std::move(far));
    const auto noticeOf = [&](const char* name) {
        const Result<SavedMesh> saved = saveMesh(mesh, {(desk.folder / name).string(), false});
        REQUIRE(saved.ok());
        return savedText(saved.value());
    };
    CHECK(noticeOf("a.stl").find("relative to (500000, 5400000, 300)") != std::string::npos);
    CHECK(noticeOf("a.ply").find("relative") == std::string::npos);
}
