/// Orientation of normals to a common side.
#include "spiraling_edge/prepare/orientation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "spiraling_edge/prepare/neighbor_search.h"
#include "spiraling_edge/prepare/normals.h"
#include "support/clouds.h"
#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

OrientationReport oriented(std::span<const Vec3> position, const NeighborLists& neighbors,
                           std::vector<Vec3>& normal) {
    return orientNormals(position, neighbors, normal).value();
}

OrientationOptions withThreads(unsigned threads) {
    OrientationOptions options;
    options.threads = threads;
    return options;
}

/// Turns about half of the normals.
std::vector<Vec3> shuffledSides(std::vector<Vec3> normal, std::uint64_t seed) {
    Random random(seed);
    for (Vec3& n : normal) {
        if (random.below(2) == 1) n = -n;
    }
    return normal;
}

std::size_t against(const std::vector<Vec3>& normal, const std::vector<Vec3>& truth) {
    std::size_t count = 0;
    for (std::size_t p = 0; p < normal.size(); ++p) {
        count += glm::dot(normal[p], truth[p]) <= 0.0 ? 1 : 0;
    }
    return count;
}

/// The cosine that decides, as documented: of the normal of q and that of p mirrored.
double mirroredCosine(std::span<const Vec3> position, const std::vector<Vec3>& normal, Index p,
                      Index q) {
    const Vec3 d = position[q] - position[p];
    if (d == Vec3(0.0)) return glm::dot(normal[p], normal[q]);
    const Vec3 unit = glm::normalize(d);
    return glm::dot(normal[p] - 2.0 * glm::dot(normal[p], unit) * unit, normal[q]);
}

/// A minimum spanning forest by Kruskal's algorithm.
std::vector<std::vector<Index>> kruskal(std::span<const Vec3> position, const NeighborLists& lists,
                                        const std::vector<Vec3>& normal) {
    struct Edge {
        double weight;
        Index p, q;
    };
    std::vector<Edge> edges;
    for (Index p = 0; p < lists.size(); ++p) {
        for (const Index q : lists[p]) {
            if (normal[p] == Vec3(0.0) || normal[q] == Vec3(0.0)) continue;
            edges.push_back({-std::abs(mirroredCosine(position, normal, p, q)), p, q});
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return a.weight < b.weight; });
    std::vector<Index> part(lists.size());
    for (Index p = 0; p < lists.size(); ++p) part[p] = p;
    std::vector<std::vector<Index>> tree(lists.size());
    for (const Edge& edge : edges) {
        const Index from = part[edge.p];
        const Index to = part[edge.q];
        if (from == to) continue;
        std::replace(part.begin(), part.end(), from, to);
        tree[edge.p].push_back(edge.q);
        tree[edge.q].push_back(edge.p);
    }
    return tree;
}

/// Points at random with normals and lists at random, a few without a normal: every edge of the
/// forest decides about a side.
struct RandomSides {
    std::vector<Vec3> position, normal;
    NeighborLists lists;
};
RandomSides randomSides(std::size_t count, std::size_t longest, std::uint64_t seed) {
    Random random(seed);
    RandomSides made;
    std::vector<Index> list;
    for (std::size_t p = 0; p < count; ++p) {
        made.position.push_back(random.inCube());
        made.normal.push_back(random.below(20) == 0 ? Vec3(0.0) : random.direction());
        list.clear();
        for (std::size_t i = random.below(longest + 1); i > 0; --i) {
            const auto q = static_cast<Index>(random.below(count));
            if (q != p) list.push_back(q);
        }
        made.lists.append(list);
    }
    return made;
}

}  // namespace

TEST_CASE("orientation: normals of closed surfaces point outward, in each component") {
    for (const Family& family : closedFamilies(1.0)) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const PointFile file = family.sample(seed);
            std::vector<Vec3> normal = shuffledSides(file.normal, seed);
            const std::size_t wrong = against(normal, file.normal);
            const auto report = oriented(file.position, nearestLists(file.position), normal);
            CHECK_MESSAGE(against(normal, file.normal) == 0, family.name, ", seed ", seed);
            CHECK(report.turned >= wrong);  // The first one may have been turned and turned back.
            CHECK(report.turned <= wrong + static_cast<std::size_t>(family.components));
        }
    }
}

TEST_CASE("orientation: derived normals of closed surfaces point outward as well") {
    for (const Family& family : closedFamilies(kTubesApart)) {
        const PointFile file = family.sample(2);
        const NeighborLists lists = nearestLists(file.position);
        std::vector<Vec3> normal = estimateNormals(file.position, lists).value();
        oriented(file.position, lists, normal);
        CHECK_MESSAGE(against(normal, file.normal) == 0, family.name);
    }
}

