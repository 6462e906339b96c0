/// Beyond the paper: Rules::fill. A ring that would be freed with interior points is a hole; it is
/// closed by ears, each a pivot with first and last alone, the best least angle first.
#include <algorithm>
#include <cmath>

#include "phases.h"
#include "shape.h"

namespace se {
namespace {

/// The fan of the ear at `entry`.
void setEar(StepContext& context, Index entry) {
    setPivot(context, entry);
    context.state.pivot.candidates.clear();
    layOutFan(context);
}

/// A ring as short as this is a hole even where neighbors leave wide gaps.
constexpr Index kNeverAnOpening = 4;

struct Ear {
    Index entry = kNone;
    double cosine = 2.0;
    bool faulty = true;
    friend bool operator<(const Ear& a, const Ear& b) {
        return a.faulty != b.faulty ? !a.faulty : a.cosine < b.cosine;
    }
};

/// The best ear of the active ring, no entry if the guard refuses all.
Ear bestEar(StepContext& context) {
    State& s = context.state;
    const Index ring = s.rings.active();
    // Where the surface may end anyway, an ear with a fault is no gain.
    const bool force = !isOpening(context);
    Ear best;
    Index entry = s.rings.head(ring);
    for (Index i = 0; i < s.rings.length(ring); ++i, entry = s.rings.next(entry)) {
        const Index before = s.rings.prev(entry);
        if (s.rings.open(before) || s.rings.open(entry)) continue;
        setEar(context, entry);
        if (manifoldRefuses(context)) continue;
        const double cosine = leastAngleCosine(
            context.points,
            {s.rings.point(entry), s.rings.point(before), s.rings.point(s.rings.next(entry))});
        Ear ear{entry, cosine, false};
        if (best.entry != kNone && !(ear < best)) continue;
        ear.faulty = overlapsAsTwoPointRing(s.pivot.lastAngle) || shapeRefuses(context);
        if (ear.faulty && !force) continue;
        if (best.entry == kNone || ear < best) best = ear;
    }
    return best;
}

}  // namespace

namespace {

/// Does the active ring run round a patch of the surface, instead of round a hole in it? Seen along
/// the normals it turns clockwise about a hole, which lies in the free sectors of its points.
bool runsRoundPatch(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    const Index head = rings.head(rings.active());
    const Vec3 origin = context.positionAt(head);
    Vec3 area(0.0);
    Vec3 normal(0.0);
    Index entry = head;
    do {
        const Index next = rings.next(entry);
        area += glm::cross(context.positionAt(entry) - origin, context.positionAt(next) - origin);
        normal += context.normalAt(entry);
        entry = next;
    } while (entry != head);
    return glm::dot(area, normal) > 0.0;
}

}  // namespace

bool isOpening(const StepContext& context) {
    if (!context.params.rules.rim) return false;
    const EdgeRings& rings = context.state.rings;
    const Index ring = rings.active();
    const Index length = rings.length(ring);
    Index rim = 0;
    Index entry = rings.head(ring);
    for (Index i = 0; i < length; ++i, entry = rings.next(entry)) {
        rim += isRim(context.points, rings.point(entry)) ? 1U : 0U;
    }
    return 3 * rim > 2 * length || (length > kNeverAnOpening && runsRoundPatch(context));
}

namespace {

/// Is the hole too wide to be one that missing points left, measured by the points about it?
bool isTooWide(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    const Index ring = rings.active();
    const Index length = rings.length(ring);
    const Vec3 origin = context.positionAt(rings.head(ring));
    Vec3 sum(0.0);
    double spacing = 0.0;
    Index entry = rings.head(ring);
    for (Index i = 0; i < length; ++i, entry = rings.next(entry)) {
        const Vec3 offset = context.positionAt(entry) - origin;
        sum += offset;
        const auto list = context.points.neighbors[rings.point(entry)];
        if (list.empty()) continue;
        const Vec3 nearest = context.points.position[list.front()] - context.positionAt(entry);
        spacing += std::sqrt(glm::dot(nearest, nearest));
    }
    if (!(spacing > 0.0)) return false;
    const Vec3 middle = sum / static_cast<double>(length);
    double farthestSq = 0.0;
    for (Index i = 0; i < length; ++i, entry = rings.next(entry)) {
        const Vec3 offset = context.positionAt(entry) - origin - middle;
        farthestSq = std::max(farthestSq, glm::dot(offset, offset));
    }
    const double limit = 0.5 * context.params.maxFillWidth * spacing / static_cast<double>(length);
    return farthestSq > limit * limit;
}

}  // namespace

bool mayFill(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    const Index length = rings.length(rings.active());
    return length > 2 && length <= context.params.maxFillLength && !isTooWide(context) &&
           (length <= kNeverAnOpening || !isOpening(context));
}

void phaseFill(AnyContext auto& context) {
    State& s = context.state;
    ++s.counters.pivots;
    s.pivotTriangles = 0;
    s.insertedEntries.clear();
    s.instances.clear();
    const Ear ear = bestEar(context);
    if (ear.entry == kNone) {
        s.patience = kFillFailed;
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
                            ear.faulty};
    });
    s.phase = Phase::Emit;
}

template void phaseFill(SilentContext&);
template void phaseFill(LoggedContext&);

}  // namespace se
