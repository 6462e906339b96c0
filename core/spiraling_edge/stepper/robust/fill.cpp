/// Beyond the paper: RobustRules::fill. A ring that would be freed is a hole, unless the surface
/// ends there; it is closed by ears, each a pivot with first and last alone, the best least angle
/// first.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_set>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/geometry/loop_shape.h"
#include "spiraling_edge/geometry/second_layer.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

/// The fan of the ear at `entry`.
void setEar(StepContext& context, Index entry) {
    setPivot(context, entry);
    context.state.pivot.candidates.clear();
    layOutFan(context);
}

/// A ring as short as this is a hole even where neighbors leave wide gaps, unless it is
/// isOutlineOfSmallPatch().
constexpr Index kShortRing = 5;

/// The longest ring in which an ear may have a fault.
constexpr Index kMayForce = 4;

struct Ear {
    Index entry = kNone;
    double cosine = 2.0;
    int faults = 0;
    bool faulty() const { return faults > 0; }
    friend bool operator<(const Ear& a, const Ear& b) {
        return a.faults != b.faults ? a.faults < b.faults : a.cosine < b.cosine;
    }
};

/// The shape of the active ring. Requires one. O(ring).
LoopShape shapeOfRing(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    assert(rings.active() != kNone);
    const Vec3 origin = context.positionAt(rings.head(rings.active()));
    ShapeSum sum;
    for (const Index entry : rings.entriesOf(rings.active())) {
        sum.add(context.positionAt(entry) - origin, context.normalAt(entry),
                context.positionAt(rings.next(entry)) - origin);
    }
    return sum.shape();
}

/// True if the triangles at the active ring, and those that are connected to them by edges, are
/// at most `limit`. O(limit).
bool isPatchOf(const StepContext& context, std::size_t limit) {
    const State& s = context.state;
    std::vector<Index> found;
    std::unordered_set<Index> seen;
    const auto add = [&](HalfEdge h) {
        if (h != kNone && seen.insert(h / 3).second) found.push_back(h / 3);
    };
    for (const Index entry : s.rings.entriesOf(s.rings.active())) {
        add(s.edges.find(s.rings.point(entry), s.rings.point(s.rings.next(entry))));
    }
    for (std::size_t i = 0; i < found.size() && found.size() <= limit; ++i) {
        const Triangle& t = s.triangles[found[i]];
        for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}})
            add(s.edges.find(v, u));
    }
    return found.size() <= limit;
}

/// True if the ring runs around a whole patch of the surface instead of around a hole in it. A
/// round patch has 0.18 triangles per square of its border's length; one of more than 1 would be
/// folded.
bool runsRoundPatch(const StepContext& context, const LoopShape& shape) {
    return shape.turnsRoundPatch && isPatchOf(context, std::size_t{shape.length} * shape.length);
}

/// True if the active ring holds a boundary point, of a wall or of a rim.
bool touchesBoundary(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    bool found = false;
    for (const Index entry : rings.entriesOf(rings.active())) {
        found = found || isBoundary(context.points.type[rings.point(entry)]);
    }
    return found;
}

/// True if the surface may end anywhere, by the rule or by rim points.
bool mayEnd(const StepContext& context) {
    return context.params.robust.rim || !context.points.rim.empty();
}

/// True if the surface may end at the active ring, which has this shape.
bool isOpening(const StepContext& context, const LoopShape& shape) {
    if (!mayEnd(context)) return false;
    const EdgeRings& rings = context.state.rings;
    const Index length = rings.length(rings.active());
    Index boundary = 0;
    Index flagged = 0;
    Index rim = 0;
    for (const Index entry : rings.entriesOf(rings.active())) {
        const Index point = rings.point(entry);
        boundary += isBoundary(context.points.type[point]) ? 1U : 0U;
        flagged += isRimPoint(context.points.type[point]) ? 1U : 0U;
        rim += context.passesRim(point) ? 1U : 0U;
    }
    const auto most = [length](Index count) { return 3 * count > 2 * length; };
    if (most(flagged)) return true;
    if (!context.params.robust.rim) return false;
    if (most(boundary)) return true;
    return ((length > kShortRing || rim == length) && runsRoundPatch(context, shape)) ||
           (most(rim) && shape.widthInEdges() >= context.params.thresholds.openingWidth);
}

/// True if the surface ends at every point of the short ring, and it runs around a patch: the first
/// four triangles of a grid of 3 x 3 points.
bool isOutlineOfSmallPatch(const StepContext& context, const LoopShape& shape) {
    const EdgeRings& rings = context.state.rings;
    const auto entries = rings.entriesOf(rings.active());
    return context.params.robust.rim &&
           std::all_of(entries.begin(), entries.end(),
                       [&](Index e) { return context.passesRim(rings.point(e)); }) &&
           runsRoundPatch(context, shape);
}

