#include "spiraling_edge/stepper/state.h"

#include <cmath>

namespace se {

double Angle::degrees() const {
    constexpr double kDegrees = 57.295779513082320877;
    const double half = std::acos(cosine) * kDegrees;
    return key > kHalfTurnKey ? 360.0 - half : half;
}

namespace {

/// 64 bits at a time, mixed as in FNV-1a with a final avalanche; endianness does not matter.
class Hasher {
  public:
    template <typename... Numbers>
    void add(Numbers... values) {
        for (const std::uint64_t value : {static_cast<std::uint64_t>(values)...}) {
            hash_ = (hash_ ^ value) * 0x9E3779B97F4A7C15ULL;
            hash_ ^= hash_ >> 32U;
        }
    }
    std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 0xCBF29CE484222325ULL;
};

void addTriangles(Hasher& hasher, const std::vector<Triangle>& triangles) {
    hasher.add(triangles.size());
    for (const Triangle& t : triangles) hasher.add(t.a, t.b, t.c);
}

void addRing(Hasher& hasher, const EdgeRings& rings, Index from) {
    hasher.add(rings.length(rings.ringOf(from)));
    Index entry = from;
    do {
        hasher.add(rings.point(entry), rings.open(entry));
        entry = rings.next(entry);
    } while (entry != from);
}

void addCounters(Hasher& hasher, const Counters& c) {
    // Only if there is one: the hashes of other runs stay those of before this counter.
    if (c.failedSeeds > 0) hasher.add(c.failedSeeds);
    hasher.add(c.pivots, c.skipped, c.seeds, c.isolated, c.stranded, c.inserted, c.discarded,
               c.refused, c.splits, c.joins, c.closedRings, c.freedRings, c.shelved, c.holes,
               c.openings, c.filled, c.lostSeeds, c.maxRingLength, c.maxStackDepth);
}

void addPivot(Hasher& hasher, const State& s) {
    const auto place = [&](Index entry) {
        hasher.add(s.rings.alive(entry) ? s.rings.point(entry) : kNone);
    };
    place(s.pivot.pivot);
    if (s.phase == Phase::Seed || s.phase == Phase::Pivot || s.finished()) return;
    for (const Index entry : {s.pivot.first, s.pivot.last, s.pivot.start, s.pivot.end}) {
        place(entry);
    }
    hasher.add(s.pivot.candidates.size());
    for (const Candidate& c : s.pivot.candidates) hasher.add(c.point);
}

}  // namespace

std::uint64_t stateHash(const State& s) {
    Hasher hasher;
    hasher.add(s.phase, s.startPointer, s.circuit, s.retryLevel);
    addCounters(hasher, s.counters);
    addPivot(hasher, s);
    for (const PointStatus status : s.status) hasher.add(status);
    if (s.rings.active() != kNone) {
        const bool atPivot = s.rings.alive(s.pivot.pivot);
        addRing(hasher, s.rings, atPivot ? s.pivot.pivot : s.rings.head(s.rings.active()));
    }
    hasher.add(s.rings.stack().size(), s.rings.shelved(), s.seedsSpent);
    for (const Index ring : s.rings.stack()) addRing(hasher, s.rings, s.rings.head(ring));
    addTriangles(hasher, s.triangles);
    addTriangles(hasher, s.repair.triangles);
    hasher.add(s.alerts.size());
    for (const Alert& alert : s.alerts) hasher.add(alert.kind, alert.pivot, alert.point);
    return hasher.value();
}

}  // namespace se
