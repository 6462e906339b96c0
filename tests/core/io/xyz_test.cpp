/// XYZ: recognition of colors, normals and intensities, and the meaning of commas.
#include <cmath>

#include "spiraling_edge/io/write_mesh.h"
#include "support/io_support.h"

using namespace se;
using namespace se::test;

namespace {

/// The values of a column that must be there.
std::vector<double> column(const PointFile& file, std::string_view name,
                           ScalarType type = ScalarType::UInt8) {
    for (const Attribute& attribute : file.attributes) {
        if (attribute.name != name) continue;
        CHECK(attribute.type == type);
        return attribute.values;
    }
    FAIL_CHECK("no column " << name);
    return {};
}

void checkColors(const PointFile& file, const std::vector<double>& red,
                 const std::vector<double>& green, const std::vector<double>& blue) {
    CHECK(column(file, "red") == red);
    CHECK(column(file, "green") == green);
    CHECK(column(file, "blue") == blue);
}

const std::string kColors = "0 0 0 255 0 17\n1 0 0 200 100 0\n0 1 0 0 0 0\n";

}  // namespace

TEST_CASE("XYZ: whole numbers from 0 to 255 after the position are colors, no normals") {
    const PointFile file = mustRead(kColors);
    CHECK_FALSE(file.hasNormals());
    REQUIRE(file.attributes.size() == 3);
    checkColors(file, {255, 200, 0}, {0, 100, 0}, {17, 0, 0});
    CHECK(file.columns.names == "x y z red green blue");
    CHECK(contains(file.columns.reason, "columns 4 to 6 are whole numbers from 0 to 255"));
    // They are written as the usual columns, and the normals are derived.
    const std::string bytes = meshPlyBytes(file, {});
    for (const char* name : {"red", "green", "blue"})
        CHECK(contains(bytes, std::string("property uchar ") + name + "\n"));
    checkSame(mustRead(bytes), file);
}

