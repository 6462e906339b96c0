#include "spiraling_edge/io/polygons.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <string>
#include <utility>

#include "spiraling_edge/io/read_points.h"
#include "support/io_support.h"

using namespace se;
using namespace se::test;

namespace {

/// Twice the area of all triangles, and of those that face down.
struct Areas {
    double all = 0.0;
    double down = 0.0;
};
Areas areasOf(const std::vector<Vec3>& position, const std::vector<Triangle>& faces) {
    Areas areas;
    for (const Triangle& t : faces) {
        const Vec3 a = position[t.a];
        const double area = glm::cross(position[t.b] - a, position[t.c] - a).z;
        areas.all += std::abs(area);
        areas.down += area < 0.0 ? -area : 0.0;
    }
    return areas;
}

/// The triangles of one polygon through all positions, in order.
std::vector<Triangle> cut(const std::vector<Vec3>& position) {
    std::vector<Index> corners(position.size());
    std::iota(corners.begin(), corners.end(), Index{0});
    io::Polygons polygons;
    std::vector<Triangle> faces;
    polygons.append(corners, faces);
    polygons.cutConcave(position, faces);
    return faces;
}

/// An L, begun so that its fan has a triangle outside.
const std::vector<Vec3> kL{{2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}};

}  // namespace

TEST_CASE("Polygons: concave ones lie within their outline") {
    std::vector<Vec3> spiral;
    for (int i = 0; i < 80; ++i) {  // Out along one side, back along the other.
        const double turn = 0.3 * std::min(i, 79 - i);
        const double radius = (i < 40 ? 1.0 : 0.5) + turn;
        spiral.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 0.0);
    }
    // A square with a square hole, joined by a slit.
    const std::vector<Vec3> slit{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0},
                                 {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
    for (const std::vector<Vec3>& outline : {kL, spiral, slit}) {
        double area = 0.0;
        for (std::size_t i = 0; i < outline.size(); ++i)
            area += glm::cross(outline[i], outline[(i + 1) % outline.size()]).z;
        const std::vector<Triangle> faces = cut(outline);
        CHECK(faces.size() == outline.size() - 2);
        const Areas areas = areasOf(outline, faces);
        CHECK(areas.all == doctest::Approx(std::abs(area)));
        CHECK((areas.down == 0.0 || areas.down == areas.all));
    }
}

TEST_CASE("Polygons: no triangle is without area where corners lie in a line") {
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {2, 0, 0},
                                   {2, 2, 0}, {1, 2, 0}, {0, 2, 0}};
    for (const Triangle& t : cut(square)) CHECK(areasOf(square, {t}).all > 0.0);
}

TEST_CASE("Polygons: a fan that is right stays, and so does one that crosses itself") {
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0}};
    CHECK(cut(square) == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
    const std::vector<Vec3> bow{{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 2, 0}};
    CHECK(cut(bow).size() == 2);
    const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    CHECK(cut(line) == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("Polygons: OBJ, OFF and PLY cut concave faces alike") {
    std::string vertices;
    std::string rows;
    for (const Vec3& x : kL) {
        const std::string row = std::to_string(x.x) + " " + std::to_string(x.y) + " 0\n";
        vertices += "v " + row;
        rows += row;
    }
    const std::string obj = "f 1 2 3 4 5 6\n" + vertices;  // Faces may come first.
    const std::string off = "OFF\n6 1 0\n" + rows + "6 0 1 2 3 4 5\n";
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
        rows + "6 0 1 2 3 4 5\n";
    for (const auto& [name, text] : {std::pair("a.obj", obj), {"a.off", off}, {"a.ply", ply}}) {
        CAPTURE(name);
        const PointFile file = mustRead(text, name);
        REQUIRE(file.faces.size() == 4);
        const Areas areas = areasOf(file.position, file.faces);
        CHECK(areas.all == doctest::Approx(6.0));
        CHECK(areas.down == 0.0);
    }
}
