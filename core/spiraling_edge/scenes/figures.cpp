/// The table of figures. Addresses, names and outcomes were found by `spiraling-edge run
/// scene:figure-N --trace -`; tests/core/scenes/figures_test.cpp checks each row.
/// Most figures show one pivot of a run under way. Their points are a dozen in the plane with a
/// finished patch, its triangles and its edge rings (GivenStart); only the pivots that the figure
/// shows have neighbor lists, so that nothing else happens. The others are small samples.
#include "spiraling_edge/scenes/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/scenes/surface_scenes.h"

namespace se {
namespace {

constexpr double kOff = 0.0;
constexpr double kTwoPointOff = 2.0;  // of over, from and off
constexpr double kNextIsStart = 1.0;  // of end and start
constexpr double kOther = 1.0;        // of end, other, longer and shorter

// ---- points -------------------------------------------------------------------------------------

// Point 0 is the pivot p, and normals face the viewer, but where the figure is about them.

/// Points with normals toward the viewer, types interior and empty lists.
PointFile drawing(std::initializer_list<Vec3> points) {
    PointFile file;
    file.positionType = file.normalType = ScalarType::Double;
    file.position = points;
    file.normal.assign(points.size(), Vec3(0, 0, 1));
    file.type.assign(points.size(), kInterior);
    return file;
}

/// The neighbor list of one point.
struct ListOf {
    Index point;
    std::vector<Index> neighbors;
};

/// The list in order of distance, ties by index.
std::vector<Index> nearestFirst(const PointFile& file, ListOf list) {
    const auto distanceSq = [&](Index x) {
        const Vec3 d = file.position[x] - file.position[list.point];
        return glm::dot(d, d);
    };
    std::sort(list.neighbors.begin(), list.neighbors.end(), [&](Index a, Index b) {
        return std::pair(distanceSq(a), a) < std::pair(distanceSq(b), b);
    });
    return list.neighbors;
}

/// The file with these lists; all other points keep theirs, or have none.
PointFile withLists(PointFile file, const std::vector<ListOf>& lists) {
    NeighborLists all;
    for (Index p = 0; p < file.position.size(); ++p) {
        const auto own = std::find_if(lists.begin(), lists.end(),
                                      [p](const ListOf& each) { return each.point == p; });
        if (own != lists.end()) {
            all.append(nearestFirst(file, *own));
        } else if (file.hasNeighbors()) {
            all.append(file.neighbors[p]);
        } else {
            all.append(std::vector<Index>{});
        }
    }
    file.neighbors = all;
    return file;
}

/// The points of Figure 2 around point 1, in the order of their numbers; spacing 1.
constexpr double kFigure2[][2] = {
    {0.0, 0.0},                                     // 1
    {0.94, 0.0},    {0.52, 0.88},  {-0.5, 0.9},     // 2 to 4
    {-1.0, 0.02},   {-0.49, -0.9}, {0.52, -0.88},   // 5 to 7
    {1.56, -0.88},  {1.92, 0.1},   {1.34, 1.26},    // 8 to 10, around 2
    {0.06, 1.8},                                    // 11, around 3
    {-1.0, 1.74},   {-1.62, 0.92},                  // 12, 13, around 4
    {-1.96, 0.2},   {-1.9, -0.62}, {-1.34, -1.36},  // 14 to 16, around 5
    {-0.46, -1.86}, {0.5, -1.84},                   // 17, 18
};

/// The figure's points 1 to 18 in a box, as points 0 to 17.
PointFile figure2Points() {
    constexpr int kRows = 4;
    constexpr double kRowHeight = 0.9;
    constexpr double kHalfWidth = 4.0;
    const Vec3 high(kHalfWidth, kRows * kRowHeight, 0.0);
    PointFile file;
    file.positionType = ScalarType::Double;
    const auto add = [&](double x, double y) {
        file.position.emplace_back(x, y, 0.0);
        file.normal.emplace_back(0.0, 0.0, 1.0);
        file.type.push_back(wallsAt(file.position.back(), -high, high));
    };
    for (const auto& p : kFigure2) add(p[0], p[1]);
    for (int row = -kRows; row <= kRows; ++row) {
        // Eight or seven steps from wall to wall: rows are shifted against each other.
        const int steps = row % 2 == 0 ? 8 : 7;
        const double y = row * kRowHeight;
        for (int i = 0; i <= steps; ++i) {
            const double x = i == steps ? kHalfWidth : -kHalfWidth + i * (2.0 * kHalfWidth) / steps;
            const bool taken =
                std::any_of(std::begin(kFigure2), std::end(kFigure2), [&](const auto& p) {
                    const double dx = x - p[0];
                    const double dy = y - p[1];
                    return dx * dx + dy * dy < 0.55;
                });
            if (!taken) add(x, y);
        }
    }
    return file;
}

/// The points of Figure 2, with the list of point 1 as the figure has it.
PointFile figure1Points() {
    return withLists(withNeighborLists(figure2Points(), {KNearest{12}}),
                     {{0, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 13, 17}}});
}

// 0 p, 1 first, 2 last, 3 t beyond the finished patch, 4 r; 7 lies in the direction of r.
PointFile figure3Points() {
    PointFile file = drawing({{0, 0, 0},
                              {1, 0, 0},
                              {-0.9, 0.5, 0},
                              {-0.9, -0.9, 0},
                              {0.9, 0.4, 0},
                              {-1.1, -0.3, 0},
                              {-0.2, -1, 0},
                              {1.8, 0.8, 0}});
    return withLists(file, {{0, {1, 2, 3, 4, 7}}});
}
GivenStart figure3Start() {
    return {.triangles = {{0, 2, 5}, {0, 5, 6}, {0, 6, 1}}, .rings = {{0, 2, 5, 6, 1}}};
}

// 0 p, 1 first, 2 last, 5 q, 6 t, 8 s, 9 r; 7 lies between the new limits.
PointFile figure4Points() {
    PointFile file = drawing({{0, 0, 0},
                              {1, 0.2, 0},
                              {-1, 0.2, 0},
                              {-1.7, -1.2, 0},
                              {1.7, -1.2, 0},
                              {1.1, 1.2, 0},
                              {-1.1, 1.2, 0},
                              {0, 1.3, 0},
                              {1.45, 0.85, 0},
                              {-1.45, 0.85, 0}});
    return withLists(file, {{0, {1, 2, 5, 6, 7, 8, 9}}});
}
GivenStart figure4Start() {
    return {.triangles = {{0, 2, 3}, {2, 6, 3}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}},
            .rings = {{0, 2, 6, 3, 4, 5, 1}}};
}

