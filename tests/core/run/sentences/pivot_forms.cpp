/// §4 to §6.4 and §7, and the rules on fans: the sentences of a pivot up to its triangles.
#include "core/run/sentences/claim.h"

namespace se::test::sentences {
namespace {

// ---- seed, pivot, walls ---------------------------------------------------------------------

bool isUnused(const C& c, Index x) { return c.w.status[x] == kUnused; }

void seed(C& c) {
    const Index p = c.point(0);
    const Index q = c.point(1);
    const Real d = glm::distance(c.w.place(p), c.w.place(q));
    c.same(2, d, d, "distance");
    c.need(c.w.lists(p, q) && c.w.statusWas[p] == kUnused && isUnused(c, q), "UNUSED neighbor");
    for (const Index x : c.w.points.neighbors[p]) {
        const Real other = glm::distance(c.w.place(p), c.w.place(x));
        c.need(!isUnused(c, x) || other >= d * (1 - 1e-12L), "nearest");
    }
}
template <typename Test>
bool hasNeighbor(C& c, const Test& test) {
    const auto list = c.w.points.neighbors[c.point(0)];
    return std::any_of(list.begin(), list.end(), test);
}
void unseeded(C& c) {
    c.need(hasNeighbor(c, [&](Index x) { return c.w.statusWas[x] == kUnused; }), "UNUSED");
    c.need(c.w.state.startPointer >= c.w.points.size(), "no seed is left");
}
void onlyDone(C& c) {
    c.need(!hasNeighbor(c, [&](Index x) { return c.w.status[x] != kDone; }), "only DONE");
    c.need(!c.w.points.neighbors[c.point(0)].empty(), "neighbors");
}
void pivot(C& c) {
    const Index e = c.w.state.pivot.pivot;
    c.need(c.point(0) == c.w.p && c.point(1) == c.w.first && c.point(2) == c.w.last, "points");
    const bool full = c.w.first == c.w.last;
    c.degrees(3, full ? 360 : c.w.angleNear(c.w.last, c.number(3)), "sector");
    c.need(c.count(4) == c.w.was.length(c.w.was.ringOf(e)), "length");
}
bool namesWalls(const std::string& words, std::uint8_t type) {
    constexpr std::array<std::pair<std::string_view, std::uint8_t>, 6> kWalls{
        {{"+x", 1}, {"+y", 2}, {"+z", 4}, {"-x", 8}, {"-y", 16}, {"-z", 32}}};
    std::string own;
    for (const auto& [name, bit] : kWalls) {
        if ((type & bit) != 0) own += (own.empty() ? "" : " ") + std::string(name);
    }
    return own == words;
}
/// True if a direction points out of a wall of p.
bool leadsOut(std::uint8_t type, const V& d) {
    for (int k = 0; k < 3; ++k) {
        if (((type >> k & 1) != 0 && d[k] > 0) || ((type >> (k + 3) & 1) != 0 && d[k] < 0))
            return true;
    }
    return false;
}
/// True if the sector at p from `from` to `to` is at most straight and holds no way out of a wall.
bool staysInside(const C& c, Index p, Index from, Index to) {
    const Witness& w = c.w;
    const auto angle = [&](const V& x) {
        return angleAt(w.place(p), w.normal(p), w.place(from), x, true);
    };
    const Real sector = angle(w.place(to));
    if (sector > 182.6L) return false;
    for (int k = 0; k < 6; ++k) {
        if ((w.points.type[p] >> k & 1) == 0) continue;
        V out(0);
        out[k % 3] = k < 3 ? 1 : -1;
        const V flat = out - glm::dot(out, w.normal(p)) * w.normal(p);
        if (glm::dot(flat, flat) < 1e-12L) continue;
        const Real at = angle(w.place(p) + out);
        if (at > 1e-6L && at < sector - 1e-6L) return false;
    }
    return true;
}
/// The third point stands on the ring where the sentence has it.
void joins(C& c, std::size_t third, std::size_t place) {
    const EdgeRings& rings = c.w.state.rings;
    const bool before = c.word(place) == "before";
    const Index e = c.w.state.pivot.pivot;
    const Index beside = before ? rings.prev(e) : rings.next(e);
    c.need(rings.point(beside) == c.point(third), "place on the ring");
    c.need(c.w.statusWas[c.point(third)] == kUnused, "UNUSED");
    c.verdict = before ? Verdict::Before : Verdict::After;
}
void onRingOfTwo(C& c) {
    const Index p = c.point(0);
    const Index s = c.point(1);
    c.need(p == c.w.p && s == c.w.last, "points");
    c.need(c.w.was.length(c.w.was.active()) == 2, "ring of two");
    c.need(isBoundary(c.w.points.type[p]) && isBoundary(c.w.points.type[s]), "boundary");
}
void atCorner(C& c) {
    const Index p = c.point(0);
    const Index s = c.point(1);
    c.need(p == c.w.p && (s == c.w.first || s == c.w.last), "points");
    c.need(!shareFace(c.w.points.type[p], c.w.points.type[s]), "corner");
}
void noWallPoint(C& c, bool corner) {
    const Index p = c.point(0);
    const Index s = c.point(1);
    for (const Index x : c.w.points.neighbors[p]) {
        if (!isUnused(c, x) || !shareFace(c.w.points.type[p], c.w.points.type[x])) continue;
        const bool fits = s == c.w.last ? staysInside(c, p, x, s) : staysInside(c, p, s, x);
        c.need(corner && !fits, "no UNUSED neighbor");
    }
}
void insertAtWall(C& c, bool isBySide) {
    onRingOfTwo(c);
    joins(c, 2, 3);
    const Index p = c.point(0);
    const V to = c.w.place(c.point(1)) - c.w.place(p);
    const V own = glm::cross(c.w.normal(p), to);
    for (std::size_t k = 0; k < 3; ++k)
        c.same(4 + k, own[static_cast<V::length_type>(k)], glm::length(to), "cross product");
    c.need(namesWalls(c.word(7), c.w.points.type[p]), "wall");
    const bool other = c.word(3) == "after";
    const Index s = c.point(1);
    const Index third = c.point(2);
    c.need(isBySide == (leadsOut(c.w.points.type[p], own) == (c.word(3) == "before")), "side");
    c.need(isBySide || !(other ? staysInside(c, p, third, s) : staysInside(c, p, s, third)),
           "out of the box on the other side");
}
void rimPoints(C& c) {
    const RimGap gap = c.w.gapAt(c.point(0));
    c.need(isRimPoint(c.w.points.type[c.point(0)]), "rim point");
    for (const Index x : {gap.from, gap.to})
        c.need(x == kNone || !isUnused(c, x), "no next point of the rim");
}
void onRim(C& c, std::size_t i) {
    const RimGap gap = c.w.gapAt(c.w.p);
    c.need(c.point(i) == gap.from || c.point(i) == gap.to, "next on the rim");
}
void isOver(C& c, std::size_t i) {
    c.need(c.point(i) == c.w.p && c.w.state.phase == Phase::Advance, "passed over");
}

// ---- sort, limits, convexity, reciprocity -----------------------------------------------------

Real sorted(C& c) {
    c.need(c.w.lists(c.w.p, c.point(0)), "listed");
    return c.degrees(1, c.w.angleNear(c.point(0), c.number(1)), "angle");
}
void sameAngle(C& c) {
    const Real own = sorted(c);
    const Index x = c.point(0);
    const Index rival = c.point(2);
    c.need(std::abs(own - c.w.angle(rival)) <= kSlackDegrees, "same angle");
    const Real farther = glm::length(c.w.offset(rival)) - glm::length(c.w.offset(x));
    const Real slack = 1e-15L * glm::length(c.w.offset(x));
    c.need(c.word(3) == "as near"  ? std::abs(farther) <= slack
           : c.word(3) == "nearer" ? farther < 0
                                   : farther > 0,
           "nearer or farther");
}

struct Limit {
    bool atStart;
    Index limit, to;    ///< Entries.
    Index from, point;  ///< Points.
};
Limit limitOf(C& c, bool atStart) {
    const EdgeRings& rings = c.w.state.rings;
    const Index limit = atStart ? c.w.start : c.w.end;
    const Index to = atStart ? rings.prev(limit) : rings.next(limit);
    return {atStart, limit, to, rings.point(limit), rings.point(to)};
}
/// "Point {} beyond {} = {}": the limit that is meant.
Limit tested(C& c) {
    const Limit at = limitOf(c, c.word(1) == "start");
    c.need(c.point(0) == at.point && c.point(2) == at.from, "next on the ring");
    if (c.verdict != Verdict::Moved) c.need(c.lastWord() == c.word(1), "side that stays");
    return at;
}
Real turnAt(C& c, const Limit& at) {
    const V a = c.w.place(at.from);
    const V in = c.w.place(at.atStart ? at.point : c.w.p) - a;
    const V out = c.w.place(at.atStart ? c.w.p : at.point) - a;
    return glm::dot(glm::cross(in, out), c.w.normal(at.from));
}
Real sizeAt(C& c, const Limit& at) {
    return glm::distance(c.w.place(at.from), c.w.place(at.point)) *
           glm::distance(c.w.place(at.from), c.w.place(c.w.p));
}
Real spanTo(C& c, const Limit& at) {
    const Real to = c.w.angle(at.point);
    return at.atStart ? to - c.w.startAngle() : c.w.endAngle() - to;
}
bool isInside(C& c, Index x, Real slack) {
    return c.w.angle(x) > c.w.startAngle() - slack && c.w.angle(x) < c.w.endAngle() + slack;
}
/// A turn in words: concave above 0.
void turns(C& c, const Limit& at, std::size_t i, bool concave) {
    const Real own = turnAt(c, at);
    c.same(i, own, 1e-3L * sizeAt(c, at), "turn");
    c.need(concave ? own > -1e-15L * sizeAt(c, at) : own <= 1e-15L * sizeAt(c, at), "convex");
}
/// The candidate `x` lies in the sphere of the triangle that a move would make.
bool isInSphere(C& c, const Limit& at, Index x) {
    const auto center = circleCenter(c.w.offset(at.from), c.w.offset(at.point));
    return center && glm::distance(*center, c.w.offset(x)) < glm::length(*center) * (1 + 1e-9L);
}
bool isBetween(C& c, const Limit& at, Index x) {
    const Real low = at.atStart ? c.w.startAngle() : c.w.angle(at.point);
    const Real high = at.atStart ? c.w.angle(at.point) : c.w.endAngle();
    return c.w.angle(x) > low - kSlackDegrees && c.w.angle(x) < high + kSlackDegrees;
}
bool blocks(C& c, const Limit& at, Index x) {
    // Of two corners almost in one place, rounding may have one in the sphere.
    const bool isPair = glm::distance(c.w.place(at.from), c.w.place(at.point)) <
                        1e-3L * glm::length(c.w.offset(at.from));
    if ((x == at.from && !isPair) || !c.w.lists(c.w.p, x) || !isInSphere(c, at, x)) return false;
    if (isUnused(c, x)) return isBetween(c, at, x);
    return glm::length(c.w.offset(x)) < glm::length(c.w.offset(at.point));
}
void moves(C& c) {
    const Limit at = tested(c);
    turns(c, at, 3, true);
    c.need(c.word(4) == c.word(1), "side");
    c.degrees(5, at.atStart ? c.w.startAngle() : c.w.endAngle(), "old limit");
    c.degrees(6, c.w.angle(at.point), "new limit");
    c.need(c.w.lists(c.w.p, at.point), "listed");
    c.need(isInside(c, at.point, 0), "inside the limits");
}
void isOtherEnd(C& c) {
    const Limit at = tested(c);
    c.need(at.to == (at.atStart ? c.w.end : c.w.start), "other end");
}
void isNoEdge(C& c) {
    const Limit at = tested(c);
    c.need(!c.w.joined(at.from, at.point), "no edge");
}
void isNotListed(C& c) { c.need(!c.w.lists(c.w.p, tested(c).point), "not listed"); }
void isOutside(C& c) {
    const Limit at = tested(c);
    c.degrees(3, c.w.angle(at.point), "angle");
    c.need(!isInside(c, at.point, -kSlackDegrees), "outside");
}
void isHalfTurn(C& c) {
    const Limit at = tested(c);
    c.degrees(3, c.w.angle(at.point), "angle");
    c.need(spanTo(c, at) >= 180 - kSlackDegrees, "half turn");
}
void isBlocked(C& c) {
    const Limit at = tested(c);
    c.need(blocks(c, at, c.point(3)), "in the sphere");
}
void isConvex(C& c) { turns(c, tested(c), 3, false); }

void nowLimit(C& c) {
    const Limit at = limitOf(c, c.word(2) == "start");
    c.need(c.point(0) == at.from, "point");
    sorted(c);
    c.verdict = at.atStart ? Verdict::NowStart : Verdict::NowEnd;
}
void outsideMoved(C& c) {
    const Real own = sorted(c);
    const bool start = c.word(2) == "start";
    c.need(start ? c.w.startMoved : c.w.endMoved, "moved");
    c.need(start ? own <= c.w.startAngle() + kSlackDegrees : own >= c.w.endAngle() - kSlackDegrees,
           "outside");
}
Limit nextBeyond(C& c) {
    const Limit at = limitOf(c, c.word(1) == "start");
    c.need(c.point(0) == at.point, "next on the ring");
    return at;
}
void afterConvex(C& c) {
    const Limit at = nextBeyond(c);
    c.need(turnAt(c, at) <= 1e-15L * sizeAt(c, at), "convex");
}
void afterHalfTurn(C& c) { c.need(spanTo(c, nextBeyond(c)) >= 180 - kSlackDegrees, "half turn"); }
void afterBlocked(C& c) {
    const Limit at = nextBeyond(c);
    const auto list = c.w.points.neighbors[c.w.p];
    c.need(std::any_of(list.begin(), list.end(), [&](Index x) { return blocks(c, at, x); }),
           "in the sphere");
}
void afterOther(C& c) {
    const Limit at = nextBeyond(c);
    c.need(!c.w.joined(at.from, at.point) || !c.w.lists(c.w.p, at.point) ||
               !isInside(c, at.point, -kSlackDegrees) ||
               at.to == (at.atStart ? c.w.end : c.w.start) ||
               !c.w.params.readings.limitsFirst ||  // It may get no second test.
               !c.w.params.paper.limits,
           "for another reason");
}

void seenFrom(C& c) {
    const Witness& w = c.w;
    const Index e = c.point(0);
    const Index before = c.point(1);
    const Index after = c.point(2);
    bool found = false;
    for (Index i = w.state.rings.firstEntryOf(e); i != kNone; i = w.state.rings[i].nextOfPoint)
        found = found || (w.pointOf(w.state.rings.prev(i)) == before &&
                          w.pointOf(w.state.rings.next(i)) == after);
    c.need(found, "on the ring between");
    const bool printed = c.word(4) == "the";
    c.need(printed || c.word(4) == "its free", "sector");
    c.need(c.word(5).starts_with(" from efirst to elast ") == printed, "sector");
    const Index from = printed ? after : before;
    const Index to = printed ? before : after;
    const auto angle = [&](Index x) {
        return angleAt(w.place(e), w.normal(e), w.place(from), w.place(x), w.params.robust.tangent);
    };
    const Real own = c.degrees(3, angle(w.p), "angle of the pivot");
    const Real sector = from == to ? 360 : angle(to);
    c.degrees(5, sector, "sector");
    if (c.verdict == Verdict::Kept)
        c.need(own > -kSlackDegrees && own < sector + kSlackDegrees, "inside");
    if (c.verdict == Verdict::NotReciprocal)
        c.need(own <= kSlackDegrees || own >= sector - kSlackDegrees, "outside");
    const auto& type = w.points.type;
    if (c.verdict == Verdict::WallComplete)
        c.need(shareFace(type[e], type[before]) && shareFace(type[e], type[after]), "walls");
}

// ---- holes, circumsphere, two points ----------------------------------------------------------

void hole(C& c) {
    const Witness& w = c.w;
    const EdgeRings& rings = w.state.rings;
    Index edges = 2;
    for (Index e = w.end; e != w.start; e = rings.next(e)) ++edges;
    constexpr std::array<std::string_view, 4> kWords{"", "", "two", "three"};
    c.need(edges < 4 && c.word(0) == kWords[edges], "edges");
    const V a = w.place(w.pointOf(w.start));
    const V b = w.place(w.pointOf(w.end));
    const V up = w.normal(w.p) + w.normal(w.pointOf(w.start)) + w.normal(w.pointOf(w.end));
    const V across = glm::normalize(glm::cross(b - a, up));
    const Real side = glm::dot(across, w.place(c.point(1)) - a);
    const Real pivotSide = glm::dot(across, w.place(w.p) - a);
    const Real size = glm::length(b - a);
    c.same(2, side, size, "side");
    c.same(3, pivotSide, size, "side of the pivot");
    const bool same = c.verdict == Verdict::Kept;
    c.need(same ? side * pivotSide > -1e-15L * size : side * pivotSide <= 1e-15L * size, "side");
}

/// t, s and q beside each other on the neighbor ring, in this order.
void areBeside(C& c, Index q, Index t, Index s) {
    const auto& all = c.w.candidates;
    const auto at = std::find(all.begin(), all.end(), q);
    c.need(at != all.end(), "candidate");
    if (at == all.end()) return;
    const Index before = at == all.begin() ? c.w.pointOf(c.w.start) : *(at - 1);
    const Index after = at + 1 == all.end() ? c.w.pointOf(c.w.end) : *(at + 1);
    c.need(t == before && s == after, "neighbors on the neighbor ring");
}
void gapFrom(C& c, std::size_t i, std::size_t t, bool wide) {
    const auto& w = c.w;
    if (w.candidates.empty()) return;
    const bool atStart = w.candidates.front() == c.point(0);
    const bool atEnd = w.candidates.back() == c.point(0);
    const Real from = atStart ? w.startAngle() : w.angle(c.point(t));
    const Real to = atEnd ? w.endAngle() : w.angle(c.point(t + 1));
    const Real own = c.degrees(i, to - from, "gap");
    const Real limit = std::acos(Real(w.params.maxGapCosine)) / kDegree;
    c.need(wide ? own > limit - kSlackDegrees : own <= limit + kSlackDegrees, "gap and limit");
}
/// "Point {} lies [{}] inside the sphere of the pivot, {} and {} ([d = {},] r = {})"
void onSphere(C& c, std::size_t t) {
    areBeside(c, c.point(0), c.point(t), c.point(t + 1));
    const auto center = circleCenter(c.w.offset(c.point(t)), c.w.offset(c.point(t + 1)));
    c.need(center.has_value(), "a circle");
    if (!center) return;
    const Real r = glm::length(*center);
    const Real d = glm::distance(*center, c.w.offset(c.point(0)));
    const Real size = glm::length(c.w.offset(c.point(0)));
    if (t == 1) {
        c.same(3, r, r, "radius");
        c.need(std::abs(d - r) <= 1e-11L * (r + size), "on the sphere");
        return;
    }
    c.same(5, d, r, "distance");
    c.same(6, r, r, "radius");
    c.same(1, std::abs(d - r), 1e-3L * (r + size), "depth");
    const bool inside = c.word(2) == "inside";
    c.need(inside || c.word(2) == "outside", "side");
    c.need(inside ? d < r : d > r, "inside or outside");
    c.need(inside == (c.verdict == Verdict::InsideSphere), "kept inside");
}
void noCircle(C& c) {
    areBeside(c, c.point(0), c.point(1), c.point(2));
    const Real angle = between(c.w.offset(c.point(1)), c.w.offset(c.point(2)));
    c.need(std::min(angle, 180 - angle) < 1e-7L, "in line");
}

void twoPoint(C& c) {
    c.need(c.w.candidates.empty() && !c.w.startMoved && !c.w.endMoved, "only first and last");
}
Real apart(C& c) {
    twoPoint(c);
    return c.degrees(0, c.w.lastAngle(), "angle");
}

// ---- guard ------------------------------------------------------------------------------------

/// A triangle of the pivot with two spokes of the fan, or one spoke (b is kNone).
struct Part {
    Index a, b;
    std::size_t at;  ///< On the list of spokes.
    Corners corners;
};
using Objects = bool (*)(C&, const Part&, const std::vector<Index>&);

Real angleOfSpoke(C& c, const std::vector<Index>& fan, std::size_t i) {
    return i == 0 ? 0 : i + 1 == fan.size() ? c.w.lastAngle() : c.w.angle(fan[i]);
}
bool isTakenSpoke(C& c, const Part& t, const std::vector<Index>& fan) {
    const Witness& w = c.w;
    if (std::count(fan.begin(), fan.end(), t.a) > 1) return true;
    // The step of the ring at the pivot has its triangle on the other side.
    if (t.at == 0) return w.triangleWith(w.p, t.a) != kNone;
    return t.at + 1 == fan.size() ? w.triangleWith(t.a, w.p) != kNone : w.joined(w.p, t.a);
}
bool isTaken(C& c, const Part& t, const std::vector<Index>& fan) {
    return t.b == kNone ? isTakenSpoke(c, t, fan) : c.w.triangleWith(t.a, t.b) != kNone;
}
bool isElsewhere(C& c, const Part& t, const std::vector<Index>&) {
    const EdgeRings& rings = c.w.state.rings;
    bool known = false;
    for (Index e = rings.firstEntryOf(t.b); e != kNone; e = rings[e].nextOfPoint)
        known = known || rings.point(rings.next(e)) == t.a;
    return c.w.triangleWith(t.b, t.a) != kNone && known;
}
bool isPillow(C& c, const Part& t, const std::vector<Index>& fan) {
    const Index old = c.w.triangleWith(t.b, t.a);
    if (fan.size() == 3 && fan.front() == fan.back()) return true;
    if (old == kNone) return false;
    const Triangle& o = c.w.state.triangles[old];
    return o.a == c.w.p || o.b == c.w.p || o.c == c.w.p;
}
bool crossesRing(C& c, const Part& t, const std::vector<Index>&) {
    const Witness& w = c.w;
    const EdgeRings& rings = w.state.rings;
    const V up = w.normal(w.p);
    const auto sideOf = [&](const V& a, const V& b, const V& x) {
        const V side = glm::cross(b - a, x - a);
        const Real slack = 1e-12L * glm::length(b - a) * glm::length(x - a);  // Rounding decides.
        const Real turn = glm::dot(side, up);
        return turn > slack ? 1 : turn < -slack ? -1 : 0;
    };
    const V u = t.b == kNone ? w.place(w.p) : w.place(t.a);
    const V v = w.place(t.b == kNone ? t.a : t.b);
    for (Index e = 0; e < rings.entryCapacity(); ++e) {
        if (!rings.alive(e) || rings.open(e)) continue;
        const Index from = rings.point(e);
        const Index to = rings.point(rings.next(e));
        if (from == w.p || to == w.p || from == t.a || to == t.a || from == t.b || to == t.b)
            continue;
        const V& x = w.place(from);
        const V& y = w.place(to);
        if (sideOf(u, v, x) * sideOf(u, v, y) <= 0 && sideOf(x, y, u) * sideOf(x, y, v) <= 0)
            return true;
    }
    return false;
}
Real offNormals(C& c, const Part& t) {
    const V area = areaOf(t.corners);
    return std::max({between(area, c.w.normal(c.w.p)), between(area, c.w.normal(t.a)),
                     between(area, c.w.normal(t.b))});
}
bool isAgainst(C& c, const Part& t, const std::vector<Index>&) {
    return hasNoArea(t.corners) || offNormals(c, t) >= 90 - 1e-9L;
}
bool isSteep(C& c, const Part& t, const std::vector<Index>&) {
    return hasNoArea(t.corners) ||
           offNormals(c, t) >= std::acos(Real(c.w.params.thresholds.steepCosine)) / kDegree - 1e-9L;
}
bool isFolded(C& c, const Part& t, const std::vector<Index>& fan) {
    const auto over = [&](Index u, Index v) {
        const Index old = c.w.triangleWith(u, v);
        return old != kNone &&
               between(areaOf(t.corners), areaOf(c.w.corners(c.w.state.triangles[old]))) >
                   std::acos(Real(c.w.params.thresholds.foldCosine)) / kDegree - 1e-9L;
    };
    return over(t.b, t.a) || (t.at == 0 && over(t.a, c.w.p)) ||
           (t.at + 2 == fan.size() && over(c.w.p, t.b));
}
bool isOverRim(C& c, const Part& t, const std::vector<Index>& fan) {
    const Witness& w = c.w;
    const auto list = w.points.neighbors[w.p];
    const Real spacing = glm::length(w.offset(list[std::min<std::size_t>(5, list.size() - 1)]));
    const bool wide = angleOfSpoke(c, fan, t.at + 1) - angleOfSpoke(c, fan, t.at) > 120 - 1e-4L ||
                      circumradius(t.corners) > spacing * (1 - 1e-9L);
    if (wide && w.endsAt(w.p) && w.endsAt(t.a) && w.endsAt(t.b)) return true;
    const std::array<Index, 3> corner{w.p, t.a, t.b};
    for (std::size_t k = 0; k < 3; ++k) {
        const Index u = corner[k];
        const Index v = corner[(k + 1) % 3];
        const auto walls =
            static_cast<std::uint8_t>(w.points.type[u] & w.points.type[v] & kFaceBits);
        // The inside of the triangle is to the left of u -> v.
        const V inward = glm::cross(w.normal(u) + w.normal(v), w.place(v) - w.place(u));
        if (walls != 0 && leadsOut(walls, inward)) return true;
    }
    return false;
}
Triangle triangleOf(const C& c, const Part& t) { return {c.w.p, t.a, t.b}; }
template <typename Test>
bool anyTriangle(C& c, const Test& test) {
    const auto& all = c.w.meshWas.empty() ? c.w.state.triangles : c.w.meshWas;
    return std::any_of(all.begin(), all.end(), test);
}
bool meetsOne(C& c, const Part& t, const std::vector<Index>&) {
    return anyTriangle(
        c, [&](const Triangle& old) { return trianglesMeet(t.corners, c.w.corners(old)); });
}
bool coversOne(C& c, const Part& t, const std::vector<Index>&) {
    const V out = c.w.outward(triangleOf(c, t));
    return anyTriangle(c, [&](const Triangle& old) {
        return covers(t.corners, out, c.w.corners(old), c.w.outward(old));
    });
}
bool isWide(C& c, const Part& t, const std::vector<Index>& fan) {
    return angleOfSpoke(c, fan, t.at + 1) - angleOfSpoke(c, fan, t.at) > 180 - kSlackDegrees;
}

struct FanFault {
    std::string_view words;
    Verdict verdict;
    Objects holds;
};
constexpr std::array<FanFault, 11> kFanFaults{{
    {"gap over 180", Verdict::WideGap, isWide},
    {"edge taken", Verdict::EdgeTaken, isTaken},
    {"edge elsewhere on a ring", Verdict::EntryMissed, isElsewhere},
    {"pillow", Verdict::Pillow, isPillow},
    {"crosses a ring edge", Verdict::Crosses, crossesRing},
    {"against a normal", Verdict::AgainstNormal, isAgainst},
    {"folds over", Verdict::FoldsOver, isFolded},
    {"over the rim", Verdict::OverRim, isOverRim},
    {"steep, waits", Verdict::Steep, isSteep},
    {"meets a triangle", Verdict::Meets, meetsOne},
    {"second layer", Verdict::Covers, coversOne},
}};

/// A triangle or spoke of the fan, and the rule that objects to it.
void guard(C& c, std::size_t points, bool drops) {
    const std::vector<Index> fan = c.w.spokes();
    Part part{c.point(0), points == 2 ? c.point(1) : kNone, 0, {}};
    const auto isPart = [&](std::size_t i) {
        const bool isSide = i + 1 < fan.size() && fan[i + 1] == part.b;
        return fan[i] == part.a && (part.b == kNone || isSide);
    };
    while (part.at < fan.size() && !isPart(part.at)) ++part.at;
    c.need(part.at < fan.size(), "in the fan");
    if (part.b != kNone) part.corners = {c.w.place(c.w.p), c.w.place(part.a), c.w.place(part.b)};
    const auto rule = std::find_if(kFanFaults.begin(), kFanFaults.end(),
                                   [&](const FanFault& f) { return f.words == c.word(points); });
    c.need(rule != kFanFaults.end(), "a rule");
    if (rule == kFanFaults.end() || !c.wrong.empty()) return;
    c.verdict = rule->verdict;
    c.need(rule->holds(c, part, fan), rule->words);
    if (!drops) return;
    const Index dropped = c.point(points + 1);
    c.need(dropped == part.a || dropped == part.b, "dropped one of them");
    c.need(std::count(c.w.candidates.begin(), c.w.candidates.end(), dropped) == 1, "candidate");
}

// ---- fill -------------------------------------------------------------------------------------

struct EarOf {
    Index entry, p, first, last;  ///< The entry, and points.
};
EarOf earOf(const C& c, Index e) {
    const EdgeRings& rings = c.w.state.rings;
    return {e, rings.point(e), rings.point(rings.prev(e)), rings.point(rings.next(e))};
}
Corners cornersOf(const C& c, const EarOf& ear) {
    return {c.w.place(ear.p), c.w.place(ear.first), c.w.place(ear.last)};
}
/// True if a rule on fans objects to the ear; `refuses`: one of those that no ear may break.
bool breaksRule(const C& c, const EarOf& ear, bool refuses) {
    Witness there = c.w;
    there.p = ear.p;
    there.first = ear.first;
    there.last = ear.last;
    C at(there, {});
    const std::vector<Index> fan{ear.first, ear.last};
    const Part part{ear.first, ear.last, 0, cornersOf(c, ear)};
    if (isTakenSpoke(at, {ear.first, kNone, 0, {}}, fan) ||
        isTakenSpoke(at, {ear.last, kNone, 1, {}}, fan))
        return refuses;
    return std::any_of(kFanFaults.begin(), kFanFaults.end(), [&](const FanFault& rule) {
        const bool mayNot = rule.verdict == Verdict::EdgeTaken ||
                            rule.verdict == Verdict::EntryMissed || rule.verdict == Verdict::Pillow;
        return mayNot == refuses && rule.verdict != Verdict::WideGap &&
               rule.verdict != Verdict::Steep && rule.holds(at, part, fan);
    });
}
bool isRefusedEar(const C& c, const EarOf& ear) { return breaksRule(c, ear, true); }
bool isFaultyEar(const C& c, const EarOf& ear) {
    const Real angle = angleAt(c.w.place(ear.p), c.w.normal(ear.p), c.w.place(ear.first),
                               c.w.place(ear.last), c.w.params.robust.tangent);
    return angle > 180 - kSlackDegrees || isRefusedEar(c, ear) || breaksRule(c, ear, false);
}
template <typename Visit>
void forOtherEars(const C& c, const Visit& visit) {
    const EdgeRings& rings = c.w.state.rings;
    for (const Index e : rings.entriesOf(rings.active())) {
        if (e != c.w.state.pivot.pivot && !rings.open(e) && !rings.open(rings.prev(e)))
            visit(earOf(c, e));
    }
}
void isOnHole(C& c, const EarOf& ear) {
    c.need(c.count(0) == c.w.state.rings.length(c.w.state.rings.active()), "length");
    c.need(c.point(1) == ear.p && c.point(2) == ear.first && c.point(3) == ear.last, "ear");
    c.degrees(4, leastAngle(cornersOf(c, ear)), "least angle");
}
void bestAngle(C& c) {
    const EarOf mine = earOf(c, c.w.state.pivot.pivot);
    isOnHole(c, mine);
    forOtherEars(c, [&](const EarOf& other) {
        c.need(leastAngle(cornersOf(c, other)) <= leastAngle(cornersOf(c, mine)) + 1e-6L ||
                   isFaultyEar(c, other),
               "best least angle");
    });
}
void fewestFaults(C& c) {
    const auto faults = [&](const EarOf& ear) {
        const Triangle made{ear.p, ear.first, ear.last};
        int count = c.w.shapeFault(made);
        for (const Triangle& old : c.w.state.triangles) {
            const auto isNear = [&](Index x) {
                return c.w.lists(made.a, x) || c.w.lists(made.b, x) || c.w.lists(made.c, x);
            };
            const bool near = isNear(old.a) || isNear(old.b) || isNear(old.c);
            count += near && c.w.inConflict(made, old) ? 1 : 0;
        }
        return count;
    };
    const EarOf mine = earOf(c, c.w.state.pivot.pivot);
    isOnHole(c, mine);
    c.need(isFaultyEar(c, mine), "none without a fault");
    forOtherEars(c, [&](const EarOf& other) {
        c.need(isFaultyEar(c, other), "none without a fault");
        c.need(isRefusedEar(c, other) || faults(other) >= faults(mine), "fewest faults");
    });
}

constexpr Stage kSort = Stage::Sort;
constexpr Stage kLimits = Stage::Limits;
constexpr Stage kInsert = Stage::Insert;

// clang-format off
constexpr auto kPivotForms = std::to_array<SentenceForm>({
    {Stage::Seed, kNoVerdict, "A new edge ring of two: point {} and its nearest UNUSED neighbor {}, {} away.", seed},
    {Stage::Strand, kNoVerdict, "Point {} has no neighbors: isolated, marked DONE.",
     [](C& c) { c.need(c.w.points.neighbors[c.point(0)].empty(), "no neighbors"); }},
    {Stage::Strand, kNoVerdict, "Point {} has UNUSED neighbors, but no seed is left to try: stranded, marked DONE.", unseeded},
    {Stage::Strand, kNoVerdict, "Point {} has only DONE neighbors: stranded, marked DONE.", onlyDone},
    {Stage::Pivot, kNoVerdict, "Pivot {} between first = {} and last = {}; free sector {} deg, ring of {}.", pivot},
    {Stage::Skip, kNoVerdict, "Point {} lies on a rim of the surface: passed over, it stays on the ring.",
     [](C& c) { isOver(c, 0); c.need(isRimPoint(c.w.points.type[c.point(0)]), "rim point"); }},
    {Stage::Skip, kNoVerdict, "Point {} lies on wall {}: passed over, it stays on the ring.",
     [](C& c) { isOver(c, 0); c.need(namesWalls(c.word(1), c.w.points.type[c.point(0)]), "wall"); }},
    {kInsert, Verdict::NoThirdPoint, "On the ring of two boundary points {} and {} no UNUSED neighbor on the same wall fits.",
     [](C& c) { onRingOfTwo(c); noWallPoint(c, false); }},
    {kInsert, Verdict::NoThirdPoint, "At the corner between {} and {} no UNUSED neighbor on the same wall fits.",
     [](C& c) { atCorner(c); noWallPoint(c, true); }},
    {kInsert, Verdict::NoThirdPoint, "On the ring of two boundary points {} and {} no next point of the rim is UNUSED.",
     [](C& c) { onRingOfTwo(c); rimPoints(c); }},
    {kInsert, Verdict::NoThirdPoint, "Beside the gap of rim point {} no next point of the rim is UNUSED.",
     rimPoints},
    {kInsert, Verdict::OtherSideOpen, "At the corner between {} and {} a third point would end the pivot with its other side open.",
     [](C& c) {
         atCorner(c);
         const Index other = c.point(1) == c.w.last ? c.w.first : c.w.last;
         c.need(!shareFace(c.w.points.type[c.w.p], c.w.points.type[other]), "other side open");
     }},
    {kInsert, kNoVerdict, "On the ring of two boundary points {} and {}, point {} joins the ring {} the pivot; cross product = ({}, {}, {}) on wall {}, but on the other side the sector would leave the box.",
     [](C& c) { insertAtWall(c, false); }},
    {kInsert, kNoVerdict, "On the ring of two boundary points {} and {}, point {} joins the ring {} the pivot; cross product = ({}, {}, {}) on wall {}.",
     [](C& c) { insertAtWall(c, true); }},
    {kInsert, kNoVerdict, "On the ring of two boundary points {} and {}, point {}, the next on the rim, joins the ring {} the pivot.",
     [](C& c) { onRingOfTwo(c); joins(c, 2, 3); onRim(c, 2); }},
    {kInsert, kNoVerdict, "Beside the gap of rim point {}, point {}, the next on the rim, joins the ring {} the pivot.",
     [](C& c) { joins(c, 1, 2); onRim(c, 1); }},
    {kInsert, kNoVerdict, "At the corner between {} and {}, point {} joins the ring {} the pivot.",
     [](C& c) {
         atCorner(c);
         joins(c, 2, 3);
         c.need(shareFace(c.w.points.type[c.w.p], c.w.points.type[c.point(2)]), "same wall");
     }},
    {kSort, Verdict::AlreadyDone, "Point {} is DONE: no candidate.",
     [](C& c) { c.need(c.w.state.status[c.point(0)] == kDone, "DONE"); }},
    {kSort, Verdict::OnRingEnd, "Point {} is first or last itself: no candidate.",
     [](C& c) { c.need(c.point(0) == c.w.first || c.point(0) == c.w.last, "first or last"); }},
    {kSort, Verdict::NotAfterStart, "Point {} at {} deg is not after the start: left out.",
     [](C& c) { c.need(sorted(c) <= kSlackDegrees, "not after the start"); }},
    {kSort, Verdict::NotBeforeEnd, "Point {} at {} deg is not before last at {} deg: left out.",
     [](C& c) {
         c.degrees(2, c.w.lastAngle(), "last");
         c.need(sorted(c) >= c.w.lastAngle() - kSlackDegrees, "not before last");
     }},
    {kSort, Verdict::SameAngle, "Point {} at {} deg has the same angle as {}, which is {}: dropped.", sameAngle},
    {kSort, Verdict::Kept, "Point {} at {} deg of {} deg: a candidate.",
     [](C& c) {
         c.degrees(2, c.w.lastAngle(), "last");
         const Real own = sorted(c);
         c.need(own > 0 && own < c.w.lastAngle(), "in the sector");
     }},
    {kLimits, Verdict::Moved, "Point {} beyond {} = {} is listed, inside the limits, and the ring is concave there (turn {}): {} moves from {} deg to {} deg.", moves},
    {kLimits, Verdict::OtherLimit, "Point {} beyond {} = {} is the other end: {} stays.", isOtherEnd},
    {kLimits, Verdict::NotAnEdge, "Point {} beyond {} = {} is not joined to it by an edge: {} stays.", isNoEdge},
    {kLimits, Verdict::NotListed, "Point {} beyond {} = {} is not among the pivot's neighbors: {} stays.", isNotListed},
    {kLimits, Verdict::Outside, "Point {} beyond {} = {} at {} deg is outside the limits: {} stays.", isOutside},
    {kLimits, Verdict::HalfTurn, "Point {} beyond {} = {} at {} deg: the triangle would span 180 degrees or more and be inverted: {} stays.", isHalfTurn},
    {kLimits, Verdict::Blocked, "Point {} beyond {} = {}: neighbor {} lies in the triangle's sphere: {} stays.", isBlocked},
    {kLimits, Verdict::NotConcave, "Point {} beyond {} = {}: the ring is convex there (turn {}): {} stays.", isConvex},
    {kLimits, kNoVerdict, "Candidate {} at {} deg is now {}.", nowLimit},
    {kLimits, Verdict::Outside, "Candidate {} at {} deg is outside the moved {}: removed.", outsideMoved},
    {Stage::Convex, Verdict::BeyondConvex, "Candidate {} is next on the ring beyond {}, and the ring is convex there: removed.", afterConvex},
    {Stage::Convex, Verdict::BeyondHalfTurn, "Candidate {} is next on the ring beyond {}, and the triangle would span 180 degrees or more: removed.", afterHalfTurn},
    {Stage::Convex, Verdict::BeyondBlocked, "Candidate {} is next on the ring beyond {}, and a neighbor lies in the triangle's sphere: removed.", afterBlocked},
    {Stage::Convex, Verdict::BeyondOther, "Candidate {} is next on the ring beyond {}, and it did not move there: removed.", afterOther},
    {Stage::Reciprocal, Verdict::Kept, "Seen from ring point {} (between {} and {}) the pivot is at {} deg, {} sector{} deg: inside, kept.", seenFrom},
    {Stage::Reciprocal, Verdict::WallComplete, "Seen from ring point {} (between {} and {}) the pivot is at {} deg, {} sector{} deg; it is complete along its walls: refused.", seenFrom},
    {Stage::Reciprocal, Verdict::NotReciprocal, "Seen from ring point {} (between {} and {}) the pivot is at {} deg, {} sector{} deg: outside, refused.", seenFrom},
    {Stage::Hole, Verdict::Kept, "Hole of {}: point {} is {} from the plane through start and end, the pivot {}: same side, kept.", hole},
    {Stage::Hole, Verdict::FarSide, "Hole of {}: point {} is {} from the plane through start and end, the pivot {}: not the same side, removed.", hole},
    {Stage::Sphere, Verdict::NoCircle, "Point {} is kept: there is no circle of the pivot, {} and {}, they lie in line.", noCircle},
    {Stage::Sphere, Verdict::InsideSphere, "Point {} lies on the sphere of the pivot, {} and {} (r = {}): kept.",
     [](C& c) { onSphere(c, 1); }},
    {Stage::Sphere, Verdict::GapTooWide, "Point {} lies on the sphere of the pivot, {} and {} (r = {}), and removing it leaves a gap of {} deg, more than the limit: kept.",
     [](C& c) { onSphere(c, 1); gapFrom(c, 4, 1, true); }},
    {Stage::Sphere, Verdict::Removed, "Point {} lies on the sphere of the pivot, {} and {} (r = {}), and removing it leaves a gap of {} deg: removed.",
     [](C& c) { onSphere(c, 1); gapFrom(c, 4, 1, false); }},
    {Stage::Sphere, Verdict::InsideSphere, "Point {} lies {} {} the sphere of the pivot, {} and {} (d = {}, r = {}): kept.",
     [](C& c) { onSphere(c, 3); }},
    {Stage::Sphere, Verdict::GapTooWide, "Point {} lies {} {} the sphere of the pivot, {} and {} (d = {}, r = {}), and removing it leaves a gap of {} deg, more than the limit: kept.",
     [](C& c) { onSphere(c, 3); gapFrom(c, 7, 3, true); }},
    {Stage::Sphere, Verdict::Removed, "Point {} lies {} {} the sphere of the pivot, {} and {} (d = {}, r = {}), and removing it leaves a gap of {} deg: removed.",
     [](C& c) { onSphere(c, 3); gapFrom(c, 7, 3, false); }},
    {Stage::TwoPoint, Verdict::Discarded, "Only first and last are left, and they are one point: the ring is discarded.",
     [](C& c) { twoPoint(c); c.need(c.w.first == c.w.last, "one point"); }},
    {Stage::TwoPoint, Verdict::Discarded, "Only first and last are left, {} deg apart: over 180, the ring is discarded.",
     [](C& c) { c.need(apart(c) > 180, "over 180"); }},
    {Stage::TwoPoint, Verdict::Hole, "Only first and last are left, {} deg apart: under 180, one triangle closes the gap.",
     [](C& c) { c.need(apart(c) < 179.99L, "under 180"); }},
    {Stage::TwoPoint, Verdict::Hole, "Only first and last are left, {} deg apart: not over 180, one triangle closes the gap.",
     [](C& c) { c.need(apart(c) <= 180 + kSlackDegrees, "not over 180"); }},
    {Stage::Guard, kNoVerdict, "Triangle over {} and {}: {}: candidate {} is dropped.", [](C& c) { guard(c, 2, true); }},
    {Stage::Guard, kNoVerdict, "Triangle over {} and {}: {}: the fan is refused.", [](C& c) { guard(c, 2, false); }},
    {Stage::Guard, kNoVerdict, "Spoke to {}: {}: candidate {} is dropped.", [](C& c) { guard(c, 1, true); }},
    {Stage::Guard, kNoVerdict, "Spoke to {}: {}: the fan is refused.", [](C& c) { guard(c, 1, false); }},
    {Stage::Fill, kNoVerdict, "Hole of {}: the ear at {} between {} and {} has the best least angle of those without a fault, {} deg.", bestAngle},
    {Stage::Fill, kNoVerdict, "Hole of {}: the ear at {} between {} and {} has the fewest faults, and a least angle of {} deg; none without one is left.", fewestFaults},
});
// clang-format on

}  // namespace

std::span<const SentenceForm> pivotForms() { return kPivotForms; }

}  // namespace se::test::sentences
