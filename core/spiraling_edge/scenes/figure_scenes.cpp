/// Most figures show one pivot of a run under way. Their scenes are a dozen points in the plane
/// with a finished patch, its triangles and its edge rings (GivenStart); only the pivots that the
/// figure shows have neighbor lists, so that nothing else happens. The others are small samples.
#include "spiraling_edge/scenes/figure_scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

#include "spiraling_edge/scenes/surface_scenes.h"

namespace se {
namespace {

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

/// Moves the first `count` points to the end.
PointFile movedToBack(PointFile file, std::ptrdiff_t count) {
    const auto rotate = [count](auto& values) {
        std::rotate(values.begin(), values.begin() + count, values.end());
    };
    rotate(file.position);
    rotate(file.normal);
    rotate(file.type);
    return file;
}

/// A small sheet whose run begins at an interior point.
PointFile smallSheet(const ImplicitSurface& sheet, std::uint64_t seed, std::size_t k) {
    constexpr std::size_t kPerSide = 5;
    constexpr std::ptrdiff_t kRim = 4 * (kPerSide + 1);
    return withNeighborLists(movedToBack(sampleSheet(sheet, kPerSide, 26, seed), kRim),
                             {KNearest{k}});
}

PointFile torusOf160(std::uint64_t seed, std::size_t k) {
    return withNeighborLists(sampleClosed(torus(), 160, 0.3375, seed), {KNearest{k}});
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

}  // namespace

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

PointFile figure14Points() {
    // Rim points come in groups of four, from the corners on: this begins on the wall y = -1.
    return withNeighborLists(movedToBack(sampleSheet(flatSheet(), 5, 26, 1), 8), {KNearest{10}});
}

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

// 0 p, the corner of +x and +y, between 1 on +x and 2 q on -x; 3 r on +y, 5 on +x beyond 1.
PointFile figure20Points() {
    PointFile file =
        drawing({{1, 1, 0}, {1, 0.5, 0}, {0, 0.2, 0}, {0.1, 1, 0}, {0.5, 0, 0}, {1, 0.2, 0}});
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

PointFile smallWavySheet() { return smallSheet(wavySheet(), 122, 12); }
PointFile smallTorus() { return torusOf160(1, 10); }
PointFile smallTorusWithLongLists() { return torusOf160(1, 14); }
PointFile coarseTorus() { return torusOf160(11, 10); }

}  // namespace se
