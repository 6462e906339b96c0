/// The exact predicates, against integer arithmetic wide enough to be exact.
#include "spiraling_edge/geometry/exact_predicates.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

__extension__ using Wide = __int128;

/// A point of integers.
struct Grid {
    std::int64_t x, y, z;
    Vec3 vec() const {
        return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    }
};
struct WideVec {
    Wide x, y, z;
};

WideVec minus(const Grid& a, const Grid& b) {
    return {Wide{a.x} - b.x, Wide{a.y} - b.y, Wide{a.z} - b.z};
}
Wide dot(const WideVec& a, const WideVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
WideVec cross(const WideVec& a, const WideVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
bool isZero(const WideVec& v) { return v.x == 0 && v.y == 0 && v.z == 0; }
int signOf(Wide x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

int sign3(const Grid& a, const Grid& b, const Grid& c, const Grid& d) {
    return signOf(dot(minus(a, d), cross(minus(b, d), minus(c, d))));
}
int sign2(const Grid& a, const Grid& b, const Grid& c, Axis dropped) {
    const WideVec n = cross(minus(a, c), minus(b, c));
    return signOf(dropped == Axis::X ? n.x : (dropped == Axis::Y ? n.y : n.z));
}

class GridRandom {
  public:
    explicit GridRandom(std::uint64_t seed) : random_(seed) {}
    /// In -reach .. reach.
    std::int64_t number(std::int64_t reach) {
        const auto range = static_cast<std::size_t>(2 * reach + 1);
        return static_cast<std::int64_t>(random_.below(range)) - reach;
    }
    Grid point(std::int64_t reach) {
        const std::int64_t x = number(reach);
        const std::int64_t y = number(reach);
        return {x, y, number(reach)};
    }
    /// a + i (b - a) + j (c - a), then a step of at most `off` on each axis.
    Grid nearPlane(const Grid& a, const Grid& b, const Grid& c, std::int64_t off) {
        const std::int64_t i = number(3);
        const std::int64_t j = number(3);
        const Grid step = point(off);
        return {a.x + i * (b.x - a.x) + j * (c.x - a.x) + step.x,
                a.y + i * (b.y - a.y) + j * (c.y - a.y) + step.y,
                a.z + i * (b.z - a.z) + j * (c.z - a.z) + step.z};
    }

  private:
    Random random_;
};

constexpr std::array<std::int64_t, 4> kReaches{3, 1000, std::int64_t{1} << 20,
                                               std::int64_t{1} << 37};
constexpr std::array kAxes{Axis::X, Axis::Y, Axis::Z};

using Corners = std::array<Grid, 3>;

bool hasArea(const Corners& t) { return !isZero(cross(minus(t[1], t[0]), minus(t[2], t[0]))); }

/// True if there is a gap between the triangles along the axis.
bool separates(const WideVec& axis, const Corners& a, const Corners& b) {
    const auto range = [&](const Corners& t) {
        std::array<Wide, 3> at{};
        for (std::size_t i = 0; i < 3; ++i) at[i] = dot(axis, {t[i].x, t[i].y, t[i].z});
        const auto [low, high] = std::minmax({at[0], at[1], at[2]});
        return std::pair(low, high);
    };
    const auto [lowA, highA] = range(a);
    const auto [lowB, highB] = range(b);
    return highA < lowB || highB < lowA;
}

/// Separating axes: two triangles with an area have no point in common exactly if one of their
/// normals, of the products of their edges, or of the normals in their planes at edges, separates
/// them.
bool meetBySeparation(const Corners& a, const Corners& b) {
    const auto edge = [](const Corners& t, std::size_t i) { return minus(t[(i + 1) % 3], t[i]); };
    const WideVec na = cross(edge(a, 0), edge(a, 1));
    const WideVec nb = cross(edge(b, 0), edge(b, 1));
    if (separates(na, a, b) || separates(nb, a, b)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (separates(cross(na, edge(a, i)), a, b)) return false;
        if (separates(cross(nb, edge(b, i)), a, b)) return false;
        for (std::size_t j = 0; j < 3; ++j) {
            if (separates(cross(edge(a, i), edge(b, j)), a, b)) return false;
        }
    }
    return true;
}

/// True if the two triangles of five points share more than corners; empty if the result depends on
/// their order.
std::optional<bool> shareMore(const std::vector<Vec3>& x, const Triangle& a, const Triangle& b) {
    const auto turned = [](const Triangle& t, int turn) {
        switch (turn) {
            case 0:
                return t;
            case 1:
                return Triangle{t.b, t.c, t.a};
            case 2:
                return Triangle{t.c, t.a, t.b};
            case 3:
                return Triangle{t.b, t.a, t.c};
            case 4:
                return Triangle{t.a, t.c, t.b};
            default:
                return Triangle{t.c, t.b, t.a};
        }
    };
    const bool first = trianglesShareMore(x, a, b);
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            if (trianglesShareMore(x, turned(a, i), turned(b, j)) != first) return std::nullopt;
            if (trianglesShareMore(x, turned(b, j), turned(a, i)) != first) return std::nullopt;
        }
    }
    return first;
}

}  // namespace

