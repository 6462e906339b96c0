#include "spiraling_edge/scenes/scenes.h"

#include <array>

#include "spiraling_edge/scenes/figure_scenes.h"
#include "spiraling_edge/scenes/surface_scenes.h"

namespace se {
namespace {

/// An exact lattice of 9 x 9 points with typed walls.
PointFile grid() {
    constexpr int kHalf = 4;
    PointFile file;
    for (int y = -kHalf; y <= kHalf; ++y) {
        for (int x = -kHalf; x <= kHalf; ++x) {
            unsigned faces = 0;
            if (x == kHalf) faces |= kPositiveX;
            if (y == kHalf) faces |= kPositiveY;
            if (x == -kHalf) faces |= kNegativeX;
            if (y == -kHalf) faces |= kNegativeY;
            file.position.emplace_back(x, y, 0);
            file.normal.emplace_back(0, 0, 1);
            file.type.push_back(withCornerBit(static_cast<std::uint8_t>(faces)));
        }
    }
    return file;
}

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
          "behind them is dropped.",
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