// 0 p, 1 first, 2 before it on the ring, 3 r, 4 last. The surface bends away from the viewer at 2,
// so that 2 passes the angle test at p, and p the reciprocal test at 2, after 5.
PointFile figure5Points() {
    PointFile file = drawing({{0, 0, 0},
                              {1, 0, 0},
                              {2, 0.02, -1.2},
                              {-0.9, 0.8, 0},
                              {-1, 0.05, 0},
                              {2.6, 0.2, -2},
                              {0.6, -1, -0.1},
                              {-0.6, -1, -0.1}});
    const auto tilt = [&file](Index p, const Vec3& normal) {
        file.normal[p] = normal / std::sqrt(glm::dot(normal, normal));
    };
    tilt(1, {0.4, -0.1, 0.9});
    tilt(2, {0.8, -0.2, 0.6});
    tilt(5, {0.8, 0, 0.6});
    return withLists(file, {{0, {1, 2, 3, 4}}});
}
GivenStart figure5Start() {
    return {.triangles = {{0, 4, 7}, {0, 7, 6}, {0, 6, 1}, {1, 6, 2}, {2, 6, 5}},
            .rings = {{0, 4, 7, 6, 5, 2, 1}}};
}

// 0 p, 1 first, 2 last, 5 e, on a strip of its own.
PointFile figure6Points() {
    PointFile file = drawing({{0, 0, 0},
                              {1, -0.1, 0},
                              {-1, -0.1, 0},
                              {-2, -1.5, 0},
                              {2, -1.5, 0},
                              {0, 1, 0},
                              {1.2, 0.7, 0},
                              {-1.2, 0.7, 0},
                              {0, 0.45, 0}});
    return withLists(file, {{0, {1, 2, 5}}});
}
GivenStart figure6Start() {
    return {.triangles = {{0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 7, 8}, {5, 8, 6}},
            .rings = {{5, 7, 8, 6}, {0, 2, 3, 4, 1}}};
}