TEST_CASE("exact: orient3d is positive below a plane counterclockwise from above") {
    const Vec3 a(0, 0, 0);
    const Vec3 b(1, 0, 0);
    const Vec3 c(0, 1, 0);
    CHECK(orient3d(a, b, c, {0.2, 0.2, -1e-300}) > 0);
    CHECK(orient3d(a, b, c, {0.2, 0.2, 1e-300}) < 0);
    CHECK(orient3d(a, b, c, {7, -3, 0}) == 0);
    CHECK(orient2d(a, b, c, Axis::Z) > 0);
    CHECK(orient2d(a, c, b, Axis::Z) < 0);
    CHECK(orient2d(a, b, {2, 0, 5}, Axis::Z) == 0);
}

TEST_CASE("exact: orient3d has the sign of integer arithmetic, in and near planes as well") {
    std::array<int, 3> seen{};
    for (const std::int64_t reach : kReaches) {
        GridRandom random(static_cast<std::uint64_t>(reach));
        std::size_t wrong = 0;
        for (int i = 0; i < 5000; ++i) {
            const Grid a = random.point(reach);
            const Grid b = random.point(reach);
            const Grid c = random.point(reach);
            const Grid d = i % 3 == 0 ? random.point(reach) : random.nearPlane(a, b, c, i % 3 - 1);
            const int expected = sign3(a, b, c, d);
            ++seen[static_cast<std::size_t>(expected + 1)];
            wrong += orient3d(a.vec(), b.vec(), c.vec(), d.vec()) == expected ? 0 : 1;
        }
        CHECK_MESSAGE(wrong == 0, "reach ", reach);
    }
    for (const int count : seen) CHECK(count > 1000);
}

TEST_CASE("exact: orient2d has the sign of integer arithmetic, in and near lines as well") {
    for (const std::int64_t reach : kReaches) {
        GridRandom random(static_cast<std::uint64_t>(reach) + 1);
        std::size_t wrong = 0;
        for (int i = 0; i < 5000; ++i) {
            const Grid a = random.point(reach);
            const Grid b = random.point(reach);
            const Grid c = i % 3 == 0 ? random.point(reach) : random.nearPlane(a, b, b, i % 3 - 1);
            for (const Axis axis : kAxes) {
                wrong += orient2d(a.vec(), b.vec(), c.vec(), axis) == sign2(a, b, c, axis) ? 0 : 1;
            }
        }
        CHECK_MESSAGE(wrong == 0, "reach ", reach);
    }
}

TEST_CASE("exact: signs do not change when everything is moved far away and made small") {
    // 2^20 + i 2^-20 is exactly a double.
    const auto far = [](const Grid& p) {
        return p.vec() * 0x1p-20 + Vec3(0x1p20, -0x1p20, 0x1p19);
    };
    GridRandom random(7);
    std::size_t wrong = 0;
    std::size_t flat = 0;
    for (int i = 0; i < 10000; ++i) {
        const Grid a = random.point(5000);
        const Grid b = random.point(5000);
        const Grid c = random.point(5000);
        const Grid d = random.nearPlane(a, b, c, i % 2);
        const int expected = sign3(a, b, c, d);
        flat += expected == 0 ? 1 : 0;
        wrong += orient3d(far(a), far(b), far(c), far(d)) == expected ? 0 : 1;
        wrong += orient3d(far(b), far(a), far(c), far(d)) == -expected ? 0 : 1;
        for (const Axis axis : kAxes) {
            wrong += orient2d(far(a), far(b), far(d), axis) == sign2(a, b, d, axis) ? 0 : 1;
        }
    }
    CHECK(wrong == 0);
    CHECK(flat > 4000);
}

