#include "run/doctor_fixes.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "headless_app.h"
#include "point_files.h"
#include "run/strings.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/scenes/scenes.h"

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

PointFile sphereFile() { return findScene("sphere")->build(); }

/// A sphere with a copy of point 3 at the end, two zero normals, and a patch that points inwards.
PointFile flawed() {
    PointFile file = sphereFile();
    file.neighbors = {};
    file.normal[7] = file.normal[9] = Vec3(0.0);
    for (Vec3& normal : file.normal) {
        if (normal.z > 0.8) normal = -normal;
    }
    file.position.push_back(file.position[3]);
    file.normal.push_back(file.normal[3]);
    if (file.hasTypes()) file.type.push_back(file.type[3]);
    return file;
}

std::vector<std::string> names(const Diagnosis& diagnosis) {
    std::vector<std::string> list;
    for (const Finding& finding : diagnosis.findings) list.emplace_back(finding.check->name);
    return list;
}

/// A flawed sphere is open.
struct FixApp : test::HeadlessApp {
    std::string path;

    explicit FixApp(const std::string& name)
        : test::HeadlessApp(name), path((folder / "f.xyz").string()) {
        test::writePoints(path, flawed());
        document.open(path);
        waitUntilDone();
        REQUIRE(session.ready());
    }
    void follow(const std::vector<std::string>& fixes) {
        document.runWithFixes(fixes);
        waitUntilDone();
    }
    std::vector<std::string> findings() const {
        const auto found = session.doctorJob().findings();
        return names({{found.begin(), found.end()}, {}});
    }
    bool finds(const char* name) const {
        const auto found = findings();
        return std::find(found.begin(), found.end(), name) != found.end();
    }
};

}  // namespace

TEST_CASE("Each doctor check that has a fix here has a command as well") {
    for (const DoctorCheck& check : doctorChecks()) {
        CAPTURE(check.name);
        CHECK((!canFix(check) || !check.remedy().empty()));
        CHECK(canFix(check) == !fixText(check.fix).empty());
    }
}

TEST_CASE("Safe fixes are applied at once: repairs, and normals to be flipped") {
    const Result<Diagnosis> found = examine(flawed());
    REQUIRE(found);
    const std::vector<std::string> fixes = safeFixes(found.value().findings);
    REQUIRE(fixes.size() == 2);
    CHECK(findDoctorCheck(fixes[0])->fix == Fix::Repair);
    CHECK(findDoctorCheck(fixes[1])->fix == Fix::Orient);
    CHECK(safeFixes({}).empty());
}

TEST_CASE("A fix that does not exist, or a check without one, is refused") {
    for (const char* name : {"no_such_check", "ties"}) {
        PointFile file = sphereFile();
        CHECK_FALSE(fixInput(file, {name}));
    }
}

TEST_CASE("The input is opened again with its fixes, and unchanged without them") {
    FixApp app("cure-test");
    const std::size_t all = app.session.model().points.size();
    CHECK(app.finds("duplicates"));
    CHECK(app.finds("zero_normals"));
    CHECK(app.finds("flipped_normals"));
    CHECK(app.session.model().fixesDone.empty());

    app.follow(safeFixes(app.session.doctorJob().findings()));
    CHECK(app.session.input().spec().fixes.size() == 2);
    CHECK(app.findings().empty());
    CHECK(app.session.model().points.size() == all - 1);
    CHECK(app.session.model().fixesDone.size() == 3);  // copies, zero normals, flipped ones
    // The normals point outwards: the sphere is about the origin of its own box.
    for (std::size_t p = 0; p < app.session.model().points.size(); ++p)
        CHECK(glm::dot(app.session.model().normal[p], app.session.model().place[p]) > 0.0F);

    CHECK(app.session.atEnd());

    app.follow({});
    CHECK(app.session.model().points.size() == all);
    CHECK(app.finds("flipped_normals"));
    CHECK(app.session.model().fixesDone.empty());
}