TEST_CASE("XYZ: one number that no color can be makes the three columns normals or nothing") {
    // A fraction of length 1, a sign, whole numbers along an axis: normals.
    CHECK(mustRead("0 0 0 0.6 0.8 0\n1 0 0 0 1 0\n").hasNormals());
    CHECK(mustRead("0 0 0 0 0 1\n1 0 0 0 -1 0\n").hasNormals());
    const PointFile axes = mustRead("0 0 0 0 0 1\n1 0 0 0 1 0\n2 0 0 1 0 0\n");
    CHECK(axes.normal == std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
    CHECK(axes.columns.names == "x y z nx ny nz");
    CHECK(axes.attributes.empty());
    // Other lengths with a sign are still normals, and the reason is given.
    const PointFile scaled = mustRead("0 0 0 0 0 2.5\n1 0 0 0 -3 0\n");
    CHECK(scaled.normal[0] == Vec3(0, 0, 2.5));
    CHECK(contains(scaled.columns.reason, "length is not 1"));
    // Colors of 16 bits, colors from 0 to 1, whole numbers between colors and normals.
    for (const char* text :
         {"0 0 0 65535 0 0\n1 0 0 0 300 0\n", "0 0 0 0.2 0.3 0.1\n1 0 0 0.5 0.5 0.9\n",
          "0 0 0 1 1 0\n1 0 0 1 0 1\n", "0 0 0 0 0 1\n1 0 0 0 0 1\n2 0 0 9 9 9\n"}) {
        INFO(text);
        const std::string error = errorOf(text, "a.xyz");
        CHECK(
            contains(error, "a.xyz: line 1: found 6 columns and cannot tell what columns 4 to 6"));
        CHECK(contains(error, "\"# x y z nx ny nz\""));
    }
}

TEST_CASE("XYZ: columns of zeros as whole numbers are colors, else missing normals") {
    checkColors(mustRead("0 0 0 0 0 0\n1 0 0 0 0 0\n"), {0, 0}, {0, 0}, {0, 0});
    CHECK(mustRead("0 0 0 0.0 0.0 0.0\n1 0 0 0.0 0.0 0.0\n").hasNormals());
    CHECK(mustRead("0 0 0 nan nan nan\n1 0 0 nan nan nan\n").hasNormals());
}

TEST_CASE("XYZ: colors and normals in either order, recognized by their numbers") {
    for (const char* text : {"1 2 3 0 0.6 0.8 9 8 7\n4 5 6 0 0 1 255 0 1\n",
                             "1 2 3 9 8 7 0 0.6 0.8\n4 5 6 255 0 1 0 0 1\n"}) {
        const PointFile file = mustRead(text);
        CHECK(file.normal == std::vector<Vec3>{{0, 0.6, 0.8}, {0, 0, 1}});
        checkColors(file, {9, 255}, {8, 0}, {7, 1});
        CHECK(contains(file.columns.reason, "colors"));
        CHECK(contains(file.columns.reason, "normals"));
    }
    for (const char* text : {"1 2 3 4 5 6 7 8 9\n", "1 2 3 0 0.6 0.8 0 0 1\n"}) {
        const std::string error = errorOf(text);
        CHECK(contains(error, "line 1: found 9 columns and cannot tell"));
        CHECK(contains(error, "columns 4 to 6 and columns 7 to 9"));
    }
}

TEST_CASE("XYZ: an intensity alone, or beside colors where only one reading is possible") {
    const PointFile four = mustRead("1 2 3 0.5\n4 5 6 -7\n");
    CHECK(column(four, "intensity", ScalarType::Double) == std::vector<double>{0.5, -7});
    CHECK(four.columns.names == "x y z intensity");
    const PointFile before = mustRead("1 2 3 -1203 10 20 30\n4 5 6 17 40 50 60\n");
    checkColors(before, {10, 40}, {20, 50}, {30, 60});
    CHECK(column(before, "intensity", ScalarType::Double) == std::vector<double>{-1203, 17});
    const PointFile after = mustRead("1 2 3 10 20 30 0.25\n4 5 6 40 50 60 0.5\n");
    checkColors(after, {10, 40}, {20, 50}, {30, 60});
    CHECK(after.columns.names == "x y z red green blue intensity");
    CHECK(contains(errorOf("1 2 3 10 20 30 40\n"), "line 1: found 7 columns and cannot tell"));
    CHECK(contains(errorOf("1 2 3 0 1 0 0\n"), "line 1: found 7 columns"));
}

TEST_CASE("XYZ: a comment that names the columns decides") {
    // Without the names these are colors, and could be either.
    const PointFile named = mustRead("# x y z nx ny nz\n0 0 0 0 0 9\n1 0 0 0 0 200\n");
    CHECK(named.normal == std::vector<Vec3>{{0, 0, 9}, {0, 0, 200}});
    CHECK(named.columns.reason == "named in line 1");
    const PointFile cloud = mustRead(
        "# saved today\n//X Y Z R G B Scan_Angle Nx Ny Nz\n1 2 3 1 0 0 -5 0 1 0 // first\n");
    CHECK(cloud.normal == std::vector<Vec3>{{0, 1, 0}});
    checkColors(cloud, {1}, {0}, {0});
    CHECK(column(cloud, "Scan_Angle", ScalarType::Double) == std::vector<double>{-5});
    CHECK(cloud.columns.names == "x y z red green blue Scan_Angle nx ny nz");
    CHECK(cloud.columns.reason == "named in line 2");
    const PointFile seven = mustRead("# x,y,z,i,r,g,b\n1,2,3,4,5,6,7\n");
    CHECK(column(seven, "intensity", ScalarType::Double) == std::vector<double>{4});
    checkColors(seven, {5}, {6}, {7});
    checkColors(mustRead("# x y z r g b\n1 2 3 4.0 5.0 255.0\n"), {4}, {5}, {255});
    // The position may be in other columns, and colors from 0 to 1 stay unchanged.
    const PointFile turned = mustRead("# Red Green Blue Z Y X\n0.5 0 1 3 2 1\n");
    CHECK(turned.position == std::vector<Vec3>{{1, 2, 3}});
    CHECK(column(turned, "red", ScalarType::Double) == std::vector<double>{0.5});
}

TEST_CASE("XYZ: a comment that names no columns, or others, decides nothing") {
    for (const char* comment :
         {"# x y z\n", "# x y z x y z\n", "# x y and more of it\n", "# x y z \x1b[31m g b\n"}) {
        CHECK_FALSE(mustRead(comment + kColors).hasNormals());
    }
    // After the first point it is too late.
    CHECK_FALSE(mustRead(kColors + "# x y z nx ny nz\n").hasNormals());
}

TEST_CASE("XYZ: a comment names columns with units, a label, or blanks in names") {
    for (const char* comment :
         {"# y [m] x [m] z [m]", "# y (m), x (m), z (m)", "# columns: y x z", "# Fields: y, x, z",
          "# format = y x z", "//Y;X;Z", "# y x z\n# x y z in meters"}) {
        CAPTURE(comment);
        CHECK(mustRead(comment + std::string("\n1 2 3\n")).position[0] == Vec3(2, 1, 3));
    }
    const PointFile four = mustRead("//Z,X,Y,Gaussian curvature\n1,2,3,4\n", "a.csv");
    CHECK(four.position[0] == Vec3(2, 3, 1));
    CHECK(four.columns.names == "z x y Gaussian_curvature");
    CHECK(mustRead("//X,Y,Z,R,G,B,Scalar field,Nx,Ny,Nz\n1,2,3,4,5,6,7,0,0,1\n").normal[0] ==
          Vec3(0, 0, 1));
    CHECK(mustRead("# Points:0 Points:1 Points:2 id\n1 2 3 4\n").position[0] == Vec3(1, 2, 3));
    // A row of names decides, not a comment after it.
    CHECK(mustRead("y,x,z\n# x y z in m\n1,2,3\n").position[0] == Vec3(2, 1, 3));
}

TEST_CASE("XYZ: a comment with x, y and z in another order is not passed over") {
    for (const char* comment :
         {"# y x z", "# columns: y x z", "# z, x, y of it", "# lat lon alt"}) {
        CAPTURE(comment);
        CHECK(
            contains(errorOf(comment + ("\n" + kColors)), "line 1: this comment names x, y and z"));
    }
    // Not so a sentence.
    CHECK(mustRead("# z is up, x east, y north\n1 2 3\n").position[0] == Vec3(1, 2, 3));
}

TEST_CASE("XYZ: zeros and ones alone are normals only where they suit the points") {
    const auto ball = [](auto colorOf) {
        std::string text;
        for (int i = 0; i < 30; ++i) {
            const double turn = 2.4 * i;
            const double z = (i - 14.5) / 15;
            text += std::to_string(std::cos(turn)) + " " + std::to_string(std::sin(turn)) + " " +
                    std::to_string(z) + colorOf(i) + "\n";
        }
        return text;
    };
    const std::vector<std::string> pure{" 1 0 0", " 0 1 0", " 0 0 1"};
    const std::string error = "cannot tell what columns 4 to 6";
    CHECK(contains(errorOf(ball([](int) { return " 1 0 0"; })), error));
    CHECK(contains(errorOf(ball([](int) { return " 1.0 0.0 0.0"; })), error));
    CHECK(contains(errorOf(ball([&](int i) { return pure[static_cast<std::size_t>(i % 3)]; })),
                   error));
    CHECK(contains(errorOf("0 0 0 1.0 0.0 0.0\n1 0 0 1.0 1.0 0.0\n"), error));
    // What programs write where they know no normal.
    CHECK(mustRead(ball([](int) { return " 0 0 1"; })).hasNormals());
    // Faces of a box, steps, and a terrain.
    std::string box;
    std::string steps;
    std::string terrain;
    for (int i = 0; i < 16; ++i) {
        const std::string a = std::to_string(i % 4);
        const std::string b = std::to_string(i / 4);
        box.append("4 ").append(a).append(" ").append(b).append(" 1 0 0\n");
        box.append(a).append(" 4 ").append(b).append(" 0 1 0\n");
        steps.append(b).append(" ").append(a).append(" ").append(b).append(" 1 0 0\n");
        terrain.append(a).append(" ").append(std::to_string(0.05 * i)).append(" ").append(b);
        terrain.append(" 0 1 0\n");
    }
    for (const std::string& text : {box, steps, terrain}) CHECK(mustRead(text).hasNormals());
}

TEST_CASE("XYZ: whole numbers that double cannot hold are noted") {
    CHECK(mustRead("x,y,z,stamp\n0,0,0,1699999999123456789\n", "a.csv").notes ==
          std::vector<std::string>{"column stamp: numbers above 2^53 have lost their last digits"});
    CHECK(mustRead("x,y,z,stamp\n0,0,0,1e300\n", "a.csv").notes.empty());
}

TEST_CASE("XYZ: numbers of columns that nothing explains are refused with the way out") {
    for (const char* text :
         {"1 2\n", "1 2 3 4 5\n", "1 2 3 4 5 6 7 8\n", "1 2 3 4 5 6 7 8 9 10\n"}) {
        INFO(text);
        const std::string error = errorOf(text, "a.xyz");
        CHECK(contains(error, "a.xyz: line 1: expected 3 numbers (x y z), or 4, 6, 7 or 9"));
        CHECK(contains(error, "name them in a line before the points"));
    }
    CHECK(mustRead("# x y z label time\n1 2 3 4 5\n").attributes.size() == 2);
}

TEST_CASE("XYZ: decimal commas are read where every number has exactly one") {
    const std::vector<Vec3> expected{{0.123, 0.456, -0.789}, {1, 2.5, 1200}};
    for (const char* text :
         {"0,123 0,456 -0,789\n1,0 2,5 1,2e3\n", "0,123\t0,456\t-0,789\r\n1,0\t2,5\t1,2e3\r\n",
          "0,123;0,456;-0,789\n1,0; 2,5 ;1,2e3\n"}) {
        INFO(text);
        const PointFile file = mustRead(text);
        CHECK(file.position == expected);
        CHECK(file.attributes.empty());
        CHECK_FALSE(file.hasNormals());
    }
    CHECK(mustRead("0,5 0,5 0,5 0,0 0,6 0,8\n").normal == std::vector<Vec3>{{0, 0.6, 0.8}});
}

TEST_CASE("XYZ: commas between numbers part them, with blanks or without") {
    for (const char* text : {"0.1,0.0,1.0,0,0,1\n", "0.1, 0.0, 1.0, 0, 0, 1\n",
                             "0.1 ,0.0\t,1.0,  0,0,1,\n", "0.1;0.0;1.0;0;0;1\n"}) {
        INFO(text);
        const PointFile file = mustRead(text);
        CHECK(file.position == std::vector<Vec3>{{0.1, 0, 1}});
        CHECK(file.normal == std::vector<Vec3>{{0, 0, 1}});
    }
    CHECK(mustRead("1,2,3\n4 5 6\n7, 8, 9\n").position.size() == 3);
}

TEST_CASE("XYZ: commas that could be either are refused with their line") {
    // A plain number among decimal commas, thousands, pairs, a lone comma, a comma at an end.
    for (const char* row : {"0,123 0 0,789", "1,234.5 2,345.6 3,456.7", "1,2, 3,4 5,6",
                            "1,2,3 4,5,6", "0,1 ,5 0,2", "1 2 3,", "0,1;0,2 0.3"}) {
        INFO(row);
        CHECK(contains(errorOf(std::string("# scan\n") + row + "\n"), "line 2: expected commas"));
    }
    CHECK(contains(errorOf("0,1 0,2 0,3\n1 2 3\n"), "line 2: expected one decimal comma"));
    CHECK(contains(errorOf("0,1 0,2 0,3\n1,2,3\n"), "line 2: expected one decimal comma"));
    CHECK(contains(errorOf("1 2 3\n0,1 0,2 0,3\n"), "line 2: found decimal commas"));
    CHECK(contains(errorOf("1,2,3,4,,6\n"), "line 1: expected a number between two commas"));
    CHECK(contains(errorOf("1;2;3;;5;6;7\n"), "line 1: expected a number between two semicolons"));
}

TEST_CASE("XYZ: commas within quotation marks are decimal where others part the numbers") {
    for (const char* head : {"", "\"x\",\"y\",\"z\"\n"}) {
        const PointFile file =
            mustRead(std::string(head) + "\"3,14\",\"3,00\",\"-3,99\"\n", "a.csv");
        CHECK(file.position == std::vector<Vec3>{{3.14, 3, -3.99}});
        CHECK(file.attributes.empty());
        CHECK(file.notes == std::vector<std::string>{"commas are read as decimal points"});
    }
    CHECK(mustRead("\"1\",\"2\",\"3\"\n4,5,6\n", "a.csv").position[0] == Vec3(1, 2, 3));
    CHECK(mustRead("\"1,2,3\"\n", "a.csv").position[0] == Vec3(1, 2, 3));
    CHECK(mustRead("\"1,5\";\"2,5\";\"3,5\"\n", "a.csv").position[0] == Vec3(1.5, 2.5, 3.5));
    // Thousands, and a number without a comma beside them.
    for (const char* row : {"\"14,107\",\"0\",\"99,000\"", "\"5,141.07\",\"5,000.00\",\"5,990.00\"",
                            "\"14,107\",2,3"})
        CHECK(contains(errorOf(std::string(row) + "\n", "a.csv"), "found a mixture"));
}

TEST_CASE("Text: other formats refuse a decimal comma with its line") {
    CHECK(contains(errorOf("v 0,1 0,2 0,3\n"), "line 1: expected three numbers, found \"0,1\""));
    CHECK(contains(errorOf("OFF\n1 0 0\n0,1 0,2 0,3\n"), "line 3: expected three numbers"));
    CHECK(contains(errorOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                           "property float y\nproperty float z\nend_header\n0,1 0,2 0,3\n"),
                   "line 8: expected a value of type float"));
    CHECK(contains(errorOf("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n"
                           "0,1 0,2 0,3\n"),
                   "line 6: expected a number for field \"x\", found \"0,1\""));
}