TEST_CASE("exact: what a floating-point determinant gets wrong is still right") {
    // Points in the plane x + y + z = 1, off by one unit in the last place of 2^20.
    const double tiny = 0x1p-32;
    const Vec3 move(0x1p20, 0x1p20, 0x1p20);
    const Vec3 a = move + Vec3(1, 0, 0);
    const Vec3 b = move + Vec3(0, 1, 0);
    const Vec3 c = move + Vec3(0, 0, 1);
    const Vec3 d = move + Vec3(-1, 1, 1);
    const int up = orient3d(a, b, c, d + Vec3(0, 0, tiny));
    CHECK(orient3d(a, b, c, d) == 0);
    CHECK(up != 0);
    CHECK(orient3d(a, b, c, d - Vec3(0, 0, tiny)) == -up);
}

TEST_CASE("exact: a point beside a line by one unit in the last place is on its side of it") {
    // The differences to (24, 24) are rounded to equal numbers.
    const Vec3 b(12, 12, 0);
    const Vec3 c(24, 24, 0);
    CHECK(orient2d({0.5 + 0x1p-53, 0.5, 0}, b, c, Axis::Z) < 0);
    CHECK(orient2d({0.5, 0.5 + 0x1p-53, 0}, b, c, Axis::Z) > 0);
    CHECK(orient2d({0.5, 0.5, 0}, b, c, Axis::Z) == 0);
}

TEST_CASE("exact: triangles meet exactly where no separating axis exists, on small lattices") {
    for (const std::int64_t reach : {1, 2, 4, 50}) {
        GridRandom random(static_cast<std::uint64_t>(reach) + 2);
        std::size_t wrong = 0;
        std::size_t meeting = 0;
        std::size_t tested = 0;
        for (int i = 0; i < 10000; ++i) {
            Corners a{random.point(reach), random.point(reach), random.point(reach)};
            Corners b{random.point(reach), random.point(reach), random.point(reach)};
            if (i % 4 == 0) {  // In one plane.
                for (Grid& p : a) p.z = 0;
                for (Grid& p : b) p.z = 0;
            }
            if (!hasArea(a) || !hasArea(b)) continue;
            ++tested;
            const bool expected = meetBySeparation(a, b);
            meeting += expected ? 1 : 0;
            const Vec3 x[3] = {a[0].vec(), a[1].vec(), a[2].vec()};
            const Vec3 y[3] = {b[0].vec(), b[1].vec(), b[2].vec()};
            wrong += trianglesMeet(x, y) == expected ? 0 : 1;
            wrong += trianglesMeet(y, x) == expected ? 0 : 1;
        }
        CHECK_MESSAGE(wrong == 0, "reach ", reach);
        CHECK(meeting > 500);
        CHECK(meeting + 500 < tested);
    }
}

TEST_CASE("exact: a triangle without area off the plane of another does not meet it") {
    const Vec3 whole[3] = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Vec3 line[3] = {{1, 2, 2}, {1, 3, 3}, {1, 4, 4}};
    CHECK_FALSE(trianglesMeet(whole, line));
    CHECK_FALSE(trianglesMeet(line, whole));
}

