// Files of other programs beyond a format's letter: the rest is read, kept, or reported as left
// out.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/io_support.h"

using namespace se;
using namespace se::test;

namespace {

bool notes(const PointFile& file, const std::string& words) {
    return std::any_of(file.notes.begin(), file.notes.end(),
                       [&](const std::string& note) { return contains(note, words); });
}

const std::vector<double>& column(const PointFile& file, const std::string& name) {
    const auto found = std::find_if(file.attributes.begin(), file.attributes.end(),
                                    [&](const Attribute& each) { return each.name == name; });
    REQUIRE(found != file.attributes.end());
    return found->values;
}

/// The bytes of a number in little endian order.
template <typename Number>
std::string rawBytes(Number number) {
    std::string bytes(sizeof(Number), '\0');
    std::memcpy(bytes.data(), &number, sizeof(Number));
    if (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

std::string inUtf16(const std::string& ascii, bool big) {
    std::string bytes = big ? "\xfe\xff" : "\xff\xfe";
    for (const char c : ascii) bytes += big ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
}

/// A LAS file of version 1.2 with two points of format 2, in steps of 0.01 from 500000.
std::string lasOfTwo() {
    std::string bytes(227, '\0');
    const auto put = [&](std::size_t at, const std::string& value) {
        bytes.replace(at, value.size(), value);
    };
    put(0, "LASF");
    put(24, std::string{1, 2});
    put(94, rawBytes(std::uint16_t{227}));
    put(96, rawBytes(std::uint32_t{227}));
    put(104, std::string{2});
    put(105, rawBytes(std::uint16_t{26}));
    put(107, rawBytes(std::uint32_t{2}));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        put(131 + 8 * axis, rawBytes(0.01));
        put(155 + 8 * axis, rawBytes(500000.0));
    }
    for (const std::int32_t x : {100, -250}) {
        bytes += rawBytes(x) + rawBytes(std::int32_t{7}) + rawBytes(std::int32_t{0});
        bytes += rawBytes(std::uint16_t{900}) + std::string{0, 6, 0, 0, 0, 0};
        for (const int color : {65280, 256, 0})
            bytes += rawBytes(static_cast<std::uint16_t>(color));
    }
    return bytes;
}

}  // namespace

TEST_CASE("Text: UTF-16 and line ends of CR alone are read") {
    const std::string text = "1 2 3\n4 5 6\n";
    for (const bool big : {false, true})
        CHECK(mustRead(inUtf16(text, big), "a.xyz").position == mustRead(text).position);
    CHECK(mustRead(inUtf16("1 2 3\r4 5 6\r", false)).position == mustRead(text).position);
    CHECK(mustRead("1 2 3\r4 5 6\r").position == mustRead(text).position);
    CHECK(mustRead("# x y z\r1 2 3\r").position.size() == 1);
}

TEST_CASE("Text: what older programs of Windows write for no number is none") {
    for (const char* word : {"1.#QNAN", "-1.#IND", "1.#QNAN0", "-1.#IND00", "1.#SNAN"}) {
        CAPTURE(word);
        const PointFile file = mustRead(std::string("0 0 0\n") + word + " 2 3\n");
        CHECK(std::isnan(file.position[1].x));
        CHECK(file.position[1].y == 2.0);
    }
    CHECK(std::isinf(mustRead("0 0 0\n1.#INF 2 3 # and a comment\n").position[1].x));
    CHECK(contains(errorOf("0 0 0\n1.#XYZ 2 3\n"), "line 2: expected a number"));
}

TEST_CASE("XYZ: a line of one whole number is the number of points, and must be it") {
    const PointFile file = mustRead("2\n1 2 3\n4 5 6\n");
    CHECK(file.position == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
    CHECK(notes(file, "line 1 is the number of points"));
    // One count per block, as several scans in one PTS file have.
    CHECK(mustRead("1\n1 2 3\n2\n4 5 6\n7 8 9\n").position.size() == 3);
    CHECK(mustRead("3 0 0\n1 2 3.5\n4 5 6\n7 8 9\n").position.size() == 3);
    CHECK(mustRead("3 0 0\n1 2 3 0 0 1\n4 5 6 0 0 1\n7 8 9 0 1 0\n").position.size() == 3);
    // The sizes of a grid, or count and columns, before rows of which none is whole.
    std::string rows;
    for (int i = 0; i < 12; ++i) rows += std::to_string(i) + " 0.5 1\n";
    CHECK(notes(mustRead("4 3 1\n" + rows), "line 1 is the size of a grid"));
    CHECK(notes(mustRead("12 3 1\n" + rows), "line 1 begins with the number of points"));
    CHECK(mustRead("4 3 1\n" + rows).position.size() == 12);
    CHECK(mustRead("4 3 2\n" + rows).position.size() == 13);
    CHECK(mustRead("4 3 1\n" + replaced(rows, "7 0.5 1", "7 5 1")).position.size() == 13);
    CHECK(mustRead("1 2 1\n0.5 1 1\n1.5 1 1\n").position.size() == 3);
    // Points on a grid are not taken for counts.
    CHECK(mustRead("3 0 0\n2 0 0\n1 0 0\n0 0 0\n").position.size() == 4);
    CHECK(contains(errorOf("3\n1 2 3\n4 5 6\n"), "line 1: announces 3 points, but 2 follow"));
    CHECK(contains(errorOf("1\n1 2 3\n4 5 6\n"), "line 1: announces 1 points, but 2 follow"));
}

TEST_CASE("XYZ: a first row of names is a header, with any separator and quotation marks") {
    for (const char* header :
         {"x,y,z,nx,ny,nz", "\"X\";\"Y\";\"Z\";\"NX\";\"NY\";\"NZ\"", "x\ty\tz\tnx\tny\tnz",
          "X Y Z Nx Ny Nz", "Points:0,Points:1,Points:2,Normals:0,Normals:1,Normals:2",
          "\"Points_0\",\"Points_1\",\"Points_2\",\"Normals_0\",\"Normals_1\",\"Normals_2\"",
          "pos_x;pos_y;pos_z;n_x;n_y;n_z", "X_coord,Y_coord,Z_coord,normal.x,normal.y,normal.z"}) {
        CAPTURE(header);
        const PointFile file = mustRead(std::string(header) + "\n1 2 3 0 0 1\n", "a.csv");
        CHECK(file.position[0] == Vec3(1, 2, 3));
        REQUIRE(file.hasNormals());
        CHECK(file.normal[0] == Vec3(0, 0, 1));
    }
    const PointFile file = mustRead("id,x,y,z,\"Scalar field\"\n9,1,2,3,0.5\n");
    CHECK(file.position[0] == Vec3(1, 2, 3));
    CHECK(column(file, "Scalar_field") == std::vector<double>{0.5});
    CHECK(contains(errorOf("x,y,z,w\n1,2,3\n"), "line 2: found 3 numbers, but line 1 names 4"));
    CHECK(contains(errorOf("a,b,c\n1,2,3\n", "a.csv"), "names of columns with x, y and z"));
    CHECK(mustRead("X [m],Y [m],Z [m]\n1,2,3\n").position[0] == Vec3(1, 2, 3));
    for (const char* names :
         {"Easting (m),Northing (m),Elev (m)", "E,N,H", "lon [deg],lat [deg],h"})
        CHECK(mustRead(names + std::string("\n1,2,3\n"), "a.csv").position[0] == Vec3(1, 2, 3));
    CHECK(mustRead("lat,lon,alt,h\n2,1,3,4\n").columns.names == "y x z h");
    CHECK(mustRead("\"x\",\"y\",\"z\"\n\"1\",\"2\",\"3\"\n").position[0] == Vec3(1, 2, 3));
    CHECK(mustRead("\"x\";\"y\";\"z\"\n\"1,5\";\"2,5\";\"3,5\"\n").position[0] ==
          Vec3(1.5, 2.5, 3.5));
    // Names of maps, in any order; beside x, y and z a height is a column of its own.
    CHECK(mustRead("lat,lon,height\n48,11,520\n").position[0] == Vec3(11, 48, 520));
    CHECK(mustRead("Easting Northing Elevation\n1 2 3\n").position[0] == Vec3(1, 2, 3));
    CHECK(column(mustRead("x,y,z,height\n1,2,3,4\n"), "height") == std::vector<double>{4});
    CHECK(contains(errorOf("lat,lat,height\n1,2,3\n", "a.csv"), "names of columns"));
    CHECK(contains(errorOf("x,y,z,i\n0,0,0,1\n0,0,,1\n"), "line 3: expected a number between"));
}

TEST_CASE("XYZ: a last row that is cut to one digit is no count") {
    CHECK(contains(errorOf("0.5 0 0\n1 0 0\n0.25 1 0\n0"), "line 4: expected 3 numbers"));
    CHECK(contains(errorOf("0.5 0 0\n1 0 0\n0.25 1 0\n3"), "line 4: expected 3 numbers"));
}

TEST_CASE("XYZ: seven columns after a count are those of PTS files") {
    const PointFile file = mustRead("2\n0.5 0 0 7 10 20 30\n1 0 0 9 40 50 60\n", "a.pts");
    CHECK(column(file, "intensity") == std::vector<double>{7, 9});
    CHECK(column(file, "red") == std::vector<double>{10, 40});
}

TEST_CASE("XYZ: line ends of two kinds are refused") {
    CHECK(contains(errorOf("0.5 0 0\r0.1 0.2 -0.9\n"), "line ends of two kinds"));
    CHECK(mustRead("0.5 0 0\r\n0.1 0.2 -0.9\r\n").position.size() == 2);
}

TEST_CASE("PTX: each scan is moved by its matrix, and places without a return are not numbers") {
    const std::string scan =
        "2\n1\n5 6 7\n1 0 0\n0 1 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n5 6 7 1\n"
        "1 2 3 0.5\n0 0 0 0\n";
    const PointFile file = mustRead(scan, "a.ptx");
    REQUIRE(file.position.size() == 2);
    // (1, 2, 3) times a quarter turn about z, moved by (5, 6, 7).
    CHECK(file.position[0] == Vec3(3, 7, 10));
    CHECK(std::isnan(file.position[1].x));
    CHECK(column(file, "intensity")[0] == 0.5);
    REQUIRE(file.viewpoint);
    CHECK(*file.viewpoint == Vec3(5, 6, 7));
    const PointFile two = mustRead(scan + scan, "a.ptx");
    CHECK(two.position.size() == 4);
    CHECK_FALSE(two.viewpoint);
    CHECK(notes(two, "left out: the places of the scanners"));
    for (std::size_t size = 1; size + 9 < scan.size(); ++size)
        CHECK_FALSE(readPoints(scan.substr(0, size), "cut").ok());
    CHECK(contains(errorOf(replaced(scan, "2\n1\n", "4000000000\n4000000000\n")), "too short"));
    CHECK_FALSE(mustRead(replaced(scan, "5 6 7\n1 0 0\n", "1e400 6 7\n1 0 0\n"), "a").viewpoint);
    CHECK(contains(errorOf(replaced(scan, "0 1 0 0\n-1", "0 1 0 5\n-1")),
                   "line 7: expected 0 0 0 1"));
    CHECK(contains(errorOf(replaced(scan, "5 6 7 1\n", "5 6 7 2\n")), "line 10: expected 0 0 0 1"));
    for (const char* row : {"1 2 x 0.5", "1 2 3 ", "1,5 2 3 0.5"})
        CHECK(contains(errorOf(replaced(scan, "1 2 3 0.5", row)), "line 11: expected x y z"));
}

TEST_CASE("OFF: the first count may be glued to the keyword, and rows go on in the next line") {
    CHECK(mustRead("OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").faces.size() == 1);
    const PointFile broken = mustRead("OFF\n3 1 0\n0 0\n0\n1 0 0\n0 1 0\n3 0\n1 2\n");
    CHECK(broken.position[0] == Vec3(0, 0, 0));
    CHECK(broken.faces == std::vector<Triangle>{{0, 1, 2}});
    CHECK(contains(errorOf("OFF\n3 0 0\n0 0\n1 0 0\n0 1 0\n"), "line 3: expected more numbers"));
}

TEST_CASE("OBJ and OFF: colors of points are kept from 0 to 255") {
    const PointFile obj = mustRead("v 0 0 0 0 0.5 1\nv 1 0 0 1 1 1\nvt 0 0\n");
    CHECK(column(obj, "green") == std::vector<double>{128, 255});
    CHECK(notes(obj, "left out: texture coordinates"));
    CHECK(notes(mustRead("v 0 0 0\nv 1 0 0\nvn 0 0 1\n"), "left out: normals"));
    const PointFile off = mustRead("COFF\n2 0 0\n0 0 0 10 20 30 255\n1 0 0 40 50 60 255\n");
    CHECK(column(off, "blue") == std::vector<double>{30, 60});
    CHECK(notes(off, "left out: transparency"));
    CHECK_FALSE(notes(mustRead("COFF\n1 0 0\n0 0 0 10 20 30\n"), "transparency"));
    CHECK(column(mustRead("v 0 0 0 nan 0 1\nv 1 0 0 1 1 1\n"), "blue") ==
          std::vector<double>{0, 255});
    CHECK(notes(mustRead("v 0 0 0 1 0 0\nv 1 0 0\n"), "without those of 1 point"));
    CHECK(notes(mustRead("v 0 0 0 -1 0 0\n"), "left out: colors"));
    CHECK(mustRead("v 0 0 0 1\n").attributes.empty());
    CHECK(mustRead("v 0 0 0 1\n").notes.empty());
    CHECK(notes(mustRead("v 0 0 0 2\n"), "left out: weights of points"));
    CHECK(notes(mustRead("v 0 0 0 0.1 0.2 0.3 0.5\n"), "left out: transparency"));
}

TEST_CASE("OBJ: colors in comments of ZBrush are kept, if there is one for each point") {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const PointFile file = mustRead(points + "#MRGB ff102030ff000001\n# a word\n#MRGB FFFFFFFF\n");
    CHECK(column(file, "red") == std::vector<double>{16, 0, 255});
    CHECK(column(file, "green") == std::vector<double>{32, 0, 255});
    CHECK(column(file, "blue") == std::vector<double>{48, 1, 255});
    CHECK(notes(mustRead(points + "#MRGB ff102030\n"), "without those of 2 points"));
    CHECK(notes(mustRead("v 0 0 0\n#MRGB ff102030ff000001\n"), "more than there are points"));
    CHECK(mustRead(points + "#MRGB ff10203xff000001\n").attributes.empty());
}

TEST_CASE("OBJ: statements that are not read are named") {
    const PointFile file = mustRead("o a\ng b\nusemtl c\nv 0 0 0\ns off\nvp 1\n");
    CHECK(file.notes == std::vector<std::string>{"left out: statements g, o, s, usemtl and vp"});
    CHECK(notes(mustRead("v 0 0 0\n\x01\x02 1\nVERYLONGSTATEMENT 1\n"), "statements others"));
}

TEST_CASE("PCD: the transparency of colors is said to be left out, where it tells points apart") {
    const auto pcd = [](const std::string& first, const std::string& second) {
        return "FIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\n"
               "POINTS 2\nDATA ascii\n0 0 0 " +
               first + "\n1 0 0 " + second + "\n";
    };
    CHECK(notes(mustRead(pcd("4278190335", "255")), "left out: transparency"));
    CHECK_FALSE(notes(mustRead(pcd("4278190335", "4278190080")), "transparency"));
}

TEST_CASE("PLY: properties of a sensor and of strips that are not read are named") {
    const PointFile file = mustRead(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement camera 1\nproperty float view_px\nproperty float focal\n"
        "element tristrips 1\nproperty list int int vertex_indices\nproperty int layer\n"
        "end_header\n0 0 0\n1 0 0\n0 1 0\n7 35\n3 0 1 2 9\n");
    CHECK(notes(file, "left out of element camera: focal"));
    CHECK(notes(file, "left out of element tristrips: layer"));
}

TEST_CASE("OBJ: a backslash continues a statement in the next line") {
    const PointFile file = mustRead("v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 \\\n 2 \\\n 3\n");
    CHECK(file.position[0] == Vec3(0, 0, 0));
    CHECK(file.faces == std::vector<Triangle>{{0, 1, 2}});
    // A path of Windows is none, and an empty line ends a statement.
    CHECK(mustRead("mtllib C:\\m\\\nv 0 0 0\n").position.size() == 1);
    CHECK(mustRead("v 0 0 0 \\\n\nv 1 0 0\n").position.size() == 2);
    CHECK(contains(errorOf("v 0 0 0 v 1 0 0\n"), "expected a color"));
}

TEST_CASE("PLY: a text row may go on in the next line, if it ends there") {
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
        "property float z\nend_header\n";
    CHECK(mustRead(head + "1 2\n3\n4\n5 6\n").position == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
    CHECK(contains(errorOf(head + "1.25 2.25\n4.25 5.25 6.25\n"), "line 8: expected a value"));
}

TEST_CASE("PLY: a number beyond float costs its place in that column alone") {
    const PointFile file = mustRead(
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
        "property float z\nproperty float density\nend_header\n1 2 3 -9e61\n4 5 6 0.5\n");
    CHECK(file.position[0] == Vec3(1, 2, 3));
    CHECK(column(file, "density")[0] == -std::numeric_limits<double>::infinity());
    CHECK(notes(file, "column density: 1 number beyond the range of float"));
}

TEST_CASE("PLY: triangle strips, the place of the sensor, and integers of 64 bits are read") {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nproperty int64 label\nelement tristrips 1\n"
        "property list int int vertex_indices\nelement camera 1\nproperty float view_px\n"
        "property float view_py\nproperty float view_pz\nend_header\n"
        "0 0 0 1\n1 0 0 2\n0 1 0 3\n1 1 0 4\n0 2 0 5\n9 0 1 2 3 -1 2 3 3 4\n0 0 10\n";
    const PointFile file = mustRead(text);
    CHECK(file.faces == std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}});
    REQUIRE(file.viewpoint);
    CHECK(*file.viewpoint == Vec3(0, 0, 10));
    CHECK(column(file, "label") == std::vector<double>{1, 2, 3, 4, 5});
    CHECK(file.attributes[0].type == ScalarType::Double);
    CHECK(notes(mustRead(replaced(text, "0 0 0 1\n", "0 0 0 9223372036854775807\n")), "2^53"));
    CHECK(contains(errorOf(replaced(text, "-1 2 3 3 4", "-2 2 3 3 4")), "names point -2"));
}

TEST_CASE("PCD: nx, ny and nz are normals, and the viewpoint is kept unless it is the origin") {
    const std::string text =
        "VERSION 0.7\nFIELDS x y z nx ny nz\nSIZE 4 4 4 4 4 4\nTYPE F F F F F F\n"
        "WIDTH 1\nHEIGHT 1\nVIEWPOINT 0 0 -10 1 0 0 0\nPOINTS 1\nDATA ascii\n1 2 3 0 0 1\n";
    const PointFile file = mustRead(text);
    CHECK(file.normal == std::vector<Vec3>{{0, 0, 1}});
    CHECK(file.viewpoint == std::optional(Vec3(0, 0, -10)));
    CHECK_FALSE(mustRead(replaced(text, "0 0 -10", "0 0 0")).viewpoint);
}

TEST_CASE("PCD: compressed points are unpacked, and refused where they are damaged") {
    // Four literal bytes of 1.0F for x; y and z repeat them.
    const std::string one = rawBytes(1.0F);
    const std::string stream = '\3' + one + std::string{'\xc0', '\3'};
    const std::string head =
        "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA binary_compressed\n";
    const std::string sizes = rawBytes(std::uint32_t{7}) + rawBytes(std::uint32_t{12});
    CHECK(mustRead(head + sizes + stream).position == std::vector<Vec3>{{1, 1, 1}});
    CHECK_FALSE(readPoints(head + sizes + stream.substr(0, 6), "cut").ok());
    CHECK(contains(errorOf(head + sizes + '\3' + one + std::string{'\xc0', '\9'}), "damaged"));
}

TEST_CASE("STL: corners at one place are one point, in text and binary") {
    const std::string text =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\n"
        "vertex 0 0 1\nendloop\nendfacet\nendsolid\n";
    const PointFile file = mustRead(text);
    CHECK(file.position.size() == 4);
    CHECK(file.faces == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
    // The first point has both normals; the second triangle that of its winding, +x.
    CHECK(glm::distance(file.normal[0], glm::normalize(Vec3(1, 0, 1))) < 1e-12);
    CHECK(contains(errorOf(replaced(text, "vertex 0 1 0\nendloop", "endloop")), "three corners"));
    CHECK(contains(errorOf(replaced(text, "endfacet\nfacet", "facet")), "has no endfacet"));
    CHECK(contains(errorOf(replaced(text, "endsolid\n", "")), "without endsolid"));
    CHECK(mustRead("\n " + replaced(text, "solid a", "SOLID a")).position.size() == 4);
    CHECK(contains(errorOf(replaced(text, "endfacet\nendsolid", "endsolid")), "has no endfacet"));
    // Several keywords in a line, a comment, and a name that is longer than what is looked at.
    const PointFile joined = mustRead(replaced(replaced(text, "endfacet\nfacet", "endfacet facet"),
                                               "loop\nvertex", "loop vertex"));
    CHECK(joined.faces == file.faces);
    CHECK(joined.normal == file.normal);
    CHECK(mustRead("# made by x\n" + text, "a.stl").normal == file.normal);
    CHECK(mustRead(replaced(text, "solid a", "solid a facet " + std::string(3000, 'n'))).normal ==
          file.normal);
    CHECK_FALSE(readPoints("\nsolid x\nfacet normal 0 0 1\n", "a").ok());
    CHECK_FALSE(readPoints("solid", "a.stl").ok());

    const PointFile cube = findScene("sphere")->build();
    const std::vector<Triangle> triangles{{0, 1, 2}, {2, 1, 3}};
    const TemporaryFolder folder;
    REQUIRE(writeMesh(folder / "far.stl", cube, triangles).ok());
    const Result<PointFile> read = readPoints(folder / "far.stl");
    REQUIRE(read.ok());
    CHECK(read.value().faces == std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}});
    CHECK(glm::distance(read.value().position[3], cube.position[3]) < 1e-6);

