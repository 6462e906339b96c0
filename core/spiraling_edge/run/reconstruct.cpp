/// A run over points along a Z-curve takes the same steps with fewer cache misses: half the time
/// for large sets in random order. Results are translated back; the renumbering costs O(points +
/// list entries).
#include "spiraling_edge/run/reconstruct.h"

#include <algorithm>

#include "spiraling_edge/geometry/renumbering.h"

namespace se {
namespace {

void restore(std::vector<Triangle>& triangles, const std::vector<Index>& original) {
    for (Triangle& t : triangles) t = {original[t.a], original[t.b], original[t.c]};
}

/// The gaps of the points in their new order, and by their new indices.
std::vector<RimGap> renumbered(const std::vector<RimGap>& rim, const Numbering& numbering) {
    std::vector<RimGap> made(rim.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
        const RimGap& gap = rim[numbering.original[i]];
        if (gap.known()) made[i] = {numbering.place[gap.from], numbering.place[gap.to]};
    }
    return made;
}

}  // namespace

Renumbered renumberAlongZCurve(const PointSet& points) {
    Numbering numbering = numberingAlongZCurve(points.position);
    Renumbered result;
    PointSet& made = result.points;
    made.position = permuted(points.position, numbering.original);
    made.normal = permuted(points.normal, numbering.original);
    made.type = permuted(points.type, numbering.original);
    made.neighbors = renumbered(points.neighbors, numbering);
    made.rim = renumbered(points.rim, numbering);
    if (!points.aside.empty()) made.aside = permuted(points.aside, numbering.original);
    made.order.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        made.order.push_back(numbering.place[points.inOrder(i)]);
    result.original = std::move(numbering.original);
    return result;
}

void restoreIndices(const Renumbered& renumbered, State& state) {
    const std::vector<Index>& original = renumbered.original;
    state.status = permuted(state.status, inverse(original));
    restore(state.triangles, original);
    std::vector<Triangle> mesh = state.repair.triangles.take();
    restore(mesh, original);
    state.repair.triangles = std::move(mesh);
    state.repair.near = {};
    for (Index& p : state.done) p = original[p];
    for (Alert& alert : state.alerts) {
        if (alert.point != kNone) alert.point = original[alert.point];
    }
}

Reconstruction reconstruct(const PointSet& points, const Params& params,
                           const StopCondition& stop) {
    const auto run = [&](const PointSet& set) {
        Stepper stepper(set, params);
        const auto stops = [&](const State& state) {
            stepper.freePast();
            return stop(state);
        };
        const StopReason reason = stop ? stepper.runUntil(stops) : stepper.run();
        return Reconstruction{stepper.takeState(), reason};
    };
    // What-ifs name points by their index.
    if (!params.whatIf.empty() || !areScattered(points.neighbors)) return run(points);
    const Renumbered renumbered = renumberAlongZCurve(points);
    Reconstruction result = run(renumbered.points);
    restoreIndices(renumbered, result.state);
    return result;
}

}  // namespace se
