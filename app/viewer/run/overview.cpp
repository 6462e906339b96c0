// Takes the events of one pivot at a time, while the run is made. Each pivot is reduced to at most
// 24 bytes (a bit per stage and verdict, and counts), by which the filter of the tree can test it
// without running it again. The thread hands over what is new in batches; append() adds them to
// the lists of the window.
#include "overview.h"

#include <algorithm>
#include <limits>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/run/reading.h"

namespace se::view {

namespace {

template <typename T>
void appendList(std::vector<T>& list, const std::vector<T>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

void countUp(std::uint16_t& number) {
    if (number < std::numeric_limits<std::uint16_t>::max()) ++number;
}

/// Counts the new pivots of `overview` for their components.
void countComponents(RunOverview& overview, const std::vector<PivotSummary>& fresh) {
    auto pivot = static_cast<std::uint32_t>(overview.pivots.size() - fresh.size());
    for (const PivotSummary& summary : fresh) {
        ++pivot;
        if ((summary.found & findingOf(Stage::Seed)).any() || overview.components.empty()) {
            overview.components.push_back({pivot, 0, 0});
        }
        overview.components.back().tests += summary.tests;
        overview.components.back().refused += summary.refused;
    }
}

constexpr std::uint64_t edgeKey(Index from, Index to) { return std::uint64_t{from} << 32U | to; }

/// Number of distinct values.
std::size_t countDifferent(std::vector<Index>& points) {
    sortUnique(points);
    return points.size();
}

/// Pieces of the rim: points joined by its edges belong to one piece.
std::size_t countLoops(std::span<const std::array<Index, 2>> rim) {
    std::vector<Index> points;
    for (const auto& edge : rim) points.insert(points.end(), {edge[0], edge[1]});
    std::size_t loops = countDifferent(points);
    DisjointSets pieces(points.size());
    const auto placeOf = [&](Index point) {
        const auto found = std::lower_bound(points.begin(), points.end(), point);
        return static_cast<Index>(found - points.begin());
    };
    for (const auto& [from, to] : rim) {
        if (pieces.unite(placeOf(from), placeOf(to))) --loops;
    }
    return loops;
}

}  // namespace

Stage stageOf(MarkKind kind) {
    // In the order of the enum.
    constexpr std::array kStages = {Stage::Seed, Stage::Split, Stage::Join, Stage::Done};
    static_assert(kStages.size() == static_cast<std::size_t>(MarkKind::Alert) + 1);
    return kStages[static_cast<std::size_t>(kind)];
}

void count(PivotSummary& summary, const Event& event) {
    summary.found |= findingOf(event.address.stage);
    if (const auto verdict = verdictOf(event)) {
        summary.found |= findingOf(*verdict);
        countUp(summary.tests);
        if (outcomeOf(event) == Outcome::Refused) countUp(summary.refused);
    }
    const bool names =
        std::holds_alternative<PivotEvidence>(event.evidence) || summary.point == kNone;
    if (names && event.address.stage != Stage::Seed) summary.point = subjectOf(event);
}

void reservePivots(RunOverview& overview, std::size_t points) {
    // A point on several rings is the pivot of each; repairs are counted too.
    const std::size_t pivots = points + points / 16;
    for (auto* list : {&overview.ringLength, &overview.stackDepth, &overview.triangles})
        list->reserve(pivots);
    overview.pivots.reserve(pivots);
}

void append(RunOverview& overview, const RunOverview& fresh) {
    appendList(overview.ringLength, fresh.ringLength);
    appendList(overview.stackDepth, fresh.stackDepth);
    appendList(overview.triangles, fresh.triangles);
    appendList(overview.pivots, fresh.pivots);
    countComponents(overview, fresh.pivots);
    appendList(overview.marks, fresh.marks);
    appendList(overview.shapes, fresh.shapes);
    appendList(overview.laneChanges, fresh.laneChanges);
    appendList(overview.failures, fresh.failures);
    overview.lanes = std::max(overview.lanes, fresh.lanes);
    overview.longestRing = std::max(overview.longestRing, fresh.longestRing);
    overview.deepestStack = std::max(overview.deepestStack, fresh.deepestStack);
    overview.lastPivot = std::max(overview.lastPivot, fresh.lastPivot);
    overview.complete = fresh.complete;
}

std::span<const LiveFailure> failuresAt(const RunOverview& run, const Address& address) {
    // Within a pivot a strand may come before a seed: only the pivots are guaranteed to be in
    // order.
    const auto begin = std::partition_point(
        run.failures.begin(), run.failures.end(),
        [&](const LiveFailure& each) { return each.address.pivot < address.pivot; });
    const auto first = std::find_if(begin, run.failures.end(), [&](const LiveFailure& each) {
        return each.address.pivot > address.pivot || each.address == address;
    });
    const auto last = std::find_if_not(first, run.failures.end(), [&](const LiveFailure& each) {
        return each.address == address;
    });
    return std::span(run.failures)
        .subspan(static_cast<std::size_t>(first - run.failures.begin()),
                 static_cast<std::size_t>(last - first));
}

ComponentShape shapeOf(const Model& model, std::span<const Triangle> triangles, std::size_t begin) {
    ComponentShape shape;
    shape.begin = begin;
    shape.end = begin + triangles.size();
    glm::dvec3 sum(0.0);
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * triangles.size());
    std::vector<Index> corners;
    corners.reserve(3 * triangles.size());
    for (const Triangle& t : triangles) {
        sum += glm::dvec3(model.place[t.a]);
        edges.insert(edges.end(), {edgeKey(t.a, t.b), edgeKey(t.b, t.c), edgeKey(t.c, t.a)});
        corners.insert(corners.end(), {t.a, t.b, t.c});
    }
    if (!triangles.empty()) shape.middle = sum / static_cast<double>(triangles.size());
    std::sort(edges.begin(), edges.end());
    for (const std::uint64_t edge : edges) {
        const auto from = static_cast<Index>(edge >> 32U);
        const auto to = static_cast<Index>(edge);
        if (!std::binary_search(edges.begin(), edges.end(), edgeKey(to, from))) {
            shape.rim.push_back({from, to});
        }
    }
    shape.points = countDifferent(corners);
    shape.loops = countLoops(shape.rim);
    return shape;
}

const ComponentShape* shapeAt(std::span<const ComponentShape> shapes, std::uint32_t pivot) {
    const auto found = std::lower_bound(
        shapes.begin(), shapes.end(), pivot,
        [](const ComponentShape& shape, std::uint32_t wanted) { return shape.pivot < wanted; });
    return found != shapes.end() && found->pivot == pivot ? &*found : nullptr;
}

RunObserver::RunObserver(const Model& model, const State& start)
    : model_(model),
      before_(start.counters),
      alerts_(start.alerts.size()),
      triangles_(start.triangles.size()),
      lanes_(model.params.paper.stack) {
    if (model.points.size() <= kMaxWatched) live_.emplace(model.points, model.params.start);
    lanes_.begin(start.rings);
}

void RunObserver::add(const SweptPivot& pivot, RunOverview& run) {
    const State& state = pivot.after;
    const bool complete = state.counters.pivots > before_.pivots;
    if (complete) noteFigures(state, run);
    noteEvents(pivot, run);
    noteMarks(pivot, run);
    noteShape(pivot, run);
    noteFailures(pivot.events, run);
    // Events after the last pivot have the next number.
    if (!complete) run.lastPivot = before_.pivots + 1;
    before_ = state.counters;
    alerts_ = state.alerts.size();
    triangles_ = state.triangles.size();
}

void RunObserver::noteFigures(const State& state, RunOverview& run) {
    const EdgeRings& rings = state.rings;
    const std::uint32_t length = rings.active() == kNone ? 0 : rings.length(rings.active());
    const auto depth = static_cast<std::uint32_t>(rings.stack().size());
    run.ringLength.push_back(length);
    run.stackDepth.push_back(depth);
    run.triangles.push_back(static_cast<std::uint32_t>(state.triangles.size()));
    run.longestRing = std::max(run.longestRing, length);
    run.deepestStack = std::max(run.deepestStack, depth);
    run.lastPivot = state.counters.pivots;
}

void RunObserver::noteEvents(const SweptPivot& pivot, RunOverview& run) {
    PivotSummary summary;
    for (const Event& event : pivot.events) {
        count(summary, event);
        lanes_.take(event);
        run.lanes = std::max(run.lanes, lanes_.live());
    }
    lanes_.settle(pivot.after.rings);
    run.pivots.push_back(summary);
    const auto changes = lanes_.takeChanges();
    run.laneChanges.insert(run.laneChanges.end(), changes.begin(), changes.end());
}

void RunObserver::noteMarks(const SweptPivot& pivot, RunOverview& run) const {
    const Counters& now = pivot.after.counters;
    if (now.seeds > before_.seeds) run.marks.push_back({now.pivots, MarkKind::Seed});
    if (now.splits > before_.splits) run.marks.push_back({now.pivots, MarkKind::Split});
    if (now.joins > before_.joins) run.marks.push_back({now.pivots, MarkKind::Join});
    if (pivot.after.alerts.size() == alerts_) return;
    // The first alert of this pivot.
    for (const Event& event : pivot.events) {
        const auto* alert = as<AlertEvidence>(event);
        if (alert == nullptr) continue;
        run.marks.push_back({now.pivots, MarkKind::Alert, event.address.n, *alert});
        return;
    }
}

/// Whether this pivot, or a seed, has begun or completed a component.
void RunObserver::noteShape(const SweptPivot& pivot, RunOverview& run) {
    for (const Event& event : pivot.events) {
        if (event.address.stage == Stage::Seed) begin_ = triangles_;
        const auto* complete = as<ComponentEvidence>(event);
        if (complete == nullptr) continue;
        const std::span<const Triangle> all(pivot.after.triangles);
        const std::size_t end = std::min<std::size_t>(complete->triangles, all.size());
        const std::size_t begin = std::min(begin_, end);
        run.shapes.push_back(shapeOf(model_, all.subspan(begin, end - begin), begin));
        run.shapes.back().pivot = event.address.pivot;
        const auto since = std::chrono::steady_clock::now() - began_;
        run.shapes.back().seconds = std::chrono::duration<double>(since).count();
    }
}

void RunObserver::noteFailures(std::span<const Event> events, RunOverview& run) {
    if (!live_) return;
    for (LiveFailure& each : live_->check(events)) {
        if (noticed_++ == kMaxNoticed) live_.reset();
        if (!live_) return;
        run.failures.push_back(std::move(each));
    }
}

}  // namespace se::view
