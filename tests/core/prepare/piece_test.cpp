#include "spiraling_edge/prepare/piece.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

Piece inBox(const Vec3& low, const Vec3& high) {
    Box box(low);
    box.high = high;
    return {box, 0.0};
}
Piece thinnedTo(double spacing) { return {std::nullopt, spacing}; }

/// Six points on the x-axis with everything that a file can hold.
PointFile rowOfSix() {
    PointFile file;
    for (int i = 0; i < 6; ++i) {
        file.position.emplace_back(i, 0.0, 0.0);
        file.normal.emplace_back(0.0, i, 1.0);
        file.type.push_back(static_cast<std::uint8_t>(i));
    }
    file.attributes.push_back({"red", ScalarType::UInt8, {10, 11, 12, 13, 14, 15}});
    for (const std::vector<Index>& list :
         {std::vector<Index>{1, 2}, {0, 2, 3}, {3, 0, 4}, {}, {5, 3, 1}, {4}}) {
        file.neighbors.append(list);
    }
    file.faces = {{0, 1, 2}, {2, 4, 3}, {3, 4, 5}, {4, 3, 2}};
    return file;
}

std::vector<Index> indicesOf(const std::vector<bool>& keep) {
    std::vector<Index> indices;
    for (Index p = 0; p < keep.size(); ++p) {
        if (keep[p]) indices.push_back(p);
    }
    return indices;
}

std::vector<Vec3> randomCloud(std::uint64_t seed, std::size_t count, const Vec3& center) {
    Random random(seed);
    std::vector<Vec3> position;
    for (std::size_t i = 0; i < count; ++i) position.push_back(center + random.inCube());
    return position;
}

/// The points that thinning keeps, by comparing each point with all that were kept before.
std::vector<bool> thinnedByHand(const std::vector<Vec3>& position, double spacing) {
    std::vector<bool> keep(position.size());
    for (std::size_t p = 0; p < position.size(); ++p) {
        keep[p] = true;
        for (std::size_t q = 0; q < p; ++q) {
            if (keep[q] && glm::length((position[p] - position[q]) / spacing) < 1.0)
                keep[p] = false;
        }
    }
    return keep;
}

}  // namespace

TEST_CASE("piece: a box holds the points on its walls, and none beside them") {
    const double above = std::nextafter(1.0, 2.0);
    const std::vector<Vec3> position{{0, 0, 0},      {1, 2, 3},   {1, 0, 3},  {above, 1, 1},
                                     {0.5, -0.1, 1}, {1, 1, 3.1}, {0.5, 1, 1}};
    CHECK(indicesOf(pointsIn(position, inBox({0, 0, 0}, {1, 2, 3}))) ==
          std::vector<Index>{0, 1, 2, 6});
    CHECK(indicesOf(pointsIn(position, inBox({1, 0, 0}, {1, 2, 3}))) == std::vector<Index>{1, 2});
}

TEST_CASE("piece: a box leaves out points that are not finite, a spacing keeps them") {
    constexpr double kNotNumber = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    const std::vector<Vec3> position{
        {0, 0, 0}, {kNotNumber, 0, 0}, {0, kInfinite, 0}, {0, 0, -kInfinite}, {0, 0, 0.5}};
    CHECK(indicesOf(pointsIn(position, inBox(Vec3(-9), Vec3(9)))) == std::vector<Index>{0, 4});
    CHECK(indicesOf(pointsIn(position, thinnedTo(1.0))) == std::vector<Index>{0, 1, 2, 3});
    CHECK(indicesOf(pointsIn(position, {inBox(Vec3(-9), Vec3(9)).crop, 1.0})) ==
          std::vector<Index>{0});
}