TEST_CASE("XYZ: point numbers in the first column are not taken for x") {
    const std::string four = "101 500123.1 5400234.2 312.1\n102 500124.1 5400235.2 312.2\n";
    CHECK(contains(errorOf(four), "line 1: column 1 counts the rows"));
    CHECK(contains(errorOf("1 0 0 0 9 8 7\n2 1 0 0 9 8 7\n3 0 1 0 9 8 7\n"), "column 1 counts"));
    const PointFile named = mustRead("# id x y z\n" + four);
    CHECK(named.position[0] == Vec3(500123.1, 5400234.2, 312.1));
    CHECK(named.attributes[0].name == "id");
    // A grid of points with intensities, whose x does not count.
    CHECK(mustRead("1 0 0 7\n1 1 0 8\n2 0 0 9\n").position.size() == 3);
}

TEST_CASE("XYZ: many whole numbers, all different, before three fractions are numbers of points") {
    const auto rows = [](const std::string& end, auto first) {
        std::string text;
        for (int i = 0; i < 12; ++i)
            text += std::to_string(first(i)) + " " + std::to_string(0.5 * i) + " 1.5 0.25" + end;
        return text;
    };
    const auto gaps = [](int i) { return 1000 + 3 * i; };
    for (const std::string& text :
         {rows("\n", gaps), rows("\n", [](int i) { return 7 * i % 12; }),
          rows("\n", [](int i) { return 12.0 - i; }), rows(" 9 8 7\n", gaps)})
        CHECK(contains(errorOf(text), "line 1: column 1 holds another whole number in each row"));
    CHECK(mustRead("# id x y z\n" + rows("\n", gaps)).position[2] == Vec3(1, 1.5, 0.25));
    // Places: some of them alike, with fractions, or with whole numbers after them.
    CHECK(mustRead(rows("\n", [](int i) { return i / 2; })).position.size() == 12);
    CHECK(mustRead(rows("\n", [](int i) { return 0.5 * i; })).position.size() == 12);
    CHECK(mustRead(replaced(rows("\n", gaps), "1000 ", "1000.5 ")).position.size() == 12);
    std::string whole;
    for (int i = 0; i < 12; ++i) whole += std::to_string(gaps(i)) + " 0.5 1.5 40\n";
    CHECK(mustRead(whole).position[1] == Vec3(1003, 0.5, 1.5));
}

