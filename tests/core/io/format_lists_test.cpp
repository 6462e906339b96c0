#include "spiraling_edge/io/format_lists.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace se;

TEST_CASE("Lists of formats: names and extensions, with a word before the last one") {
    CHECK(wordList(std::array<std::string, 0>{}, "or").empty());
    CHECK(wordList(std::array{"PLY"}, "or") == "PLY");
    CHECK(wordList(std::array{"PLY", "OBJ"}, "or") == "PLY or OBJ");
    CHECK(wordList(std::array{"PLY", "OBJ", "OFF"}, "") == "PLY, OBJ, OFF");
    CHECK(listText(pointFormats(), &PointFormat::name, "or") == "PLY, XYZ, OBJ, OFF or PCD");
    CHECK(listText(pointFormats(), &PointFormat::name, "and", &PointFormat::faces) ==
          "PLY, OBJ and OFF");
    CHECK(listText(meshFormats(), &MeshFormat::extension, "and") ==
          ".ply, .obj, .off, .stl and .glb");
    CHECK(listText(meshFormats(), &MeshFormat::name, "or", isReadable) == "PLY, OBJ or OFF");
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
    for (const char* other : {"a.png", "a.stl", "a", "ply", ""}) {
        CAPTURE(other);
        CHECK(pointFormatOf(other) == nullptr);
    }
}

TEST_CASE("Formats of points: a file of no known kind is refused with all that can be read") {
    const Result<PointFile> read = readPoints("what is this", "a.doc");
    REQUIRE_FALSE(read.ok());
    const std::string& message = read.error().message;
    for (const PointFormat& format : pointFormats()) {
        CHECK(message.find(format.name) != std::string::npos);
        CHECK(message.find(format.details) != std::string::npos);
    }
    CHECK(message.find("OBJ, OFF and PCD can be read; convert it") != std::string::npos);
}
