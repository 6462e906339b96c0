#include "panel_state/file_browser_state.h"
#include "open_session.h"
#include "session/session_file.h"

#include <doctest/doctest.h>

#include <fstream>

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

TEST_CASE("A session gets its extension, regardless of other dots in the name") {
    CHECK(withExtension("one", kSessionExtension) == "one.sesession");
    CHECK(withExtension("section 6.3", kSessionExtension) == "section 6.3.sesession");
    CHECK(withExtension("a.ply", kSessionExtension) == "a.ply.sesession");
    CHECK(withExtension("one.sesession", kSessionExtension) == "one.sesession");
    CHECK(withExtension("one.SESESSION", kSessionExtension) == "one.SESESSION");
}

TEST_CASE("A typed path is relative to the shown folder") {
    CHECK(typedSource("/data/scans", "a.ply") == "/data/scans/a.ply");
    CHECK(typedSource("/data/scans", "../b.ply") == "/data/b.ply");
    CHECK(typedSource("/data/scans", "/tmp/c.ply") == "/tmp/c.ply");
    CHECK(typedSource("/data/scans", "scene:torus") == "scene:torus");
    CHECK(typedSource("/data/scans", "").empty());
}

TEST_CASE("Every format that can be read is offered") {
    for (const char* name :
         {"a.ply", "a.XYZ", "a.obj", "a.off", "a.pcd", "a.PCD", "a.txt", "a.nrrd", "a.nhdr",
          "a.sesession", "a.las", "a.csv", "a.ply.gz", "a.glb"}) {
        CAPTURE(name);
        CHECK(canBeOpened(name));
    }
    for (const char* name : {"a.ply", "a.OBJ", "a.off", "a.glb"}) CHECK(canHoldMesh(name));
    for (const char* name : {"a.xyz", "a.pcd", "a"}) CHECK_FALSE(canHoldMesh(name));
    CHECK_FALSE(canBeOpened("a.png"));
    CHECK_FALSE(canBeOpened("a"));
}

TEST_CASE("A folder is listed, folders first, one that cannot be read leaves the old list") {
    const test::OwnFolder own;
    const fs::path& folder = own.path();
    fs::create_directories(folder / "z");
    for (const char* name : {"b.pcd", "a.ply", "c.png", ".hidden.ply"})
        std::ofstream(folder / name);
    FileBrowsing browsing;
    browsing.readFolder(folder);
    const std::vector<BrowserEntry> expected = {{"z", true}, {"a.ply", false}, {"b.pcd", false}};
    CHECK(browsing.entries == expected);
    browsing.readFolder(folder / "missing");
    CHECK(browsing.error.find("missing") != std::string::npos);
    CHECK(browsing.folder == folder);
    CHECK(browsing.entries == expected);
}

TEST_CASE("The format of a saved mesh follows the name, and the name the format") {
    MeshForm form;
    CHECK(form.withFormat("/a/torus") == "/a/torus.ply");
    std::string name = "torus.obj";
    form.followName(name);
    CHECK(form.withFormat(name) == "torus.obj");
    CHECK(form.format == 1);
    form.choose(3, name);
    CHECK(name == "torus.stl");
    // An extension of no known format stays part of the name.
    name = "torus.v2";
    form.followName(name);
    CHECK(form.format == 3);
    form.choose(2, name);
    CHECK(name == "torus.v2");
    CHECK(form.withFormat(name) == "torus.v2.off");
    CHECK(form.withFormat("A.PLY") == "A.PLY");
}

TEST_CASE("A mesh is saved among the meshes of a folder: all formats that can be written") {
    for (const char* name : {"a.ply", "a.obj", "a.off", "a.stl", "A.GLB"}) {
        CAPTURE(name);
        CHECK(rowOf(BrowserTask::SaveMesh).lists(name));
    }
    CHECK_FALSE(rowOf(BrowserTask::SaveMesh).lists("a.xyz"));
    CHECK_FALSE(rowOf(BrowserTask::SaveMesh).lists("a"));
}

TEST_CASE("The dialog shows the size of the mesh, the notice the written file") {
    CHECK(sizeText(4, 6, 6) == "4 triangles, 6 points");
    CHECK(sizeText(4, 5, 6) == "4 triangles, 5 of 6 points");
    CHECK(sizeText(1, 3, 3) == "1 triangle, 3 points");
    CHECK(savedText({{"/a/b.ply", false}, 4, 6, false}) ==
          "Saved 4 triangles and 6 points to /a/b.ply.");
    CHECK(savedText({{"/a/b.stl", false}, 1, 6, false}) == "Saved 1 triangle to /a/b.stl.");
    CHECK(savedText({{"b.ply", false}, 4, 6, true}).find("rule cap") != std::string::npos);
}

TEST_CASE("Before the input itself is replaced, the question mentions that") {
    const fs::path path = test::ownPlace("replaced.ply");
    std::ofstream(path) << "x";
    CHECK(replaceText(path, path).find("is the input itself") != std::string::npos);
    CHECK(replaceText(path, "scene:torus") ==
          path.filename().string() + " exists already. Replace it?");
    fs::remove(path);
}
