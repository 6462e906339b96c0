/// The scenes that work: those of this table, then the figures of the paper (figures.h).
/// tests/core/scenes/scenes_test.cpp checks the pivots named in the table.
#include "spiraling_edge/scenes/scenes.h"

#include <array>
#include <vector>

#include "spiraling_edge/scenes/figure_scenes.h"
#include "spiraling_edge/scenes/figures.h"
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

// Two readings of §6.1 and §6.5 that matter only on irregular rings.
PointFile halfTurn() {
    return withNeighborLists(sampleClosed(torus(), 100, 0.427, 1009), {KNearest{12}});
}
PointFile finishedEdge() {
    return withNeighborLists(sampleClosed(doubleTorus(), 200, 0.403, 1390), {KNearest{9}});
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
    Scene{"small-torus", "Small torus",
          "160 points on a coarse torus: at pivot 6 the angle sort lets in the point next on the "
          "ring, and the convex end gives it away.",
          smallTorus, "6.convex.1"},
    Scene{"long-lists", "Small torus with long lists",
          "With lists of 14 pivots look far: at pivot 95 a neighbor lies beyond the far side of a "
          "hole of three.",
          smallTorusWithLongLists, "95.hole.1"},
    Scene{"coarse-torus", "Another small torus",
          "At pivot 87 only first and last are left, more than 180 degrees apart: no triangle, the "
          "pivot stays on the ring.",
          coarseTorus, "87.twopoint.1"},
    Scene{"small-sheet", "Small wavy sheet",
          "At pivot 20 a point of the ring passes the angle test, but the pivot lies in the part "
          "that it has finished: it is refused.",
          smallWavySheet, "20.reciprocal.1"},
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

std::span<const Scene> scenes() {
    static const std::vector<Scene> all = [] {
        std::vector<Scene> rows(kScenes.begin(), kScenes.end());
        for (const Figure& figure : figures()) {
            if (figure.hasScene()) rows.push_back(figure.scene);
        }
        return rows;
    }();
    return all;
}

const Scene* findScene(std::string_view id) {
    for (const Scene& scene : scenes()) {
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

GivenStart startOfScene(std::string_view id) {
    const Scene* scene = findScene(id);
    return scene != nullptr && scene->start != nullptr ? scene->start() : GivenStart{};
}

}  // namespace se
