/// Lists of clouds that are hard to search, compared with those found by looking at all pairs.
#include "spiraling_edge/prepare/neighbor_search.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "neighbor_oracle.h"
#include "spiraling_edge/prepare/single_search.h"

using namespace se;
using namespace se::test;

namespace {

struct NamedCloud {
    std::string name;
    OraclePoints points;
};

/// Normals up, but for this percentage of them.
OraclePoints withNormals(std::vector<Vec3> position, int flippedPercent) {
    OraclePoints points{std::move(position), {}, {}};
    Numbers numbers;
    for (std::size_t i = 0; i < points.position.size(); ++i) {
        const bool flipped = numbers.next() * 100.0 < flippedPercent;
        const Vec3 tilt = numbers.nextVector() - Vec3(0.5);
        points.normal.push_back(glm::normalize(Vec3(tilt.x, tilt.y, flipped ? -1 : 1)));
    }
    points.usable.assign(points.position.size(), true);
    return points;
}

std::vector<Vec3> evenPositions(std::size_t count) {
    std::vector<Vec3> positions;
    Numbers numbers;
    for (std::size_t i = 0; i < count; ++i) positions.push_back(numbers.nextVector());
    return positions;
}

/// Ever denser toward the middle, by this power.
std::vector<Vec3> clusteredPositions(std::size_t count, double power) {
    std::vector<Vec3> positions = evenPositions(count);
    Numbers numbers;
    for (Vec3& p : positions) p = (p - Vec3(0.5)) * std::pow(numbers.next(), power);
    return positions;
}

std::vector<NamedCloud> hardClouds(std::size_t count, int flippedPercent) {
    const std::vector<Vec3> even = evenPositions(count);
    std::vector<Vec3> line = even;
    for (Vec3& p : line) p = Vec3(0.25 * p.x, p.x, -p.x);
    std::vector<Vec3> rows = even;  // many equal coordinates, and exact ties
    for (Vec3& p : rows) p = glm::floor(p * 4.0);
    std::vector<Vec3> twice = even;
    for (std::size_t i = 0; i < count; i += 2) twice[i] = twice[i + 1];
    std::vector<Vec3> stray = even;
    for (std::size_t i = 0; i < count; i += 20) stray[i] *= 1e6;
    const auto scaled = [&](double scale) {
        std::vector<Vec3> positions = even;
        for (Vec3& p : positions) p *= scale;
        return positions;
    };
    std::vector<NamedCloud> clouds;
    const auto add = [&](const char* name, std::vector<Vec3> positions) {
        clouds.push_back({name, withNormals(std::move(positions), flippedPercent)});
    };
    add("even", even);
    add("clustered", clusteredPositions(count, 8.0));
    add("line", line);
    add("lattice", makeLattice(6).position);
    add("rows", rows);
    add("twice", twice);
    add("stray", stray);
    add("tiny", scaled(1e-150));
    add("square vanishes in part", scaled(1e-161));
    add("square vanishes", scaled(1e-170));
    add("least numbers", scaled(1e-322));
    add("large", scaled(1e150));
    add("square overflows in part", scaled(2e154));
    add("square overflows", scaled(1e300));
    return clouds;
}

Lists found(const OraclePoints& points, NeighborOptions options, unsigned threads = 1) {
    options.threads = threads;
    const auto lists = findNeighbors(points.position, points.normal, points.usable, options);
    REQUIRE_MESSAGE(lists.ok(), lists.error().message);
    return toVectors(lists.value());
}

/// Compares the lists of every point, or of one in `step`.
void checkLists(const NamedCloud& cloud, const NeighborOptions& options, Index step = 1) {
    const Lists lists = found(cloud.points, options);
    std::size_t wrong = 0;
    for (Index p = 0; p < lists.size(); p += step)
        wrong += lists[p] == bruteForceList(cloud.points, options, p) ? 0U : 1U;
    CHECK_MESSAGE(wrong == 0, cloud.name);
    CHECK_MESSAGE(found(cloud.points, options, 3) == lists, cloud.name);
}

/// A dense ball of points beside a sparse cloud around it.
std::vector<Vec3> ballInHaze(std::size_t dense, std::size_t sparse) {
    std::vector<Vec3> positions = evenPositions(dense + sparse);
    for (std::size_t i = 0; i < dense; ++i) positions[i] = positions[i] * 1e-3 + Vec3(0.5);
    return positions;
}

}  // namespace

TEST_CASE("findNeighbors: the k nearest of hard clouds are those of all pairs") {
    for (const NamedCloud& cloud : hardClouds(170, 0)) {
        const std::size_t n = cloud.points.position.size();
        for (const std::size_t k :
             {std::size_t{1}, std::size_t{6}, std::size_t{12}, n / 4, n - 1, n})
            checkLists(cloud, nearest(k, false));
    }
}

