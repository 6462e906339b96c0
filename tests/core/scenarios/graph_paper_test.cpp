/// Points on exact grids, flat or rolled up, in any order: most seeds stand at a border, where the
/// rules beyond the paper refuse every fan, and cost no point (Readings::keepSeeds).
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

struct Cell {
    int x, y;
};
using Cells = std::vector<Cell>;

Cells rectangle(int wide, int high) {
    Cells cells;
    for (int y = 0; y < high; ++y) {
        for (int x = 0; x < wide; ++x) cells.push_back({x, y});
    }
    return cells;
}

/// From the outside in.
Cells spiraling(Cells cells) {
    int wide = 0;
    int high = 0;
    for (const Cell& c : cells) {
        wide = std::max(wide, c.x + 1);
        high = std::max(high, c.y + 1);
    }
    const auto depth = [&](const Cell& c) {
        return std::min({c.x, c.y, wide - 1 - c.x, high - 1 - c.y});
    };
    const auto turn = [&](const Cell& c) {
        return turnDegrees({-1, -1, 0}, {2.0 * c.x - wide + 1.001, 2.0 * c.y - high + 1.0, 0});
    };
    std::stable_sort(cells.begin(), cells.end(), [&](const Cell& a, const Cell& b) {
        return std::pair(depth(a), turn(a)) < std::pair(depth(b), turn(b));
    });
    return cells;
}

Cells shuffled(Cells cells) {
    Random random(7);
    for (std::size_t i = cells.size(); i > 1; --i) std::swap(cells[i - 1], cells[random.below(i)]);
    return cells;
}

struct Order {
    const char* name;
    std::function<Cells(Cells)> of;
};
const std::vector<Order>& orders() {
    static const std::vector<Order> all{
        {"raster", [](Cells cells) { return cells; }},
        {"reversed",
         [](Cells cells) {
             std::reverse(cells.begin(), cells.end());
             return cells;
         }},
        {"random", shuffled},
        {"spiral", spiraling},
        {"columns",
         [](Cells cells) {
             std::stable_sort(cells.begin(), cells.end(),
                              [](const Cell& a, const Cell& b) { return a.x < b.x; });
             return cells;
         }},
    };
    return all;
}

struct Place {
    Vec3 position, normal;
};

PointSet pointsAt(const Cells& cells, const std::function<Place(const Cell&)>& place) {
    PointFile file;
    for (const Cell& cell : cells) {
        const Place at = place(cell);
        file.position.push_back(at.position);
        file.normal.push_back(glm::normalize(at.normal));
    }
    return prepared(file);
}

Place flat(const Cell& c) { return {{c.x, c.y, 0}, {0, 0, 1}}; }
std::function<Place(const Cell&)> sheared(double by) {
    return [by](const Cell& c) { return Place{{c.x + by * c.y, c.y, 0}, {0, 0, 1}}; };
}
/// A plane that no axis is parallel to.
Place slanted(const Cell& c) {
    const Vec3 u = glm::normalize(Vec3(2, 1, 0.5));
    const Vec3 n = glm::normalize(glm::cross(u, Vec3(0.3, -1, 2)));
    return {double(c.x) * u + double(c.y) * glm::cross(n, u), n};
}
/// Around a cylinder with the same step along it.
std::function<Place(const Cell&)> rolled(int around) {
    return [around](const Cell& c) {
        const double radius = 0.5 / std::sin(kPi / around);
        const Vec3 out = polar(360.0 * c.x / around);
        return Place{radius * out + Vec3(0, 0, c.y), out};
    };
}
/// A round island in the middle of a flat sea.
std::function<Place(const Cell&)> island(int wide) {
    return [wide](const Cell& c) {
        const auto height = [wide](double x, double y) {
            const double u = (x - 0.5 * wide) / (0.2 * wide);
            const double v = (y - 0.5 * wide) / (0.2 * wide);
            return std::max(0.0, wide / 8.0 * std::exp(-u * u - v * v) - wide / 30.0);
        };
        constexpr double kStep = 1e-3;
        const double dx = (height(c.x + kStep, c.y) - height(c.x - kStep, c.y)) / (2 * kStep);
        const double dy = (height(c.x, c.y + kStep) - height(c.x, c.y - kStep)) / (2 * kStep);
        return Place{{c.x, c.y, height(c.x, c.y)}, {-dx, -dy, 1}};
    };
}