TEST_CASE("orientation: it holds around the edges of a cube, where the plain cosine is zero") {
    PointFile cube;
    constexpr int kSide = 9;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double sign = face % 2 == 0 ? 1.0 : -1.0;
        for (int i = 0; i < kSide; ++i) {
            for (int j = 0; j < kSide; ++j) {
                Vec3 x(0.0);
                x[axis] = sign;
                x[(axis + 1) % 3] = (i + 0.5) / kSide * 2 - 1;
                x[(axis + 2) % 3] = (j + 0.5) / kSide * 2 - 1;
                Vec3 n(0.0);
                n[axis] = sign;
                cube.position.push_back(x);
                cube.normal.push_back(n);
            }
        }
    }
    std::vector<Vec3> normal = shuffledSides(cube.normal, 5);
    oriented(cube.position, nearestLists(cube.position), normal);
    CHECK(against(normal, cube.normal) == 0);
}

TEST_CASE("orientation: normals on the two sides of a thin sheet point apart") {
    // Each point has a twin below it that is nearer than its neighbors.
    std::vector<Vec3> position;
    std::vector<Vec3> truth;
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 12; ++j) {
            for (const double z : {0.2, -0.2}) {
                position.push_back({i + 0.01 * j, j, z});
                truth.push_back({0, 0, z > 0 ? 1.0 : -1.0});
            }
        }
    }
    std::vector<Vec3> normal = shuffledSides(truth, 3);
    oriented(position, nearestLists(position, 8), normal);
    CHECK(against(normal, truth) == 0);
}

TEST_CASE("orientation: components are counted, and zero normals stay zero") {
    std::vector<Vec3> position;
    std::vector<Vec3> normal;
    for (const double x : {0.0, 100.0}) {
        const PointFile ball = closedFamilies(0.3)[0].sample(1);
        for (std::size_t p = 0; p < ball.position.size(); ++p) {
            position.push_back(ball.position[p] + Vec3(x, 0, 0));
            normal.push_back(ball.normal[p]);
        }
    }
    const std::vector<Vec3> truth = normal;
    for (Vec3& n : normal) n = -n;
    normal[7] = Vec3(0.0);
    const auto report = oriented(position, nearestLists(position), normal);
    CHECK(report.components == 2);
    CHECK(normal[7] == Vec3(0.0));
    normal[7] = truth[7];
    CHECK(against(normal, truth) == 0);
}

TEST_CASE("orientation: sides agree along each edge of Kruskal's minimum spanning forest") {
    std::size_t edges = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        RandomSides sides = randomSides(5 * seed, 1 + seed % 5, seed);
        const auto tree = kruskal(sides.position, sides.lists, sides.normal);
        const std::vector<Vec3> before = sides.normal;
        const auto report = oriented(sides.position, sides.lists, sides.normal);
        std::size_t ends = 0;
        std::size_t turned = 0;
        std::size_t normals = 0;
        for (Index p = 0; p < tree.size(); ++p) {
            turned += sides.normal[p] != before[p] ? 1U : 0U;
            normals += before[p] != Vec3(0.0) ? 1U : 0U;
            ends += tree[p].size();
            for (const Index q : tree[p]) {
                CHECK(mirroredCosine(sides.position, sides.normal, p, q) > 0.0);
            }
        }
        CHECK(report.components == normals - ends / 2);
        CHECK(report.turned == turned);
        edges += ends / 2;
    }
    CHECK(edges > 5000);
}

TEST_CASE("orientation: it is the same for any number of threads") {
    const RandomSides sides = randomSides(20000, 6, 1);
    std::vector<Vec3> one = sides.normal;
    const auto expected = orientNormals(sides.position, sides.lists, one, withThreads(1)).value();
    for (const unsigned threads : {0U, 2U, 3U, 8U}) {
        std::vector<Vec3> normal = sides.normal;
        const auto report =
            orientNormals(sides.position, sides.lists, normal, withThreads(threads)).value();
        CHECK(normal == one);
        CHECK(report.turned == expected.turned);
        CHECK(report.components == expected.components);
    }
}