TEST_CASE("findNeighbors: opposing normals are left out, whatever their share") {
    for (const int percent : {0, 10, 50, 100}) {
        for (const NamedCloud& cloud : hardClouds(170, percent)) {
            for (const std::size_t k : {1U, 12U, 40U, 169U}) checkLists(cloud, nearest(k, true));
        }
    }
}

TEST_CASE(
    "findNeighbors: a flipped point gets no neighbors, the corners of a tetrahedron all others") {
    OraclePoints flat = withNormals(evenPositions(170), 0);
    flat.normal[85] = Vec3(0, 0, -1);
    CHECK(found(flat, nearest(12, true))[85].empty());
    const Vec3 corners[] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    OraclePoints tetrahedron;
    for (const Vec3& x : corners) {
        tetrahedron.position.push_back(x);
        tetrahedron.normal.push_back(glm::normalize(x));
        tetrahedron.usable.push_back(true);
    }
    const Lists all{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
    CHECK(found(tetrahedron, nearest(12, true)) == all);
    CHECK(found(tetrahedron, within(3.0, true)) == all);
}

TEST_CASE("findNeighbors: a radius in hard clouds takes what comparing all pairs does") {
    for (const NamedCloud& cloud : hardClouds(170, 10)) {
        const double extent = glm::distance(cloud.points.position[0], cloud.points.position[1]);
        for (const double share : {1e-3, 0.1, 0.5, 1.0, 100.0}) {
            if (!(share * extent > 0.0)) continue;
            checkLists(cloud, within(share * extent, false));
            checkLists(cloud, within(share * extent, true));
        }
    }
}

TEST_CASE("findNeighbors: points that are not usable neither have lists nor stand in one") {
    for (NamedCloud& cloud : hardClouds(170, 10)) {
        for (std::size_t i = 0; i < cloud.points.usable.size(); ++i)
            cloud.points.usable[i] = i % 3 != 1;
        checkLists(cloud, nearest(12, true));
        checkLists(cloud, within(0.2, true));
    }
}

TEST_CASE("findNeighbors: sets of all sizes up to a few blocks") {
    for (std::size_t count = 1; count < 40; ++count) {
        const NamedCloud cloud{"few", withNormals(evenPositions(count), 20)};
        for (const std::size_t k : {1U, 5U, 12U}) checkLists(cloud, nearest(k, true));
        checkLists(cloud, within(0.4, true));
    }
}

TEST_CASE("findNeighbors: a dense ball within the reach of sparse points") {
    const NamedCloud cloud{"ball in haze", withNormals(ballInHaze(5000, 600), 10)};
    for (const bool drop : {false, true}) checkLists(cloud, nearest(12, drop), 37);
    checkLists({"steep", withNormals(clusteredPositions(4000, 16.0), 3)}, nearest(12, true), 37);
}

TEST_CASE("findNeighbors: thousands of copies of one point among others") {
    std::vector<Vec3> positions = evenPositions(600);
    positions.insert(positions.begin() + 300, 3000, Vec3(0.5));
    const NamedCloud cloud{"copies", withNormals(positions, 10)};
    for (const bool drop : {false, true}) checkLists(cloud, nearest(12, drop), 37);
    checkLists(cloud, within(0.1, true), 37);
}

TEST_CASE("SingleSearch: the lists of hard clouds are those of all pairs") {
    for (const int percent : {0, 50}) {
        for (const NamedCloud& cloud : hardClouds(170, percent)) {
            const OraclePoints& points = cloud.points;
            const PointBlocks blocks(points.position, points.usable);
            std::vector<Vec3> normal;
            for (std::size_t i = 0; i < blocks.size(); ++i)
                normal.push_back(points.normal[blocks.id(i)]);
            ListRule rule;
            rule.length = 12;
            rule.examined = 8 * 12 + 64;
            SingleSearch search(blocks, normal, rule);
            std::size_t wrong = 0;
            for (std::size_t i = 0; i < blocks.size(); ++i) {
                std::vector<Index> ids;
                for (const Neighbor& neighbor : search.list(i)) ids.push_back(neighbor.id);
                wrong += ids == bruteForceList(points, nearest(12, true), blocks.id(i)) ? 0U : 1U;
            }
            CHECK_MESSAGE(wrong == 0, cloud.name);
        }
    }
}

TEST_CASE("findNeighbors: the point at place 8 k + 64 is examined, the one after it is not") {
    std::vector<Vec3> line;
    for (int i = 0; i < 200; ++i) line.emplace_back(i, 0, 0);
    for (const Index agreeing : {80U, 81U}) {
        OraclePoints points = withNormals(line, 0);
        points.normal[0] = points.normal[agreeing] = Vec3(0, 0, -1);
        const Lists lists = found(points, nearest(2, true));
        CHECK(lists[0] == (agreeing == 80 ? std::vector<Index>{80} : std::vector<Index>{}));
    }
}
