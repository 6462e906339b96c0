/// Meshes written for other programs (write_mesh.h): read back by our own readers where there is
/// one, else by the formats' specifications.
#include "spiraling_edge/io/write_mesh.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include "mesh_bytes.h"
#include "support/clouds.h"
#include "support/io_support.h"

using namespace se;
using namespace se::test;

namespace {

struct Mesh {
    PointFile points;
    std::vector<Triangle> triangles;
};

/// A torus with normals, moved far out so that digits count.
Mesh torusMesh() {
    Mesh mesh{closedFamilies(1.0)[1].sample(1), {}};
    for (Vec3& x : mesh.points.position) x += Vec3(1e6, -2e3, 0.1);
    mesh.points.positionType = ScalarType::Double;
    mesh.triangles = runAll(prepared(mesh.points), *paramsByName("robust")).state.mesh();
    return mesh;
}

std::string bytesAs(const char* extension, const Mesh& mesh) {
    return meshFormatOf(std::string("x") + extension)->bytes(mesh.points, mesh.triangles);
}
std::string bytesWithNormals(const char* extension, const Mesh& mesh) {
    return meshFormatOf(std::string("x") + extension)
        ->bytesWithNormals(mesh.points, mesh.triangles);
}

}  // namespace

TEST_CASE("mesh files: OBJ, OFF and PLY read back exactly, with and without normals") {
    for (const char* extension : {".obj", ".off", ".ply"}) {
        for (const bool withNormals : {true, false}) {
            Mesh mesh = torusMesh();
            if (!withNormals) mesh.points.normal.clear();
            const auto again =
                readPoints(bytesWithNormals(extension, mesh), std::string("again") + extension);
            REQUIRE_MESSAGE(again.ok(), extension);
            CHECK(again.value().position == mesh.points.position);
            CHECK(again.value().faces == mesh.triangles);
            if (extension == std::string(".ply")) continue;  // Normals there as float.
            CHECK(again.value().normal == mesh.points.normal);
        }
    }
}

TEST_CASE("mesh files: points alone can be written in every format") {
    for (const MeshFormat& format : meshFormats()) {
        Mesh mesh = torusMesh();
        mesh.triangles.clear();
        CHECK_FALSE(format.bytes(mesh.points, mesh.triangles).empty());
        CHECK_FALSE(format.bytes(PointFile{}, {}).empty());
    }
}

TEST_CASE("STL: header, count, and a normal with three corners per triangle") {
    const Mesh mesh = torusMesh();
    const std::string bytes = bytesAs(".stl", mesh);
    REQUIRE(bytes.size() == 84 + 50 * mesh.triangles.size());
    CHECK_FALSE(bytes.starts_with("solid"));
    CHECK(wordAt(bytes, 80) == mesh.triangles.size());
    for (const std::size_t i : {std::size_t{0}, mesh.triangles.size() - 1}) {
        const Triangle& t = mesh.triangles[i];
        const std::size_t row = 84 + 50 * i;
        const Vec3 n = vectorAt(bytes, row);
        CHECK(glm::length(n) == doctest::Approx(1.0));
        CHECK(glm::dot(n, mesh.points.normal[t.a]) > 0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t at = row + 12 + 4 * static_cast<std::size_t>(axis);
            const double shift = shiftInHeader(bytes)[axis];
            CHECK(floatAt(bytes, at) ==
                  static_cast<float>(mesh.points.position[t.a][axis] - shift));
            CHECK(floatAt(bytes, at + 24) ==
                  static_cast<float>(mesh.points.position[t.c][axis] - shift));
        }
    }
}