/// True if an ear may have a fault: only in the smallest rings, since one fault leads to more, and
/// not where the surface may end.
bool mayForce(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    return rings.length(rings.active()) <= kMayForce && !touchesBoundary(context) &&
           !isOpening(context, shapeOfRing(context));
}

/// The faults of a triangle that a rule refuses: one for the refusal, those of its shape, and
/// conflicts with finished ones near.
int faultsOf(const StepContext& context, const Triangle& made) {
    const State& s = context.state;
    std::vector<Index> near;
    for (const Index corner : {made.a, made.b, made.c}) {
        for (const Index x : context.points.neighbors[corner]) {
            for (HalfEdge h = s.edges.firstFrom(x); h != kNone; h = s.edges.nextFrom(h))
                near.push_back(h / 3);
        }
    }
    sortUnique(near);
    int faults = 1 + shapeFaults(context.points, made);
    for (const Index t : near) faults += conflict(context.points, made, s.triangles[t]) ? 1 : 0;
    return faults;
}

/// The best ear of the active ring; no entry if rules refuse all. O(ring).
Ear bestEar(StepContext& context) {
    State& s = context.state;
    const Index ring = s.rings.active();
    const bool force = mayForce(context);
    Ear best;
    Index entry = s.rings.head(ring);
    for (Index i = 0; i < s.rings.length(ring); ++i, entry = s.rings.next(entry)) {
        const Index before = s.rings.prev(entry);
        if (s.rings.open(before) || s.rings.open(entry)) continue;
        setEar(context, entry);
        if (s.pivot.fullTurn || manifoldRefuses(context)) continue;
        const double cosine = leastAngleCosine(
            context.points,
            {s.rings.point(entry), s.rings.point(before), s.rings.point(s.rings.next(entry))});
        Ear ear{entry, cosine, 0};
        if (best.entry != kNone && !(ear < best)) continue;
        if (overlapsAsTwoPointRing(s.pivot.lastAngle) || shapeRefuses(context)) {
            if (!force) continue;
            ear.faults = faultsOf(context, {s.rings.point(entry), s.rings.point(before),
                                            s.rings.point(s.rings.next(entry))});
        }
        if (best.entry == kNone || ear < best) best = ear;
    }
    return best;
}

/// True if the hole is too wide to be left by missing points, in spacings of the points around it.
bool isTooWide(const StepContext& context, const LoopShape& shape) {
    const EdgeRings& rings = context.state.rings;
    const double length = rings.length(rings.active());
    double spacing = 0.0;
    for (const Index entry : rings.entriesOf(rings.active())) {
        spacing += nearestDistance(context.points, rings.point(entry)) / length;
    }
    return spacing > 0.0 && shape.width() > context.params.maxFillWidth * spacing;
}

}  // namespace

bool isOpening(const StepContext& context) {
    return mayEnd(context) && isOpening(context, shapeOfRing(context));
}

bool mayFill(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    const Index length = rings.length(rings.active());
    if (length <= 2 || length > context.params.maxFillLength) return false;
    const LoopShape shape = shapeOfRing(context);
    if (!context.params.isWithinHoleLimits(shape.width(), length)) return false;
    if (isTooWide(context, shape)) return false;
    return length <= kShortRing ? !isOutlineOfSmallPatch(context, shape)
                                : !isOpening(context, shape);
}

void phaseFill(AnyContext auto& context) {
    State& s = context.state;
    ++s.counters.pivots;
    s.pivotTriangles = 0;
    s.insertedEntries.clear();
    s.instances.clear();
    const Ear ear = bestEar(context);
    if (ear.entry == kNone) {
        s.retryLevel = kFillFailed;
        s.phase = Phase::Advance;
        return;
    }
    setEar(context, ear.entry);
    ++s.counters.filled;
    note(context, Stage::Fill, [&] {
        constexpr double kDegrees = 57.295779513082320877;
        return FillEvidence{s.rings.point(ear.entry),
                            s.rings.point(s.pivot.first),
                            s.rings.point(s.pivot.last),
                            s.rings.length(s.rings.active()),
                            std::acos(std::clamp(ear.cosine, -1.0, 1.0)) * kDegrees,
                            ear.faulty(),
                            s.pivot.lastAngle.degrees()};
    });
    s.phase = Phase::Emit;
}

template void phaseFill(UnloggedContext&);
template void phaseFill(LoggedContext&);

}  // namespace se