TEST_CASE("piece: normals, types, attributes, lists and faces follow the points") {
    const PointFile piece = pieceOf(rowOfSix(), inBox({2, 0, 0}, {4, 0, 0}));
    CHECK(piece.position == std::vector<Vec3>{{2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
    CHECK(piece.normal == std::vector<Vec3>{{0, 2, 1}, {0, 3, 1}, {0, 4, 1}});
    CHECK(piece.type == std::vector<std::uint8_t>{2, 3, 4});
    REQUIRE(piece.attributes.size() == 2);
    CHECK(piece.attributes[0].values == std::vector<double>{12, 13, 14});
    CHECK(piece.attributes[1].name == "index");
    CHECK(piece.attributes[1].type == ScalarType::UInt32);
    CHECK(piece.attributes[1].values == std::vector<double>{2, 3, 4});
    CHECK(piece.faces == std::vector<Triangle>{{0, 2, 1}, {2, 1, 0}});
    CHECK(piece.neighbors.offset == std::vector<std::uint32_t>{0, 2, 2, 3});
    CHECK(piece.neighbors.ids == std::vector<Index>{1, 2, 1});
}

TEST_CASE(
    "piece: a column index of the file is kept, so that a piece of a piece names its points") {
    const PointFile once = pieceOf(rowOfSix(), inBox({1, 0, 0}, {5, 0, 0}));
    const PointFile twice = pieceOf(once, thinnedTo(2.0));
    REQUIRE(twice.attributes.size() == 2);
    CHECK(twice.attributes[1].values == std::vector<double>{1, 3, 5});
}

TEST_CASE("piece: marked points are kept like those of a box") {
    const PointFile marked = keptPoints(rowOfSix(), {false, false, true, true, true, false});
    const PointFile box = pieceOf(rowOfSix(), inBox({2, 0, 0}, {4, 0, 0}));
    CHECK(marked.position == box.position);
    CHECK(marked.faces == box.faces);
    REQUIRE(marked.attributes.size() == 2);
    CHECK(marked.attributes[1].values == std::vector<double>{2, 3, 4});
}

TEST_CASE("piece: coordinates are scaled, and normals stay perpendicular to the surface") {
    const Vec3 factors(74310.0, 111132.0, 0.5);
    PointFile file = rowOfSix();
    file.normal[0] = Vec3(0.0);
    file.viewpoint = Vec3(1.0, 2.0, 4.0);
    const PointFile made = pieceOf(file, {{}, 0.0, factors});
    CHECK(made.position[2] == Vec3(148620.0, 0.0, 0.0));
    CHECK(made.viewpoint == Vec3(74310.0, 222264.0, 2.0));
    CHECK(made.normal[0] == Vec3(0.0));
    for (std::size_t p = 1; p < 6; ++p) {
        CHECK(std::abs(glm::length(made.normal[p]) - 1.0) < 1e-12);
        // In the plane of the file.
        const Vec3 along(0.0, 1.0, -static_cast<double>(p));
        CHECK(std::abs(glm::dot(file.normal[p], along)) < 1e-12);
        CHECK(std::abs(glm::dot(made.normal[p], glm::normalize(along * factors))) < 1e-12);
    }
    CHECK(made.positionType == ScalarType::Double);
    CHECK(made.faces == file.faces);
    CHECK(made.type == file.type);
    CHECK(made.attributes.size() == 1);
    CHECK(scaled(file, Vec3(1e-300, 1.0, 1e300)).normal[3] == Vec3(0.0, 1.0, 0.0));
}

TEST_CASE("piece: box and spacing mean the coordinates of the file, before they are scaled") {
    Piece piece = inBox({2, 0, 0}, {5, 0, 0});
    piece.thin = 1.5;
    piece.scale = Vec3(10.0, 1.0, 1.0);
    CHECK(pieceOf(rowOfSix(), piece).position ==
          std::vector<Vec3>{{20.0, 0.0, 0.0}, {40.0, 0.0, 0.0}});
}

TEST_CASE("piece: the whole file is as it was") {
    const PointFile whole = pieceOf(rowOfSix(), {});
    CHECK(whole.position == rowOfSix().position);
    CHECK(whole.attributes.size() == 1);
    CHECK(whole.faces == rowOfSix().faces);
    CHECK(whole.neighbors.ids == rowOfSix().neighbors.ids);
}

TEST_CASE("piece: a box is cut out before the rest is thinned") {
    // The point at 0 would displace the one at 1.
    const PointFile piece = pieceOf(rowOfSix(), {inBox({1, 0, 0}, {5, 0, 0}).crop, 1.5});
    CHECK(piece.position == std::vector<Vec3>{{1, 0, 0}, {3, 0, 0}, {5, 0, 0}});
}

TEST_CASE("piece: of missing values thinning keeps none, unless they are places like all others") {
    PointFile file;
    for (int i = 0; i < 100; ++i) file.position.emplace_back(i % 10, i / 10, 500.0);
    file.normal.assign(100, Vec3(0, 0, 1));
    for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 1, 0)}) {
        file.position.emplace_back(0, 0, 0);
        file.normal.push_back(normal);
    }
    Piece thinned = thinnedTo(0.5);
    const PointFile piece = pieceOf(file, thinned);
    CHECK(piece.position.size() == 100);
    CHECK(piece.notes == std::vector<std::string>{
                             "left out by thinning: 4 points where a missing value was written"});
    thinned.farValues = FarValues::Real;
    const PointFile kept = pieceOf(file, thinned);
    REQUIRE(kept.position.size() == 101);
    CHECK(kept.notes.empty());
    CHECK(glm::distance(kept.normal.back(), glm::normalize(Vec3(0, 1, 1))) < 1e-12);
}