// 0 p, 1 first, 2 last, 3 r in the hole, 4 q beyond it; around them a finished patch.
PointFile figure7Points() {
    PointFile file = drawing({{0, 0, 0},
                              {1, 1, 0},
                              {-1, 1, 0},
                              {-0.3, 0.5, 0},
                              {0.35, 1.28, 0},
                              {0, 2, 0},
                              {-2.2, 0.6, 0},
                              {0, -0.8, 0},
                              {2.2, 0.6, 0}});
    return withLists(file, {{0, {1, 2, 3, 4}}});
}
GivenStart figure7Start() {
    return {
        .triangles = {{2, 1, 5}, {2, 5, 6}, {0, 2, 6}, {0, 6, 7}, {0, 7, 8}, {1, 0, 8}, {1, 8, 5}},
        .rings = {{5, 6, 7, 8}, {0, 2, 1}}};
}

/// Figures 8 and 10: a flat sheet of 50 points.
PointFile figure8Points() { return smallSheet(flatSheet(), 1, 10); }

// 0 p, 1 first, 2 last: 200 degrees at p; 100 at last, between p and 3.
PointFile figure9Points() {
    PointFile file = drawing({{0, 0, 0},
                              {1, 0, 0},
                              {-0.94, -0.34, 0},
                              {-1.44, 0.526, 0},
                              {-2, -1.3, 0},
                              {1.2, -1.3, 0}});
    return withLists(file, {{0, {1, 2}}, {2, {0, 3}}});
}
GivenStart figure9Start() {
    return {.triangles = {{2, 3, 4}, {0, 2, 4}, {0, 4, 5}, {0, 5, 1}},
            .rings = {{0, 2, 3, 4, 5, 1}}};
}

// As Figure 4: 0 p, 1 first, 2 last, 5 start, 6 end, 7 t, 8 s. A hole at first is on the stack.
PointFile figure11Points() {
    PointFile file = drawing({{0, 0, 0},
                              {1, 0.2, 0},
                              {-1, 0.2, 0},
                              {-1.7, -1.2, 0},
                              {4, -1.2, 0},
                              {1.1, 1.2, 0},
                              {-1.1, 1.2, 0},
                              {0.4, 1.2, 0},
                              {-0.4, 1.2, 0},
                              {1.7, 0.5, 0},
                              {1.7, -0.2, 0}});
    return withLists(file, {{0, {1, 2, 5, 6, 7, 8}}});
}
GivenStart figure11Start() {
    return {.triangles = {{0, 2, 3},
                          {2, 6, 3},
                          {0, 3, 4},
                          {10, 0, 4},
                          {10, 1, 0},
                          {9, 10, 4},
                          {4, 5, 9},
                          {1, 9, 5}},
            .rings = {{1, 9, 10}, {0, 2, 6, 3, 4, 5, 1}}};
}

PointFile figure12Points() { return torusOf160(5, 10); }

// 0 p on the wall -y, between 1 first and 2 last inside; 4 and 5 beside p on the wall, 6 beyond 4.
PointFile figure13Points() {
    PointFile file = drawing(
        {{0, 0, 0}, {-1, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 0, 0}, {-1, 0, 0}, {2, 0, 0}, {2, 1, 0}});
    for (const Index p : {0U, 4U, 5U, 6U}) file.type[p] = kNegativeY;
    return withLists(file, {{0, {1, 2, 4, 5}}, {1, {0, 3, 5}}, {2, {0, 3, 4, 6, 7}}});
}
GivenStart figure13Start() {
    return {.triangles = {{0, 2, 1}, {2, 3, 1}}, .rings = {{0, 2, 3, 1}}};
}

/// Figures 14, 16 and 19: the sheet of Figure 8, begun with two points on one wall.
PointFile figure14Points() {
    // Rim points come in groups of four, from the corners on: this begins on the wall y = -1.
    return withNeighborLists(movedToBack(sampleSheet(flatSheet(), 5, 26, 1), 8), {KNearest{10}});
}

/// The mirror image of Figure 14.
PointFile figure15Points() {
    PointFile file = figure14Points();
    for (Vec3& x : file.position) x.x = -x.x;
    constexpr unsigned kBoth = kPositiveX | kNegativeX;
    for (std::uint8_t& type : file.type) {
        const bool onOne = (type & kBoth) != 0;
        if (onOne) type = static_cast<std::uint8_t>(type ^ kBoth);
    }
    return file;
}