TEST_CASE("XYZ: a sentence with a word per column is not taken for names of normals or colors") {
    const std::string rows = "0 0 1 0 0 1\n1 0 0 1 0 0\n0 1 0 0 1 0\n";
    CHECK(contains(errorOf("# x y z in mm, up\n" + rows), "line 1: this comment has one word"));
    CHECK(contains(errorOf("# coordinates x y z in meters\n" + rows), "line 1: this comment"));
    CHECK(mustRead("# x y z nx ny nz\n" + rows).hasNormals());
    CHECK(mustRead("# id x y z r g b\n5 0 0 1 9 200 7\n6 1 0 0 9 100 7\n").attributes.size() == 4);
    // Nor is a comment that names a column twice.
    CHECK(mustRead("# x y z nx nx ny\n" + rows).hasNormals());
}

TEST_CASE("XYZ: one wrong number does not turn colors into normals") {
    std::string rows;
    for (int i = 0; i < 20; ++i)
        rows += "0 0 " + std::to_string(i) + " 200 9 " + std::to_string(i) + "\n";
    CHECK(mustRead(rows).attributes.size() == 3);
    CHECK(contains(errorOf(rows + "1 1 1 -1 0 0\n"), "cannot tell what columns 4 to 6 hold"));
    CHECK(contains(errorOf("0 0 0 nan 1 1\n0 0 1 nan 1 1\n" + rows), "cannot tell"));
}
