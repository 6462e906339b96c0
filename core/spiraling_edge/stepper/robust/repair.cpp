/// Beyond the paper: the steps after the last pivot (repair.h), each with a number like a pivot.
/// Each kind runs until it finds nothing more, in the order of kOrder, kRepairRounds times. Their
/// half-edges: twins are found in a table of directed edges, sides of edges with more than two
/// triangles get none, and points with more than one fan are marked. O(t) for t triangles, on all
/// cores.
#include "spiraling_edge/stepper/repair.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"
#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

/// Calls work(list) for each list that has a journal.
template <typename Repair, typename Work>
void forEachList(Repair& m, const Work& work) {
    work(m.triangles);
    work(m.twin);
    work(m.sideOf);
    work(m.pinched);
    work(m.queue);
    work(m.conflictFlips);
    work(m.sound);
    work(m.pinchedSides);
}

/// Fewest points that are worth a thread of their own.
constexpr std::size_t kPointsPerThread = 1 << 15;

/// The side u -> v, if there is exactly one; else kNone.
HalfEdge onlySide(const EdgeTable& table, Index u, Index v) {
    HalfEdge only = kNone;
    for (HalfEdge h = table.firstFrom(u); h != kNone; h = table.nextFrom(h)) {
        if (table.target(h) != v) continue;
        if (only != kNone) return kNone;
        only = h;
    }
    return only;
}

/// RepairState::twin.
std::vector<HalfEdge> findTwins(const std::vector<Triangle>& triangles, const EdgeTable& table) {
    std::vector<HalfEdge> twin(3 * triangles.size(), kNone);
    // Sides with two opposite ones, or with one in the same triangle: they get no twin.
    std::vector<HalfEdge> shared;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto& [a, b, c] = triangles[i];
        const std::array corner{a, b, c, a};
        for (std::size_t k = 0; k < 3; ++k) {
            const Index u = corner[k];
            const Index v = corner[k + 1];
            if (u >= v) continue;  // Found from the other side.
            const HalfEdge other = onlySide(table, v, u);
            if (other == kNone) continue;
            if (other / 3 == i || twin[other] != kNone) {
                shared.push_back(other);
            } else {
                twin[other] = static_cast<HalfEdge>(3 * i + k);
                twin[twin[other]] = other;
            }
        }
    }
    for (const HalfEdge side : shared) {
        const HalfEdge other = std::exchange(twin[side], kNone);
        if (other != kNone) twin[other] = kNone;
    }
    return twin;
}

/// RepairState::sideOf.
std::vector<HalfEdge> newestSides(const EdgeTable& table, std::size_t pointCount) {
    std::vector<HalfEdge> newest(pointCount);
    for (Index p = 0; p < pointCount; ++p) newest[p] = table.firstFrom(p);
    return newest;
}

/// RepairState::pinched. Requires twins.
std::vector<std::uint8_t> findPinched(const RepairState& m, const EdgeTable& table) {
    std::vector<std::uint8_t> pinched(m.sideOf.size());
    forEachItem(pinched.size(), 0, kPointsPerThread, [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        Index sides = 0;
        for (HalfEdge h = table.firstFrom(p); h != kNone; h = table.nextFrom(h)) ++sides;
        pinched[p] = reachedSides(m, p) != sides ? 1 : 0;
    });
    return pinched;
}

struct RepairPhase {
    Phase phase;
    bool (*isOn)(const RobustRules& rules, std::uint32_t round);
};
constexpr RepairPhase kOrder[] = {
    // Only in the last round but one: until then, filling the holes that meet at a point may leave
    // it a single fan.
    {Phase::DropFans,
     [](const RobustRules& rules, std::uint32_t round) {
         return rules.dropPatches && round == kSettlingRound;
     }},
    // Fans that are dropped may leave a patch.
    {Phase::DropPatch, [](const RobustRules& rules, std::uint32_t) { return rules.dropPatches; }},
    {Phase::Reinsert, [](const RobustRules& rules, std::uint32_t) { return rules.reinsert; }},
    {Phase::CloseHole, [](const RobustRules& rules, std::uint32_t) { return rules.closeHoles; }},
    {Phase::Flip, [](const RobustRules& rules, std::uint32_t) { return rules.flip; }},
    // Not in the second round: the third one repairs what that would.
    {Phase::Remesh,
     [](const RobustRules& rules, std::uint32_t round) { return rules.remesh && round != 1; }},
};

/// Goes to the first phase at or after position `from` of the order whose rule is on.
bool enterFrom(StepContext& context, std::size_t from) {
    RepairState& m = context.state.repair;
    for (std::size_t i = from; i < std::size(kOrder); ++i) {
        const bool late = m.round + 1 == kRepairRounds && kOrder[i].phase != Phase::Reinsert;
        if (late || !kOrder[i].isOn(context.params.robust, m.round)) continue;
        context.state.phase = kOrder[i].phase;
        m.next = 0;
        return true;
    }
    return false;
}

