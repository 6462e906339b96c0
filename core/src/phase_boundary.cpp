/// §7: when a boundary point may be a pivot.
#include "phases.h"

namespace se {
namespace {

/// Puts `third` on the ring beside the pivot; both steps at it are open, for they are no mesh
/// edges.
void putOnRing(StepContext& context, Index third, bool before) {
    State& s = context.state;
    const Index pivot = s.pivot.pivot;
    const Index behind = before ? s.rings.prev(pivot) : pivot;
    s.third.stepBeforeWasOpen = s.rings.open(behind);
    s.third.entry = s.rings.insertAfter(behind, third);
    s.rings.setOpen(behind, true);
    s.rings.setOpen(s.third.entry, true);
    s.status[third] = 1;
}

bool unusedOnSameWall(const StepContext& context, Index p, Index x) {
    return context.state.status[x] == kUnused &&
           shareFace(context.points.type[p], context.points.type[x]);
}

/// §7.1: the ring consists of two boundary points.
bool insertOnRingOfTwo(AnyContext auto& context, Index p, Index second) {
    const PointSet& points = context.points;
    InsertEvidence evidence{
        p, second, kNone, false, Vec3(0.0), points.type[p], Verdict::NoThirdPoint};
    for (const Index x : points.neighbors[p]) {
        if (!unusedOnSameWall(context, p, x)) continue;
        const ThirdPointPlace place =
            placeThirdPoint(points.position[p], points.normal[p], points.type[p],
                            points.position[second], points.position[x]);
        putOnRing(context, x, place.before);
        evidence.third = x;
        evidence.cross = place.cross;
        evidence.verdict = place.before ? Verdict::Before : Verdict::After;
        break;
    }
    note(context, Stage::Insert, [&] { return evidence; });
    return evidence.third != kNone;
}

/// The pivot and its neighbors on the ring, as points.
struct OnRing {
    Index p, previous, next;
};

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
    if (context.params.rules.bothWalls && !shareFace(points.type[p], points.type[other])) {
        evidence.verdict = Verdict::OtherSideOpen;
        note(context, Stage::Insert, [&] { return evidence; });
        return false;
    }
    for (const Index x : points.neighbors[p]) {
        if (!unusedOnSameWall(context, p, x)) continue;
        const Vec3& from = before ? points.position[x] : points.position[across];
        const Vec3& to = before ? points.position[across] : points.position[x];
        if (!sectorStaysInside(position, points.normal[p], points.type[p], from, to)) continue;
        putOnRing(context, x, before);
        evidence.third = x;
        evidence.verdict = before ? Verdict::Before : Verdict::After;
        break;
    }
    note(context, Stage::Insert, [&] { return evidence; });
    return evidence.third != kNone;
}

}  // namespace

bool admitBoundaryPivot(AnyContext auto& context) {
    const State& s = context.state;
    const std::vector<std::uint8_t>& type = context.points.type;
    const Index pivot = s.pivot.pivot;
    const OnRing at{s.rings.point(pivot), s.rings.point(s.rings.prev(pivot)),
                    s.rings.point(s.rings.next(pivot))};
    if (s.rings.length(s.rings.active()) == 2) {
        return isBoundary(type[at.next]) && insertOnRingOfTwo(context, at.p, at.next);
    }
    if (isTransition(type[at.p], type[at.next]) && insertAtCorner(context, at, true)) return true;
    return isTransition(type[at.p], type[at.previous]) && insertAtCorner(context, at, false);
}

void withdrawThirdPoint(StepContext& context) {
    State& s = context.state;
    if (s.third.entry == kNone) return;
    const Index behind = s.rings.prev(s.third.entry);
    s.status[s.rings.point(s.third.entry)] = kUnused;
    s.rings.erase(s.third.entry);
    s.rings.setOpen(behind, s.third.stepBeforeWasOpen);
    s.third = {};
}

template bool admitBoundaryPivot(SilentContext&);
template bool admitBoundaryPivot(LoggedContext&);

}  // namespace se
