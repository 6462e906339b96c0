#include <cmath>
#include <limits>

#include "ply_encoder.h"
#include "spiraling_edge/io/write_mesh.h"
#include "support/io_support.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

/// Five points with all features of a PLY file, written by hand as text.
const char* const kFull =
    "ply\n"
    "format ascii 1.0\n"
    "comment all that can be read, in an unusual order\n"
    "element material 1\n"
    "property list uchar float shine\n"
    "element vertex 5\n"
    "property uchar red\n"
    "property double x\n"
    "property double y\n"
    "property list uchar int visible_from\n"
    "property double z\n"
    "property float nx\n"
    "property float ny\n"
    "property float nz\n"
    "property short height\n"
    "property uchar scalar_se_type\n"
    "element face 2\n"
    "property uchar group\n"
    "property list uchar uint vertex_index\n"
    "element se_neighbors 5\n"
    "property list ushort uint id\n"
    "end_header\n"
    "2 0.5 0.25\n"
    "255 0 0 0 0 0 0 1 -300 0\n"
    "1 1e-3 0 2 7 8 0 0 0 1 2 1\n"
    "2 1 1 0 0.1 0 0.6 0.8 3 3\n"
    "3 -1 1 1 9 0 0 0 1 4 0\n"
    "4 .5 +2 0 5. 0 0 1 5 64\n"
    "9 4 0 1 2 3\n"
    "9 3 2 1 4\n"
    "2 1 2\n"
    "0\n"
    "1 3\n"
    "1 2\n"
    "3 0 1 2\n";

std::string littleEndian(const std::string& ascii) { return BinaryEncoder(ascii, false).bytes(); }
std::string bigEndian(const std::string& ascii) { return BinaryEncoder(ascii, true).bytes(); }

/// Two points, in text. The last value has one digit, so that no cut leaves a whole number.
const std::string kTwo =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nend_header\n0 0 0\n1 2 3\n";

/// Two points with longer numbers, so that there seems to be room for more rows.
const std::string kLongTwo =
    kTwo.substr(0, kTwo.find("0 0 0")) + "0.000 0.000 0.000\n1.5 2.5 3.5\n";

}  // namespace

TEST_CASE("PLY: everything in a file is read unchanged") {
    const PointFile file = mustRead(kFull);
    REQUIRE(file.position.size() == 5);
    CHECK(file.position[1] == Vec3(1e-3, 0, 0));
    CHECK(file.position[4] == Vec3(.5, 2, 5));
    CHECK(file.positionType == ScalarType::Double);
    CHECK(file.normal[2] == Vec3(0, double{0.6F}, double{0.8F}));
    CHECK(file.normalType == ScalarType::Float);
    CHECK(file.type == std::vector<std::uint8_t>{0, 1, 3, 0, 64});
    REQUIRE(file.attributes.size() == 2);
    CHECK(file.attributes[0].name == "red");
    CHECK(file.attributes[0].type == ScalarType::UInt8);
    CHECK(file.attributes[0].values == std::vector<double>{255, 1, 2, 3, 4});
    CHECK(file.attributes[1].name == "height");
    CHECK(file.attributes[1].values == std::vector<double>{-300, 2, 3, 4, 5});
    CHECK(file.faces == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {2, 1, 4}});
    CHECK(file.neighbors.offset == std::vector<std::uint32_t>{0, 2, 2, 3, 4, 7});
    CHECK(file.neighbors.ids == std::vector<Index>{1, 2, 3, 2, 0, 1, 2});
}

TEST_CASE("PLY: text, little endian and big endian give the same content") {
    const PointFile text = mustRead(kFull);
    checkSame(mustRead(littleEndian(kFull)), text);
    checkSame(mustRead(bigEndian(kFull)), text);
}

TEST_CASE("PLY: columns without lists are read the same in every encoding") {
    const std::string ascii =
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty ushort a\n"
        "property double y\nproperty float nz\nproperty double z\nproperty double nx\n"
        "property float ny\nend_header\n0.1 65535 0.2 1 0.3 0 0\n-1e300 7 1e-300 0 3 0.7 0.1\n";
    const PointFile text = mustRead(ascii);
    CHECK(text.normalType == ScalarType::Double);
    CHECK(text.normal[1] == Vec3(0.7, double{0.1F}, 0));
    checkSame(mustRead(littleEndian(ascii)), text);
    checkSame(mustRead(bigEndian(ascii)), text);
}