TEST_CASE("orientation: among equal weights, the edge of the lowest indices is taken") {
    // On a lattice with three normals, edges have few different weights, and no sides agree along
    // all of them. The order of the lists must not matter.
    std::vector<Vec3> position;
    for (int i = 0; i < 30; ++i) {
        for (int j = 0; j < 30; ++j) position.push_back({i, j, 0});
    }
    Random random(4);
    std::vector<Vec3> normal;
    for (std::size_t p = 0; p < position.size(); ++p) {
        const std::array<Vec3, 3> some{Vec3(0.6, 0.8, 0), Vec3(0, 0.6, 0.8), Vec3(0.8, 0, 0.6)};
        normal.push_back(some[random.below(some.size())]);
    }
    const NeighborLists lists = nearestLists(position, 8);
    NeighborLists backward;
    for (Index p = 0; p < lists.size(); ++p) {
        const std::vector<Index> list(std::make_reverse_iterator(lists[p].end()),
                                      std::make_reverse_iterator(lists[p].begin()));
        backward.append(list);
    }
    std::vector<Vec3> other = normal;
    const auto report = oriented(position, lists, normal);
    CHECK(oriented(position, backward, other).turned == report.turned);
    CHECK(normal == other);
}

TEST_CASE("orientation: a long chain whose edges get ever cheaper faces one side") {
    // Every point joins the next: in the first round, one component of a hundred thousand links.
    constexpr int kCount = 100000;
    std::vector<Vec3> position;
    std::vector<Vec3> normal;
    NeighborLists lists;
    double angle = 0.0;
    for (int i = 0; i < kCount; ++i) {
        position.push_back({i, 0, 0});
        normal.push_back({0, std::cos(angle), std::sin(angle)});
        angle += 1.0 - 0.99 * i / kCount;
        if (i + 1 < kCount) {
            lists.append(std::vector<Index>{static_cast<Index>(i) + 1});
        } else {
            lists.append({});
        }
    }
    const auto report = oriented(position, lists, normal);
    CHECK(report.components == 1);
    for (std::size_t p = 1; p < normal.size(); ++p) CHECK(glm::dot(normal[p - 1], normal[p]) > 0);
}

TEST_CASE("orientation: progress ascends, and cancelled work is an error and turns nothing") {
    const RandomSides sides = randomSides(20000, 6, 2);
    double last = 0.0;
    std::vector<Vec3> normal = sides.normal;
    const auto ascends = [&](double share) {
        const bool on = share >= last && share <= 1.0;
        last = share;
        return on;
    };
    CHECK(orientNormals(sides.position, sides.lists, normal, withThreads(2), ascends).ok());
    CHECK(last > 0.9);
    for (const unsigned threads : {1U, 3U}) {
        normal = sides.normal;
        const auto result = orientNormals(sides.position, sides.lists, normal, withThreads(threads),
                                          [](double share) { return share < 0.6; });
        REQUIRE_FALSE(result.ok());
        CHECK(result.error().message == "the work on normals was cancelled");
        CHECK(normal == sides.normal);
    }
}

namespace {

/// Two samples of a surface, `apart` spacings from each other along the normals, with noise.
struct TwoLayers {
    std::vector<Vec3> position;
    std::vector<Vec3> outward;
    std::size_t outer = 0;  ///< Points of the outer layer, which come first.
};
TwoLayers twoLayers(const Family& family, double apart, double noise) {
    TwoLayers made;
    Random random(3);
    for (const double side : {0.5, -0.5}) {
        const PointFile layer = family.sample(side > 0.0 ? 1 : 2);
        const double spacing = std::sqrt(
            distanceSquared(layer.position[0], layer.position[nearestLists(layer.position)[0][5]]));
        for (std::size_t p = 0; p < layer.position.size(); ++p) {
            const Vec3 shift = side * apart * layer.normal[p] + noise * random.direction();
            made.position.push_back(layer.position[p] + spacing * shift);
            made.outward.push_back(layer.normal[p]);
        }
        if (side > 0.0) made.outer = made.position.size();
    }
    return made;
}

/// Shares of the points of the two layers whose derived normals point inward.
std::pair<double, double> inwardShares(const TwoLayers& layers) {
    const NeighborLists lists = nearestLists(layers.position);
    std::vector<Vec3> normal = estimateNormals(layers.position, lists).value();
    CHECK(oriented(layers.position, lists, normal).unknownSides == 0);
    std::array<double, 2> inward{};
    for (std::size_t p = 0; p < normal.size(); ++p) {
        if (glm::dot(normal[p], layers.outward[p]) < 0.0) inward[p < layers.outer ? 0 : 1] += 1.0;
    }
    const auto outer = static_cast<double>(layers.outer);
    return {inward[0] / outer, inward[1] / (static_cast<double>(normal.size()) - outer)};
}

PointFile bumpySheet(int side) {
    PointFile sheet;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            sheet.position.emplace_back(i + 0.01 * j, j, 0.3 * std::sin(i) * std::cos(j));
            sheet.normal.emplace_back(0, 0, 1);
        }
    }
    return sheet;
}

}  // namespace