TEST_CASE("Fixes that take most of the points are refused, and the open input stays") {
    FixApp app("fix-most-test");
    PointFile lines;  // Rays, far from each other: each point is in line with all of its nearest.
    for (int i = 0; i < 200; ++i) {
        lines.position.emplace_back(i % 50, 1000.0 * (i / 50), 0.0);
        lines.normal.emplace_back(0.0, 0.0, 1.0);
    }
    test::writePoints(app.path, lines);
    app.document.open(app.path);
    app.waitUntilDone();
    REQUIRE(app.finds("in_line"));
    app.follow({"in_line"});
    CHECK(app.session.input().error().find("would leave 0 of 200 distinct") != std::string::npos);
    CHECK(app.session.ready());
    CHECK(app.session.input().spec().fixes.empty());
    CHECK(app.session.model().points.size() == 200);
    PointFile file = lines;
    CHECK_FALSE(fixInput(file, {"non_finite", "in_line"}));
}

TEST_CASE("Bookmarks and notes stay when the input is repaired, and another input is not") {
    FixApp app("cure-notes-test");
    app.ui.notes = "kept";
    app.follow({"zero_normals"});
    CHECK(app.ui.notes == "kept");
    CHECK_FALSE(app.ui.leaving.asked);
    app.openInstead("scene:torus");
    CHECK(app.session.input().spec().fixes.empty());
    CHECK(app.session.model().fixesDone.empty());
}

TEST_CASE("A session keeps the fixes of its input") {
    FixApp app("cure-session-test");
    app.follow({"zero_normals", "flipped_normals"});
    app.document.saveAs((app.folder / "a.sesession").string());
    app.follow({});
    CHECK(app.finds("flipped_normals"));
    app.openInstead((app.folder / "a.sesession").string());
    CHECK(app.session.input().spec().fixes ==
          std::vector<std::string>{"zero_normals", "flipped_normals"});
    CHECK(app.findings().empty());
    const std::string text = *readText(app.folder / "a.sesession");
    CHECK(text.find("\"doctor\": [") != std::string::npos);
    for (const char* wrong : {"\"zero_normals\"", "[\"ties\"]", "[1]"}) {
        std::string broken = text;
        const auto from = broken.find("\"doctor\": ") + 10;
        broken.replace(from, broken.find(']', from) + 1 - from, wrong);
        const auto read = sessionFromJson(broken, "b", app.folder);
        REQUIRE_FALSE(read);
        CHECK(read.error().message.find("options.doctor") != std::string::npos);
    }
}

TEST_CASE("Undo restores the fixes, and selects no point of the other input") {
    FixApp app("cure-undo-test");
    app.session.select(5);
    const Edits before = captureEdits(app.context);
    app.follow({"zero_normals"});
    const Edits after = captureEdits(app.context);
    CHECK(after.selected.kind == SelectionKind::None);
    CHECK(describeChange(before, after) == "the doctor's fix");
    applyEdits(before, app.context);
    CHECK(app.session.selection().kind == SelectionKind::None);
    CHECK(app.session.input().opening().fixes.empty());
    app.waitUntilDone();
    CHECK(app.finds("zero_normals"));
}

TEST_CASE("A path is one word of a command line, with any characters") {
    CHECK(shellQuoted("/a/b-c_1.ply") == "/a/b-c_1.ply");
    CHECK(shellQuoted("/a b/c.ply") == "'/a b/c.ply'");
    CHECK(shellQuoted("it's") == "'it'\\''s'");
    CHECK(shellQuoted("a;b$c") == "'a;b$c'");
    CHECK(shellQuoted("") == "''");
    Finding copies;
    copies.check = findDoctorCheck("duplicates");
    CHECK(commandOf(copies, "'/IN x/OUT.ply'", "'y IN.ply'") ==
          "spiraling-edge doctor '/IN x/OUT.ply' --fix 'y IN.ply'");
}