TEST_CASE("PLY: a file cut at any byte is refused") {
    checkAllPrefixes(kFull);
    checkAllPrefixes(kTwo);
    checkAllPrefixes(littleEndian(kFull));
    checkAllPrefixes(bigEndian(kTwo));
}

TEST_CASE("PLY: CRLF, blank lines, a byte order mark and obj_info change nothing") {
    std::string text = replaced(kFull, "end_header\n", "\nobj_info x\nend_header\n\n");
    std::string crlf = "\xef\xbb\xbf";
    for (const char c : text) crlf += (c == '\n') ? std::string("\r\n") : std::string(1, c);
    checkSame(mustRead(crlf), mustRead(kFull));
}

TEST_CASE("PLY: nan and inf are read as such") {
    const PointFile file = mustRead(replaced(kTwo, "1 2 3", "nan -inf +Infinity"));
    CHECK(std::isnan(file.position[1].x));
    CHECK(file.position[1].y == -std::numeric_limits<double>::infinity());
    CHECK(file.position[1].z == std::numeric_limits<double>::infinity());
}

TEST_CASE("PLY: integer positions are widened") {
    std::string text = kTwo;
    for (int i = 0; i < 3; ++i) text = replaced(text, "float", "int");
    const PointFile file = mustRead(text);
    CHECK(file.positionType == ScalarType::Double);
    CHECK(file.position[1] == Vec3(1, 2, 3));
    CHECK(contains(errorOf(replaced(text, "1 2 3", "1 2.5 3")),
                   "line 9: expected a value of type int"));
}

TEST_CASE("PLY: types may be of any scalar type, and se_type is a name for them too") {
    const std::string text =
        replaced(replaced(replaced(kTwo, "end_header", "property float se_type\nend_header"),
                          "0 0 0", "0 0 0 65"),
                 "1 2 3", "1 2 3 0");
    CHECK(mustRead(text).type == std::vector<std::uint8_t>{65, 0});
    CHECK(mustRead(text).attributes.empty());
    CHECK(contains(errorOf(replaced(text, "65", "256")), "from 0 to 255"));
    CHECK(contains(errorOf(replaced(text, "65", "1.5")), "point 0"));
    CHECK(contains(errorOf(replaced(text, "65", "nan")), "whole number"));
}

TEST_CASE("PLY: a lone nx is an attribute, not a normal") {
    const std::string text = replaced(kTwo, "property float z", "property float nx");
    CHECK(contains(errorOf(text), "no property z"));
    const PointFile file = mustRead(replaced(
        replaced(replaced(kTwo, "end_header", "property float nx\nend_header"), "0 0 0", "0 0 0 7"),
        "1 2 3", "1 2 3 8"));
    CHECK_FALSE(file.hasNormals());
    CHECK(file.attributes.at(0).values == std::vector<double>{7, 8});
}

TEST_CASE("PLY: no points at all is a valid file") {
    const std::string text = replaced(kTwo, "vertex 2", "vertex 0");
    const PointFile file = mustRead(text.substr(0, text.find("0 0 0")));
    CHECK(file.position.empty());
    CHECK_FALSE(file.hasNormals());
}

TEST_CASE("PLY: polygons of fewer than three corners give no triangle") {
    const PointFile file = mustRead(replaced(kFull, "9 3 2 1 4", "9 2 2 1"));
    CHECK(file.faces.size() == 2);
}

TEST_CASE("PLY: a text header that announces more rows than there are names the line") {
    const std::string error = errorOf(replaced(kLongTwo, "vertex 2", "vertex 3"));
    CHECK(contains(error, "test: line 9: the file ends after 2 of 3 rows of element \"vertex\""));
}

TEST_CASE("PLY: a binary header that announces more points than there are names the byte") {
    const std::string bytes = replaced(littleEndian(kTwo), "vertex 2", "vertex 3");
    CHECK(contains(errorOf(bytes),
                   "byte " + std::to_string(bytes.size()) + ": the file ends after 2 of 3 rows"));
}

TEST_CASE("PLY: rows beyond those announced are an error") {
    CHECK(contains(errorOf(replaced(kTwo, "vertex 2", "vertex 1")), "line 9: the file goes on"));
    const std::string bytes = replaced(littleEndian(kTwo), "vertex 2", "vertex 1");
    CHECK(contains(errorOf(bytes), "byte " + std::to_string(bytes.size() - 12) +
                                       ": the file goes on for 12 bytes"));
    checkSame(mustRead(littleEndian(kTwo) + "\n"), mustRead(kTwo));
}

