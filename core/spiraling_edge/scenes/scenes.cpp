/// The scenes that work, small inputs that each show one figure of the paper among them.
/// tests/core/scenes/scenes_test.cpp checks the pivots named in the table.
#include "spiraling_edge/scenes/scenes.h"

#include <algorithm>
#include <array>

#include "spiraling_edge/scenes/surface_scenes.h"

namespace se {
namespace {

/// An exact lattice of 9 x 9 points with typed walls.
PointFile grid() {
    constexpr int kHalf = 4;
    PointFile file;
    for (int y = -kHalf; y <= kHalf; ++y) {
        for (int x = -kHalf; x <= kHalf; ++x) {
            file.position.emplace_back(x, y, 0);
            file.normal.emplace_back(0, 0, 1);
            file.type.push_back(wallsAt(file.position.back(), Vec3(-kHalf), Vec3(kHalf)));
        }
    }
    return file;
}

// ---- the figures of the paper -------------------------------------------------------------------

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

PointFile smallTorus(std::uint64_t seed, std::size_t k) {
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

PointFile figure2() {
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

PointFile figure4() { return smallSheet(flatSheet(), 1, 10); }
PointFile figure5() { return smallTorus(1, 10); }
PointFile figure6() { return smallSheet(wavySheet(), 122, 12); }
PointFile figure7() { return smallTorus(1, 14); }
PointFile figure9() { return smallTorus(11, 10); }
PointFile figure12() { return smallTorus(5, 10); }

// Two readings of §6.1 and §6.5 that matter only on irregular rings.
PointFile halfTurn() {
    return withNeighborLists(sampleClosed(torus(), 100, 0.427, 1009), {KNearest{12}});
}
PointFile finishedEdge() {
    return withNeighborLists(sampleClosed(doubleTorus(), 200, 0.403, 1390), {KNearest{9}});
}

/// Begins with two points on one wall.
PointFile figure14() {
    // Rim points come in groups of four, from the corners on: this begins on the wall y = -1.
    return withNeighborLists(movedToBack(sampleSheet(flatSheet(), 5, 26, 1), 8), {KNearest{10}});
}

// ---- the table ----------------------------------------------------------------------------------

constexpr std::array kScenes{
    Scene{
        "sphere", "Sphere",
        "The spiral grows from one point over the whole sphere and closes its last hole by itself.",
        [] { return sampleClosed(unitSphere(), 600, 0.155, 1); }},
    Scene{"torus", "Torus",
          "The edge ring meets itself behind the hole: it splits, and the parts are finished in "
          "turn from the stack.",
          [] { return sampleClosed(torus(), 1000, 0.135, 1); }, "200.split.1"},
    Scene{"linked-tori", "Two linked tori",
          "Two components: when the first is closed, a new ring of two starts on the other.",
          [] { return sampleClosed(linkedTori(), 1500, 0.156, 1); }, "537.seed.1"},
    Scene{"genus-2", "Double torus",
          "Two holes: the ring splits and joins again on the way around them.",
          [] { return sampleClosed(doubleTorus(), 1500, 0.147, 1); }, "471.join.1"},
    Scene{"sheet", "Wavy sheet in a box",
          "Boundary points are passed over and stay on the ring until a full circuit adds nothing; "
          "only corners are turned with a third point.",
          [] { return sampleSheet(wavySheet(), 15, 270, 1); }, "2.skip.1"},
    Scene{"grid", "Exact grid of 9 x 9 points",
          "Every fourth point of a square lies exactly on the circle of the other three: what is "
          "on the sphere is removed, and the result is still 128 triangles.",
          grid, "4.sphere.5"},
    Scene{"figure-2", "Figure 2: the spiral",
          "Points have the figure's numbers less one: after five pivots the ring runs through "
          "points 5 to 15, and 5 is the next pivot.",
          figure2, "5.advance.1"},
    Scene{"figure-4", "Figure 4: start and end move",
          "At pivot 8 the ring is concave on both sides: start and end advance, and what lies "
          "beyond them is dropped.",
          figure4, "8.limits.1"},
    Scene{"figure-5", "Figure 5: the convexity test",
          "At pivot 6 the surface bends so much that the angle sort lets in the point next on the "
          "ring; the convex end gives it away.",
          figure5, "6.convex.1"},
    Scene{"figure-6", "Figure 6: the reciprocal test",
          "At pivot 20 a point of the ring passes the angle test, but the pivot lies in the part "
          "that it has finished: it is refused.",
          figure6, "20.reciprocal.1"},
    Scene{"figure-7", "Figure 7: a hole of three",
          "At pivot 95 three points enclose a hole; what lies beyond its far side is removed.",
          figure7, "95.hole.1"},
    Scene{"figure-9", "Figure 9: two points over 180 degrees",
          "At pivot 87 only first and last are left, more than 180 degrees apart: no triangle, the "
          "pivot stays on the ring.",
          figure9, "87.twopoint.1"},
    Scene{"figure-12", "Figures 11 and 12: split and join",
          "At pivot 35 the ring meets itself and splits; at pivot 74 the two parts meet around the "
          "tube and join again.",
          figure12, "35.split.1"},
    Scene{"figure-14", "Figures 14 to 16: two boundary points",
          "The first ring is two points on one wall: a third one on that wall keeps the sector "
          "inside the box.",
          figure14, "1.insert.1"},
    Scene{"half-turn", "Section 6.1: no move across 180 degrees",
          "At pivot 30 the ring is concave at end, but seen from the pivot the next point is more "
          "than 180 degrees before it: the triangle would be inverted, and end stays.",
          halfTurn, "30.limits.2"},
    Scene{"finished-edge", "Section 6.5: a finished edge in a longer ring",
          "At pivot 129 point 4 lies between two entries of 130: their edge has triangles on both "
          "sides, so 4 and one entry of 130 leave the ring.",
          finishedEdge, "129.ring.3"},
};

}  // namespace

std::span<const Scene> scenes() { return kScenes; }

const Scene* findScene(std::string_view id) {
    for (const Scene& scene : kScenes) {
        if (scene.id == id) return &scene;
    }
    for (const FailureScene& each : failureScenes()) {
        if (each.scene.id == id) return &each.scene;
    }
    return nullptr;
}

std::string_view addressOfScene(std::string_view id) {
    for (const FailureScene& each : failureScenes()) {
        if (each.scene.id == id) return each.address;
    }
    const Scene* scene = findScene(id);
    return scene != nullptr ? scene->address : std::string_view{};
}

}  // namespace se
