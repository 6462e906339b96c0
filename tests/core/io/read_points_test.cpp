#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/text_scan.h"
#include "support/io_support.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

const std::string kObj =
    "# a comment\n"
    "mtllib some.mtl\n"
    "v 0 0 0\n"
    "v 1 0 0 0.5 0.5 0.5\n"
    "v 1 1 0\n"
    "v 0 1 0 # the last\n"
    "vn 0 0 1\n"
    "vn 0 1 0\n"
    "f 1//1 2//1 3//2 4//1\n"
    "f -4//-2 -3//-2 -1//-1\n";

const std::string kOff =
    "NOFF # with normals\n4 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 1 0\n"
    "\n0 1 0 0 0 1\n4 0 1 2 3 255 0 0\n";

bool parses(std::string_view field, double& value) {
    double other = 0.0;
    const bool good = io::parseDouble(field, value);
    CHECK(io::parseDoubleByStrtod(field, other) ==
          good);  // the code path of libraries without from_chars
    if (good) CHECK(sameNumber(value, other));
    return good;
}

}  // namespace

TEST_CASE("Text: numbers are read in full or not at all") {
    double value = 0.0;
    const std::pair<const char*, double> good[] = {{"1", 1},
                                                   {"-1.5", -1.5},
                                                   {"+2", 2},
                                                   {".5", .5},
                                                   {"5.", 5},
                                                   {"1e3", 1000},
                                                   {"1E-3", 1e-3},
                                                   {"-0", -0.0},
                                                   {"1e+2", 100},
                                                   {"0.1", 0.1},
                                                   {"1e-400", 0},
                                                   {"5e-324", 5e-324},
                                                   {"007", 7},
                                                   {"+.25e1", 2.5},
                                                   {"-INF", -HUGE_VAL},
                                                   {"1e999", HUGE_VAL},
                                                   {"-1e999", -HUGE_VAL}};
    for (const auto& [field, expected] : good) {
        INFO(field);
        CHECK(parses(field, value));
        CHECK(sameNumber(value, expected));
    }
    CHECK(parses("NaN", value));
    CHECK(std::isnan(value));
    for (const char* field : {"", "+", "-", ".", "e5", "1e", "1,5", "0x10", "1f", "--1", "+-1",
                              "-+1", "1.2.3", "in", "nano", "infinit", "1 ", " 1"}) {
        INFO(field);
        CHECK_FALSE(parses(field, value));
    }
}

TEST_CASE("Text: numbers written with 17 digits read back the same") {
    std::uint64_t bits = 88172645463325252U;
    for (int i = 0; i < 2000; ++i) {
        bits ^= bits << 13U, bits ^= bits >> 7U, bits ^= bits << 17U;
        double number = 0.0;
        std::memcpy(&number, &bits, sizeof number);
        if (!std::isfinite(number)) continue;
        char field[40];
        std::snprintf(field, sizeof field, "%.17g", number);
        double value = 0.0;
        CHECK(parses(field, value));
        CHECK(sameNumber(value, number));
    }
}

TEST_CASE("XYZ: points with and without normals") {
    const PointFile plain = mustRead("# x y z\n0 0 0\n\n 1\t2 3 # the second\r\n4,5,6");
    CHECK(plain.position == std::vector<Vec3>{{0, 0, 0}, {1, 2, 3}, {4, 5, 6}});
    CHECK_FALSE(plain.hasNormals());
    CHECK(plain.positionType == ScalarType::Double);
    const PointFile full = mustRead(
        "\xef\xbb\xbf"
        "0, 0, 0, 0, 0, 1\nnan 2 3 0 -1 0\n");
    CHECK(full.normal == std::vector<Vec3>{{0, 0, 1}, {0, -1, 0}});
    CHECK(std::isnan(full.position[1].x));
}

TEST_CASE("XYZ: what is wrong is named with its line") {
    CHECK(contains(errorOf("5\n1 2 3\n", "a.xyz"),
                   "a.xyz: line 1: announces 5 points, but 1 follow"));
    CHECK(contains(errorOf("1 2 3\n1 2 3 4\n"), "line 2: expected 3 numbers"));
    CHECK(contains(errorOf("1 2 3\n#\n1 2 3 0 0 1\n"), "line 3: expected 3 numbers as in"));
    CHECK(contains(errorOf("1 2 3\n1 2 z\n"), "line 2: expected a number, found \"z\""));
    CHECK(contains(errorOf("1 2 3 4 5 6 7 8 9\n"), "found 9"));
}

