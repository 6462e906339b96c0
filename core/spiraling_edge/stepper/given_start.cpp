/// Given starts: the State of one, and the checks that it is one that a run could have reached.
#include "spiraling_edge/stepper/given_start.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/state.h"

namespace se {

Index addRing(State& state, std::span<const Index> points) {
    assert(points.size() >= 2);
    EdgeRings& rings = state.rings;
    if (rings.active() != kNone) rings.push(rings.active(), rings.head(rings.active()));
    const Index head = rings.start(points[0], points[1]);
    Index last = rings.next(head);
    for (const Index p : points.subspan(2)) last = rings.insertAfter(last, p);
    Index entry = head;
    for (const Index p : points) {
        ++state.status[p];
        rings.setOpen(entry, false);
        entry = rings.next(entry);
    }
    return head;
}

void addTriangles(State& state, std::span<const Triangle> triangles) {
    for (const Triangle& t : triangles) {
        state.triangles.push_back(t);
        if (!state.edges.empty()) state.edges.add(t);
    }
}

void openSteps(State& state, const RingStep& step) {
    EdgeRings& rings = state.rings;
    for (Index e = rings.firstEntryOf(step.from); e != kNone; e = rings[e].nextOfPoint) {
        const Index to = rings.point(rings.next(e));
        if (step.to == kNone || to == step.to) rings.setOpen(e, true);
    }
}

namespace {

void takeRings(const GivenStart& start, State& state) {
    for (const std::vector<Index>& ring : start.rings) {
        state.pivot.pivot = addRing(state, ring);
        state.counters.maxRingLength =
            std::max(state.counters.maxRingLength, static_cast<std::uint32_t>(ring.size()));
    }
    for (const RingStep& step : start.open) openSteps(state, step);
    if (start.rings.empty()) return;
    state.phase = Phase::Pivot;
    state.counters.seeds = 1;  // that of the given mesh
    state.counters.maxStackDepth = static_cast<std::uint32_t>(state.rings.stack().size());
}

}  // namespace

State startState(const PointSet& points, const Params& params) {
    assert(requireStart(points, params.start).ok());
    State state(points.size());
    state.triangles.reserve(2 * points.size());  // about the number of a closed surface
    state.done.reserve(points.size());
    if (params.robust.needsEdges()) state.edges = EdgeTable(points.size());
    addTriangles(state, params.start.triangles);
    takeRings(params.start, state);
    for (const Index p : params.start.done) state.finish(p);
    return state;
}

// ---- checks -------------------------------------------------------------------------------------

namespace {

/// "rings[1]", "triangles[0][2]".
std::string entryName(std::string_view list, std::size_t i) {
    return std::string(list) + "[" + std::to_string(i) + "]";
}
std::string entryName(std::string_view list, std::size_t i, std::size_t k) {
    return entryName(entryName(list, i), k);
}

std::string stepText(const RingStep& step) {
    return std::to_string(step.from) + " -> " + std::to_string(step.to);
}

/// Checks a start entry by entry; each check gives a sentence on the first violation.
class StartChecker {
  public:
    StartChecker(const PointSet& points, const GivenStart& start) : points_(points), start_(start) {
        roles_.resize(points.size());
    }

    /// The first violation; empty if there is none.
    std::string check() {
        using Check = std::string (StartChecker::*)();
        constexpr Check kChecks[] = {&StartChecker::checkPoints, &StartChecker::checkTriangles,
                                     &StartChecker::checkDone,   &StartChecker::checkOpen,
                                     &StartChecker::checkSteps,  &StartChecker::checkRoles};
        for (const Check each : kChecks) {
            std::string problem = (this->*each)();
            if (!problem.empty()) return problem;
        }
        return {};
    }

  private:
    /// The uses of a point by the start.
    struct Roles {
        bool inTriangle = false;
        bool onRing = false;
        bool done = false;
    };

    std::string checkPoint(Index p, const std::string& entry) const {
        if (p >= points_.size()) {
            return entry + ": there is no point " + std::to_string(p) + "; the points are 0 to " +
                   std::to_string(points_.size() - 1) + ".";
        }
        if (points_.isAside(p))
            return entry + ": point " + std::to_string(p) + " was set aside, no triangle has it.";
        return {};
    }

    /// All points exist; rings have two entries or more.
    std::string checkPoints() {
        for (std::size_t i = 0; i < start_.triangles.size(); ++i) {
            const Triangle& t = start_.triangles[i];
            const std::string entry = entryName("triangles", i);
            for (const Index p : {t.a, t.b, t.c}) {
                if (const std::string problem = checkPoint(p, entry); !problem.empty())
                    return problem;
                roles_[p].inTriangle = true;
            }
        }
        for (std::size_t i = 0; i < start_.rings.size(); ++i) {
            if (const std::string problem = checkRing(i); !problem.empty()) return problem;
        }
        for (std::size_t i = 0; i < start_.done.size(); ++i) {
            const std::string problem = checkPoint(start_.done[i], entryName("done", i));
            if (!problem.empty()) return problem;
        }
        return {};
    }

