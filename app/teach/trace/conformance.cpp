#include "conformance.h"

#include <cassert>

#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/figures.h"
#include "spiraling_edge/scenes/surface_scenes.h"
#include "trace_run.h"

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

ConformanceInput sceneInput(std::string_view id, std::string_view shows) {
    const Scene* scene = findScene(id);
    assert(scene != nullptr);
    return {id, shows, scene->build, scene->start};
}

std::vector<ConformanceInput> buildInputs() {
    std::vector<ConformanceInput> inputs;
    for (const Figure& figure : figures()) {
        if (figure.hasScene()) inputs.push_back(sceneInput(figure.scene.id, figure.scene.title));
    }
    inputs.push_back(sceneInput("grid", "Points at one angle, on one sphere, and open steps"));
    inputs.push_back(sceneInput("half-turn", "No move of start or end across 180 degrees"));
    inputs.push_back(sceneInput("coarse-torus", "Angles that nearly agree"));
    inputs.push_back({"wide-gaps", "Gaps over 120 degrees, and holes of four edges", wideGaps});
    inputs.push_back({"revisited-points", "Points with several ring entries", revisitedPoints});
    inputs.push_back({"opposing-normals",
                      "Lists with neighbors that a run leaves out, since their "
                      "normals oppose",
                      opposingNormals});
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
