/// Beyond the paper (docs/robust.md): rules that look at the whole fan before it is made. Each is
/// one function and one row of kFanRules. A rule names the spoke or triangle it objects to; a
/// candidate there is dropped and §6.3 is done again without it, else the fan is refused.
#include <algorithm>
#include <array>
#include <cmath>

#include "exact.h"
#include "phases.h"

namespace se {
namespace {

/// What a rule objects to: spoke `at` of the fan, or its triangle `at`, `at + 1`.
struct Objection {
    Verdict verdict = Verdict::Kept;
    std::size_t at = 0;
    bool triangle = false;

    explicit operator bool() const { return verdict != Verdict::Kept; }
};

using Fan = std::vector<FanPoint>;

// ---- gap ----------------------------------------------------------------------------------------

Objection wideGap(const StepContext& context) {
    const Fan& fan = context.state.pivot.fan;
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        if (fan[i + 1].angle.key - fan[i].angle.key > kHalfTurnKey) {
            return {Verdict::WideGap, i, true};
        }
    }
    return {};
}

// ---- guard --------------------------------------------------------------------------------------

/// The spokes: those inside the fan are new edges, used in both directions.
Objection takenSpoke(const StepContext& context) {
    const State& s = context.state;
    const Fan& fan = s.pivot.fan;
    const Index p = s.rings.point(s.pivot.pivot);
    const auto isNewOrStep = [&](Index u, Index v, bool open) {
        // u -> v is about to be made; v -> u may only be there as the ring step at the pivot.
        return !s.edges.has(u, v) && !(open && s.edges.has(v, u));
    };
    if (!isNewOrStep(p, fan.front().point, s.rings.open(s.pivot.first))) {
        return {Verdict::EdgeTaken, 0, false};
    }
    if (!isNewOrStep(fan.back().point, p, s.rings.open(s.pivot.pivot))) {
        return {Verdict::EdgeTaken, fan.size() - 1, false};
    }
    for (std::size_t i = 1; i + 1 < fan.size(); ++i) {
        if (fan[i].entry == kNone) continue;  // UNUSED: no edge can be there.
        if (s.edges.has(p, fan[i].point) || s.edges.has(fan[i].point, p)) {
            return {Verdict::EdgeTaken, i, false};
        }
    }
    return {};
}

/// The rim: an edge that exists the other way round must be the ring step between these entries.
Objection takenRim(const StepContext& context) {
    const State& s = context.state;
    const Fan& fan = s.pivot.fan;
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        const FanPoint& u = fan[i];
        const FanPoint& v = fan[i + 1];
        if (u.entry == kNone || v.entry == kNone) continue;
        if (s.edges.has(u.point, v.point)) return {Verdict::EdgeTaken, i, true};
        const bool isStep = s.rings.next(v.entry) == u.entry && !s.rings.open(v.entry);
        if (!isStep && s.edges.has(v.point, u.point)) return {Verdict::EntryMissed, i, true};
    }
    return {};
}

Objection takenEdge(const StepContext& context) {
    const Objection spoke = takenSpoke(context);
    return spoke ? spoke : takenRim(context);
}

// ---- nopillow -----------------------------------------------------------------------------------

Objection pillow(const StepContext& context) {
    const State& s = context.state;
    const Fan& fan = s.pivot.fan;
    const Index p = s.rings.point(s.pivot.pivot);
    if (s.pivot.fullTurn() && fan.size() == 3) return {Verdict::Pillow, 0, true};
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        if (fan[i].entry == kNone || fan[i + 1].entry == kNone) continue;
        const HalfEdge h = s.edges.find(fan[i + 1].point, fan[i].point);
        if (h != kNone && s.edges.opposite(h) == p) return {Verdict::Pillow, i, true};
    }
    return {};
}

// ---- nocross ------------------------------------------------------------------------------------

struct Flat {
    double x, y;
};

