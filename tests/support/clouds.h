/// Even samples of surfaces with exact normals, and common steps of tests with them.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/scenes/surface_scenes.h"
#include "spiraling_edge/spec/run_spec.h"
#include "support/invariant_checker.h"
#include "support/rig.h"

namespace se::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SE_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(SE_SANITIZED)
/// Large inputs take minutes with sanitizers.
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// A family of even samples, one per seed.
struct Family {
    std::string name;
    int components;
    int euler;  ///< Euler number of the whole surface.
    std::function<PointFile(std::uint64_t seed)> sample;
};

/// About `scale` times 300 points on a sphere; the others have a similar spacing.
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

/// Even points of the unit sphere (Fibonacci), with outward normals.
inline PointFile fibonacciSphere(std::size_t count) {
    PointFile file;
    const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
        const double r = std::sqrt(1.0 - z * z);
        const double a = turn * static_cast<double>(i);
        file.position.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
    file.normal = file.position;
    return file;
}

/// Scale of closedFamilies() at which no point has its neighbors on another tube.
inline constexpr double kTubesApart = 3.0;

inline NeighborOptions reach(std::size_t k, bool dropOpposing = true) {
    return {KNearest{k}, dropOpposing};
}

/// The k nearest of each point, regardless of normals.
inline NeighborLists nearestLists(const std::vector<Vec3>& position, std::size_t k = 12) {
    const std::vector<bool> usable(position.size(), true);
    return findNeighbors(position, {}, usable, reach(k, false)).value();
}

/// The points prepared for the stepper; empty if they cannot be.
inline PointSet prepared(const PointFile& file, const NeighborOptions& options = {}) {
    auto result = prepare(file, {options});
    return result.ok() ? std::move(result.value().points) : PointSet{};
}

/// The points as `spiraling-edge run` prepares them by this spec.
inline Prepared preparedBy(const RunSpec& spec, const PointFile& file) {
    const Params params = paramsOf(spec).value();
    Result<Prepared> result = prepare(file, prepareOptionsOf(spec, params, file).value());
    REQUIRE_MESSAGE(result.ok(), result.error().message);
    return std::move(result.value());
}
/// The same by a set of rules.
inline Prepared preparedBy(const char* rules, const PointFile& file) {
    return preparedBy(withSet({}, rules), file);
}

/// The points of a built-in scene.
inline PointSet sceneNamed(std::string_view id) { return prepared(findScene(id)->build()); }

/// Calls visit(scene) for every built-in scene of either table.
template <typename Visit>
void forEachScene(Visit&& visit) {
    for (const Scene& each : scenes()) visit(each);
    for (const FailureScene& each : failureScenes()) visit(each.scene);
}

/// The params with the start of a built-in scene.
inline Params withStartOf(const Scene& scene, Params params) {
    params.start = startOfScene(scene.id);
    return params;
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

/// All events of a run, in one log.
inline std::vector<Event> eventsOf(const PointSet& points, const Params& params) {
    EventLog log;
    Stepper(points, params, &log).run();
    return log.events();
}

/// The faults of a mesh in words, empty if it is sound.
inline std::string describeFaults(const PointSet& points, const std::vector<Triangle>& triangles) {
    std::string text;
    const MeshInspection found = inspectWithTotals(points, triangles);
    for (std::size_t i = 0; i < found.totals.size(); ++i) {
        const FailureClass& each = failureClasses()[i];
        if (!each.fault || found.totals[i].total == 0) continue;
        text += std::string(each.name) + " " + std::to_string(found.totals[i].total) + " ";
    }
    return text;
}

/// Steps a run to its end and returns the first violated invariant; empty if there is none.
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