TEST_CASE("GLB: chunks of the right length, and places that keep their digits far out") {
    const Mesh mesh = torusMesh();
    const std::string bytes = bytesAs(".glb", mesh);
    REQUIRE(bytes.substr(0, 4) == "glTF");
    CHECK(wordAt(bytes, 4) == 2);
    CHECK(wordAt(bytes, 8) == bytes.size());
    const std::size_t json = wordAt(bytes, 12);
    CHECK(json % 4 == 0);
    CHECK(bytes.substr(16, 4) == "JSON");
    const std::size_t head = 20 + json;
    CHECK(bytes.substr(head + 4, 4) == std::string("BIN\0", 4));
    const std::size_t binary = wordAt(bytes, head);
    CHECK(head + 8 + binary == bytes.size());
    const std::size_t count = mesh.points.position.size();
    CHECK(binary == 24 * count + 12 * mesh.triangles.size());
    // Distances between points are preserved, which floats at 1e6 would not do.
    const std::size_t first = head + 8;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 found = vectorAt(bytes, first + 12 * t.b) - vectorAt(bytes, first + 12 * t.a);
        const Vec3 wanted = mesh.points.position[t.b] - mesh.points.position[t.a];
        CHECK(glm::length(found - wanted) < 1e-6);
    }
    const std::size_t indices = first + 24 * count;
    CHECK(wordAt(bytes, indices) == mesh.triangles[0].a);
    CHECK(wordAt(bytes, indices + 8) == mesh.triangles[0].c);
}

TEST_CASE("GLB: the box of the positions is that of the floats in the file") {
    Mesh mesh = torusMesh();
    mesh.points.position[3].x = std::numeric_limits<double>::quiet_NaN();
    const std::string bytes = bytesAs(".glb", mesh);
    const std::size_t json = wordAt(bytes, 12);
    const std::string text = bytes.substr(20, json);
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find("inf") == std::string::npos);
    Vec3 low = vectorAt(bytes, 28 + json);
    Vec3 high = low;
    for (std::size_t p = 0; p < mesh.points.position.size(); ++p) {
        low = glm::min(low, vectorAt(bytes, 28 + json + 12 * p));
        high = glm::max(high, vectorAt(bytes, 28 + json + 12 * p));
    }
    const auto numbersAfter = [&](const char* key) {
        float x = 0.0F;
        float y = 0.0F;
        float z = 0.0F;
        const char* at = text.c_str() + text.find(key);
        REQUIRE(std::sscanf(at + std::strlen(key), "[%f,%f,%f]", &x, &y, &z) == 3);
        return Vec3(x, y, z);
    };
    CHECK(numbersAfter("\"min\":") == low);
    CHECK(numbersAfter("\"max\":") == high);
}

TEST_CASE("mesh files: the extension decides, in any case, others are named in the error") {
    CHECK(meshFormatOf("a.OBJ")->extension == ".obj");
    CHECK(meshFormatOf("folder.obj/a")->extension == ".ply");
    CHECK(meshFormatOf("a.fbx") == nullptr);
    const TemporaryFolder folder;
    const Mesh mesh = torusMesh();
    const Status status = writeMesh(folder / "a.fbx", mesh.points, mesh.triangles);
    REQUIRE_FALSE(status.ok());
    CHECK(status.error().message.find(".glb") != std::string::npos);
    for (const MeshFormat& format : meshFormats()) {
        const auto path = folder / ("a" + std::string(format.extension)).c_str();
        CHECK(writeMesh(path, mesh.points, mesh.triangles).ok());
        CHECK(bytesOf(path) == format.bytes(mesh.points, mesh.triangles));
    }
    const std::vector<Triangle> outside{{0, 1, 4000000000U}};
    CHECK_FALSE(writeMesh(folder / "b.stl", mesh.points, outside).ok());
    CHECK_FALSE(std::filesystem::exists(folder / "b.stl"));
}

TEST_CASE("Lists of formats: names and extensions, with a word before the last one") {
    CHECK(wordList(std::array<std::string, 0>{}, "or").empty());
    CHECK(wordList(std::array{"PLY"}, "or") == "PLY");
    CHECK(wordList(std::array{"PLY", "OBJ"}, "or") == "PLY or OBJ");
    CHECK(wordList(std::array{"PLY", "OBJ", "OFF"}, "") == "PLY, OBJ, OFF");
    CHECK(listText(pointFormats(), &PointFormat::name, "or") ==
          "PLY, STL, GLB, LAS, PTX, XYZ, OBJ, OFF or PCD");
    CHECK(listText(pointFormats(), &PointFormat::name, "and", &PointFormat::faces) ==
          "PLY, STL, GLB, OBJ and OFF");
    CHECK(listText(meshFormats(), &MeshFormat::extension, "and") ==
          ".ply, .obj, .off, .stl and .glb");
    CHECK(listText(meshFormats(), &MeshFormat::name, "or", keepsPoints) == "PLY, OBJ, OFF or GLB");
}