TEST_CASE("XYZ: a file cut at any byte gives whole rows or an error") {
    const std::string text = "1 2 3\n4 5 6\n";
    for (std::size_t size = 1; size < text.size(); ++size) {
        const Result<PointFile> cut = readPoints(text.substr(0, size), "cut");
        CHECK(cut.ok() == (size == 5 || size == 6 || size == 11));
    }
}

TEST_CASE("OBJ: points, faces and the normals that faces refer to") {
    const PointFile file = mustRead(kObj);
    CHECK(file.position.size() == 4);
    CHECK(file.position[3] == Vec3(0, 1, 0));
    CHECK(file.faces == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}});
    REQUIRE(file.normal.size() == 4);
    CHECK(file.normal[0] == Vec3(0, 0, 1));
    CHECK(file.normal[1] == Vec3(0, 0, 1));
    CHECK(file.normal[2] == Vec3(0, 1, 0));
    // Two faces assign different ones: their mean.
    CHECK(glm::distance(file.normal[3], glm::normalize(Vec3(0, 1, 1))) < 1e-12);
}

TEST_CASE("OBJ: as many normals as points belong to them in order, fewer to none") {
    CHECK(mustRead("v 0 0 0\nv 1 0 0\nvn 0 0 1\nvn 0 1 0\n").normal ==
          std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}});
    CHECK_FALSE(mustRead("v 0 0 0\nv 1 0 0\nvn 0 0 1\n").hasNormals());
    // A point in no face, and faces that assign the others in another order.
    const std::string loose =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn 1 0 0\n";
    CHECK(mustRead(loose + "f 1//1 2//2 3//3\n").normal[1] == Vec3(0, 1, 0));
    const PointFile turned = mustRead(loose + "f 1//3 2//2 3//1\n");
    CHECK_FALSE(turned.hasNormals());
    CHECK(turned.notes == std::vector<std::string>{"left out: normals, which not every point has"});
    CHECK_FALSE(mustRead(replaced(kObj, "f -4//-2 -3//-2 -1//-1\n", "v 2 2 2\n")).hasNormals());
}

TEST_CASE("OBJ: points with several normals take their mean, and are counted in a note") {
    // Points 1 and 2 lie on the edge of two faces; the third normal is the first one again.
    const std::string text = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nvn 0 0 1\nvn 1 0 0\nvn 0 0 2\n";
    const PointFile hard = mustRead(text + "f 1//1 3//3 2//1\nf 1//2 2//2 4//2\n");
    CHECK(hard.notes ==
          std::vector<std::string>{"2 places with several normals: the mean of them is used"});
    CHECK(glm::distance(hard.normal[0], glm::normalize(Vec3(1, 0, 1))) < 1e-12);
    const PointFile soft = mustRead(text + "f 1//1 3//3 2//1\nf 1//3 2//1 4//2\n");
    CHECK(soft.notes.empty());
}

TEST_CASE("OBJ: texture coordinates in faces are passed over, and faces may come first") {
    const PointFile file = mustRead(
        "f 1/9 2/8 3/7\nf 1/1/1 2/2/1 3/3/1\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
        "vn 0 0 1\n");
    CHECK(file.faces.size() == 2);
    CHECK(file.normal == std::vector<Vec3>(3, Vec3(0, 0, 1)));
    for (const char* face : {"f 1// 2// 3//\n", "f 1/7/ 2/8/ 3/9/\n", "f 1/ 2/ 3/\n"})
        CHECK(mustRead(std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + face).faces.size() == 1);
}

TEST_CASE("OBJ: by extension it may begin with any statement") {
    const PointFile file = mustRead("deg 3 3\nv 1 2 3\n", "a.obj");
    CHECK(file.position[0] == Vec3(1, 2, 3));
    CHECK(file.notes == std::vector<std::string>{"left out: statements deg"});
    CHECK(contains(errorOf("BZh91AY...", "a.obj"), "bunzip2"));
    CHECK(mustRead("1 2 3\n", "a.obj").position.size() == 1);
}