double turn(const Flat& a, const Flat& b, const Flat& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool properlyCross(const Flat& a, const Flat& b, const Flat& c, const Flat& d) {
    return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}

/// Looks for ring steps near the pivot that a new edge crosses, in the pivot's tangent plane.
class CrossingSearch {
  public:
    explicit CrossingSearch(const StepContext& context)
        : context_(context), frame_(context.state.pivot.frame) {
        y_ = glm::cross(frame_.normal, frame_.z);
        x_ = glm::cross(y_, frame_.normal);
    }

    Objection find() const {
        const State& s = context_.state;
        const Index p = s.rings.point(s.pivot.pivot);
        for (const Index x : context_.points.neighbors[p]) {
            for (Index e = s.rings.firstEntryOf(x); e != kNone; e = s.rings[e].nextOfPoint) {
                // A step between two listed points is found at its first one.
                Objection found = againstStep(e, s.rings.next(e));
                if (!found) found = againstStep(s.rings.prev(e), e);
                if (found) return found;
            }
        }
        return {};
    }

  private:
    Flat flat(const Vec3& offset) const { return {glm::dot(x_, offset), glm::dot(y_, offset)}; }

    Objection againstStep(Index from, Index to) const {
        const State& s = context_.state;
        const Fan& fan = s.pivot.fan;
        const Index u = s.rings.point(from);
        const Index v = s.rings.point(to);
        const Index p = s.rings.point(s.pivot.pivot);
        if (u == p || v == p || s.rings.open(from)) return {};
        const Vec3 du = context_.points.position[u] - frame_.origin;
        const Vec3 dv = context_.points.position[v] - frame_.origin;
        const Flat fu = flat(du);
        const Flat fv = flat(dv);
        for (std::size_t i = 0; i < fan.size(); ++i) {
            if (fan[i].point == u || fan[i].point == v) continue;
            const Flat a = flat(fan[i].offset);
            if (fan[i].candidate && properlyCross({0.0, 0.0}, a, fu, fv)) {
                return {Verdict::Crosses, i, false};
            }
            if (i + 1 == fan.size() || fan[i + 1].point == u || fan[i + 1].point == v) continue;
            if (!fan[i].candidate && !fan[i + 1].candidate) continue;
            if (properlyCross(a, flat(fan[i + 1].offset), fu, fv)) {
                return {Verdict::Crosses, i, true};
            }
        }
        return {};
    }

    const StepContext& context_;
    const Frame& frame_;
    Vec3 x_, y_;
};

Objection crossing(const StepContext& context) { return CrossingSearch(context).find(); }

// ---- nofold -------------------------------------------------------------------------------------

/// Cosine of the largest angle between the normals of two triangles at an edge: 150 degrees.
constexpr double kSharpestFold = -0.8660254037844386;

/// Is the old triangle across u -> v folded onto one with the area vector `area`?
bool foldsOver(const StepContext& context, Index u, Index v, const Vec3& area) {
    const State& s = context.state;
    const HalfEdge h = s.edges.find(u, v);
    if (h == kNone) return false;
    const std::vector<Vec3>& position = context.points.position;
    const Vec3 old =
        glm::cross(position[v] - position[u], position[s.edges.opposite(h)] - position[u]);
    const double size = std::sqrt(glm::dot(old, old) * glm::dot(area, area));
    return glm::dot(old, area) < kSharpestFold * size;
}

/// Is a triangle of the pivot, a and b against the normal of a corner, or, once that is allowed, of
/// all three together?
bool isAgainstNormals(const StepContext& context, const Vec3& area, Index a, Index b) {
    const double atPivot = glm::dot(area, context.state.pivot.frame.normal);
    const double atA = glm::dot(area, context.points.normal[a]);
    const double atB = glm::dot(area, context.points.normal[b]);
    const bool faces = context.state.patience >= kCornerAllowed
                           ? atPivot + atA + atB > 0.0
                           : atPivot > 0.0 && atA > 0.0 && atB > 0.0;
    return !faces;
}

Objection fold(const StepContext& context) {
    const State& s = context.state;
    const Fan& fan = s.pivot.fan;
    const Index p = s.rings.point(s.pivot.pivot);
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        const Vec3 area = glm::cross(fan[i].offset, fan[i + 1].offset);
        if (isAgainstNormals(context, area, fan[i].point, fan[i + 1].point)) {
            return {Verdict::AgainstNormal, i, true};
        }
        if (foldsOver(context, fan[i + 1].point, fan[i].point, area) ||
            (i == 0 && foldsOver(context, fan[i].point, p, area)) ||
            (i + 2 == fan.size() && foldsOver(context, p, fan[i + 1].point, area))) {
            return {Verdict::FoldsOver, i, true};
        }
    }
    return {};
}