    const std::string leftOut = "left out: colors or other attributes of triangles";
    std::string bytes = bytesOf(folder / "far.stl");
    CHECK_FALSE(contains(mustRead(bytes).notes.back(), leftOut));
    bytes.back() = '\x80';  // Of the attribute of the last triangle.
    CHECK(mustRead(bytes).notes.back() == leftOut);
}

TEST_CASE("LAS: positions by scale and offset, intensity, class and color") {
    const PointFile file = mustRead(lasOfTwo(), "a.las");
    CHECK(file.position ==
          std::vector<Vec3>{{500001, 500000.07, 500000}, {499997.5, 500000.07, 500000}});
    CHECK(column(file, "intensity") == std::vector<double>{900, 900});
    CHECK(column(file, "classification") == std::vector<double>{6, 6});
    CHECK(column(file, "red") == std::vector<double>{255, 255});
    CHECK(column(file, "green") == std::vector<double>{1, 1});
    for (std::size_t size = 4; size < lasOfTwo().size(); ++size)
        CHECK_FALSE(readPoints(lasOfTwo().substr(0, size), "cut.las").ok());
    std::string flagged = lasOfTwo();
    flagged[227 + 15] = '\x46';  // With a flag above the class.
    CHECK(column(mustRead(flagged), "classification") == std::vector<double>{6, 6});
    CHECK_FALSE(notes(mustRead(flagged), "withheld"));
    flagged[227 + 15] = '\x86';
    CHECK(notes(mustRead(flagged), "1 point marked as withheld: used"));
    std::string nowhere = lasOfTwo();
    nowhere.replace(96, 4, 4, '\0');
    CHECK(contains(errorOf(nowhere), "byte 96"));
    // More points than the header counts, what else may follow, and zeros of a page.
    const std::string record = lasOfTwo().substr(227, 26);
    CHECK(contains(errorOf(lasOfTwo() + record), "announces 2 points, but 1 more follow"));
    CHECK(notes(mustRead(lasOfTwo() + "user"), "left out: 4 bytes after the points"));
    CHECK(mustRead(lasOfTwo() + std::string(52, '\0')).notes == file.notes);
    std::string waves = lasOfTwo();
    waves.insert(227, 8, '\0');
    waves[25] = 3;
    waves[94] = waves[96] = static_cast<char>(235);
    waves.replace(227, 8, rawBytes(std::uint64_t{waves.size()}));
    CHECK(mustRead(waves + record).notes == file.notes);
    std::string packed = lasOfTwo();
    packed[104] = '\x82';
    CHECK(contains(errorOf(packed), "laszip -i"));
}

