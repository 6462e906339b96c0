#include "panel_state/file_browser_state.h"
#include "open_session.h"
#include "session/session_file.h"

#include <doctest/doctest.h>

#include <fstream>

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
    for (const char* name : {"a.ply", "a.XYZ", "a.obj", "a.off", "a.pcd", "a.PCD", "a.txt",
                             "a.nrrd", "a.nhdr", "a.sesession"}) {
        CAPTURE(name);
        CHECK(canBeOpened(name));
    }
    for (const char* name : {"a.ply", "a.OBJ", "a.off"}) CHECK(canHoldMesh(name));
    for (const char* name : {"a.xyz", "a.pcd", "a.stl", "a"}) CHECK_FALSE(canHoldMesh(name));
    CHECK_FALSE(canBeOpened("a.png"));
    CHECK_FALSE(canBeOpened("a"));
}

TEST_CASE("A folder is listed, folders first; one that cannot be read leaves the old list") {
    const fs::path folder = test::ownPlace("browsing-test");
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
    fs::remove_all(folder);
}