// 0 p, the corner of +x and +y, between 1 on +x and 2 q on -x, which is the first point there
// below the corner of -x and +y; 3 r on +y between the two corners, 5 on +x beyond 1.
PointFile figure20Points() {
    PointFile file =
        drawing({{1, 1, 0}, {1, 0.7, 0}, {0, 0.6, 0}, {0.4, 1, 0}, {0.5, 0.2, 0}, {1, 0.45, 0}});
    file.type = {withCornerBit(kPositiveX | kPositiveY),
                 kPositiveX,
                 kNegativeX,
                 kPositiveY,
                 kInterior,
                 kPositiveX};
    return withLists(file, {{0, {1, 2, 3, 5}}});
}
GivenStart figure20Start() {
    return {.triangles = {{0, 2, 4}, {0, 4, 1}}, .rings = {{0, 2, 4, 1}}};
}

// ---- names --------------------------------------------------------------------------------------

constexpr std::string_view kNumbers =
    "0 1 1 2 2 3 3 4 4 5 5 6 6 7 7 8 8 9 9 10 10 11 11 12 12 13 13 14 14 15 15 16 16 17 17 18";
constexpr std::string_view kNames3 = "0 p 1 first 2 last 3 t 4 r 7 r'";
constexpr std::string_view kNames4 = "0 p 1 first 2 last 5 q 6 t 8 s 9 r";
constexpr std::string_view kNames5 = "0 p 1 1 2 2 3 r 4 last";
constexpr std::string_view kNames6 = "0 p 1 pfirst 2 plast 5 e 7 efirst 6 elast";
constexpr std::string_view kNames7 = "0 p 1 first 2 last 3 r 4 q";
constexpr std::string_view kNames8 = "15 p 20 first 9 t 46 q 31 s 35 r 39 last";
constexpr std::string_view kNames9 = "0 p 1 first 2 last";
constexpr std::string_view kNames11 = "0 p 1 first 2 last 5 start 6 end 7 t 8 s";
constexpr std::string_view kNames14 = "0 p 4 first 46 q";
constexpr std::string_view kNames17 = "58 p 75 t 74 q";
constexpr std::string_view kNames18 = "66 p 74 q 75 r";
constexpr std::string_view kNames19 = "49 p 14 q 45 r";
constexpr std::string_view kNames20 = "0 p 2 q 3 r";

// ---- expectations -------------------------------------------------------------------------------