TEST_CASE("PLY: absurd counts are refused before memory is taken for them") {
    for (const char* count :
         {"4294967294", "4294967295", "99999999999999", "9223372036854775807"}) {
        const std::string claim = std::string("vertex ") + count;
        CHECK(contains(errorOf(replaced(kTwo, "vertex 2", claim)), "line 3: announces "));
        (void)errorOf(replaced(littleEndian(kTwo), "vertex 2", claim));
        const std::string faces = std::string("face ") + count;
        CHECK(contains(errorOf(replaced(kFull, "face 2", faces)), "has room for"));
        CHECK(contains(errorOf(replaced(bigEndian(kFull), "face 2", faces)), "ends too early"));
        const std::string material = std::string("material ") + count;
        (void)errorOf(replaced(bigEndian(kFull), "material 1", material));
    }
    CHECK(contains(errorOf(replaced(kTwo, "vertex 2", "vertex 9223372036854775808")), "COUNT"));
    CHECK(contains(errorOf(replaced(kTwo, "vertex 2", "vertex -1")), "COUNT"));
    CHECK(contains(errorOf(replaced(kTwo, "vertex 2", "vertex")), "COUNT"));
}

TEST_CASE("PLY: an element without properties has rows of nothing") {
    const std::string none = "element nothing 4000000000\nend_header";
    checkSame(mustRead(replaced(kTwo, "end_header", none)), mustRead(kTwo));
    checkSame(mustRead(replaced(littleEndian(kTwo), "end_header", none)), mustRead(kTwo));
}

TEST_CASE("PLY: a text row must hold as many values as the header announces") {
    CHECK(contains(errorOf(replaced(kLongTwo, "1.5 2.5 3.5", "1.5 2.5")),
                   "line 9: expected a value of type float for property \"z\", found the end"));
    CHECK(contains(errorOf(replaced(kLongTwo, "1.5 2.5 3.5", "1.5 2.5 3.5 4")),
                   "line 9: expected the end"));
    CHECK(contains(errorOf(replaced(kLongTwo, "1.5 2.5 3.5", "1.5 2.5 x3")), "found \"x3\""));
    CHECK(contains(errorOf(replaced(kFull, "255 0 0", "256 0 0")), "type uchar"));
}

TEST_CASE("PLY: each name of a header is looked up once" * doctest::timeout(5.0)) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\n"
        "property float y\nproperty float z\n";
    for (int i = 0; i < 100000; ++i) text += "property float p" + std::to_string(i) + "\n";
    for (int i = 0; i < 100000; ++i) text += "element e" + std::to_string(i) + " 0\n";
    CHECK(readPoints(text + "end_header\n", "a.ply").ok());
    CHECK(contains(errorOf(text + "element e7 0\nend_header\n"), "\"e7\" is announced twice"));
}

TEST_CASE("PLY: lists that lie are refused") {
    const std::string text =
        replaced(kFull, "list uchar uint vertex_index", "list char int vertex_index");
    CHECK(contains(errorOf(replaced(text, "9 4 0 1 2 3", "9 -4 0 1 2 3")), "length of list"));
    CHECK(contains(errorOf(replaced(text, "9 4 0 1 2 3", "9 4 0 1 2 5")), "names point 5"));
    CHECK(contains(errorOf(replaced(text, "9 4 0 1 2 3", "9 4 0 1 2 -1")), "names point -1"));
    CHECK(contains(errorOf(replaced(text, "9 4 0 1 2 3", "9 5 0 1 2 3")), "the end of the line"));
    CHECK(
        contains(errorOf(replaced(text, "1 3\n", "1 5\n")), "line 33: list \"id\" names point 5"));
    std::string bytes = littleEndian(kFull);
    bytes[bytes.size() - 14] = '\x7f';  // the length of the last list of neighbors
    CHECK(contains(errorOf(bytes), "ends after 4 of 5 rows of element \"se_neighbors\""));
}

