#include "run/doctor_fixes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

#include "headless_app.h"
#include "run/strings.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/scenes/scenes.h"

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

PointFile sphere() { return findScene("sphere")->build(); }

/// With a copy of point 3 at the end, two zero normals, and a patch that points inwards.
PointFile flawed() {
    PointFile file = sphere();
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
    for (const Finding& finding : diagnosis) list.emplace_back(finding.check->name);
    return list;
}

void write(const fs::path& path, const PointFile& file) {
    std::ofstream out(path);
    out.precision(17);
    for (std::size_t p = 0; p < file.position.size(); ++p) {
        const Vec3& x = file.position[p];
        const Vec3& n = file.normal[p];
        out << x.x << ' ' << x.y << ' ' << x.z << ' ' << n.x << ' ' << n.y << ' ' << n.z << '\n';
    }
}

/// A flawed sphere is open.
struct CureDesk : test::Desk {
    std::string path;

    explicit CureDesk(const std::string& name)
        : test::Desk(name), path((folder / "f.xyz").string()) {
        write(path, flawed());
        filing.open(path);
        settle();
        REQUIRE(session.ready());
    }
    void follow(const Cures& cures) {
        ui.requests.cures = cures;
        filing.carryOut(ui.requests);
        settle();
    }
    std::vector<std::string> findings() const {
        const auto found = session.checkup().findings();
        return names({found.begin(), found.end()});
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
        CHECK((!canCure(check) || !check.remedy.empty()));
        CHECK(canCure(check) == !cureText(check.cure).empty());
    }
}

TEST_CASE("Safe fixes are applied at once: repairs, and normals to be flipped") {
    const Result<Diagnosis> found = examine(flawed());
    REQUIRE(found);
    const Cures cures = plainCures(found.value());
    REQUIRE(cures.size() == 2);
    CHECK(findDoctorCheck(cures[0])->cure == Cure::Mend);
    CHECK(findDoctorCheck(cures[1])->cure == Cure::Orient);
    CHECK(plainCures({}).empty());
}

TEST_CASE("A fix that does not exist, or a check without one, is refused") {
    for (const char* name : {"no_such_check", "ties"}) {
        PointFile file = sphere();
        PrepareOptions options;
        CHECK_FALSE(cure(file, {name}, options));
    }
}

TEST_CASE("The input is opened again with its fixes, and unchanged without them") {
    CureDesk desk("cure-test");
    const std::size_t all = desk.session.model().points.size();
    CHECK(desk.finds("duplicates"));
    CHECK(desk.finds("zero_normals"));
    CHECK(desk.finds("flipped_normals"));
    CHECK(desk.session.model().mended.empty());

    desk.follow(plainCures(desk.session.checkup().findings()));
    CHECK(desk.session.spec().cures.size() == 2);
    CHECK(desk.findings().empty());
    CHECK(desk.session.model().points.size() == all - 3);
    CHECK(desk.session.model().mended.size() == 3);  // copies, zero normals, flipped ones
    // The normals point outwards: the sphere is about the origin of its own box.
    for (std::size_t p = 0; p < desk.session.model().points.size(); ++p)
        CHECK(glm::dot(desk.session.model().normal[p], desk.session.model().place[p]) > 0.0F);

    desk.follow({});
    CHECK(desk.session.model().points.size() == all);
    CHECK(desk.finds("flipped_normals"));
    CHECK(desk.session.model().mended.empty());
}

TEST_CASE("Bookmarks and notes stay when the input is repaired, and another input is not") {
    CureDesk desk("cure-notes-test");
    desk.ui.notes = "kept";
    desk.follow({"zero_normals"});
    CHECK(desk.ui.notes == "kept");
    CHECK_FALSE(desk.ui.leaving.asked);
    desk.filing.open("scene:torus");
    desk.settle();
    CHECK(desk.session.spec().cures.empty());
    CHECK(desk.session.model().mended.empty());
}

TEST_CASE("A session keeps the fixes of its input") {
    CureDesk desk("cure-session-test");
    desk.follow({"zero_normals", "flipped_normals"});
    desk.ui.requests.saveSessionAs = (desk.folder / "a.sesession").string();
    desk.filing.carryOut(desk.ui.requests);
    desk.follow({});
    CHECK(desk.finds("flipped_normals"));
    desk.filing.open((desk.folder / "a.sesession").string());
    desk.settle();
    CHECK(desk.session.spec().cures == Cures{"zero_normals", "flipped_normals"});
    CHECK(desk.findings().empty());
    const std::string text = *readText(desk.folder / "a.sesession");
    CHECK(text.find("\"doctor\": [") != std::string::npos);
    for (const char* wrong : {"\"zero_normals\"", "[\"ties\"]", "[1]"}) {
        std::string broken = text;
        const auto from = broken.find("\"doctor\": ") + 10;
        broken.replace(from, broken.find(']', from) + 1 - from, wrong);
        const auto read = sessionFromJson(broken, "b", desk.folder);
        REQUIRE_FALSE(read);
        CHECK(read.error().message.find("options.doctor") != std::string::npos);
    }
}

TEST_CASE("Undo restores the fixes, and selects no point of the other input") {
    CureDesk desk("cure-undo-test");
    desk.session.select(5);
    const Edits before = captureEdits(desk.context);
    desk.follow({"zero_normals"});
    const Edits after = captureEdits(desk.context);
    CHECK(after.selected.kind == SelectionKind::None);
    CHECK(describeChange(before, after) == "the doctor's fix");
    applyEdits(before, desk.context);
    CHECK(desk.session.selection().kind == SelectionKind::None);
    REQUIRE(desk.ui.requests.cures);
    CHECK(desk.ui.requests.cures->empty());
    desk.filing.carryOut(desk.ui.requests);
    desk.settle();
    CHECK(desk.finds("zero_normals"));
}

TEST_CASE("A path is one word of a command line, with any characters") {
    CHECK(shellQuoted("/a/b-c_1.ply") == "/a/b-c_1.ply");
    CHECK(shellQuoted("/a b/c.ply") == "'/a b/c.ply'");
    CHECK(shellQuoted("it's") == "'it'\\''s'");
    CHECK(shellQuoted("a;b$c") == "'a;b$c'");
    CHECK(shellQuoted("") == "''");
    const DoctorCheck& check = *findDoctorCheck("duplicates");
    CHECK(remedyFor(check, "'/IN x/OUT.ply'", "'y IN.ply'") ==
          "spiraling-edge doctor '/IN x/OUT.ply' --fix 'y IN.ply'");
}
