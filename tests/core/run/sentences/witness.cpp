#include "core/run/sentences/witness.h"

namespace se::test::sentences {

Witness::Witness(const PointSet& given, const Params& rules, const State& now)
    : points(given), params(rules), state(now), status(now.status), statusWas(now.status) {
    keepMesh(state.triangles);
    emitted = state.triangles.size();
    seeds = state.counters.seeds;
}

void Witness::keepMesh(const std::vector<Triangle>& mesh) {
    at.assign(points.size(), {});
    for (Index t = 0; t < mesh.size(); ++t) {
        for (const Index x : {mesh[t].a, mesh[t].b, mesh[t].c}) at[x].push_back(t);
    }
}

void Witness::beforePhase() {
    const Phase phase = state.phase;
    released.clear();
    keptByInstance_.clear();
    if (isRepair(phase)) {
        meshWas = state.mesh();
        keepMesh(meshWas);
    }
    if (phase == Phase::Sphere) pool = candidates;
    if (phase != Phase::Seed && phase != Phase::Pivot && phase != Phase::Fill &&
        phase != Phase::Ring && phase != Phase::Link && phase != Phase::Advance)
        return;
    was = state.rings;
    status = statusWas = state.status;
    changes = 0;
    if (phase == Phase::Link) rings = was;
    if (phase == Phase::Advance) {
        const bool isMade = state.pivotTriangles > 0;
        idle = isMade ? 0 : idle + 1;
        circuit = was.active() == kNone ? 0 : was.length(was.active());
        if (!isMade && state.third.entry != kNone) --circuit;
    }
    stated_.clear();
    if (phase != Phase::Pivot) return;
    const Index e = state.pivot.pivot;
    p = was.point(e);
    first = was.point(was.prev(e));
    last = was.point(was.next(e));
    startMoved = endMoved = false;
    candidates.clear();
}

void Witness::afterPhase() {
    if (state.phase == Phase::Hole) {
        std::erase_if(candidates, [&](Index c) {
            return state.status[c] > 0 &&
                   std::count(keptByInstance_.begin(), keptByInstance_.end(), c) == 0;
        });
    }
    if (state.phase == Phase::Sort) {
        // A third point of §7 is in place: first and last are now those of the sector.
        start = state.rings.prev(state.pivot.pivot);
        end = state.rings.next(state.pivot.pivot);
        first = pointOf(start);
        last = pointOf(end);
        if (state.third.entry != kNone) stated_.clear();
    }
    if (state.phase == Phase::Limits) {
        std::stable_sort(candidates.begin(), candidates.end(),
                         [&](Index a, Index b) { return angle(a) < angle(b); });
    }
}

void Witness::follow(const Event& event) {
    const auto drop = [&](Index x) { std::erase(candidates, x); };
    if (const auto* seed = as<SeedEvidence>(event)) {
        status[seed->first] = status[seed->second] = 1;
        ++seeds;
        idle = 0;
    } else if (const auto* strand = as<StrandEvidence>(event)) {
        status[strand->point] = kDone;
    } else if (isA<TakeUpEvidence>(event)) {
        idle = 0;
    } else if (const auto* begun = as<PivotEvidence>(event)) {
        if (first != last) stated_[last] = angleNear(last, begun->sectorDegrees);
    } else if (const auto* sort = as<SortEvidence>(event)) {
        stated_[sort->point] = angleNear(sort->point, sort->degrees);
        if (sort->verdict == Verdict::Kept) candidates.push_back(sort->point);
        if (sort->verdict == Verdict::SameAngle) drop(sort->point);
    } else if (const auto* limit = as<LimitEvidence>(event)) {
        if (!limit->moves()) return;
        const bool atStart = limit->side == Side::Start;
        (atStart ? startMoved : endMoved) = true;
        (atStart ? start : end) = atStart ? state.rings.prev(start) : state.rings.next(end);
    } else if (const auto* gone = as<DropEvidence>(event)) {
        drop(gone->point);
    } else if (const auto* seen = as<ReciprocalEvidence>(event)) {
        if (seen->verdict == Verdict::Kept) keptByInstance_.push_back(seen->point);
    } else if (const auto* hole = as<HoleEvidence>(event)) {
        if (hole->verdict == Verdict::FarSide) drop(hole->point);
    } else if (const auto* sphere = as<SphereEvidence>(event)) {
        if (sphere->verdict == Verdict::Removed) drop(sphere->q);
    } else if (const auto* guard = as<GuardEvidence>(event)) {
        std::erase(pool, guard->dropped);
        candidates = pool;
    } else if (const auto* fill = as<FillEvidence>(event)) {
        p = fill->pivot;
        first = fill->first;
        last = fill->last;
        start = state.pivot.start;
        end = state.pivot.end;
        startMoved = endMoved = false;
        candidates.clear();
    } else if (const auto* emit = as<EmitEvidence>(event)) {
        for (const Index x : {emit->corners.a, emit->corners.b, emit->corners.c})
            at[x].push_back(emit->triangle);
        ++emitted;
    } else if (const auto* ring = as<RingEvidence>(event)) {
        status[ring->point] = ring->status;
        if (!ring->inserted) released.push_back(ring->point);
    } else if (const auto* insert = as<InsertEvidence>(event)) {
        if (insert->third != kNone) status[insert->third] = 1;
    } else if (isA<SplitEvidence>(event) || isA<JoinEvidence>(event)) {
        const auto [x, y] = linked(testedPoint(event));
        const Exchange exchange = rings.exchangeSuccessors(x, y);
        const Index part = exchange.ringOfX;
        const bool hasRole = part == rings.active() || rings.depthFromTop(part) != kNone;
        if (exchange.split) rings.push(hasRole ? exchange.ringOfY : part, hasRole ? y : x);
        ++changes;
    } else if (const auto* closed = as<CloseEvidence>(event)) {
        const Index e = closedEntry(closed->a, closed->b);
        if (closed->b != kNone) rings.erase(rings.next(e));
        rings.erase(e);
        ++changes;
    } else if (const auto* next = as<AdvanceEvidence>(event)) {
        if (next->popped || next->to == kNone || idle >= circuit) idle = 0;
    } else if (const auto* freed = as<FreeEvidence>(event)) {
        failed += freed->seed ? 1 : 0;
    }
}

std::pair<Index, Index> Witness::linked(Index point) const {
    for (std::size_t i = 0; i < state.insertedEntries.size(); ++i) {
        const Index x = state.insertedEntries[i];
        if (rings.alive(x) && rings.point(x) == point) return {x, state.instances[i]};
    }
    return {kNone, kNone};
}

Index Witness::closedEntry(Index a, Index b) const {
    Index e = rings.firstEntryOf(a);
    const auto isBetween = [&] {
        if (b == kNone) return rings.next(e) == e;
        return rings.point(rings.next(e)) == b && rings.point(rings.prev(e)) == b;
    };
    while (e != kNone && !isBetween()) e = rings[e].nextOfPoint;
    return e;
}

Real Witness::angleNear(Index x, Real stated) const {
    const V v = offset(x);
    const V ahead = glm::cross(normal(p), place(first) - place(p));
    const Real across = glm::dot(ahead, v) / (glm::length(ahead) * glm::length(v));
    const Real own = angle(x);
    const bool isMirrored = std::abs(stated - own) > std::abs(stated + own - 360);
    return isMirrored && std::abs(across) <= 1e-12L ? 360 - own : own;
}

Real Witness::angle(Index x) const {
    const auto known = stated_.find(x);
    if (known != stated_.end()) return known->second;
    return angleAt(place(p), normal(p), place(first), place(x), params.robust.tangent);
}

bool Witness::lists(Index a, Index b) const { return points.neighbors.has(a, b); }

Index Witness::triangleWith(Index u, Index v) const {
    const std::vector<Triangle>& mesh = meshWas.empty() ? state.triangles : meshWas;
    for (const Index t : at[u]) {
        const Triangle& c = mesh[t];
        if ((c.a == u && c.b == v) || (c.b == u && c.c == v) || (c.c == u && c.a == v)) return t;
    }
    return kNone;
}

std::vector<Index> Witness::spokes() const {
    std::vector<Index> all;
    const EdgeRings& now = state.rings;
    const Index pivot = state.pivot.pivot;
    for (Index e = now.prev(pivot); e != start; e = now.prev(e)) all.push_back(pointOf(e));
    all.push_back(pointOf(start));
    all.insert(all.end(), candidates.begin(), candidates.end());
    const std::size_t middle = all.size();
    for (Index e = now.next(pivot); e != end; e = now.next(e)) all.push_back(pointOf(e));
    all.push_back(pointOf(end));
    std::reverse(all.begin() + static_cast<std::ptrdiff_t>(middle), all.end());
    return all;
}

V Witness::outward(const Triangle& t) const {
    const V area = areaOf(corners(t));
    return glm::dot(area, normal(t.a) + normal(t.b) + normal(t.c)) < 0 ? -area : area;
}

int Witness::shapeFault(const Triangle& t) const {
    const V area = areaOf(corners(t));
    const auto faces = [&](const V& n) { return glm::dot(area, n) > 0; };
    if (!faces(normal(t.a) + normal(t.b) + normal(t.c))) return 4;
    return faces(normal(t.a)) && faces(normal(t.b)) && faces(normal(t.c)) ? 0 : 1;
}

bool Witness::inConflict(const Triangle& a, const Triangle& b) const {
    const Corners one = corners(a);
    const Corners other = corners(b);
    Real size = 0;
    for (const Corners& t : {one, other})
        size += glm::distance(t[0], t[1]) + glm::distance(t[0], t[2]);
    if (glm::distance(one[0], other[0]) > 2 * size) return false;
    return trianglesMeet(one, other) || covers(one, outward(a), other, outward(b));
}

bool Witness::endsAt(Index x) const {
    const auto list = points.neighbors[x];
    if (isBoundary(points.type[x]) || list.size() < 3) return true;
    std::vector<Real> angles;
    for (const Index q : list)
        angles.push_back(angleAt(place(x), normal(x), place(list[0]), place(q), true));
    std::sort(angles.begin(), angles.end());
    angles.push_back(angles.front() + 360);
    Real widest = 0;
    for (std::size_t i = 1; i < angles.size(); ++i)
        widest = std::max(widest, angles[i] - angles[i - 1]);
    return widest > (list.size() == 3 ? 180 : 120) - 1e-4L;
}

}  // namespace se::test::sentences
