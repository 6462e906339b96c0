/// The scenes that work: those of this table, then the figures of the paper (figures.h).
/// tests/core/scenes/scenes_test.cpp checks the pivots named in the table. The failure gallery:
/// small inputs that fail, each for a reason that the paper names;
/// tests/core/scenarios/gallery_test.cpp checks each failure and its decision.
#include "spiraling_edge/scenes/scenes.h"

#include <array>
#include <vector>

#include "spiraling_edge/base/random.h"
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

// ---- points of the gallery ----------------------------------------------------------------------

PointFile smallSphere() { return sampleClosed(unitSphere(), 300, 0.2195, 1); }

void add(PointFile& file, const Vec3& position, const Vec3& normal, unsigned faces = 0) {
    file.position.push_back(position);
    file.normal.push_back(normal);
    file.type.push_back(withCornerBit(static_cast<std::uint8_t>(faces)));
}

double lengthSq(const Vec3& v) { return glm::dot(v, v); }

PointFile fourEdgeHole() {
    return withNeighborLists(sampleClosed(torus(), 100, 0.427, 341), {KNearest{20}});
}

PointFile sparseSpot() {
    // Every second point of a cap is missing, and the reach stays that of the rest.
    const PointFile even = smallSphere();
    const Vec3 top(0.0, 0.0, 1.0);
    PointFile file;
    for (std::size_t i = 0; i < even.position.size(); ++i) {
        if (lengthSq(even.position[i] - top) > 0.5 || i % 2 == 0)
            add(file, even.position[i], even.normal[i]);
    }
    file.type.clear();
    return withNeighborLists(std::move(file), {WithinRadius{0.33}});
}

PointFile closeSheets() {
    constexpr double kGap = 0.12;  // the spacing is 0.2
    PointFile file = sampleSheet(flatSheet(), 7, 60, 1);
    const PointFile second = sampleSheet(flatSheet(), 7, 60, 2);
    for (std::size_t i = 0; i < second.position.size(); ++i)
        add(file, second.position[i] + Vec3(0, 0, kGap), second.normal[i], second.type[i]);
    return file;
}

PointFile sharpCrease() {
    // Two half planes that meet at 40 degrees along y; rows are shifted against each other.
    constexpr double kSine = 0.3420201433256687;
    constexpr double kCosine = 0.9396926207859084;
    constexpr double kSpacing = 0.2;
    constexpr double kRow = 0.1732050807568877;
    PointFile file;
    for (int y = -4; y <= 4; ++y) {
        for (int x = -8; x <= 8; ++x) {
            const double u = (x + (y % 2 != 0 ? 0.5 : 0.0)) * kSpacing;
            const double side = u < 0.0 ? -1.0 : 1.0;
            const Vec3 normal = u == 0.0 ? Vec3(0, 0, 1) : Vec3(side * kCosine, 0.0, kSine);
            add(file, Vec3(u * kSine, y * kRow, -side * u * kCosine), normal);
        }
    }
    file.type.clear();
    return file;
}

PointFile unevenDensity() {
    const PointFile even = sampleClosed(unitSphere(), 1200, 0.1097, 1);
    PointFile file;
    for (std::size_t i = 0; i < even.position.size(); ++i) {
        if (even.position[i].x < 0.0 || i % 12 == 0) add(file, even.position[i], even.normal[i]);
    }
    file.type.clear();
    return file;
}

PointFile noiseAlongNormal() {
    PointFile file = sampleClosed(unitSphere(), 400, 0.19, 1);
    SplitMix random(5);
    for (Vec3& x : file.position) x *= 1.0 + 0.3 * (random.unit() - 0.5);
    return file;
}

PointFile wrongLists() {
    // Every fortieth point lists points of the other side of the sphere.
    PointFile file = withNeighborLists(smallSphere(), {KNearest{10}});
    const auto count = static_cast<Index>(file.position.size());
    NeighborLists lists;
    for (Index p = 0; p < count; ++p) {
        std::vector<Index> list(file.neighbors[p].begin(), file.neighbors[p].end());
        if (p % 40 == 17) {
            for (Index& q : list) q = (q + count / 2) % count;
            std::erase(list, p);
        }
        lists.append(list);
    }
    file.neighbors = std::move(lists);
    return file;
}

