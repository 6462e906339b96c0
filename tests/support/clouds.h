/// Even samples of surfaces with exact normals, and what is done with them in many tests.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "../../core/src/scenes_sampling.h"
#include "rig.h"
#include "spiraling_edge/invariants.h"
#include "spiraling_edge/mesh.h"
#include "spiraling_edge/prepare.h"

namespace se::test {

/// A family of even samples, one per seed.
struct Family {
    std::string name;
    int components;
    int euler;  ///< Of the whole surface.
    std::function<PointFile(std::uint64_t seed)> sample;
};

/// About `scale` times 300 points on a sphere; the others have a like spacing.
inline std::vector<Family> closedFamilies(double scale = 1.0) {
    const auto closed = [scale](ImplicitSurface surface, double area, double points) {
        const double count = std::floor(points * scale);
        const double spacing = std::sqrt(area / count * 1.1547005383792515);
        return [=](std::uint64_t seed) {
            return sampleClosed(surface, static_cast<std::size_t>(count), spacing, seed);
        };
    };
    return {{"sphere", 1, 2, closed(unitSphere(), 12.57, 300)},
            {"torus", 1, 0, closed(torus(), 15.79, 500)},
            {"linked tori", 2, 0, closed(linkedTori(), 31.58, 1000)},
            {"genus 2", 1, -2, closed(doubleTorus(), 28.1, 1000)}};
}

inline NeighborOptions reach(std::size_t k, bool dropOpposing = true) {
    return {KNearest{k}, dropOpposing};
}

/// The points as the stepper wants them; empty if they cannot be prepared.
inline PointSet prepared(const PointFile& file, const NeighborOptions& options = {}) {
    auto result = prepare(file, options);
    return result.ok() ? std::move(result.value().points) : PointSet{};
}

/// A run to the end.
struct Run {
    State state;
    StopReason stop = StopReason::Finished;
    MeshReport mesh;
};
inline Run runAll(const PointSet& points, const Params& params, EventLog* log = nullptr) {
    Stepper stepper(points, params, log);
    Run run;
    run.stop = stepper.run();
    run.state = stepper.takeState();
    run.mesh = reportMesh(points, run.state.mesh());
    return run;
}

/// Steps a run to its end and returns the first breach, empty if there is none.
inline std::string firstBreach(const PointSet& points, const Params& params,
                               InvariantChecker::Level level) {
    Stepper stepper(points, params);
    InvariantChecker checker(points, params, level);
    std::string breach = checker.check(stepper.state());
    while (breach.empty() && stepper.stepPivot()) breach = checker.check(stepper.state());
    if (breach.empty()) breach = checkInvariants(stepper.state(), points, params);
    if (!breach.empty()) {
        breach += " at pivot " + std::to_string(stepper.state().counters.pivots);
    }
    return breach;
}

}  // namespace se::test