TEST_CASE("Files: formats that are known by their header may hold no points, others need one") {
    std::string las = lasOfTwo().substr(0, 227);
    las.replace(107, 4, 4, '\0');
    for (const auto& [bytes, name] : std::vector<std::pair<std::string, const char*>>{
             {"ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
              "property float z\nend_header\n",
              "a.ply"},
             {"OFF\n0 0 0\n", "a.off"},
             {"# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
              "WIDTH 0\nHEIGHT 1\nPOINTS 0\nDATA ascii\n",
              "a.pcd"},
             {las, "a.las"},
             {"0\n0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", "a.ptx"},
         }) {
        CAPTURE(name);
        const PointFile file = mustRead(bytes, name);
        CHECK(file.position.empty());
        CHECK(file.faces.empty());
    }
    CHECK(contains(errorOf("", "a.ply"), "is empty"));
    CHECK(contains(errorOf("o nothing\n", "a.obj"), "holds no points"));
    CHECK(contains(errorOf("# nothing\n", "a.xyz"), "holds no points"));
    CHECK(contains(errorOf(std::string(84, '\0'), "a.stl"), "holds no triangles"));
}

TEST_CASE("CSV: a column without a name is named as left out, and a missing value explained") {
    const PointFile file = mustRead(",x,y,z\n0,1,2,3\n1,4,5,6\n", "a.csv");
    CHECK(file.position == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
    CHECK(file.attributes.empty());
    CHECK(file.notes == std::vector<std::string>{"left out: a column without a name"});
    CHECK(contains(errorOf("x,y,z\n1,2,NA\n", "a.csv"), "write nan where a value is missing"));
}

TEST_CASE("PLY, PCD and OFF: elements, fields and textures that are not read are named") {
    const auto notesOf = [](const std::string& text, const char* name) {
        return mustRead(text, name).notes;
    };
    using Notes = std::vector<std::string>;
    CHECK(notesOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                  "property float z\nelement material 1\nproperty int shine\nend_header\n"
                  "1 2 3\n7\n",
                  "a.ply") == Notes{"left out: element material"});
    CHECK(notesOf("VERSION 0.7\nFIELDS x y z histogram\nSIZE 4 4 4 4\nTYPE F F F F\n"
                  "COUNT 1 1 1 2\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3 4 5\n",
                  "a.pcd") == Notes{"left out: field histogram"});
    CHECK(notesOf("STOFF\n1 0 0\n1 2 3 0.5 0.5\n", "a.off") ==
          Notes{"left out: texture coordinates"});
}