TEST_CASE("PLY: each flaw of a header has its own message") {
    const auto error = [](std::string_view from, std::string_view to) {
        return errorOf(replaced(kFull, from, to));
    };
    CHECK(contains(error("format ascii 1.0\n", ""), "no line \"format\""));
    CHECK(contains(error("ascii", "binary_middle_endian"), "line 2: expected ascii"));
    CHECK(contains(error("end_header\n", ""), "line 22: expected format"));
    CHECK(contains(errorOf("ply\nformat ascii 1.0\n"), "before the line \"end_header\""));
    CHECK(contains(error("property double x", "property quad x"), "line 8: expected a type"));
    CHECK(contains(error("double x", "double w"), "no property x"));
    CHECK(contains(error("property double x", "property double"), "has no name"));
    CHECK(contains(error("double y", "double x"), "announced twice"));
    CHECK(contains(error("element face", "element vertex"), "announced twice"));
    CHECK(contains(error("element vertex", "element point"), "no element \"vertex\""));
    CHECK(contains(error("element material 1\n", ""), "before the first element"));
    CHECK(contains(error("list uchar uint", "list float uint"), "must be of an integer type"));
    CHECK(contains(error("list uchar uint", "list uchar float"), "must be of an integer type"));
    CHECK(contains(error("se_neighbors 5", "se_neighbors 4"), "element se_neighbors 5"));
    CHECK(contains(error("uint id", "uint ids"), "property list ushort uint id"));
}

TEST_CASE("PLY: what was written reads back the same, and is written the same again") {
    PointFile file = mustRead(kFull);
    const std::string bytes = meshPlyBytes(file, file.faces);
    const PointFile again = mustRead(bytes);
    checkSame(again, file);
    CHECK(again.positionType == ScalarType::Double);
    CHECK(again.normalType == ScalarType::Float);
    CHECK(meshPlyBytes(again, again.faces) == bytes);
    CHECK(contains(bytes, "property list uchar int vertex_indices\n"));
    CHECK(contains(bytes, "element se_neighbors 5\nproperty list ushort uint id\n"));
    checkAllPrefixes(bytes);
}

TEST_CASE("PLY: attributes keep type and value at the ends of their range") {
    PointFile file = mustRead(kTwo);
    file.attributes = {{"a", ScalarType::Int8, {-128, 127}},
                       {"b", ScalarType::UInt32, {0, 4294967295.0}},
                       {"c", ScalarType::Int32, {-2147483648.0, 2147483647.0}},
                       {"d", ScalarType::Double, {0.1, 5e-324}}};
    checkSame(mustRead(meshPlyBytes(file, {})), file);
}

TEST_CASE("PLY: values that a type cannot hold are written as the nearest") {
    PointFile file = mustRead(kTwo);
    file.attributes = {{"a", ScalarType::UInt8, {-5, 1e9}},
                       {"b", ScalarType::Int16, {std::nan(""), -1e9}}};
    const PointFile again = mustRead(meshPlyBytes(file, {}));
    CHECK(again.attributes[0].values == std::vector<double>{0, 255});
    CHECK(again.attributes[1].values == std::vector<double>{0, -32768});
}

TEST_CASE("PLY: attributes whose name is not allowed in a header are left out") {
    PointFile file = mustRead(kTwo);
    file.attributes = {{"x", ScalarType::Float, {1, 1}},   {"", ScalarType::Float, {1, 1}},
                       {"a b", ScalarType::Float, {1, 1}}, {"ok", ScalarType::Float, {1, 1}},
                       {"ok", ScalarType::Float, {2, 2}},  {"n\nl", ScalarType::Float, {1, 1}}};
    const PointFile again = mustRead(meshPlyBytes(file, {}));
    REQUIRE(again.attributes.size() == 1);
    CHECK(again.attributes[0].values == std::vector<double>{1, 1});
}

TEST_CASE("PLY: lists too long for ushort are counted by uint") {
    PointFile file;
    const Index count = 70000;
    file.position.resize(count);
    std::vector<Index> all(count - 1);
    for (Index i = 0; i < all.size(); ++i) all[i] = i + 1;
    file.neighbors.append(all);
    for (Index p = 1; p < count; ++p) file.neighbors.append({});
    checkSame(mustRead(meshPlyBytes(file, {})), file);
}

TEST_CASE("PLY: normals under the names of the Point Cloud Library are read as normals") {
    const std::string text =
        replaced(replaced(kTwo, "property float z\n",
                          "property float z\nproperty float normal_x\nproperty float normal_y\n"
                          "property float normal_z\nproperty float curvature\n"),
                 "0 0 0\n1 2 3\n", "0 0 0 0 1 0 5\n1 2 3 1 0 0 6\n");
    for (const std::string& bytes : {text, littleEndian(text), bigEndian(text)}) {
        const PointFile file = mustRead(bytes);
        CHECK(file.normal == std::vector<Vec3>{{0, 1, 0}, {1, 0, 0}});
        REQUIRE(file.attributes.size() == 1);
        CHECK(file.attributes[0].name == "curvature");
        checkSame(mustRead(meshPlyBytes(file, {})), file);
    }
    // Two of three are two columns.
    const PointFile two = mustRead(replaced(text, "normal_z", "other"));
    CHECK_FALSE(two.hasNormals());
    CHECK(two.attributes.size() == 4);
}

