/// Meshes far from the origin: no writer may move a point by more than a thousandth of the spacing.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh_bytes.h"
#include "spiraling_edge/io/write_mesh.h"
#include "support/clouds.h"
#include "support/io_support.h"

using namespace se;
using namespace se::test;

namespace {

struct FarMesh {
    PointFile points;
    std::vector<Triangle> triangles;

    double spacing() const {
        double sum = 0.0;
        for (const Triangle& t : triangles)
            sum += glm::length(points.position[t.b] - points.position[t.a]);
        return sum / static_cast<double>(triangles.size());
    }
};

/// A torus of `size` about `middle`.
FarMesh torusAt(const Vec3& middle, double size) {
    FarMesh mesh{closedFamilies(1.0)[1].sample(1), {}};
    for (Vec3& x : mesh.points.position) x = middle + size / 2.5 * x;
    mesh.points.positionType = ScalarType::Double;
    mesh.triangles = runAll(prepared(mesh.points), *paramsByName("robust")).state.mesh();
    return mesh;
}

/// Every position of a file with the intended one.
struct Pairs {
    std::vector<Vec3> found;
    std::vector<Vec3> meant;

    double farthest() const {
        REQUIRE(found.size() == meant.size());
        REQUIRE_FALSE(found.empty());
        double farthest = 0.0;
        for (std::size_t i = 0; i < found.size(); ++i)
            farthest = std::max(farthest, glm::length(found[i] - meant[i]));
        return farthest;
    }
};

Pairs readBack(const std::filesystem::path& path, const FarMesh& mesh) {
    const std::string bytes = bytesOf(path);
    if (path.extension() == ".glb")
        return {glbPositions(bytes, mesh.points.position.size()), mesh.points.position};
    if (path.extension() != ".stl")
        return {mustRead(bytes, path.string()).position, mesh.points.position};
    Pairs pairs{stlCorners(bytes), {}};
    for (const Triangle& t : mesh.triangles) {
        for (const Index corner : {t.a, t.b, t.c})
            pairs.meant.push_back(mesh.points.position[corner]);
    }
    return pairs;
}

}  // namespace

TEST_CASE(
    "mesh files: every format keeps a scan far from the origin to a thousandth of its spacing") {
    const TemporaryFolder folder;
    const std::pair<Vec3, double> places[] = {{{500000, 5400000, 300}, 2.0},
                                              {{-1e9, 3.25e8, 1e3}, 100.0},
                                              {{0.0, -7e4, 1e-3}, 0.01},
                                              {{1e12, -1e12, 1e12}, 5e3}};
    for (const auto& [middle, size] : places) {
        const FarMesh mesh = torusAt(middle, size);
        REQUIRE_FALSE(mesh.triangles.empty());
        for (const MeshFormat& format : meshFormats()) {
            INFO(format.extension << " at " << middle.x);
            const auto path = folder / ("far" + std::string(format.extension)).c_str();
            REQUIRE(writeMesh(path, mesh.points, mesh.triangles).ok());
            CHECK(readBack(path, mesh).farthest() <= mesh.spacing() / 1000.0);
        }
    }
}

TEST_CASE("STL: the shift is a round number, given by its header and by shiftOf()") {
    const FarMesh mesh = torusAt({500001, 5400001, 301}, 2.0);
    const MeshFormat& stl = *meshFormatOf("far.stl");
    const auto shift = shiftOf(stl, mesh.points, mesh.triangles);
    REQUIRE(shift.has_value());
    CHECK(*shift == Vec3(500000, 5400000, 300));
    const std::string bytes = stl.bytes(mesh.points, mesh.triangles);
    CHECK(bytes.substr(0, 80) ==
          "written by spiraling-edge; add 500000 5400000 300" + std::string(31, ' '));
    CHECK(shiftInHeader(bytes) == *shift);
    for (const MeshFormat& format : meshFormats()) {
        if (format.extension == ".stl") continue;
        CHECK_FALSE(shiftOf(format, mesh.points, mesh.triangles).has_value());
    }
}

TEST_CASE("STL: where floats are fine enough the positions are those of the input") {
    for (const double far : {0.0, 1.0, 200.0}) {
        const FarMesh mesh = torusAt({far, 0, 0}, 2.0);
        const MeshFormat& stl = *meshFormatOf("near.stl");
        CHECK_FALSE(shiftOf(stl, mesh.points, mesh.triangles).has_value());
        const std::string bytes = stl.bytes(mesh.points, mesh.triangles);
        CHECK_FALSE(contains(bytes.substr(0, 80), "add"));
        const Vec3& first = mesh.points.position[mesh.triangles[0].a];
        CHECK(floatAt(bytes, 96) == static_cast<float>(first.x));
    }
}

TEST_CASE("STL: a mesh that no shift helps, or without size, is written without one") {
    PointFile points;
    const MeshFormat& stl = *meshFormatOf("a.stl");
    CHECK_FALSE(shiftOf(stl, points, {}).has_value());
    // All corners in one place, and small triangles far apart.
    points.position.assign(3, Vec3(1e7 + 0.1));
    const std::vector<Triangle> one{{0, 1, 2}};
    CHECK_FALSE(shiftOf(stl, points, one).has_value());
    points.position = {{1e7, 0, 0},  {1e7, 0.1, 0},  {1e7 + 0.1, 0, 0},
                       {-1e7, 0, 0}, {-1e7, 0.1, 0}, {-1e7 - 0.1, 0, 0}};
    const std::vector<Triangle> two{{0, 1, 2}, {3, 4, 5}};
    CHECK_FALSE(shiftOf(stl, points, two).has_value());
}

TEST_CASE("OFF: plain unless normals are requested, STL has no place for them") {
    const TemporaryFolder folder;
    const FarMesh mesh = torusAt({0, 0, 0}, 2.0);
    const auto plain = folder / "a.off";
    REQUIRE(writeMesh(plain, mesh.points, mesh.triangles).ok());
    CHECK(bytesOf(plain).starts_with("OFF\n"));
    CHECK_FALSE(mustRead(bytesOf(plain), "a.off").hasNormals());
    REQUIRE(writeMesh(plain, mesh.points, mesh.triangles, {.normals = true}).ok());
    CHECK(bytesOf(plain).starts_with("NOFF\n"));
    CHECK(mustRead(bytesOf(plain), "a.off").normal == mesh.points.normal);
    const Status refused =
        writeMesh(folder / "a.stl", mesh.points, mesh.triangles, {.normals = true});
    REQUIRE_FALSE(refused.ok());
    CHECK(contains(refused.error().message, "no place for normals"));
    for (const char* name : {"a.obj", "a.ply", "a.glb"}) {
        const MeshFormat& format = *meshFormatOf(name);
        CHECK((format.bytesWithNormals == format.bytes));
    }
}
