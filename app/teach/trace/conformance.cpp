#include "conformance.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "setrace.h"
#include "spiraling_edge/base/random.h"
#include "spiraling_edge/prepare/neighbor_search.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/figures.h"
#include "spiraling_edge/scenes/surface_scenes.h"

namespace se::teach {
namespace {

/// A torus so coarse that points stand on the ring several times where tests look at them.
PointFile revisitedPoints() {
    return withNeighborLists(sampleClosed(torus(), 70, 0.514, 61), {KNearest{9}});
}

/// A torus so coarse that gaps are wide and holes have four edges.
PointFile wideGaps() {
    return withNeighborLists(sampleClosed(torus(), 100, 0.43, 49), {KNearest{7}});
}

/// Two sheets at a sharp crease, with lists that reach from one to the other.
PointFile opposingNormals() {
    NeighborOptions lists;
    lists.dropOpposingNormals = false;
    return withNeighborLists(findScene("sharp-crease")->build(), lists);
}

/// A cloud of points that are no surface: rare cases are frequent there.
struct CloudShape {
    std::uint64_t seed;
    std::size_t count;
    double cells;   ///< Coordinates are multiples of one over this.
    double height;  ///< Of a cloud that is 1 wide.
    double tilt;    ///< Of the normals from z: up to half of this in x and in y.
    std::size_t neighbors;
};

PointFile cloudPoints(const CloudShape& shape) {
    PointFile file;
    file.positionType = file.normalType = ScalarType::Double;
    SplitMix random(shape.seed);
    while (file.position.size() < shape.count) {
        Vec3 x = random.inBox(Vec3(0.0), Vec3(shape.cells));
        for (int i = 0; i < 3; ++i) x[i] = std::floor(x[i]) / shape.cells;
        x.z *= shape.height;
        const double u = shape.tilt * (random.unit() - 0.5);
        const double v = shape.tilt * (random.unit() - 0.5);
        if (std::find(file.position.begin(), file.position.end(), x) != file.position.end())
            continue;
        file.position.push_back(x);
        file.normal.push_back(Vec3(u, v, 1.0) / std::sqrt(u * u + v * v + 1.0));
    }
    return withNeighborLists(file, {KNearest{shape.neighbors}});
}

/// A hexagon about a point, and before it a seed that gets no triangle: 0, a corner of the hexagon,
/// and 1 list each other alone.
PointFile failedSeed() {
    PointFile file;
    file.positionType = file.normalType = ScalarType::Double;
    const double half = std::sqrt(3.0) / 2.0;
    file.position = {{1, 0, 0},       {3, 0, 0},  {0, 0, 0},        {0.5, half, 0},
                     {-0.5, half, 0}, {-1, 0, 0}, {-0.5, -half, 0}, {0.5, -half, 0}};
    file.normal.assign(file.position.size(), Vec3(0, 0, 1));
    file.neighbors.append(std::vector<Index>{1});
    file.neighbors.append(std::vector<Index>{0});
    for (Index p = 2; p < file.position.size(); ++p) {
        std::vector<Index> list;
        for (Index q = 0; q < file.position.size(); ++q) {
            if (q != p && q != 1) list.push_back(q);
        }
        std::stable_sort(list.begin(), list.end(), [&](Index a, Index b) {
            return distanceSquared(file.position[p], file.position[a]) <
                   distanceSquared(file.position[p], file.position[b]);
        });
        file.neighbors.append(list);
    }
    return file;
}

/// The bay of Figure 4, of which no step is an edge: neither start nor end may move.
GivenStart openBay() {
    GivenStart start{.rings = {{0, 2, 6, 3, 4, 5, 1}}};
    const std::vector<Index>& ring = start.rings.front();
    for (std::size_t i = 0; i < ring.size(); ++i)
        start.open.push_back({ring[i], ring[(i + 1) % ring.size()]});
    return start;
}

/// The hole of Figure 7 without a triangle beyond its third step, which is open.
GivenStart openHole() {
    GivenStart start = startOfScene("figure-7");
    start.triangles.erase(start.triangles.begin());
    start.rings = {{5, 6, 7, 8}, {5, 1, 2}, {0, 2, 1}};
    start.open = {{1, 2}, {2, 1}};
    return start;
}

/// Figure 6 with a new ring of two where the other patch was: its sector is a full turn.
GivenStart ringOfTwo() {
    GivenStart start = startOfScene("figure-6");
    start.triangles.resize(3);
    start.rings.front() = {5, 7};
    start.open = {{5, 7}, {7, 5}};
    return start;
}

ConformanceInput cloudInput(std::string_view name, std::string_view shows,
                            const CloudShape& shape) {
    return {name, shows, [=] { return cloudPoints(shape); }};
}

ConformanceInput sceneInput(std::string_view id, std::string_view shows) {
    const Scene* scene = findScene(id);
    assert(scene != nullptr);
    return {id, shows, scene->build, scene->start};
}

/// Inputs for rules that no figure shows.
std::vector<ConformanceInput> otherInputs() {
    return {
        sceneInput("grid", "Points at one angle, on one sphere, and open steps"),
        sceneInput("half-turn", "No move of start or end across 180 degrees"),
        sceneInput("coarse-torus", "Angles that nearly agree"),
        {"wide-gaps", "Gaps over 120 degrees, and holes of four edges", wideGaps},
        {"revisited-points", "Points with several ring entries", revisitedPoints},
        {"opposing-normals",
         "Lists with neighbors that a run leaves out, since their normals oppose", opposingNormals},
        {"failed-seed", "A seed that gets no triangle, and costs no point", failedSeed},
        {"open-steps", "Start and end do not move over open steps", findScene("figure-4")->build,
         openBay},
        {"open-hole", "A ring of three with an open step is no hole", findScene("figure-7")->build,
         openHole},
        {"ring-of-two", "The sector in a ring of two is a full turn", findScene("figure-6")->build,
         ringOfTwo},
        cloudInput("cloud-holes", "Holes of three whose plane follows three normals",
                   {2683, 15, 64, 1.0, 1.0, 8}),
        cloudInput("cloud-half-turn", "No move of start across 180 degrees",
                   {7291, 18, 64, 0.5, 1.0, 11}),
        cloudInput("cloud-entries", "A second ring entry whose sector holds the pivot",
                   {1340, 16, 64, 1.0, 1.0, 10}),
        cloudInput("cloud-in-line", "The neighbors beside a candidate lie in line with the pivot",
                   {1418, 17, 6, 0.125, 0.0, 11}),
    };
}

std::vector<ConformanceInput> buildInputs() {
    std::vector<ConformanceInput> inputs;
    for (const Figure& figure : figures()) {
        if (figure.hasScene()) inputs.push_back(sceneInput(figure.scene.id, figure.scene.title));
    }
    for (const ConformanceInput& each : otherInputs()) inputs.push_back(each);
    return inputs;
}

}  // namespace

const std::vector<ConformanceInput>& conformanceInputs() {
    static const std::vector<ConformanceInput> inputs = buildInputs();
    return inputs;
}

ConformanceCase conformanceCase(const ConformanceInput& input) {
    PointFile file = input.build();
    Result<Prepared> prepared = prepare(file, {});
    assert(prepared.ok());  // Built-in points have lists of their own, or get the default ones.
    PointSet& points = prepared.value().points;
    file.normal = points.normal;
    file.type = points.type;
    // Lists with neighbors that the run leaves out show that it does.
    if (prepared.value().report.droppedListEntries == 0) file.neighbors = points.neighbors;
    file.positionType = file.normalType = ScalarType::Double;
    return {std::move(file), SharedPoints(std::move(points)),
            input.start != nullptr ? input.start() : GivenStart{}};
}

std::string conformanceTrace(const ConformanceCase& input) {
    Params params;
    params.start = input.start;
    Stepper stepper(input.points, params);
    std::string text = traceHeader(*input.points);
    while (true) {
        const TraceStep step = stepTraced(stepper, TraceDetail::Stages);
        if (step.pivot) text += traceLine(*step.pivot);
        if (!step.ran) return text;
    }
}

}  // namespace se::teach