TEST_CASE("OBJ: what is wrong is named with its line") {
    const auto error = [](std::string_view from, std::string_view to) {
        return errorOf(replaced(kObj, from, to));
    };
    CHECK(contains(error("v 1 1 0", "v 1 1"), "line 5: expected three numbers, found \"\""));
    CHECK(contains(error("v 1 1 0", "v 1 1 O"), "line 5"));
    CHECK(contains(error("4//1\n", "5//1\n"), "line 9: refers to number 5 of 4 vertices"));
    CHECK(contains(error("4//1\n", "4//3\n"), "line 9: refers to number 3 of 2 normals"));
    CHECK(contains(error("4//1\n", "0//1\n"), "line 9: expected a reference"));
    CHECK(contains(error("f -4", "f -5"), "line 10: expected a reference"));
    CHECK(contains(error("f -4", "f x"), "line 10: expected a reference"));
    CHECK(contains(error("f -4", "f 99999999999999999999"), "line 10: expected a reference"));
    CHECK(contains(error("f -4//-2 -3//-2", "f"), "three corners or more, found 1"));
    CHECK(contains(errorOf("o nothing\n"), "holds no points"));
}

TEST_CASE("OBJ: a file cut at any byte never gives more than was there") {
    for (std::size_t size = 0; size < kObj.size(); ++size) {
        const Result<PointFile> cut = readPoints(kObj.substr(0, size), "cut.obj");
        CHECK((!cut.ok() || cut.value().position.size() <= 4));
    }
}