TEST_CASE("piece: of the points at one place the one that thinning keeps has their mean normal") {
    PointFile file;
    file.position = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    file.normal = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const PointFile piece = pieceOf(file, thinnedTo(0.5));
    REQUIRE(piece.normal.size() == 2);
    CHECK(glm::distance(piece.normal[0], glm::normalize(Vec3(1, 1, 0))) < 1e-12);
    CHECK(piece.normal[1] == Vec3(0, 0, 1));
}

TEST_CASE("piece: points at exactly the spacing stay, copies go") {
    const std::vector<Vec3> position{
        {0, 0, 0}, {0.5, 0, 0}, {0, 0, 0}, {0, 0.5, 0}, {0.5, 0, 0.25}};
    CHECK(indicesOf(pointsIn(position, thinnedTo(0.5))) == std::vector<Index>{0, 1, 3});
}

TEST_CASE(
    "piece: no two kept points are nearer than the spacing, each other one is near a kept one") {
    for (const double spacing : {0.01, 0.1, 0.37, 5.0}) {
        for (const Vec3& center : {Vec3(0.0), Vec3(5.4e6, -1e3, 0.5)}) {
            const std::vector<Vec3> position = randomCloud(7, 3000, center);
            const std::vector<bool> keep = pointsIn(position, thinnedTo(spacing));
            std::size_t tooNear = 0;
            std::size_t needless = 0;
            for (std::size_t p = 0; p < position.size(); ++p) {
                bool near = false;
                for (std::size_t q = 0; q < p; ++q)
                    near |= keep[q] && glm::distance(position[p], position[q]) < spacing;
                tooNear += keep[p] && near ? 1U : 0U;
                needless += !keep[p] && !near ? 1U : 0U;
            }
            CHECK(tooNear == 0);
            CHECK(needless == 0);
            CHECK(keep.front());
        }
    }
}

TEST_CASE("piece: extreme coordinates and spacings are thinned as by hand") {
    std::vector<Vec3> position = randomCloud(3, 300, Vec3(0.0));
    for (const double x : {1e300, -1e300, 1e-300, 0x1p54, 0x1p54 + 4.0, 0x1p53, 0x1p53 + 2.0, 3e38})
        position.insert(position.end(), {Vec3(x), Vec3(x, 0, 0), Vec3(x)});
    for (const double spacing : {1e-200, 0.25, 1.0, 3.0, 1e30, 1e200})
        CHECK(pointsIn(position, thinnedTo(spacing)) == thinnedByHand(position, spacing));
}

TEST_CASE("piece: equal points give the same piece, wherever they are in memory") {
    const std::vector<Vec3> position = randomCloud(11, 20000, Vec3(1.0));
    const std::vector<bool> first = pointsIn(position, thinnedTo(0.05));
    const std::vector<Vec3> copy(position.begin(), position.end());
    CHECK(pointsIn(copy, thinnedTo(0.05)) == first);
    // What follows a point has no effect on it.
    const std::vector<Vec3> half(position.begin(), position.begin() + 10000);
    const std::vector<bool> start = pointsIn(half, thinnedTo(0.05));
    CHECK(std::equal(start.begin(), start.end(), first.begin()));
}

TEST_CASE("piece: a box without points is an error that gives the bounds") {
    PointFile file;
    file.position = {{0, 0, 0}, {4, 0.1, 2}};
    Piece piece{Box(Vec3(9, 9, 9)), 0.0};
    CHECK(cutPiece(file, piece, "a.ply").error().message ==
          "the box holds 0 of the 2 points of a.ply, which lie between (0, 0, 0) and (4, 0.1, 2); "
          "give a box that meets these bounds");
    piece.crop = Box(Vec3(0, 0, 0));
    CHECK(cutPiece(file, piece, "a.ply").value().position.size() == 1);
}