constexpr FigureExpectation kExpected1[] = {
    {"1.sphere.1", "9", "removed"},       {"1.sphere.2", "10", "removed"},
    {"1.sphere.3", "3", "inside sphere"}, {"1.sphere.4", "11", "removed"},
    {"1.sphere.5", "4", "inside sphere"}, {"1.sphere.6", "14", "removed"},
    {"1.sphere.7", "5", "inside sphere"}, {"1.sphere.8", "6", "inside sphere"},
    {"1.sphere.9", "18", "removed"},      {"1.sphere.10", "7", "inside sphere"},
    {"1.sphere.11", "8", "removed"},
};
constexpr FigureExpectation kExpected2[] = {
    {"1.advance.1", "2", "next pivot"},   {"2.advance.1", "3", "next pivot"},
    {"2.ring.2", "8", "enters, USED 1"},  {"2.ring.3", "9", "enters, USED 1"},
    {"2.ring.4", "10", "enters, USED 1"}, {"3.ring.2", "11", "enters, USED 1"},
    {"5.ring.1", "5", "leaves, DONE"},    {"5.ring.4", "16", "enters, USED 1"},
    {"5.advance.1", "6", "next pivot"},
};
constexpr FigureExpectation kExpected3[] = {
    {"1.sort.1", "r", "kept"},
    {"1.sort.4", "t", "beyond last"},
    {"1.sort.6", "r'", "same angle"},
};
constexpr FigureExpectation kExpected4[] = {
    {"1.limits.1", "q", "moved"},   {"1.limits.3", "t", "moved"},
    {"1.limits.5", "s", "outside"}, {"1.limits.6", "q", "now start"},
    {"1.limits.7", "t", "now end"}, {"1.limits.8", "r", "outside"},
};
constexpr FigureExpectation kExpected5[] = {
    {"1.sort.4", "2", "kept"},
    {"1.limits.1", "2", "convex"},
    {"1.convex.1", "2", "after convex end"},
};
constexpr FigureExpectation kExpected6[] = {
    {"1.sort.1", "e", "kept"},
    {"1.reciprocal.1", "e", "not reciprocal"},
    {"1.twopoint.1", "", "over 180"},
};
constexpr FigureExpectation kExpected7[] = {
    {"1.hole.1", "q", "far side"},
    {"1.hole.2", "r", "kept"},
    {"1.emit.1", "p first r", "made"},
    {"1.emit.2", "p r last", "made"},
};
constexpr FigureExpectation kExpected8[] = {
    {"9.sphere.1", "t", "inside sphere"},
    {"9.sphere.2", "q", "removed"},
    {"9.sphere.3", "s", "inside sphere"},
};
constexpr FigureExpectation kExpected9[] = {
    {"1.twopoint.1", "", "over 180"},
    {"1.advance.1", "last", "next pivot"},
    {"2.twopoint.1", "", "under 180"},
};
constexpr FigureExpectation kExpected10[] = {
    {"9.emit.1", "p first t", "made"},
    {"9.emit.2", "p t s", "made"},
    {"9.emit.3", "p s r", "made"},
    {"9.emit.4", "p r last", "made"},
};
constexpr FigureExpectation kExpected11[] = {
    {"1.ring.1", "p", "leaves, DONE"},    {"1.ring.2", "first", "leaves, USED 1"},
    {"1.ring.3", "last", "leaves, DONE"}, {"1.ring.4", "t", "enters, USED 1"},
    {"1.ring.5", "s", "enters, USED 1"},  {"1.advance.1", "end", "next pivot"},
};
constexpr FigureExpectation kExpected12[] = {
    {"35.split.1", "19", "splits into 19 and 13"},
    {"74.ring.2", "39", "enters, USED 2"},
    {"74.join.1", "39", "joins, a ring of 30"},
};
constexpr FigureExpectation kExpected13[] = {
    {"1.skip.1", "p", "passed over"}, {"1.advance.1", "last", "next pivot"},
    {"2.sphere.2", "6", "removed"},   {"2.sphere.3", "7", "gap too wide"},
    {"2.emit.1", "last p 4", "made"}, {"4.emit.2", "first 5 p", "made"},
};
constexpr FigureExpectation kExpected14[] = {
    {"1.insert.1", "q", "after"},
    {"1.emit.1", "p first 34", "made"},
    {"1.emit.4", "p 38 q", "made"},
};
constexpr FigureExpectation kExpected15[] = {
    {"1.insert.1", "q", "before"},
    {"1.emit.1", "p q 38", "made"},
    {"1.emit.4", "p 34 first", "made"},
};
constexpr FigureExpectation kExpected16[] = {{"1.insert.1", "q", "after"}};
constexpr FigureExpectation kExpected17[] = {
    {"91.skip.1", "p", "passed over"}, {"91.advance.1", "t", "next pivot"},
    {"92.skip.1", "t", "passed over"}, {"92.advance.1", "q", "next pivot"},
    {"93.skip.1", "q", "passed over"},
};
constexpr FigureExpectation kExpected18[] = {
    {"64.insert.1", "r", "before"},
    {"64.limits.1", "58", "no edge"},
    {"64.emit.1", "p r q", "made"},
};
constexpr FigureExpectation kExpected19[] = {
    {"56.insert.1", "r", "after"},
};
constexpr FigureExpectation kExpected20[] = {
    {"1.insert.1", "r", "before"},
    {"1.emit.1", "p r q", "made"},
};

// ---- without the rule ---------------------------------------------------------------------------

constexpr FigureExpectation kWithout1[] = {{"1.emit.12", "1 8 2", "made"}, {"1.emit.13", "", ""}};
constexpr FigureExpectation kWithout2[] = {{"2.advance.1", "7", "next pivot"}};
constexpr FigureExpectation kWithout3[] = {{"1.emit.2", "p r t", "made"},
                                           {"1.emit.3", "p t last", "made"}};
constexpr FigureExpectation kWithout4[] = {
    {"1.sphere.1", "s", "removed"},
    {"1.sphere.3", "r", "removed"},
    {"1.emit.2", "p 7 last", "made"},
    {"1.emit.3", "", ""},
    {"1.ring.1", "p", "leaves, DONE"},
    {"1.ring.2", "7", "enters, USED 1"},
    {"1.ring.3", "", ""},
};
constexpr FigureExpectation kWithout5[] = {{"1.emit.1", "p 1 2", "made"}};
constexpr FigureExpectation kWithout6[] = {{"1.emit.1", "p pfirst e", "made"},
                                           {"1.emit.2", "p e plast", "made"}};
constexpr FigureExpectation kWithout7[] = {{"1.emit.1", "p first q", "made"},
                                           {"1.emit.2", "p q r", "made"}};