TEST_CASE("Files: kinds that are not read are named, with the program that converts them") {
    CHECK(contains(errorOf("ASTM-E57...", "a.e57"), "pdal translate"));
    CHECK(contains(errorOf("\x93NUMPY...", "a.npy"), "numpy.savetxt"));
    CHECK(contains(errorOf("\x1f\x8b...", "a.ply.gz"), "gunzip"));
    CHECK(contains(errorOf("BZh91AY...", "a.xyz.bz2"), "bunzip2"));
    CHECK(contains(errorOf("\xfd"
                           "7zXZ...",
                           "a.xyz.xz"),
                   "unxz"));
    CHECK(contains(errorOf("\x28\xb5\x2f\xfd...", "a.xyz.zst"), "unzstd"));
    CHECK(contains(errorOf("ncols 4\nnrows 3\n", "a.asc"), "gdal_translate -of XYZ"));
    CHECK(contains(errorOf("# vtk DataFile Version 3.0\n", "a.vtk"), "meshio convert"));
    CHECK(contains(errorOf("{\"asset\": {\"version\": \"2.0\"}}", "a.gltf"), ".glb"));
    CHECK(contains(errorOf("<?xml version=\"1.0\"?>\n<VTKFile/>\n", "a.vtu"), "meshio convert"));
}

