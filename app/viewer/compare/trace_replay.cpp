// A fan p, f0, f1, ... makes the triangles (p, f0, f1), (p, f1, f2), ... as §6.4 does. A trace has
// no rings, unless it names them: a ring runs along the edges with one triangle, the mesh on its
// left, so the edges u -> v of triangles whose opposite v -> u is missing are chained.
#include "trace_replay.h"

#include <algorithm>
#include <cassert>
#include <unordered_map>
#include <utility>

namespace se::view {

namespace {

/// Directed edges with one triangle: the ends by the beginning, the newest last.
using OpenEdges = std::unordered_map<Index, std::vector<Index>>;

void layEdge(OpenEdges& open, Index from, Index to) {
    const auto opposite = open.find(to);
    if (opposite != open.end()) {
        std::vector<Index>& ends = opposite->second;
        const auto found = std::find(ends.begin(), ends.end(), from);
        if (found != ends.end()) {
            ends.erase(found);
            if (ends.empty()) open.erase(opposite);
            return;
        }
    }
    open[from].push_back(to);
}

/// Takes the loop of edges that begins at `from`, or the part of it that there is.
RingPath takeLoop(OpenEdges& open, Index from) {
    RingPath ring;
    Index at = from;
    for (auto found = open.find(at); found != open.end(); found = open.find(at)) {
        ring.points.push_back(at);
        at = found->second.back();
        found->second.pop_back();
        if (found->second.empty()) open.erase(found);
        if (at == from) break;
    }
    ring.open.assign(ring.points.size(), false);
    // What does not lead back is no ring; its last step is shown as no edge of the mesh.
    if (at != from) {
        ring.points.push_back(at);
        ring.open.push_back(true);
    }
    return ring;
}

std::string fanText(const std::vector<Index>& points) {
    std::string text;
    for (const Index each : points) text += " " + std::to_string(each);
    return text;
}

}  // namespace

TraceReplay::TraceReplay(teach::Trace trace, std::vector<Triangle> given, std::size_t pointCount)
    : trace_(std::move(trace)), pointCount_(pointCount) {
    mesh_.pivots = pivots();
    mesh_.triangles = std::move(given);
    mesh_.made.resize(mesh_.triangles.size());
    begin_.push_back(mesh_.triangles.size());
    for (std::uint32_t pivot = 1; pivot <= mesh_.pivots; ++pivot) {
        const teach::TracePivot& each = trace_.pivots[pivot - 1];
        const std::vector<Index> fan = each.fan.value_or(std::vector<Index>{});
        for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
            assert(std::max({each.p, fan[i], fan[i + 1]}) < pointCount_);
            mesh_.triangles.push_back({each.p, fan[i], fan[i + 1]});
            mesh_.made.push_back({pivot, Stage::Emit, static_cast<std::uint32_t>(i + 1)});
        }
        begin_.push_back(mesh_.triangles.size());
    }
}

std::span<const Triangle> TraceReplay::fanOf(std::uint32_t pivot) const {
    if (pivot == 0 || pivot > pivots()) return {};
    return std::span(mesh_.triangles).subspan(begin_[pivot - 1], begin_[pivot] - begin_[pivot - 1]);
}

std::vector<RingPath> TraceReplay::ringsAt(std::size_t triangles, std::uint32_t pivots) const {
    OpenEdges open;
    for (const Triangle& t : std::span(mesh_.triangles).first(triangles)) {
        layEdge(open, t.a, t.b);
        layEdge(open, t.b, t.c);
        layEdge(open, t.c, t.a);
    }
    std::vector<RingPath> rings;
    // The active ring is that of the next pivot.
    if (pivots < trace_.pivots.size() && open.contains(trace_.pivots[pivots].p)) {
        rings.push_back(takeLoop(open, trace_.pivots[pivots].p));
        rings.back().active = true;
    }
    // In the order of the triangles, so that the picture is the same each time.
    for (const Triangle& t : std::span(mesh_.triangles).first(triangles)) {
        for (const Index from : {t.a, t.b, t.c}) {
            while (open.contains(from)) {
                rings.push_back(takeLoop(open, from));
                rings.back().depth = kNone;  // whether it is on the stack is not known
            }
        }
    }
    const bool named = pivots > 0 && trace_.pivots[pivots - 1].ring.has_value();
    if (named && !rings.empty() && rings.front().active) {
        rings.front().points = *trace_.pivots[pivots - 1].ring;
        rings.front().open.assign(rings.front().points.size(), false);
    }
    return rings;
}

DecisionState TraceReplay::stateAt(const TracePosition& position) const {
    assert(position.pivot <= pivots());
    DecisionState state;
    const std::span<const Triangle> fan = fanOf(position.pivot);
    const std::size_t laid = position.complete ? fan.size() : std::min(position.laid, fan.size());
    state.complete = position.complete;
    state.finishedTriangles = begin_[std::max(position.pivot, 1U) - 1];
    if (position.complete) state.finishedTriangles += laid;
    if (position.pivot > 0) {
        const teach::TracePivot& at = trace_.pivots[position.pivot - 1];
        state.pivot = at.p;
        state.first = at.first;
        state.last = at.last;
        if (!position.complete) {
            state.newTriangles.assign(fan.begin(), fan.begin() + laid);
            for (std::size_t i = 1; i < fan.size(); ++i)
                state.candidates.push_back({fan[i].b, 0.0, CandidateState::Kept});
        }
        if (position.complete && position.pivot < pivots())
            state.nextPivot = trace_.pivots[position.pivot].p;
    }
    // The ring is that before the pivot until its fan is complete.
    const std::uint32_t done =
        position.complete || position.pivot == 0 ? position.pivot : position.pivot - 1;
    state.rings = ringsAt(state.finishedTriangles, done);
    std::vector<PointStatus> status(pointCount_, kUnused);
    for (const Triangle& t : std::span(mesh_.triangles).first(state.finishedTriangles))
        for (const Index each : {t.a, t.b, t.c}) status[each] = kDone;
    for (std::uint32_t i = 0; i < done; ++i) status[trace_.pivots[i].p] = kDone;
    for (const RingPath& ring : state.rings)
        for (const Index each : ring.points) status[each] = std::max(status[each], kUnused) + 1;
    state.status.assign(status);
    return state;
}

std::string TraceReplay::sentence(const TracePosition& position) const {
    if (position.pivot == 0) return "Before the first pivot of the trace.";
    const teach::TracePivot& at = trace_.pivots[position.pivot - 1];
    const std::string fan = at.fan && !at.fan->empty() ? "fan" + fanText(*at.fan) : "no triangle";
    return "Pivot " + std::to_string(position.pivot) + " of the trace: point " +
           std::to_string(at.p) + " between " + std::to_string(at.first) + " and " +
           std::to_string(at.last) + ", " + fan + ".";
}

}  // namespace se::view