TEST_CASE("orientation: of two noisy layers less than a spacing apart both face out") {
    for (const Family& family : closedFamilies(kTubesApart)) {
        if (family.components > 1) continue;
        for (const double apart : {0.3, 0.4, 0.5}) {
            const auto [outer, inner] = inwardShares(twoLayers(family, apart, 0.15));
            CHECK_MESSAGE(outer < 0.02, family.name, ", ", apart, " apart");
            CHECK_MESSAGE(inner < 0.02, family.name, ", ", apart, " apart");
        }
    }
}

TEST_CASE("orientation: sheets a spacing apart are a wall, and the outermost faces out") {
    for (const Family& family : closedFamilies(kTubesApart)) {
        if (family.components > 1) continue;
        const auto [outer, inner] = inwardShares(twoLayers(family, 1.0, 0.0));
        CHECK_MESSAGE(outer < 0.05, family.name);
        CHECK_MESSAGE(inner > 0.95, family.name);
    }
}

TEST_CASE("orientation: nested components each face out") {
    const PointFile ball = closedFamilies(1.0)[0].sample(1);
    std::vector<Vec3> position = ball.position;
    std::vector<Vec3> truth = ball.normal;
    for (std::size_t p = 0; p < ball.position.size(); ++p) {
        position.push_back(0.4 * ball.position[p]);
        truth.push_back(ball.normal[p]);
    }
    std::vector<Vec3> normal = shuffledSides(truth, 4);
    const auto report = oriented(position, nearestLists(position), normal);
    CHECK(report.components == 2);
    CHECK(report.unknownSides == 0);
    CHECK(against(normal, truth) == 0);
}

TEST_CASE("orientation: scattered points beside a surface do not decide its side") {
    PointFile ball = closedFamilies(1.0)[0].sample(1);
    const std::size_t count = ball.position.size();
    Random random(8);
    for (int i = 0; i < 12; ++i) ball.position.push_back(4.0 * random.direction());
    const NeighborLists lists = nearestLists(ball.position);
    std::vector<Vec3> normal = estimateNormals(ball.position, lists).value();
    CHECK(oriented(ball.position, lists, normal).unknownSides == 0);
    normal.resize(count);
    CHECK(against(normal, ball.normal) == 0);
}

TEST_CASE("orientation: the side of a sheet is unknown, and stays that of most of its normals") {
    const PointFile sheet = bumpySheet(15);
    const NeighborLists lists = nearestLists(sheet.position);
    for (const double sign : {1.0, -1.0}) {
        std::vector<Vec3> normal = sheet.normal;
        for (std::size_t p = 0; p < normal.size(); ++p) normal[p] *= p % 5 == 0 ? -sign : sign;
        OrientationOptions options;
        options.unknown = UnknownSide::AsMost;
        const auto report = orientNormals(sheet.position, lists, normal, options).value();
        CHECK(report.components == 1);
        CHECK(report.unknownSides == 1);
        CHECK(against(normal, sheet.normal) == (sign > 0.0 ? 0 : normal.size()));
    }
}

TEST_CASE("orientation: a sheet faces the scanner") {
    const PointFile sheet = bumpySheet(15);
    const NeighborLists lists = nearestLists(sheet.position);
    for (const double height : {30.0, -30.0, 3.0}) {
        std::vector<Vec3> normal = shuffledSides(sheet.normal, 6);
        OrientationOptions options;
        options.scanner = Vec3(7, 7, height);
        const auto report = orientNormals(sheet.position, lists, normal, options).value();
        CHECK(report.unknownSides == 0);
        CHECK(against(normal, sheet.normal) == (height > 0.0 ? 0 : normal.size()));
    }
}

TEST_CASE("orientation: a body faces a scanner outside of it, and a room one inside") {
    // Of the points of a ball less than half face a scanner outside; the others are hidden.
    for (const Family& family : closedFamilies(1.0)) {
        if (family.components > 1) continue;
        const PointFile body = family.sample(1);
        const NeighborLists lists = nearestLists(body.position);
        OrientationOptions options;
        options.scanner = Vec3(2.0, 2.5, 3.0);
        std::vector<Vec3> normal = shuffledSides(body.normal, 6);
        CHECK(orientNormals(body.position, lists, normal, options).value().unknownSides == 0);
        CHECK_MESSAGE(against(normal, body.normal) == 0, family.name);
    }
    const PointFile room = closedFamilies(1.0)[0].sample(1);
    std::vector<Vec3> normal = shuffledSides(room.normal, 6);
    OrientationOptions options;
    options.scanner = Vec3(0.2, 0.1, -0.3);
    CHECK(orientNormals(room.position, nearestLists(room.position), normal, options)
              .value()
              .unknownSides == 0);
    CHECK(against(normal, room.normal) == normal.size());
}
