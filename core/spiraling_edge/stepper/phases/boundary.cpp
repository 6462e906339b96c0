/// §7: decides whether a boundary point may be a pivot, and inserts the third point of §7.1 and
/// §7.2. Rim points follow the same rules, with the end of their gap in place of a wall's point.
/// O(list).
#include <algorithm>

#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

/// Puts `third` on the ring next to the pivot; both steps at it are open, since they are no mesh
/// edges.
void putOnRing(StepContext& context, Index third, bool before) {
    State& s = context.state;
    const Index pivot = s.pivot.pivot;
    const Index previous = before ? s.rings.prev(pivot) : pivot;
    s.third.stepBeforeWasOpen = s.rings.open(previous);
    s.third.entry = s.rings.insertAfter(previous, third);
    s.rings.setOpen(previous, true);
    s.rings.setOpen(s.third.entry, true);
    s.status[third] = 1;
}

bool unusedOnSameWall(const StepContext& context, Index p, Index x) {
    return context.state.status[x] == kUnused &&
           shareFace(context.points.type[p], context.points.type[x]);
}

/// The pivot and its neighbors on the ring, as points.
struct OnRing {
    Index p, previous, next;
};

/// Inserts `third` next to the pivot and logs it, also if there is none. True if there is one.
bool insertThird(AnyContext auto& context, InsertEvidence evidence, Index third, bool before) {
    if (third != kNone) {
        putOnRing(context, third, before);
        evidence.third = third;
        evidence.verdict = before ? Verdict::Before : Verdict::After;
    }
    note(context, Stage::Insert, [&] {
        evidence.sectorDegrees = sectorDegrees(context, context.state.pivot.pivot);
        return evidence;
    });
    return third != kNone;
}

// ---- rim points ---------------------------------------------------------------------------------

// Choice: a rim point's next on the rim takes the place of the third point on its wall.

/// §7.1 for a rim point: the end of its gap goes before it, the beginning after it, so that the
/// remaining sector lies on the surface.
bool insertOnRimOfTwo(AnyContext auto& context, Index p, Index second) {
    const RimGap gap = context.points.gapAt(p);
    const auto isFree = [&](Index x) { return x != kNone && context.state.status[x] == kUnused; };
    const bool before = isFree(gap.to);
    const Index third = before ? gap.to : isFree(gap.from) ? gap.from : kNone;
    return insertThird(
        context,
        {p, second, kNone, false, Vec3(0.0), context.points.type[p], Verdict::NoThirdPoint}, third,
        before);
}

/// A rim point on a longer ring: a pivot like an interior point while the surface does not end in
/// its free sector, no pivot once both sides of the gap are meshed. In between, as in §7.2, the
/// rest on one side of the gap is meshed with the end of the gap as third point.
bool tryRimPivot(AnyContext auto& context, const OnRing& at) {
    const PointSet& points = context.points;
    const RimGap gap = points.gapAt(at.p);
    if (!gap.known()) return false;
    const auto place = [&](Index x) { return points.position[x]; };
    const RimSector sector =
        testRimSector(place(at.p), points.normal[at.p], place(at.previous), place(at.next),
                      at.previous == at.next, place(gap.from), place(gap.to));
    if (!sector.holdsGap) return true;
    if (sector.openAtFirst == sector.openAtLast) return false;
    const bool before = sector.openAtLast;
    const Index third = before ? gap.to : gap.from;
    return insertThird(context,
                       {at.p, before ? at.next : at.previous, kNone, true, Vec3(0.0),
                        points.type[at.p], Verdict::NoThirdPoint},
                       context.state.status[third] == kUnused ? third : kNone, before);
}

// ---- walls --------------------------------------------------------------------------------------

/// §7.1: the ring consists of two boundary points.
bool insertOnRingOfTwo(AnyContext auto& context, Index p, Index second) {
    const PointSet& points = context.points;
    InsertEvidence evidence{
        p, second, kNone, false, Vec3(0.0), points.type[p], Verdict::NoThirdPoint};
    const auto list = points.neighbors[p];
    const auto third = std::find_if(list.begin(), list.end(),
                                    [&](Index x) { return unusedOnSameWall(context, p, x); });
    if (third == list.end()) return insertThird(context, evidence, kNone, false);
    const ThirdPointSide place =
        paperRules(context).stayInside
            ? placeThirdPoint(points.position[p], points.normal[p], points.type[p],
                              points.position[second], points.position[*third])
            : printedThirdPointSide(points.position[p], points.normal[p], points.type[p],
                                    points.position[second]);
    evidence.cross = place.cross;
    return insertThird(context, evidence, *third, place.before);
}

/// §7.2: a transition between p and the ring neighbor across the corner: next ("entering", the
/// third point goes before p) or previous ("exiting").
bool insertAtCorner(AnyContext auto& context, const OnRing& at, bool before) {
    const PointSet& points = context.points;
    const Index p = at.p;
    const Index across = before ? at.next : at.previous;
    const Index other = before ? at.previous : at.next;
    const Vec3& position = points.position[p];
    InsertEvidence evidence{
        p, across, kNone, true, Vec3(0.0), points.type[p], Verdict::NoThirdPoint};
    if (context.params.robust.bothWalls && !shareFace(points.type[p], points.type[other])) {
        evidence.verdict = Verdict::OtherSideOpen;
        return insertThird(context, evidence, kNone, before);
    }
    const auto fits = [&](Index x) {
        if (!unusedOnSameWall(context, p, x)) return false;
        const Vec3& from = before ? points.position[x] : points.position[across];
        const Vec3& to = before ? points.position[across] : points.position[x];
        return !paperRules(context).stayInside ||
               sectorStaysInside(position, points.normal[p], points.type[p], from, to);
    };
    const auto list = points.neighbors[p];
    const auto third = std::find_if(list.begin(), list.end(), fits);
    return insertThird(context, evidence, third == list.end() ? kNone : *third, before);
}

}  // namespace

bool tryBoundaryPivot(AnyContext auto& context) {
    const State& s = context.state;
    const std::vector<std::uint8_t>& type = context.points.type;
    const Index pivot = s.pivot.pivot;
    const OnRing at{s.rings.point(pivot), s.rings.point(s.rings.prev(pivot)),
                    s.rings.point(s.rings.next(pivot))};
    const bool onRim = isRimPoint(type[at.p]);
    if (s.rings.length(s.rings.active()) == 2) {
        if (!isBoundary(type[at.next])) return false;
        // Fig. 14: the result of the unmodified neighbor ring.
        if (!paperRules(context).thirdPoint) return true;
        return onRim ? insertOnRimOfTwo(context, at.p, at.next)
                     : insertOnRingOfTwo(context, at.p, at.next);
    }
    if (onRim) return tryRimPivot(context, at);
    if (!paperRules(context).corners) return false;
    if (isTransition(type[at.p], type[at.next]) && insertAtCorner(context, at, true)) return true;
    return isTransition(type[at.p], type[at.previous]) && insertAtCorner(context, at, false);
}

void removeThirdPoint(StepContext& context) {
    State& s = context.state;
    if (s.third.entry == kNone) return;
    const Index previous = s.rings.prev(s.third.entry);
    s.status[s.rings.point(s.third.entry)] = kUnused;
    s.rings.erase(s.third.entry);
    s.rings.setOpen(previous, s.third.stepBeforeWasOpen);
    s.third = {};
}

template bool tryBoundaryPivot(UnloggedContext&);
template bool tryBoundaryPivot(LoggedContext&);

}  // namespace se