constexpr FigureExpectation kWithout8[] = {{"1.emit.10", "0 4 10", "made"}, {"1.emit.11", "", ""}};
constexpr FigureExpectation kWithout9[] = {{"1.emit.1", "p first last", "made"}};
constexpr FigureExpectation kWithout11[] = {{"1.ring.1", "p", "leaves, DONE"},
                                            {"1.ring.2", "t", "enters, USED 1"},
                                            {"1.ring.3", "s", "enters, USED 1"},
                                            {"1.ring.4", "", ""}};
constexpr FigureExpectation kWithout12[] = {{"35.split.1", "19", "splits into 13 and 19"}};
constexpr FigureExpectation kWithout13[] = {{"1.emit.2", "p 5 4", "made"}};
constexpr FigureExpectation kWithout14[] = {{"1.emit.5", "p q first", "made"}};
constexpr FigureExpectation kWithout15[] = {{"1.emit.1", "p first q", "made"}};
constexpr FigureExpectation kWithout16[] = {{"1.insert.1", "", ""}};
constexpr FigureExpectation kWithout17[] = {{"80.strand.4", "t", "stranded"}};
constexpr FigureExpectation kWithout18[] = {{"80.strand.4", "r", "stranded"}};
constexpr FigureExpectation kWithout19[] = {{"92.strand.2", "r", "stranded"}};
constexpr FigureExpectation kWithout20[] = {{"5.strand.1", "r", "stranded"}};

// ---- the table ----------------------------------------------------------------------------------

constexpr Vec3 kFront{0.0, 0.0, 1.0};

/// A figure of the paper's results: a surface without a decision to show.
constexpr Figure resultsFigure(int number, std::string_view title, std::string_view caption,
                               FigureCounts counts, std::string_view sample,
                               std::string_view volume = {}) {
    Figure figure;
    figure.number = number;
    figure.scene.title = title;
    figure.scene.watch = caption;
    figure.scene.build = nullptr;
    figure.view = {0.6, -0.6, 0.5};
    figure.counts = counts;
    figure.sample = sample;
    figure.volume = volume;
    return figure;
}