/// Goes to the phase after the current one, which has nothing left to do.
void enterNext(AnyContext auto& context) {
    State& s = context.state;
    std::size_t place = 0;
    while (kOrder[place].phase != s.phase) ++place;
    if (enterFrom(context, place + 1)) return;
    while (++s.repair.round < kRepairRounds) {
        if (enterFrom(context, 0)) return;
    }
    // No step searches any more, and the tree is as large as the mesh.
    s.repair.near = {};
    finishRun(context);
}

/// Counts and logs a step like a pivot; without one, goes to the next phase.
template <typename Found>
void finishStep(AnyContext auto& context, Stage stage, const std::optional<Found>& step) {
    if (!step) return enterNext(context);
    ++context.state.counters.pivots;
    note(context, stage, [&] { return *step; });
}

}  // namespace

void RepairState::setTriangle(Index t, const Triangle& corners) {
    if (t == triangles.size()) {
        triangles.push_back(corners);
    } else {
        triangles.set(t, corners);
    }
    if (t < sound.size() && sound[t] != 0) sound.set(t, 0);
    if (near.tree != nullptr) near.changed.push_back(t);
    if (t < facing.at.size()) facing.at[t] = {};
}

void RepairState::popTriangle() {
    triangles.pop_back();
    if (near.tree != nullptr) near.changed.push_back(static_cast<Index>(triangles.size()));
}

void RepairState::beginJournal() {
    forEachList(*this, [](auto& list) { list.beginJournal(); });
}

RepairPlace RepairState::place() const {
    RepairPlace here{*this};
    auto changes = here.changes.begin();
    forEachList(*this,
                [&](const auto& list) { *changes++ = static_cast<std::uint32_t>(list.changes()); });
    return here;
}

void RepairState::moveTo(const RepairPlace& place) {
    static_cast<RepairNumbers&>(*this) = place.numbers;
    facing = {};
    failedCorners = {};
    auto changes = place.changes.begin();
    triangles.moveTo(*changes, [&](std::size_t t) {
        if (near.tree != nullptr) near.changed.push_back(static_cast<Index>(t));
    });
    forEachList(*this, [&](auto& list) { list.moveTo(*changes++); });
}

RepairState beginRepair(std::size_t pointCount, const std::vector<Triangle>& triangles) {
    EdgeTable table(pointCount);
    for (const Triangle& t : triangles) table.add(t);
    return beginRepair(pointCount, triangles, table);
}

RepairState beginRepair(std::size_t pointCount, const std::vector<Triangle>& triangles,
                        const EdgeTable& table) {
    assert(3 * triangles.size() == table.size());
    RepairState m;
    m.triangles = triangles;
    m.twin = findTwins(triangles, table);
    m.sideOf = newestSides(table, pointCount);
    m.pinched = findPinched(m, table);
    std::vector<HalfEdge> queue(m.twin.size() / 2);
    std::size_t count = 0;
    for (HalfEdge h = 0; h < m.twin.size(); ++h) {
        if (m.twin[h] != kNone && h < m.twin[h]) queue[count++] = h;
    }
    queue.resize(count);
    m.queue = std::move(queue);
    return m;
}

void beginRepairPhases(AnyContext auto& context) {
    State& s = context.state;
    s.pivotTriangles = 0;
    if (s.triangles.empty() || !enterFrom(context, 0)) return finishRun(context);
    const std::size_t count = context.points.size();
    s.repair = s.edges.empty() ? beginRepair(count, s.triangles)
                               : beginRepair(count, s.triangles, s.edges);
}

void phaseReinsert(AnyContext auto& context) {
    finishStep(context, Stage::Reinsert, reinsertNext(context.points, context.state.repair));
}

void phaseDropFans(AnyContext auto& context) {
    finishStep(context, Stage::DropPatch, dropNextFans(context.state.repair));
}

void phaseDropPatch(AnyContext auto& context) {
    finishStep(context, Stage::DropPatch, dropNextPatch(context.points, context.state.repair));
}

void phaseCloseHole(AnyContext auto& context) {
    finishStep(context, Stage::CloseHole,
               closeNextHole(context.points, context.params, context.state.repair));
}

void phaseFlip(AnyContext auto& context) {
    finishStep(context, Stage::Flip,
               flipNext(context.points, context.params.thresholds, context.state.repair));
}

void phaseRemesh(AnyContext auto& context) {
    finishStep(context, Stage::Remesh, remeshNext(context.points, context.state.repair));
}

template void beginRepairPhases(UnloggedContext&);
template void beginRepairPhases(LoggedContext&);
template void phaseReinsert(UnloggedContext&);
template void phaseReinsert(LoggedContext&);
template void phaseFlip(UnloggedContext&);
template void phaseFlip(LoggedContext&);
template void phaseDropFans(UnloggedContext&);
template void phaseDropFans(LoggedContext&);
template void phaseDropPatch(UnloggedContext&);
template void phaseDropPatch(LoggedContext&);
template void phaseCloseHole(UnloggedContext&);
template void phaseCloseHole(LoggedContext&);
template void phaseRemesh(UnloggedContext&);
template void phaseRemesh(LoggedContext&);

}  // namespace se