/// `robust` uses every point, makes that many triangles, and none with a fault.
void checkGrid(const PointSet& points, std::size_t triangles) {
    const Run run = runAll(points, robust());
    CHECK(run.mesh.triangles == triangles);
    CHECK(run.mesh.unusedPoints == 0);
    CHECK(describeFaults(points, run.state.mesh()) == "");
}

std::size_t trianglesOf(int wide, int high) {
    return 2 * static_cast<std::size_t>(wide - 1) * static_cast<std::size_t>(high - 1);
}

}  // namespace

TEST_CASE("graph paper: a flat grid of n x n points gets 2 (n - 1)^2 triangles in any order") {
    for (const int n : {3, 4, 5, 10, 31, 80}) {
        for (const Order& order : orders()) {
            if (n == 80 && order.name != std::string("raster")) continue;
            CAPTURE(n);
            CAPTURE(order.name);
            checkGrid(pointsAt(order.of(rectangle(n, n)), flat), trianglesOf(n, n));
        }
    }
}

TEST_CASE("graph paper: sheared, tilted and long grids") {
    for (const int n : {3, 5, 10, 31}) {
        for (const Order& order : orders()) {
            CAPTURE(n);
            CAPTURE(order.name);
            for (const double by : {0.1, 0.25}) {
                checkGrid(pointsAt(order.of(rectangle(n, n)), sheared(by)), trianglesOf(n, n));
            }
            checkGrid(pointsAt(order.of(rectangle(n, n)), slanted), trianglesOf(n, n));
            checkGrid(pointsAt(order.of(rectangle(n, 4)), flat), trianglesOf(n, 4));
        }
    }
}

TEST_CASE("graph paper: an equal-step cylinder, open along a side or wrapped around") {
    for (const Cell& size : Cells{{12, 6}, {24, 12}, {60, 4}}) {
        const int around = size.x;
        const int high = size.y;
        for (const Order& order : orders()) {
            CAPTURE(around);
            CAPTURE(order.name);
            const int side = 3 * around / 4;
            checkGrid(pointsAt(order.of(rectangle(side, high)), rolled(around)),
                      trianglesOf(side, high));
            checkGrid(pointsAt(order.of(rectangle(around, high)), rolled(around)),
                      trianglesOf(around + 1, high));
        }
    }
}

TEST_CASE("graph paper: an island in a flat sea loses no point") {
    for (const int n : {20, 60}) {
        for (const Order& order : orders()) {
            if (n == 60 && order.name != std::string("raster")) continue;
            CAPTURE(n);
            CAPTURE(order.name);
            checkGrid(pointsAt(order.of(rectangle(n, n)), island(n)), trianglesOf(n, n));
        }
    }
}

TEST_CASE("graph paper: grids apart from each other are components of their own") {
    for (const Order& order : orders()) {
        CAPTURE(order.name);
        const PointSet points = pointsAt(order.of(rectangle(24, 5)), [](const Cell& c) {
            return Place{{c.x + 20 * (c.x / 6), c.y, 0}, {0, 0, 1}};
        });
        checkGrid(points, 4 * trianglesOf(6, 5));
        CHECK(runAll(points, robust()).mesh.components == 4);
    }
}

TEST_CASE("graph paper: the invariants hold while seeds fail, and the work is linear") {
    for (const Order& order : orders()) {
        CAPTURE(order.name);
        const PointSet points = pointsAt(order.of(rectangle(9, 9)), flat);
        CHECK(firstBreach(points, robust(), InvariantChecker::Level::Guarded) == "");
        CHECK(firstBreach(points, paper(), InvariantChecker::Level::AnyInput) == "");
        EventLog log;
        const Run run = runAll(points, robust(), &log);
        CHECK(run.state.counters.seeds <= points.size());
    }
}

TEST_CASE("graph paper: with keepseeds off every seed at a border costs its two points") {
    Params params = robust();
    params.readings.keepSeeds = false;
    const Run run = runAll(pointsAt(rectangle(10, 10), flat), params);
    CHECK(run.mesh.triangles == 0);
    CHECK(run.state.counters.lostSeeds == 50);
    CHECK(run.state.counters.failedSeeds == 0);
}
