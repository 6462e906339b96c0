#include "panel_state/mesh_form.h"

#include <doctest/doctest.h>

#include <fstream>

#include "open_session.h"
#include "panel_state/file_browser_state.h"

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

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
        CHECK(isListed(name, BrowserTask::SaveMesh));
    }
    CHECK_FALSE(isListed("a.xyz", BrowserTask::SaveMesh));
    CHECK_FALSE(isListed("a", BrowserTask::SaveMesh));
}

TEST_CASE("The dialog shows the size of the mesh, the notice the written file") {
    CHECK(sizeText({4, 6, 5, false}, false) == "4 triangles, 6 points");
    CHECK(sizeText({4, 6, 5, false}, true) == "4 triangles, 5 of 6 points");
    CHECK(sizeText({1, 3, 3, false}, true) == "1 triangle, 3 points");
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