PointFile flippedPatch() {
    PointFile file = smallSphere();
    for (std::size_t i = 0; i < file.position.size(); ++i) {
        if (file.position[i].z > 0.8) file.normal[i] = -file.normal[i];
    }
    return file;
}

PointFile nearDuplicates() {
    PointFile file = smallSphere();
    const std::size_t count = file.position.size();
    for (std::size_t i = 0; i < count; i += 15) {
        file.position.push_back(file.position[i] + Vec3(1e-7, 2e-7, 0.0));
        file.normal.push_back(file.normal[i]);
    }
    return file;
}

PointFile strandedPoint() { return torusOf160(4, 14); }

PointFile teeAtWall() {
    // A second sheet is upright on the middle of the first: where the two meet a wall, three walls'
    // points are neighbors.
    PointFile file = sampleSheet(flatSheet(), 5, 26, 1);
    for (Vec3& x : file.position) {
        if (x.x * x.x < 0.01 && x.y * x.y < 0.98) x.x = 0.0;
    }
    const PointFile second = sampleSheet(flatSheet(), 5, 26, 11);
    for (const Vec3& x : second.position) {
        if (x.x < -0.8) continue;
        unsigned faces = 0;
        if (x.y >= 1.0) faces |= kPositiveY;
        if (x.y <= -1.0) faces |= kNegativeY;
        if (x.x >= 1.0) faces |= kPositiveZ;
        add(file, Vec3(0.0, x.y, x.x + 1.0), Vec3(1, 0, 0), faces);
    }
    return file;
}

// ---- the tables ---------------------------------------------------------------------------------

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
          [] { return torusOf160(1, 10); }, "6.convex.1"},
    Scene{"long-lists", "Small torus with long lists",
          "With lists of 14 pivots look far: at pivot 95 a neighbor lies beyond the far side of a "
          "hole of three.",
          [] { return torusOf160(1, 14); }, "95.hole.1"},
    Scene{"coarse-torus", "Another small torus",
          "At pivot 87 only first and last are left, more than 180 degrees apart: no triangle, the "
          "pivot stays on the ring.",
          [] { return torusOf160(11, 10); }, "87.twopoint.1"},
    Scene{"small-sheet", "Small wavy sheet",
          "At pivot 20 a point of the ring passes the angle test, but the pivot lies in the part "
          "that it has finished: it is refused.",
          [] { return smallSheet(wavySheet(), 122, 12); }, "20.reciprocal.1"},
    Scene{"half-turn", "Section 6.1: no move across 180 degrees",
          "At pivot 30 the ring is concave at end, but seen from the pivot the next point is more "
          "than 180 degrees before it: the triangle would be inverted, and end stays.",
          halfTurn, "30.limits.2"},
    Scene{"finished-edge", "Section 6.5: a finished edge in a longer ring",
          "At pivot 129 point 4 lies between two entries of 130: their edge has triangles on both "
          "sides, so 4 and one entry of 130 leave the ring.",
          finishedEdge, "129.ring.3"},
};

