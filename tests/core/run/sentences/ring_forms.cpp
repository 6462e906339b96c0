/// §6.4 and §6.5: the sentences of triangles, of the edge ring and of the end of a run.
#include "core/run/sentences/claim.h"

namespace se::test::sentences {
namespace {

// ---- triangles, rings -------------------------------------------------------------------------

void emit(C& c) {
    const std::vector<Index> fan = c.w.spokes();
    const std::size_t of = c.w.state.triangles.size() - fan.size() + 1;
    c.need(c.count(0) == c.w.emitted && c.count(0) >= of, "number");
    const std::size_t i = c.count(0) - of;
    if (!c.wrong.empty() || i + 1 >= fan.size()) return c.need(false, "triangle of the fan");
    c.need(c.point(1) == c.w.p && c.point(2) == fan[i] && c.point(3) == fan[i + 1], "corners");
}
/// "DONE", "UNUSED", "USED 2".
std::string statusWords(PointStatus status) {
    return status == kDone ? "DONE" : status == 0 ? "UNUSED" : "USED " + std::to_string(status);
}
void enters(C& c) {
    const auto& all = c.w.candidates;
    c.need(std::count(all.begin(), all.end(), c.point(0)) == 1, "of the fan");
    c.need(c.word(1) == statusWords(c.w.status[c.point(0)] + 1), "status");
}
void leaves(C& c) {
    const PointStatus now = c.w.status[c.point(0)];
    c.need(now > 0, "on the ring");
    const bool seed = c.word(1) == "UNUSED" && c.w.circuit == 2;
    c.need(c.word(1) == statusWords(seed ? kUnused : now == 1 ? kDone : now - 1), "status");
}
void advances(C& c, std::size_t i) {
    const Index e = c.w.state.pivot.pivot;
    c.need(e != kNone && c.point(i) == c.w.pointOf(e), "next pivot");
}
void counted(C& c) {
    advances(c, 0);
    c.need(counts(c, 1, c.w.idle, "pivot"), "pivots without a triangle");
}
void popped(C& c) {
    advances(c, 0);
    const EdgeRings& rings = c.w.state.rings;
    c.need(c.w.was.depthFromTop(rings.active()) != kNone || c.w.was.active() == kNone, "stack");
}
void noRing(C& c) {
    const EdgeRings& rings = c.w.state.rings;
    c.need(rings.active() == kNone && rings.stack().empty(), "no ring");
}
void fullCircuit(C& c) { c.need(c.count(0) == c.w.circuit, "length"); }
void freed(C& c, bool interior) {
    fullCircuit(c);
    std::vector<Index> gone = c.w.released;
    c.need(gone.size() == c.count(0), "points that left");
    std::sort(gone.begin(), gone.end());
    gone.erase(std::unique(gone.begin(), gone.end()), gone.end());
    const auto inside = std::count_if(gone.begin(), gone.end(),
                                      [&](Index x) { return !isBoundary(c.w.points.type[x]); });
    if (interior) c.need(counts(c, 1, static_cast<std::size_t>(inside), "interior point"), "count");
    if (!interior) c.need(inside == 0, "no interior point");
}
void component(C& c) {
    c.need(c.count(0) == c.w.seeds - c.w.failed, "number");
    c.need(counts(c, 1, c.w.state.triangles.size(), "triangle"), "triangles");
    c.need(c.w.state.rings.active() == kNone && c.w.state.rings.stack().empty(), "complete");
}
void openHole(C& c) {
    const auto& gone = c.w.released;
    c.need(std::count(gone.begin(), gone.end(), c.point(0)) > 0, "of the ring");
    c.need(!isBoundary(c.w.points.type[c.point(0)]), "interior");
}
void finished(C& c) {
    const auto& mesh = c.w.state.mesh();
    const std::size_t count = c.w.points.size();
    std::vector<Index> group(count);
    std::vector<Index> loop(count);
    for (Index x = 0; x < count; ++x) group[x] = loop[x] = x;
    const auto root = [](std::vector<Index>& of, Index x) {
        while (of[x] != x) x = of[x] = of[of[x]];
        return x;
    };
    std::vector<bool> used(count, false);
    std::map<std::pair<Index, Index>, int> sides;
    for (const Triangle& t : mesh) {
        for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
            used[u] = true;
            group[root(group, u)] = root(group, v);
            ++sides[std::minmax(u, v)];
        }
    }
    std::vector<bool> open(count, false);
    for (const auto& [edge, times] : sides) {
        if (times != 1) continue;
        open[edge.first] = open[edge.second] = true;
        loop[root(loop, edge.first)] = root(loop, edge.second);
    }
    std::size_t components = 0;
    std::size_t loops = 0;
    std::size_t unused = 0;
    for (Index x = 0; x < count; ++x) {
        components += used[x] && root(group, x) == x ? 1 : 0;
        loops += open[x] && root(loop, x) == x ? 1 : 0;
        unused += used[x] ? 0 : 1;
    }
    c.need(counts(c, 0, mesh.size(), "triangle"), "triangles");
    c.need(counts(c, 1, components, "component"), "components");
    c.need(counts(c, 2, unused, "point"), "unused");
    c.need(counts(c, 3, loops, "open loop"), "loops");
}
void everyDone(C& c) {
    finished(c);
    const auto& status = c.w.state.status;
    c.need(std::all_of(status.begin(), status.end(), [](PointStatus s) { return s == kDone; }),
           "every point is DONE");
}

// ---- splits, joins, finished edges -------------------------------------------------------------

void splits(C& c) {
    const auto [x, y] = c.w.linked(c.point(0));
    EdgeRings rings = c.w.rings;
    if (x == kNone || y == kNone || rings.ringOf(x) != rings.ringOf(y))
        return c.need(false, "in the same ring");
    const Exchange parts = rings.exchangeSuccessors(x, y);
    const bool hasEnd = rings.alive(c.w.end) && rings.ringOf(c.w.end) == parts.ringOfX;
    c.need(hasEnd || rings.ringOf(c.w.end) == parts.ringOfY, "goes on with end");
    c.need(c.count(1) == rings.length(hasEnd ? parts.ringOfX : parts.ringOfY), "goes on");
    c.need(c.count(2) == rings.length(hasEnd ? parts.ringOfY : parts.ringOfX), "stacked");
    c.need(c.count(3) == rings.stack().size() + 1, "depth");
}
void joinsRing(C& c, std::size_t length, bool stacked) {
    const auto [x, y] = c.w.linked(c.point(0));
    EdgeRings rings = c.w.rings;
    if (x == kNone || y == kNone || rings.ringOf(x) == rings.ringOf(y))
        return c.need(false, "in another ring");
    const Index depth = c.w.was.depthFromTop(c.w.was.ringOf(y));
    if (stacked && c.w.changes == 0) c.need(c.count(1) == depth + 1, "from the top");
    c.need(c.count(length) == rings.length(rings.exchangeSuccessors(x, y).ringOfX), "entries");
}
void isFinished(C& c, bool two) {
    const Index a = c.point(0);
    const Index b = c.point(1);
    c.need(c.w.triangleWith(a, b) != kNone && c.w.triangleWith(b, a) != kNone, "finished edge");
    const Index e = c.w.closedEntry(a, b);
    c.need(e != kNone && (c.w.rings.length(c.w.rings.ringOf(e)) == 2) == two, "on the ring");
}

constexpr Stage kAdvance = Stage::Advance;
constexpr Stage kEnds = Stage::Done;

// clang-format off
constexpr auto kRingForms = std::to_array<SentenceForm>({
    {Stage::Emit, kNoVerdict, "Triangle {} = ({}, {}, {}).", emit},
    {Stage::Ring, kNoVerdict, "Point {} enters the ring: now {}.", enters},
    {Stage::Ring, kNoVerdict, "Point {} leaves the ring: now {}.", leaves},
    {Stage::Ring, kNoVerdict, "A lone entry of point {} is left: closed.",
     [](C& c) { c.need(c.w.closedEntry(c.point(0), kNone) != kNone, "lone entry"); }},
    {Stage::Ring, kNoVerdict, "Point {} lies between two entries of {}: one finished edge, closed.", [](C& c) { isFinished(c, false); }},
    {Stage::Ring, kNoVerdict, "The ring of {} and {} is one finished edge: closed.", [](C& c) { isFinished(c, true); }},
    {Stage::Split, kNoVerdict, "Point {} is met again in the same ring, which splits: {} entries go on, {} go on the stack (depth {}).", splits},
    {Stage::Join, kNoVerdict, "Point {} is met again in the active ring: the rings join, {} entries.", [](C& c) { joinsRing(c, 1, false); }},
    {Stage::Join, kNoVerdict, "Point {} is met again in stacked ring {} from the top: the rings join, {} entries.", [](C& c) { joinsRing(c, 2, true); }},
    {kAdvance, kNoVerdict, "No ring is left.", noRing},
    {kAdvance, kNoVerdict, "No ring is left but {} on the shelf.",
     [](C& c) {
         c.need(c.w.state.rings.active() == kNone, "no ring");
         c.need(counts(c, 0, c.w.state.rings.stack().size(), "ring"), "on the shelf");
     }},
    {kAdvance, kNoVerdict, "The next ring comes off the stack; the next pivot is {}.", popped},
    {kAdvance, kNoVerdict, "The next pivot is {}.", [](C& c) { advances(c, 0); }},
    {kAdvance, kNoVerdict, "No triangle; the next pivot is {} ({} of this circuit without one).", counted},
    {kEnds, kNoVerdict, "Point {} leaves the ring: now {}.", leaves},
    {kEnds, kNoVerdict, "A full circuit of {} without a triangle: the ring waits on the shelf.", fullCircuit},
    {Stage::Seed, kNoVerdict, "No seed is left: {} on the shelf taken up; the next pivot is {}.",
     [](C& c) {
         advances(c, 1);
         c.need(c.w.state.startPointer >= c.w.points.size(), "no seed");
         c.need(counts(c, 0, c.w.was.stack().size(), "ring"), "rings on the shelf");
     }},
    {kEnds, kNoVerdict, "A full circuit of the seed without a triangle: the ring is freed, and its points are UNUSED again.",
     [](C& c) {
         c.need(c.w.released.size() == 2, "two points");
         for (const Index x : c.w.released) c.need(c.w.state.status[x] == kUnused, "UNUSED");
     }},
    {kEnds, kNoVerdict, "A full circuit of {} without a triangle: the ring is freed.", [](C& c) { freed(c, false); }},
    {kEnds, kNoVerdict, "A full circuit of {} without a triangle: the ring is freed, with {} on it.", [](C& c) { freed(c, true); }},
    {kEnds, kNoVerdict, "Component {} is complete; {} so far.", component},
    {kEnds, kNoVerdict, "Alert: too many triangles for the number of points; the run is stopped.",
     [](C& c) { c.need(c.w.state.triangles.size() > c.w.points.size() * c.w.params.maxTrianglesPerPoint, "too many"); }},
    {kEnds, kNoVerdict, "Alert: a hole is left open at point {}.", openHole},
    {kEnds, kNoVerdict, "Alert: the ring of two at point {} got no triangle.",
     [](C& c) {
         const auto& gone = c.w.released;
         c.need(gone.size() == 2 && (gone[0] == c.point(0) || gone[1] == c.point(0)), "of two");
     }},
    {Stage::Finished, kNoVerdict, "The run is finished, since every point is DONE: {} in {}, {} unused, {}.", everyDone},
    {Stage::Finished, kNoVerdict, "The run is stopped, since it has too many triangles: {} in {}, {} unused, {}.", finished},
});
// clang-format on

}  // namespace

std::span<const SentenceForm> ringForms() { return kRingForms; }

}  // namespace se::test::sentences