TEST_CASE(
    "PLY: capitals in the names of positions and normals do not matter, exact names come first") {
    const std::string text =
        replaced(replaced(kTwo, "float x\nproperty float y\nproperty float z\n",
                          "float X\nproperty float Y\nproperty float Z\nproperty float Nx\n"
                          "property float Ny\nproperty float Nz\n"),
                 "0 0 0\n1 2 3\n", "0 0 0 0 1 0\n1 2 3 1 0 0\n");
    const PointFile file = mustRead(text);
    CHECK(file.position == std::vector<Vec3>{{0, 0, 0}, {1, 2, 3}});
    CHECK(file.normal == std::vector<Vec3>{{0, 1, 0}, {1, 0, 0}});
    CHECK(file.attributes.empty());
    // A second x in lower case is the position; the capital one stays a column.
    const PointFile lower =
        mustRead(replaced(replaced(text, "float Nx", "float x"), "1 2 3 1", "9 2 3 1"));
    CHECK(lower.position[1] == Vec3(1, 2, 3));
    CHECK_FALSE(lower.hasNormals());
    REQUIRE(lower.attributes.size() == 3);
    CHECK(lower.attributes[0].name == "X");
    CHECK(lower.attributes[0].values[1] == 9.0);
    checkSame(mustRead(meshPlyBytes(lower, {})), lower);
}

TEST_CASE("Write: a mesh whose parts do not fit together is refused") {
    const TemporaryFolder folder;
    PointFile file = mustRead(kTwo);
    const Triangle outside[] = {{0, 1, 2}};
    CHECK(contains(writeMeshPly(folder / "a.ply", file, outside).error().message, "a triangle"));
    file.type = {0};
    CHECK(contains(writeMeshPly(folder / "a.ply", file, {}).error().message, "differ in length"));
    CHECK(folder.fileCount() == 0);
}

TEST_CASE("Write: a file appears whole and replaces the one before") {
    const TemporaryFolder folder;
    const PointFile file = mustRead(kFull);
    for (int i = 0; i < 2; ++i) {
        REQUIRE(writeMeshPly(folder / "a.ply", file, file.faces).ok());
        CHECK(bytesOf(folder / "a.ply") == meshPlyBytes(file, file.faces));
        CHECK(folder.fileCount() == 1);
    }
    const Result<PointFile> again = readPoints(folder / "a.ply");
    REQUIRE(again.ok());
    checkSame(again.value(), file);
}

TEST_CASE("PLY: the three encodings of the shared files hold the same points") {
    const auto text = sharedFile("formats/ascii.ply");
    if (text.empty()) return;
    const PointFile ascii = readPoints(text).value();
    const PointFile little = readPoints(sharedFile("formats/little_endian.ply")).value();
    const PointFile big = readPoints(sharedFile("formats/big_endian_double.ply")).value();
    CHECK(ascii.position.size() == 299);
    CHECK(sameVectors(ascii.position, little.position));
    CHECK(little.faces.size() == 562);
    CHECK(big.positionType == ScalarType::Double);
    CHECK(big.attributes.size() == 3);
    for (std::size_t i = 0; i < 299; ++i) {
        CHECK(glm::distance(big.position[i], little.position[i]) < 1e-6);
        CHECK(glm::distance(ascii.normal[i], little.normal[i]) < 1e-6);
    }
}

TEST_CASE("PLY: the shared file that is too short names its last line") {
    const auto path = sharedFile("hazards/short_file.ply");
    if (path.empty()) return;
    CHECK(contains(readPoints(path).error().message,
                   "line 1060: the file ends after 1050 of 1550 rows"));
}

TEST_CASE("PLY: of normals under both names the usual ones are read, the others are columns") {
    const std::string text =
        replaced(replaced(kTwo, "property float z\n",
                          "property float z\nproperty float normal_x\nproperty float normal_y\n"
                          "property float normal_z\nproperty float nx\nproperty float ny\n"
                          "property float nz\n"),
                 "0 0 0\n1 2 3\n", "0 0 0 1 0 0 0 1 0\n1 2 3 1 0 0 0 0 1\n");
    const PointFile file = mustRead(text);
    CHECK(file.normal == std::vector<Vec3>{{0, 1, 0}, {0, 0, 1}});
    REQUIRE(file.attributes.size() == 3);
    CHECK(file.attributes[0].name == "normal_x");
}