// ---- nomeet -------------------------------------------------------------------------------------

/// Neighborhoods whose normals all lie within 45 degrees of the pivot's are flat enough for
/// Rules::noCross to see every overlap.
constexpr double kFlat = 0.70710678118654752;

bool isFlat(const PointSet& points, Index p) {
    const auto list = points.neighbors[p];
    return std::all_of(list.begin(), list.end(), [&](Index x) {
        return glm::dot(points.normal[x], points.normal[p]) > kFlat;
    });
}

struct Box {
    Vec3 low, high;

    explicit Box(const Vec3& p) : low(p), high(p) {}
    void add(const Vec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    bool meets(const Box& o) const {
        return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y &&
               low.z <= o.high.z && o.low.z <= high.z;
    }
};

Box boxOf(const PointSet& points, const Triangle& t) {
    Box box(points.position[t.a]);
    box.add(points.position[t.b]);
    box.add(points.position[t.c]);
    return box;
}

Objection meetsFinished(const StepContext& context) {
    const State& s = context.state;
    const Fan& fan = s.pivot.fan;
    const PointSet& points = context.points;
    const Index p = s.rings.point(s.pivot.pivot);
    if (isFlat(points, p)) return {};
    Box all(points.position[p]);
    for (const FanPoint& x : fan) all.add(points.position[x.point]);
    for (const Index x : points.neighbors[p]) {
        for (HalfEdge h = s.edges.firstFrom(x); h != kNone; h = s.edges.nextFrom(h)) {
            const Triangle& old = s.triangles[h / 3];
            const Box oldBox = boxOf(points, old);
            if (!oldBox.meets(all)) continue;
            for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
                const Triangle made{p, fan[i].point, fan[i + 1].point};
                if (boxOf(points, made).meets(oldBox) &&
                    trianglesShareMore(points.position, made, old)) {
                    return {Verdict::Meets, i, true};
                }
            }
        }
    }
    return {};
}

// ---- rim ----------------------------------------------------------------------------------------

Objection overRim(const StepContext& context) {
    const Fan& fan = context.state.pivot.fan;
    constexpr double kWide = -0.5;  // 120 degrees.
    const Index p = context.state.rings.point(context.state.pivot.pivot);
    const auto endsHere = [&](Index x) {
        return !isBoundary(context.points.type[x]) && isRim(context.points, x);
    };
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        if (exceedsAngle(fan[i].angle, fan[i + 1].angle, kWide) && endsHere(p) &&
            endsHere(fan[i].point) && endsHere(fan[i + 1].point)) {
            return {Verdict::OverRim, i, true};
        }
    }
    return {};
}

// ---- delay --------------------------------------------------------------------------------------

/// Cosine of the angle between a triangle's normal and a corner's, beyond which it waits.
constexpr double kSteep = 0.5;

Objection steep(const StepContext& context) {
    const Fan& fan = context.state.pivot.fan;
    if (context.state.patience >= kDelayedAllowed) return {};
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        const Vec3 area = glm::cross(fan[i].offset, fan[i + 1].offset);
        const double limit = kSteep * std::sqrt(glm::dot(area, area));
        if (glm::dot(area, context.points.normal[fan[i].point]) < limit ||
            glm::dot(area, context.points.normal[fan[i + 1].point]) < limit ||
            glm::dot(area, context.state.pivot.frame.normal) < limit) {
            return {Verdict::Steep, i, true};
        }
    }
    return {};
}