constexpr std::array kGallery{
    FailureScene{{"four-edge-hole", "A hole of four with a point behind it",
                  "At pivot 54 the ring is a hole of four. Point 63, on the other side of what is "
                  "finished, is its only candidate, and both triangles lie over finished ones.",
                  fourEdgeHole},
                 "intersecting_triangles",
                 "54.sphere.1",
                 "6.2",
                 "Note that the algorithm will not recognize a hole formed by more than three "
                 "points.",
                 "Shorter neighbor lists, or --rules corrected."},
    FailureScene{
        {"sparse-spot", "A sparse spot beyond the search range",
         "Where every second point is missing, the next point is farther than the radius "
         "of the lists: two points find only each other, over 180 degrees apart.",
         sparseSpot},
        "lost_points",
        "258.twopoint.1",
        "6.4",
        "This situation can arise when the neighboring points lie just outside the search "
        "range for p.",
        "A larger radius, or lists of the k nearest; --rules robust puts the points back."},
    FailureScene{
        {"close-sheets", "Two close sheets",
         "Lists reach from sheet to sheet: from pivot 31 on the ring runs over both, and at "
         "pivot 86 the step from one to the other is taken for a corner of the box.",
         closeSheets},
        "intersecting_triangles",
        "86.insert.1",
        "3",
        "The algorithm also assumes that there is only one point at any particular "
        "location.",
        "A spacing below the gap. Sheets whose normals oppose are kept apart by themselves."},
    FailureScene{{"sharp-crease", "A sharp crease",
                  "The first pivot's neighbors lie on both sides of a crease of 40 degrees; seen "
                  "along its normal they are no ring around it.",
                  sharpCrease},
                 "flipped_triangles",
                 "1.emit.2",
                 "3",
                 "We work locally to create a nearly planar triangulation between a point and its "
                 "nearest neighbors.",
                 "Points much closer than the crease is sharp, or --rules robust."},
    FailureScene{
        {"uneven-density", "Uneven density",
         "On the dense side of the step no point of the sparse side is listed: at pivot "
         "342 end moves over three points of the ring at once.",
         unevenDensity},
        "non_manifold_edges",
        "342.limits.2",
        "6.4",
        "The occurrence of this configuration indicates that p is insufficiently linked to "
        "its neighbors.",
        "--symmetric lists, or --rules robust."},
    FailureScene{
        {"noise", "Noise along the normal",
         "Heights vary as much as the spacing. What is left over at the end begins "
         "components of its own: pivot 284 makes two triangles on the same three points.",
         noiseAlongNormal},
        "duplicate_triangles",
        "284.emit.2",
        "4",
        "These points represent such a tiny surface area that only a single point will fit "
        "in that space.",
        "Smooth the points first; --rules robust makes no such pair."},
    FailureScene{{"wrong-lists", "Wrong neighbor lists",
                  "Every fortieth point lists points of the other side of the sphere: pivot 245 "
                  "takes one of them, and two rings that have nothing to do with each other join.",
                  wrongLists},
                 "intersecting_triangles",
                 "245.reciprocal.2",
                 "3",
                 "A list of each point's neighbors.",
                 "New lists: --neighbors 12."},
    FailureScene{
        {"flipped-patch", "A patch of flipped normals",
         "The normals of the cap point inwards. Pivot 5 is a point of it: counterclockwise "
         "about its normal is the other way round than everywhere else.",
         flippedPatch},
        "flipped_triangles",
        "5.emit.2",
        "3",
        "The edge ring traversal proceeds in counterclockwise order around the normal of "
        "the first point, thus providing an orientation for the triangulation that is "
        "consistent across the surface.",
        "--orient turns the normals to agree."},
    FailureScene{
        {"near-duplicates", "Points given twice",
         "Every fifteenth point has a copy nearly at its place: at pivot 29 a triangle takes "
         "both, and has no height.",
         nearDuplicates},
        "degenerate_triangles",
        "29.sphere.5",
        "3",
        "The algorithm also assumes that there is only one point at any particular "
        "location.",
        "spiraling-edge doctor IN --fix OUT.ply --drop near_duplicates."},
    FailureScene{
        {"stranded-point", "Stranded points",
         "Three points are passed by at every pivot around them, and their neighbors are "
         "DONE before one of them begins.",
         strandedPoint},
        "lost_points",
        "98.strand.1",
        "4",
        "In the second case, the algorithm has rejected the point in the triangulations of "
        "all its neighbors and it has been left stranded.",
        "--rule unblocked=on, or --rules corrected."},
    FailureScene{{"tee-at-wall", "A T where a sheet meets a wall",
                  "One sheet stands on another. Where they meet, three sheets share a line: at "
                  "pivot 149 end moves across it, over a sheet that is finished.",
                  teeAtWall},
                 "intersecting_triangles",
                 "149.limits.2",
                 "3",
                 "The algorithm assumes that except at points with boundary type designations the "
                 "surface is closed and there are no non-manifold structures.",
                 "Give the sheets one by one."},
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

std::span<const FailureScene> failureScenes() { return kGallery; }

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