TEST_CASE("exact: a segment meets a triangle through it, at its rim, and lying in it") {
    const Vec3 t[3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    CHECK(segmentMeetsTriangle({1, 1, -1}, {1, 1, 1}, t));
    CHECK(segmentMeetsTriangle({1, 1, 0}, {1, 1, 1}, t));   // It ends on it.
    CHECK(segmentMeetsTriangle({2, 2, -1}, {2, 2, 1}, t));  // Through an edge.
    CHECK(segmentMeetsTriangle({4, 0, -1}, {4, 0, 1}, t));  // Through a corner.
    CHECK(segmentMeetsTriangle({1, 1, 0}, {2, 1, 0}, t));   // Inside, in the plane.
    CHECK(segmentMeetsTriangle({-1, 1, 0}, {9, 1, 0}, t));  // Across, in the plane.
    CHECK(segmentMeetsTriangle({4, 0, 0}, {9, 0, 0}, t));   // In line with an edge.
    CHECK_FALSE(segmentMeetsTriangle({5, 0, 0}, {9, 0, 0}, t));
    CHECK_FALSE(segmentMeetsTriangle({1, 1, 1}, {1, 1, 9}, t));
    CHECK_FALSE(segmentMeetsTriangle({3, 3, -1}, {3, 3, 1}, t));
    CHECK_FALSE(segmentMeetsTriangle({3, 3, 0}, {5, 3, 0}, t));
}

TEST_CASE("exact: without a common corner, triangles share more if they touch at all") {
    const Vec3 a(0, 0, 0);
    const Vec3 b(4, 0, 0);
    const Vec3 c(0, 4, 0);
    const auto other = [&](const Vec3& x, const Vec3& y, const Vec3& z) {
        return shareMore({a, b, c, x, y, z}, {0, 1, 2}, {3, 4, 5});
    };
    CHECK(other({0, 0, 1}, {4, 0, 1}, {0, 4, 1}) == false);     // Above it.
    CHECK(other({5, 5, 0}, {9, 5, 0}, {5, 9, 0}) == false);     // Beside it, in its plane.
    CHECK(other({1, 1, -1}, {1, 1, 1}, {9, 9, 0}) == true);     // Through it.
    CHECK(other({1, 1, 0}, {9, 9, 1}, {9, 9, 2}) == true);      // A corner on it.
    CHECK(other({4, 0, 0}, {9, 0, 1}, {9, 0, -1}) == true);     // Corner to corner.
    CHECK(other({2, 0, -1}, {2, 0, 1}, {2, -5, 0}) == true);    // Edge to edge.
    CHECK(other({1, 1, 0}, {2, 1, 0}, {1, 2, 0}) == true);      // Inside it, in its plane.
    CHECK(other({-1, -1, 0}, {9, -1, 0}, {-1, 9, 0}) == true);  // About it, in its plane.
    CHECK(other({3, 3, 0}, {-1, 1, 0}, {9, 9, 0}) == true);     // Across it, in its plane.
}

TEST_CASE("exact: at a common corner, triangles share more if one reaches into the other") {
    const auto other = [&](const Vec3& x, const Vec3& y) {
        return shareMore({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, x, y}, {0, 1, 2}, {0, 3, 4});
    };
    CHECK(other({-4, 0, 0}, {0, -4, 0}) == false);  // Opposite, in its plane.
    CHECK(other({0, 0, 4}, {-4, 0, 0}) == false);   // Upright beside it.
    CHECK(other({1, 1, 1}, {1, 1, 2}) == false);    // Upright over it.
    CHECK(other({1, 1, 1}, {1, 1, -1}) == true);    // Through it.
    CHECK(other({9, 9, 1}, {9, 9, -1}) == true);    // Through it, reaching farther.
    CHECK(other({1, 1, 0}, {9, 9, 9}) == true);     // An edge within it.
    CHECK(other({2, 0, 0}, {0, 0, 5}) == true);     // An edge along its edge.
    CHECK(other({9, 0, 0}, {0, 0, 5}) == true);     // And beyond.
    CHECK(other({1, 2, 0}, {2, 1, 0}) == true);     // Within it, in its plane.
    CHECK(other({9, -1, 0}, {-1, 9, 0}) == true);   // Over all of it.
    CHECK(other({-1, 2, 0}, {2, 2, 0}) == true);    // Over a part.
}

TEST_CASE("exact: at a common edge, triangles share more only if folded flat onto one another") {
    const auto other = [&](const Vec3& y) {
        return shareMore({{0, 0, 0}, {4, 0, 0}, {1, 4, 0}, y}, {0, 1, 2}, {0, 1, 3});
    };
    CHECK(other({1, -4, 0}) == false);    // A flat neighbor.
    CHECK(other({1, 0, 4}) == false);     // At a right angle.
    CHECK(other({1, 4, 1e-9}) == false);  // Nearly folded.
    CHECK(other({1, 3, 0}) == true);      // Folded.
    CHECK(other({-9, 1, 0}) == true);
    CHECK(overlapAtEdge({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}));
    CHECK_FALSE(overlapAtEdge({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -1, 0}));
}

TEST_CASE("exact: two triangles on the same three points always share more") {
    const std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(shareMore(x, {0, 1, 2}, {0, 1, 2}) == true);
}

TEST_CASE("exact: sharing more does not depend on the order of corners or triangles") {
    GridRandom random(11);
    std::array<std::size_t, 2> seen{};
    for (int i = 0; i < 3000; ++i) {
        std::vector<Vec3> x;
        for (int p = 0; p < 6; ++p) {
            Grid g = random.point(2);
            if (i % 3 == 0) g.z = 0;
            x.push_back(g.vec());
        }
        const Index common = static_cast<Index>(i % 3);
        const Triangle a{0, 1, 2};
        const Triangle b{common > 0 ? 0U : 3U, common > 1 ? 1U : 4U, 5};
        const auto area = [&](const Triangle& t) {
            return glm::length(glm::cross(x[t.b] - x[t.a], x[t.c] - x[t.a]));
        };
        if (area(a) == 0 || area(b) == 0) continue;
        const auto verdict = shareMore(x, a, b);
        REQUIRE(verdict.has_value());
        ++seen[*verdict ? 1 : 0];
    }
    CHECK(seen[0] > 300);
    CHECK(seen[1] > 300);
}