    std::string checkRing(std::size_t i) {
        const std::vector<Index>& ring = start_.rings[i];
        if (ring.size() < 2)
            return entryName("rings", i) + ": a ring has two points or more (invariant 2).";
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const std::string entry = entryName("rings", i, k);
            if (const std::string problem = checkPoint(ring[k], entry); !problem.empty())
                return problem;
            if (ring[k] == ring[(k + 1) % ring.size()])
                return entry + ": point " + std::to_string(ring[k]) + " follows itself.";
            roles_[ring[k]].onRing = true;
        }
        return {};
    }

    /// Invariant 5, and no corner twice.
    std::string checkTriangles() {
        for (std::size_t i = 0; i < start_.triangles.size(); ++i) {
            const Triangle& t = start_.triangles[i];
            const std::string entry = entryName("triangles", i);
            for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
                if (u == v) return entry + ": point " + std::to_string(u) + " is a corner twice.";
                const auto [other, fresh] = edges_.try_emplace({u, v}, i);
                if (fresh) continue;
                return entry + ": " + entryName("triangles", other->second) + " has the edge " +
                       stepText({u, v}) + " in the same direction (invariant 5).";
            }
        }
        return {};
    }

    /// Invariant 1: a DONE point has no entries.
    std::string checkDone() {
        for (std::size_t i = 0; i < start_.done.size(); ++i) {
            Roles& roles = roles_[start_.done[i]];
            const std::string point =
                entryName("done", i) + ": point " + std::to_string(start_.done[i]);
            if (roles.onRing) return point + " is on a ring, so it is not DONE (invariant 1).";
            if (roles.done) return point + " is named twice.";
            roles.done = true;
        }
        return {};
    }

    bool isOpen(const RingStep& step) const {
        return std::find(start_.open.begin(), start_.open.end(), step) != start_.open.end();
    }
    bool isStep(const RingStep& wanted) const {
        return std::any_of(start_.rings.begin(), start_.rings.end(), [&](const auto& ring) {
            for (std::size_t k = 0; k < ring.size(); ++k) {
                if (RingStep{ring[k], ring[(k + 1) % ring.size()]} == wanted) return true;
            }
            return false;
        });
    }
    std::string checkOpen() {
        for (std::size_t i = 0; i < start_.open.size(); ++i) {
            if (!isStep(start_.open[i])) {
                return entryName("open", i) + ": no ring has the step " + stepText(start_.open[i]) +
                       ".";
            }
        }
        return {};
    }

    /// Invariant 3, and with it that of 2 on finished edges: an entry between two of one point has
    /// triangles on both sides of its steps.
    std::string checkSteps() {
        std::map<std::pair<Index, Index>, std::size_t> seen;
        for (std::size_t i = 0; i < start_.rings.size(); ++i) {
            const std::vector<Index>& ring = start_.rings[i];
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const RingStep step{ring[k], ring[(k + 1) % ring.size()]};
                const std::string text = entryName("rings", i) + ": the step " + stepText(step);
                const auto [other, fresh] = seen.try_emplace({step.from, step.to}, i);
                if (!fresh) return text + " is on " + entryName("rings", other->second) + " too.";
                const bool edge = edges_.contains({step.from, step.to});
                if (isOpen(step) && edge) return text + " is open, but an edge of a triangle.";
                if (isOpen(step)) continue;
                if (!edge) {
                    return text +
                           " is no edge of a triangle; give the triangle on its left, or name the "
                           "step in \"open\" (invariant 3).";
                }
                if (edges_.contains({step.to, step.from}))
                    return text + " has triangles on both sides (invariant 3).";
            }
        }
        return {};
    }

    /// A point of the mesh is USED or DONE.
    std::string checkRoles() {
        for (std::size_t i = 0; i < start_.triangles.size(); ++i) {
            const Triangle& t = start_.triangles[i];
            for (const Index p : {t.a, t.b, t.c}) {
                if (roles_[p].onRing || roles_[p].done) continue;
                return entryName("triangles", i) + ": point " + std::to_string(p) +
                       " is neither on a ring nor in \"done\".";
            }
        }
        return {};
    }

    const PointSet& points_;
    const GivenStart& start_;
    std::vector<Roles> roles_;
    /// The triangle of each directed edge.
    std::map<std::pair<Index, Index>, std::size_t> edges_;
};

}  // namespace

Status requireStart(const PointSet& points, const GivenStart& start) {
    if (start.empty() && start.open.empty()) return success();
    const std::string problem = StartChecker(points, start).check();
    return problem.empty() ? success() : Status(Error{problem});
}

}  // namespace se