constexpr std::array kFigures{
    Figure{1,
           {"figure-1", "Figure 1: a point and its ring of neighbors",
            "Point 1 has twelve neighbors, 2 to 11, 14 and 18; the farther ones, 8, 9, 10, 11, 14 "
            "and 18, are removed, and 2 to 7 are left as its ring.",
            figure1Points, "1.emit.6"},
           kFront,
           kNumbers,
           kExpected1,
           {"sphere", kOff},
           "All twelve stay, and the fan of point 1 has twelve triangles.",
           kWithout1},
    Figure{2,
           {"figure-2", "Figure 2: the spiral",
            "After five pivots the ring runs through points 6 to 16, and 6 is the next pivot.",
            figure2Points, "5.advance.1"},
           kFront,
           kNumbers,
           kExpected2,
           {"next", kNextIsStart},
           "After the fan of 2 the next pivot is 7, where the fan starts, not 3, where it ends.",
           kWithout2},
    Figure{3,
           {"figure-3", "Figure 3: the maximum angle",
            "Point t is a neighbor of p, but its angle is beyond that of last: it is left out.",
            figure3Points, "1.sort.4", figure3Start},
           kFront,
           kNames3,
           kExpected3,
           {"maxangle", kOff},
           "t stays, and the triangles p, r, t and p, t, last cross finished ones.",
           kWithout3,
           FaultKind::Intersecting},
    Figure{
        4,
        {"figure-4", "Figure 4: start and end move",
         "The ring is concave at first and at last: start moves to q and end to t, and s and r, "
         "beyond them, are left out.",
         figure4Points, "1.limits.1", figure4Start},
        kFront,
        kNames4,
        kExpected4,
        {"limits", kOff},
        "s and r are left to the circumsphere, which removes both here; the fan has two triangles, "
        "and first and last stay on the ring.",
        kWithout4},
    Figure{5,
           {"figure-5", "Figure 5: the convexity test",
            "Beyond 1 the surface bends away from the viewer, so that 2, the point before 1 on the "
            "ring, passes the angle test at p; since the ring is convex at 1, 2 is dropped.",
            figure5Points, "1.convex.1", figure5Start},
           {0.0, -0.35, 0.94},
           kNames5,
           kExpected5,
           {"convex", kOff},
           "2 stays: the fan of p begins with p, 1, 2, and a triangle is flipped.",
           kWithout5,
           FaultKind::Flipped},
    Figure{6,
           {"figure-6", "Figure 6: the reciprocal test",
            "Point e of the ring passes the angle test at p, but p lies on the finished side of e: "
            "seen from e it could be no neighbor, and e is refused.",
            figure6Points, "1.reciprocal.1", figure6Start},
           kFront,
           kNames6,
           kExpected6,
           {"reciprocal", kOff},
           "The triangles p, pfirst, e and p, e, plast cross the finished strip at e.",
           kWithout6,
           FaultKind::Intersecting},
    Figure{7,
           {"figure-7", "Figure 7: a hole of three",
            "p, first and last enclose a hole: r, inside, stays; q, beyond the edge from last to "
            "first, is removed.",
            figure7Points, "1.hole.1", figure7Start},
           kFront,
           kNames7,
           kExpected7,
           {"holesize", kOff},
           "q stays, and the triangles p, first, q and p, q, r cross those beyond the hole.",
           kWithout7,
           FaultKind::Intersecting},
    Figure{
        8,
        {"figure-8", "Figure 8: the circumsphere",
         "q lies outside the sphere on the circle through p, t and s, and without it the gap "
         "from t to s is 53 degrees: it is removed, and s is next.",
         figure8Points, "9.sphere.2"},
        kFront,
        kNames8,
        kExpected8,
        {"sphere", kOff},
        "No candidate is removed at any pivot: the first fan has ten triangles, and the run takes "
        "another way.",
        kWithout8},
    Figure{9,
           {"figure-9", "Figure 9: two points over 180 degrees",
            "Only first and last are left. At p they are 200 degrees apart: no triangle, p stays "
            "on the ring. At the next pivot they are 100 degrees apart: a hole, which is filled.",
            figure9Points, "1.twopoint.1", figure9Start},
           kFront,
           kNames9,
           kExpected9,
           {"twopoint", kTwoPointOff},
           "The triangle p, first, last crosses finished ones.",
           kWithout9,
           FaultKind::Intersecting},
    Figure{10,
           {"figure-10", "Figure 10: the fan of p",
            "The triangles run counterclockwise from first to last, each with p as its first "
            "corner: p, first, t; p, t, s; p, s, r; p, r, last.",
            figure8Points, "9.emit.1"},
           kFront,
           kNames8,
           kExpected10,
           {"turn", kOther},
           "Angles grow clockwise, and the fan is another one."},
    Figure{11,
           {"figure-11", "Figure 11: points that leave the ring",
            "start and end have moved: p, first and last leave the ring. first stands on a stacked "
            "ring too and stays USED, last is surrounded and DONE; t and s enter.",
            figure11Points, "1.ring.2", figure11Start},
           kFront,
           kNames11,
           kExpected11,
           {"limits", kOff},
           "start and end stay at first and last, which do not leave the ring.",
           kWithout11},
    Figure{
        12,
        {"figure-12", "Figure 12: split and join",
         "At pivot 35 the ring meets itself around the tube and splits; at pivot 74 the two parts "
         "meet around the hole and join again: 39 stands twice on one ring of 30.",
         figure12Points, "74.join.1"},
        {0.0, 0.0, 1.0},
        {},
        kExpected12,
        {"active", kOther},
        "The other part of a split goes on, and the run takes another way.",
        kWithout12},
    Figure{13,
           {"figure-13", "Figure 13: a boundary point on the ring",
            "p lies on the wall, with free surface on both sides: it is passed over and stays; the "
            "side at last is triangulated from last, that at first from first.",
            figure13Points, "1.skip.1", figure13Start},
           kFront,
           kNames9,
           kExpected13,
           {"walls", kOff},
           "p becomes a pivot, with a triangle without area along the wall.",
           kWithout13,
           FaultKind::Degenerate},
    Figure{
        14,
        {"figure-14", "Figure 14: a ring of two boundary points",
         "p and first, on one wall, are the only two points on the edge ring. The neighbor ring as "
         "it is would end with the incorrect triangle p, q, first, along the wall; a third point "
         "on that wall, q, keeps the sector inside the box.",
         figure14Points, "1.insert.1"},
        kFront,
        kNames14,
        kExpected14,
        {"thirdpoint", kOff},
        "The sector is a full turn: the last triangle, p, q, first, lies along the wall and has no "
        "area.",
        kWithout14,
        FaultKind::Degenerate},
    Figure{15,
           {"figure-15", "Figure 15: the third point as first or last",
            "The mirror image of Figure 14: here q is inserted before p and becomes first; there "
            "it comes after p and is last.",
            figure15Points, "1.insert.1"},
           kFront,
           kNames14,
           kExpected15,
           {"thirdpoint", kOff},
           "The sector is a full turn: the first triangle, p, first, q, lies along the wall and "
           "has no "
           "area.",
           kWithout15,
           FaultKind::Degenerate},
    Figure{16,
           {"figure-16", "Figure 16: before or after p",
            "The normal of p x the vector to first points from the wall -y into the box: q is "
            "inserted after p.",
            figure14Points, "1.insert.1"},
           kFront,
           kNames14,
           kExpected16,
           {"thirdpoint", kOff},
           "There is no third point to place.",
           kWithout16,
           FaultKind::Degenerate},
    Figure{
        17,
        {"figure-17", "Figure 17: from one wall to the next",
         "The edge ring runs from p, on the wall +x, over t to q, on the wall +y: t lies on both "
         "walls, and is a corner.",
         figure2Points, "91.pivot.1"},
        kFront,
        kNames17,
        kExpected17,
        {"corners", kOff},
        "t is in no triangle.",
        kWithout17},
    Figure{18,
           {"figure-18", "Figure 18: entering a corner",
            "p is on the way into a corner: r is inserted before it, and the triangle p, r, q "
            "fills the corner.",
            figure2Points, "64.insert.1"},
           kFront,
           kNames18,
           kExpected18,
           {"corners", kOff},
           "r is in no triangle.",
           kWithout18},
    Figure{19,
           {"figure-19", "Figure 19: leaving a corner",
            "q, before p on the ring, lies on another wall: r is inserted after p.", figure14Points,
            "56.insert.1"},
           kFront,
           kNames19,
           kExpected19,
           {"corners", kOff},
           "r is in no triangle.",
           kWithout19},
    Figure{20,
           {"figure-20", "Figure 20: on a corner",
            "p is the corner itself. q, next on the ring, lies beside a corner of its own, on the "
            "wall beyond that of r: r is inserted on the side of q.",
            figure20Points, "1.insert.1", figure20Start},
           kFront,
           kNames20,
           kExpected20,
           {"corners", kOff},
           "r is in no triangle.",
           kWithout20},
    resultsFigure(21, "Figure 21: hydrogen",
                  "An orbital of hydrogen: two lobes within a ring, at whose end the edge ring "
                  "joins itself (Figure 12).",
                  {1516, 3020}, "sample:hydrogen,n=1516"),
    resultsFigure(22, "Figure 22: lobster", "A computed tomography of a lobster.", {42906, 83893},
                  "", "lobster.nhdr"),
    resultsFigure(23, "Figure 23: hyperboloid",
                  "A quadric in a box: a closed formula, cut by the walls.", {215, 366},
                  "sample:hyperboloid,n=215"),
    resultsFigure(24, "Figure 24: blast wave", "A dome, cut by two walls.", {1393, 2662},
                  "sample:blast-wave,n=1393"),
    resultsFigure(25, "Figure 25: electron cloud", "The electron density of a molecule.",
                  {3755, 7046}, "", "electron_cloud.nhdr"),
};

}  // namespace

std::vector<PointName> Figure::pointNames() const {
    std::vector<PointName> list;
    const std::vector<std::string> words = io::wordsIn(names);
    for (std::size_t i = 0; i + 1 < words.size(); i += 2)
        list.push_back({numberIn<Index>(words[i]).value_or(kNone), words[i + 1]});
    return list;
}

std::span<const Figure> figures() { return kFigures; }

const Figure* findFigure(int number) {
    const auto found = std::find_if(kFigures.begin(), kFigures.end(),
                                    [&](const Figure& each) { return each.number == number; });
    return found == kFigures.end() ? nullptr : &*found;
}

const Figure* figureOfScene(std::string_view id) {
    const auto found = std::find_if(kFigures.begin(), kFigures.end(), [&](const Figure& each) {
        return each.hasScene() && each.scene.id == id;
    });
    return found == kFigures.end() ? nullptr : &*found;
}

std::string sourceOf(const Figure& figure) {
    if (figure.hasScene()) return "scene:" + std::string(figure.scene.id);
    return std::string(figure.sample);
}

}  // namespace se
