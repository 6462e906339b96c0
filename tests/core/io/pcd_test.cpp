/// PCD, ascii and binary: valid files, and the errors of invalid ones.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <string>

#include "support/clouds.h"
#include "support/io_support.h"

using namespace se;
using namespace se::test;

#include "spiraling_edge/base/float_bits.h"

namespace {

const std::string kHead =
    "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
    "FIELDS x y z normal_x normal_y normal_z curvature\nSIZE 4 4 4 4 4 4 4\nTYPE F F F F F F F\n"
    "COUNT 1 1 1 1 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\n";
const std::string kRows = "1 2.5 3 0 0 1 0.5\n-4 5 nan 0 1 0 0.25\n";

template <typename T>
void add(std::string& bytes, T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

}  // namespace

TEST_CASE("PCD: points, normals and other fields, in text") {
    const auto result = readPoints(kHead + "DATA ascii\n" + kRows, "a.pcd");
    REQUIRE(result.ok());
    const PointFile& file = result.value();
    REQUIRE(file.position.size() == 2);
    CHECK(file.position[0] == Vec3(1, 2.5, 3));
    CHECK(std::isnan(file.position[1].z));
    CHECK(file.normal[1] == Vec3(0, 1, 0));
    CHECK(file.positionType == ScalarType::Float);
    REQUIRE(file.attributes.size() == 1);
    CHECK(file.attributes[0].name == "curvature");
    CHECK(file.attributes[0].values == std::vector<double>{0.5, 0.25});
}

TEST_CASE("PCD: names of positions and normals are known in capitals, as in PLY") {
    for (const char* names : {"X Y Z NX NY NZ CURVATURE", "x y z nx nY nz Curvature",
                              "X y z Normal_X Normal_Y Normal_Z curvature"}) {
        CAPTURE(names);
        std::string head = kHead;
        const std::string usual = "x y z normal_x normal_y normal_z curvature";
        head.replace(head.find(usual), usual.size(), names);
        const auto result = readPoints(head + "DATA ascii\n" + kRows, "a.pcd");
        REQUIRE(result.ok());
        CHECK(result.value().position[0] == Vec3(1, 2.5, 3));
        REQUIRE(result.value().hasNormals());
        CHECK(result.value().normal[1] == Vec3(0, 1, 0));
        CHECK(result.value().attributes.size() == 1);
    }
    // As they are written before others: the normals are those of nx, as before.
    const auto both = readPoints(
        "FIELDS x y z Normal_X Normal_Y Normal_Z nx ny nz\nSIZE 4 4 4 4 4 4 4 4 4\n"
        "TYPE F F F F F F F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n0 0 0 1 0 0 0 0 1\n",
        "a.pcd");
    REQUIRE(both.ok());
    CHECK(both.value().normal == std::vector<Vec3>{Vec3(0, 0, 1)});
}

TEST_CASE("PCD: the same points in binary, whatever the size and order of the fields") {
    std::string bytes =
        "VERSION .7\nFIELDS z label x _ y rgb\nSIZE 8 2 8 1 8 4\nTYPE F U F U F F\n"
        "COUNT 1 1 1 3 1 1\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA binary\n";
    for (int i = 0; i < 3; ++i) {
        add(bytes, 0.1 * i);
        add(bytes, static_cast<std::uint16_t>(40000 + i));
        add(bytes, 1e6 + i);
        bytes += "___";
        add(bytes, -2.0 * i);
        add(bytes, 0x00102030U + static_cast<std::uint32_t>(i));
    }
    const auto result = readPoints(bytes, "a.pcd");
    REQUIRE(result.ok());
    const PointFile& file = result.value();
    CHECK(file.positionType == ScalarType::Double);
    CHECK(file.position[2] == Vec3(1e6 + 2, -4.0, 0.1 * 2));
    CHECK_FALSE(file.hasNormals());
    REQUIRE(file.attributes.size() == 4);
    CHECK(file.attributes[0].values[1] == 40001.0);
    CHECK(file.attributes[1].name == "red");
    CHECK(file.attributes[1].values[0] == 16.0);
    CHECK(file.attributes[3].values[2] == 50.0);
}

TEST_CASE("PCD: a color in text is the number that has its bits") {
    const std::string head =
        "VERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 1\n"
        "HEIGHT 1\nPOINTS 1\nDATA ascii\n";
    const auto result = readPoints(head + "0 0 0 4.2108e+06\n", "a.pcd");
    REQUIRE(result.ok());
    const std::uint32_t bits = bitsAs<std::uint32_t>(4.2108e+06F);
    CHECK(result.value().attributes[0].values[0] == static_cast<double>((bits >> 16U) & 0xFFU));
}

TEST_CASE("PCD: a color with a sign has the same bits as one without") {
    const std::string head =
        "VERSION 0.7\nFIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F I\nPOINTS 1\nDATA ascii\n";
    // -1 is four bytes of 255: alpha, red, green, blue.
    const auto file = readPoints(head + "1 2 3 -1\n", "input.pcd");
    REQUIRE(file.ok());
    REQUIRE(file.value().attributes.size() == 3);
    for (const Attribute& channel : file.value().attributes) {
        CHECK(channel.values == std::vector<double>{255});
    }
}

TEST_CASE("PCD: errors name the line or byte, and what to do") {
    CHECK(errorOf(kHead + "DATA ascii\n1 2 3 0 0 1 0\n").find("1 of 2 points") !=
          std::string::npos);
    CHECK(errorOf(kHead + "DATA ascii\n" + kRows + "7 7 7 7 7 7 7\n").find("goes on") !=
          std::string::npos);
    CHECK(errorOf(kHead + "DATA ascii\n1 2 x 0 0 1 0\n1 2 3 0 0 1 0\n").find("line 12") !=
          std::string::npos);
    CHECK(errorOf(kHead + "DATA binary_compressed\n").find("0 of 2 points") != std::string::npos);
    CHECK(errorOf(kHead + "DATA other\n").find("ascii, binary or") != std::string::npos);
    CHECK(errorOf(kHead).find("without DATA") != std::string::npos);
    CHECK(errorOf("VERSION 0.7\nFIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
                  "DATA ascii\n1 2\n")
              .find("no field z") != std::string::npos);
    CHECK(errorOf("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 3\n").find("SIZE of field") !=
          std::string::npos);
    CHECK(errorOf("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F Q\n").find("TYPE of field") !=
          std::string::npos);
    CHECK(errorOf("VERSION 0.7\nFIELDS x y z\nWIDTH 2\nHEIGHT 2\nPOINTS 3\nDATA ascii\n")
              .find("WIDTH times HEIGHT is 4, but POINTS is 3") != std::string::npos);
    CHECK(errorOf("VERSION 0.7\nFIELDS x y z\nPOINTS 4000000000\nDATA binary\n")
              .find("0 of 4000000000") != std::string::npos);
    // No such size of a floating point number.
    CHECK(
        errorOf("VERSION 0.7\nFIELDS x y z\nSIZE 2 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n")
            .find("no field x of type F and size 4 or 8") != std::string::npos);
    CHECK(errorOf("VERSION 0.7\nFIELDS x y z n\nSIZE 4 4 4 1\nTYPE F F F U\nPOINTS 1\n"
                  "DATA ascii\n1 2 3 300\n")
              .find("300 is no number of the type and size of field \"n\"") != std::string::npos);
    CHECK(errorOf("VERSION 0.7\nNONSENSE 1\n").find("line of a PCD header") != std::string::npos);
}

TEST_CASE("PCD: cut at any byte it is refused, in text and in binary") {
    std::string binary = kHead + "DATA binary\n";
    for (int i = 0; i < 14; ++i) add(binary, 0.5F * static_cast<float>(i));
    REQUIRE(readPoints(binary, "a.pcd").ok());
    // The last row of text may lose its line end, and digits of its last number.
    const std::string text = kHead + "DATA ascii\n" + kRows;
    for (std::size_t size = 1; size < binary.size(); ++size) {
        CHECK_FALSE(readPoints(binary.substr(0, size), "a.pcd").ok());
    }
    for (std::size_t size = 1; size + 5 < text.size(); ++size) {
        CHECK_FALSE(readPoints(text.substr(0, size), "a.pcd").ok());
    }
}

TEST_CASE("PCD: without POINTS there are WIDTH times HEIGHT") {
    const std::string head = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\n";
    const std::string rows = "DATA ascii\n0 0 0\n1 0 0\n";
    const auto two = readPoints(head + rows, "a.pcd");
    REQUIRE(two.ok());
    CHECK(two.value().position.size() == 2);
    const auto four = readPoints(head + "HEIGHT 2\n" + rows + "0 1 0\n1 1 0\n", "a.pcd");
    REQUIRE(four.ok());
    CHECK(four.value().position.size() == 4);
}

TEST_CASE("PCD: fields of several numbers per point, or of an unknown type, are passed over") {
    const auto file = readPoints(
        "VERSION 0.7\nFIELDS x y z histogram half i\nSIZE 4 4 4 4 2 4\nTYPE F F F F F F\n"
        "COUNT 1 1 1 2 1 1\nPOINTS 1\nDATA ascii\n1 2 3 4 5 7 6\n",
        "a.pcd");
    REQUIRE(file.ok());
    REQUIRE(file.value().attributes.size() == 1);
    CHECK(file.value().attributes[0].name == "i");
    CHECK(file.value().attributes[0].values == std::vector<double>{6});
}

TEST_CASE("PCD: positions are double if one of their fields is") {
    const std::string text =
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 8 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n"
        "1 4000000.123456789 3\n";
    const PointFile file = mustRead(text);
    CHECK(file.positionType == ScalarType::Double);
    CHECK(file.position[0].y == 4000000.123456789);
    CHECK(mustRead(replaced(text, "4 8 4", "4 4 4")).positionType == ScalarType::Float);
}

TEST_CASE("PCD: a field named _ is padding, and whole numbers are no coordinates") {
    const std::string head = "VERSION 0.7\nFIELDS x y z _ i\nSIZE 4 4 4 4 4\nTYPE F F ";
    const std::string rest = " F F\nPOINTS 1\nDATA ascii\n1 2 3 4 5\n";
    const auto file = readPoints(head + "F" + rest, "a.pcd");
    REQUIRE(file.ok());
    REQUIRE(file.value().attributes.size() == 1);
    CHECK(file.value().attributes[0].name == "i");
    CHECK(errorOf(head + "I" + rest).find("no field z of type F") != std::string::npos);
}