// ---- the table ----------------------------------------------------------------------------------

/// What follows an objection.
enum class Remedy : std::uint8_t {
    Drop,    ///< The candidate at fault goes; without one the fan is refused.
    Refuse,  ///< The fan is refused.
};

struct FanRule {
    bool Rules::*on;
    Objection (*find)(const StepContext&);
    Remedy remedy;
};

constexpr std::array kManifoldRules{
    FanRule{&Rules::guard, takenEdge, Remedy::Drop},
    FanRule{&Rules::noPillow, pillow, Remedy::Drop},
};
constexpr std::array kShapeRules{
    FanRule{&Rules::noCross, crossing, Remedy::Drop},
    FanRule{&Rules::noFold, fold, Remedy::Drop},
    FanRule{&Rules::noMeet, meetsFinished, Remedy::Drop},
};
constexpr std::array kWaitingRules{
    FanRule{&Rules::gap, wideGap, Remedy::Refuse},
    FanRule{&Rules::rim, overRim, Remedy::Refuse},
    FanRule{&Rules::delay, steep, Remedy::Refuse},
};

template <std::size_t N>
const FanRule* firstObjecting(const StepContext& context, const std::array<FanRule, N>& rules,
                              Objection& objection) {
    for (const FanRule& rule : rules) {
        if (!(context.params.rules.*rule.on)) continue;
        objection = rule.find(context);
        if (objection) return &rule;
    }
    return nullptr;
}

/// The candidate to drop for an objection: the farther one of a triangle. kNone if there is none.
std::size_t culprit(const Fan& fan, const Objection& objection) {
    const std::size_t i = objection.at;
    if (!objection.triangle) return fan[i].candidate ? i : kNone;
    if (fan[i].candidate && fan[i + 1].candidate) {
        return fan[i].lengthSq > fan[i + 1].lengthSq ? i : i + 1;
    }
    if (fan[i].candidate) return i;
    return fan[i + 1].candidate ? i + 1 : kNone;
}

void refuse(StepContext& context) {
    ++context.state.counters.refused;
    context.state.phase = Phase::Advance;
}

void tryWithout(StepContext& context, Index point) {
    NeighborRing& n = context.state.pivot;
    const auto found = std::find_if(n.pool.begin(), n.pool.end(),
                                    [&](const Candidate& c) { return c.point == point; });
    n.pool.erase(found);
    n.candidates = n.pool;
    context.state.phase = Phase::Sphere;
}

}  // namespace

void phaseGuard(StepContext& context) {
    layOutFan(context);
    const Fan& fan = context.state.pivot.fan;
    Objection objection;
    const FanRule* rule = firstObjecting(context, kWaitingRules, objection);
    if (rule == nullptr) rule = firstObjecting(context, kManifoldRules, objection);
    if (rule == nullptr) rule = firstObjecting(context, kShapeRules, objection);
    if (rule == nullptr) {
        context.state.phase = Phase::Emit;
        return;
    }
    const std::size_t drop = rule->remedy == Remedy::Refuse ? kNone : culprit(fan, objection);
    const Index dropped = drop == kNone ? kNone : fan[drop].point;
    note(context, Stage::Guard, [&] {
        return GuardEvidence{objection.verdict, fan[objection.at].point,
                             objection.triangle ? fan[objection.at + 1].point : kNone, dropped};
    });
    if (dropped == kNone) {
        refuse(context);
    } else {
        tryWithout(context, dropped);
    }
}

bool manifoldRefuses(const StepContext& context) {
    Objection objection;
    return firstObjecting(context, kManifoldRules, objection) != nullptr;
}

bool shapeRefuses(const StepContext& context) {
    Objection objection;
    return firstObjecting(context, kShapeRules, objection) != nullptr;
}

}  // namespace se