TEST_CASE("Files: a packed file is read where there is a function that unpacks it") {
    const Unpack unpack = [](std::string_view, const std::string&,
                             const ByteLimit&) -> Result<std::string> {
        return std::string("1 2 3\n");
    };
    CHECK(readPoints("\x1f\x8b...", "a.xyz.gz", {}, unpack).value().position.size() == 1);
}

TEST_CASE("Viewpoint: an open sheet without normals faces it, a closed body faces out") {
    PointFile sheet;
    for (int x = 0; x < 12; ++x)
        for (int y = 0; y < 12; ++y)
            sheet.position.emplace_back(x, y, 0.2 * std::sin(0.7 * x) * std::cos(0.5 * y));
    for (const double side : {1.0, -1.0}) {
        sheet.viewpoint = Vec3(6, 6, 20 * side);
        const Result<Prepared> prepared = prepare(sheet, {});
        REQUIRE(prepared.ok());
        CHECK(prepared.value().report.derived.unknownSides == 0);
        for (const Vec3& n : prepared.value().points.normal) CHECK(n.z * side > 0.0);
    }
    PointFile ball = findScene("sphere")->build();
    ball.normal.clear();
    ball.type.clear();
    ball.viewpoint = Vec3(0.1, 0.0, 0.0);
    const Result<Prepared> inside = prepare(ball, {});
    REQUIRE(inside.ok());
    const PointSet& points = inside.value().points;
    for (Index p = 0; p < points.size(); ++p)
        CHECK(glm::dot(points.normal[p], points.position[p]) > 0.0);
}