TEST_CASE("OFF: points, normals, polygons with colors") {
    const PointFile file = mustRead(kOff);
    CHECK(file.position.size() == 4);
    CHECK(file.normal.at(2) == Vec3(0, 1, 0));
    CHECK(file.faces == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("OFF: counts may follow the keyword, and by extension the keyword may be missing") {
    const char* const body = "1 0 0\n1 2 3\n";
    CHECK(mustRead(std::string("OFF ") + body).position.at(0) == Vec3(1, 2, 3));
    CHECK(mustRead(body, "a.OFF").position.size() == 1);
    CHECK(mustRead(body, "a.xyz").position.size() == 2);
    CHECK(mustRead("COFF\n1 0 0\n1 2 3 255 0 0 255\n").position.size() == 1);
    CHECK(mustRead("STCNOFF\n1 0 0\n1 2 3 0 0 1 255 0 0 1 0.5 0.5\n").hasNormals());
}

TEST_CASE("OFF: prefixes come in any order, and MeshLab writes colors before normals after NCOFF") {
    CHECK(mustRead("off\n1 0 0\n1 2 3\n").position.size() == 1);
    CHECK(mustRead("CSTOFF\n1 0 0\n1 2 3 10 20 30 255 0.5 0.5\n").attributes.size() == 3);
    const PointFile file = mustRead("NCOFF\n1 0 0\n1 2 3 10 20 30 255 0 0.6 0.8\n");
    CHECK(file.normal[0] == Vec3(0, 0.6, 0.8));
    CHECK(file.attributes[2].values == std::vector<double>{30});
    CHECK(mustRead("NCSTOFF\n1 0 0\n1 2 3 10 20 30 255 0 0.6 0.8 0.5 0.5\n").hasNormals());
    CHECK(mustRead("CNOFF\n1 0 0\n1 2 3 0 0.6 0.8 10 20 30 255\n").normal[0] == file.normal[0]);
    CHECK(contains(errorOf("NCOFF\n1 0 0\n1 2 3 0 0.6 0.8 10 20 30 255\n"),
                   "line 3: expected a color of four whole numbers"));
    for (const char* keyword : {"4OFF", "nOFF", "STN4OFF", "noff"})
        CHECK(contains(errorOf(std::string(keyword) + "\n1 0 0\n1 2 3\n"), "OFF of the kind"));
}

TEST_CASE("OFF: a file cut at any byte is refused") {
    checkAllPrefixes("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    checkAllPrefixes(kOff.substr(0, kOff.find(" 255")));
}

TEST_CASE("OFF: what is wrong is named with its line") {
    const auto error = [](std::string_view from, std::string_view to) {
        return errorOf(replaced(kOff, from, to));
    };
    CHECK(contains(error("4 1 0", "5 1 0"), "line 8: the line holds more"));
    CHECK(contains(error("4 1 0", "3 1 0"), "line 8: the file goes on"));
    CHECK(contains(error("4 1 0", "4 2 0"), "line 8: the file ends after 1 of 2 faces"));
    CHECK(contains(error("4 1 0", "4 0 0"), "line 8: the file goes on"));
    CHECK(contains(error("4 1 0", "4 -1 0"), "line 2: expected the numbers of points"));
    CHECK(contains(error("4 1 0", "99999999999 1 0"), "line 2"));
    CHECK(contains(error("4 1 0", "4294967294 1 0"), "line 8"));
    CHECK(contains(error("4 0 1", "4 4 1"), "line 8: expected a point number from 0 to below 4"));
    CHECK(contains(error("4 0 1", "999999999999 0 1"), "line 8"));
    CHECK(contains(error("4 0 1", "-4 0 1"), "line 8"));
    CHECK(contains(error("NOFF", "OFF"), "the line holds more numbers"));
    CHECK(contains(errorOf("OFF BINARY\n"), "binary OFF cannot be read"));
}

TEST_CASE("Files: what is none of the known kinds is refused with a list of those that are") {
    for (const char* bytes : {"solid cube\n", "hello", "ply", "\n\n", "#\n", "\xef\xbb\xbf"}) {
        const std::string error = errorOf(bytes, "x.bin");
        CHECK(contains(error, "x.bin: is of no known kind. PLY"));
        CHECK(contains(error, "OBJ, OFF and PCD can be read; convert it"));
        for (const PointFormat& format : pointFormats()) CHECK(contains(error, format.details));
    }
    CHECK(contains(errorOf(std::string(100, '\0')), "no known kind"));
}

TEST_CASE("Files: missing, empty and folders have their own errors") {
    const TemporaryFolder folder;
    CHECK(contains(readPoints(folder / "none").error().message, "there is no such file"));
    CHECK(contains(readPoints(folder / "").error().message, "is a folder"));
    REQUIRE(writeFileAtomically(folder / "empty", "").ok());
    CHECK(contains(readPoints(folder / "empty").error().message, "is empty"));
}

TEST_CASE("Files: the content counts, not the extension") {
    CHECK(mustRead("1 2 3\n", "a.ply").position.size() == 1);
    CHECK(mustRead(kOff, "a.obj").position.size() == 4);
    CHECK(mustRead(kObj, "a").position.size() == 4);
}

TEST_CASE("Files: the shared text files hold the points of their PLY") {
    if (sharedFile("formats/ascii.ply").empty()) return;
    const PointFile ply = readPoints(sharedFile("formats/ascii.ply")).value();
    const std::pair<const char*, bool> files[] = {{"formats/points.xyz", false},
                                                  {"formats/points_normals.xyz", true},
                                                  {"formats/mesh.off", false},
                                                  {"formats/mesh.obj", true}};
    for (const auto& [name, hasNormals] : files) {
        const Result<PointFile> file = readPoints(sharedFile(name));
        REQUIRE_MESSAGE(file.ok(), file.error().message);
        CHECK(file.value().hasNormals() == hasNormals);
        REQUIRE(file.value().position.size() == ply.position.size());
        for (std::size_t i = 0; i < ply.position.size(); ++i) {
            CHECK(glm::distance(file.value().position[i], ply.position[i]) < 1e-6);
        }
    }
    CHECK(readPoints(sharedFile("formats/mesh.off")).value().faces ==
          readPoints(sharedFile("formats/mesh.obj")).value().faces);
}

TEST_CASE("Formats of points: found by each of their extensions, in upper or lower case") {
    for (const PointFormat& format : pointFormats()) {
        REQUIRE_FALSE(format.extensions.empty());
        for (const std::string_view extension : format.extensions) {
            CAPTURE(extension);
            CHECK(pointFormatOf("folder/a" + std::string(extension)) == &format);
        }
    }
    CHECK(pointFormatOf("A.Xyz")->name == "XYZ");
    CHECK(pointFormatOf("a.ply.gz")->name == "PLY");
    for (const char* other : {"a.png", "a.gltf", "a", "ply", ""}) {
        CAPTURE(other);
        CHECK(pointFormatOf(other) == nullptr);
    }
}
