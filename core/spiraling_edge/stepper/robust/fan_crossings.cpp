/// Rules on other parts of the mesh in the place of a fan: nocross, nomeet. Both search only around
/// the points that the pivot lists: the cost of a fan is its length times the ring steps or
/// triangles there.
#include <algorithm>

#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/stepper/robust/fan_rules.h"

namespace se {
namespace {

// ---- nocross ------------------------------------------------------------------------------------

struct Spot {
    double x, y;
};

double turn(const Spot& a, const Spot& b, const Spot& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// True if the three are collinear up to rounding.
bool inLine(const Spot& a, const Spot& b, const Spot& c) {
    const double t = turn(a, b, c);
    const Spot u{b.x - a.x, b.y - a.y};
    const Spot v{c.x - a.x, c.y - a.y};
    return t * t <= 1e-24 * (u.x * u.x + u.y * u.y) * (v.x * v.x + v.y * v.y);
}

/// True if a b and c d cross. Along a straight border all four points are collinear, and signs
/// would be those of rounding errors.
bool properlyCross(const Spot& a, const Spot& b, const Spot& c, const Spot& d) {
    return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0 &&
           !(inLine(a, b, c) && inLine(a, b, d));
}

/// Finds ring steps near the pivot that a new edge crosses, in the pivot's tangent plane.
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
    Spot flat(const Vec3& offset) const { return {glm::dot(x_, offset), glm::dot(y_, offset)}; }

    Objection againstStep(Index from, Index to) const {
        const State& s = context_.state;
        const Fan& fan = s.pivot.fan;
        const Index u = s.rings.point(from);
        const Index v = s.rings.point(to);
        const Index p = s.rings.point(s.pivot.pivot);
        if (u == p || v == p || s.rings.open(from)) return {};
        const Vec3 du = context_.points.position[u] - frame_.origin;
        const Vec3 dv = context_.points.position[v] - frame_.origin;
        const Spot fu = flat(du);
        const Spot fv = flat(dv);
        for (std::size_t i = 0; i < fan.size(); ++i) {
            if (fan[i].point == u || fan[i].point == v) continue;
            const Spot a = flat(fan[i].offset);
            // Also to ring points that start and end have passed, since points between may have
            // been left out.
            const bool isNew = i > 0 && i + 1 < fan.size();
            if (isNew && properlyCross({0.0, 0.0}, a, fu, fv)) {
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

}  // namespace

Objection crossing(const StepContext& context) { return CrossingSearch(context).find(); }

namespace {

// ---- nomeet -------------------------------------------------------------------------------------

/// Neighborhoods whose normals all lie within 45 degrees of the pivot's, as is usual, are flat
/// enough for RobustRules::noCross to see every overlap.
bool isFlat(const PointSet& points, Index p, double cosine) {
    const auto list = points.neighbors[p];
    return std::all_of(list.begin(), list.end(), [&](Index x) {
        return glm::dot(points.normal[x], points.normal[p]) > cosine;
    });
}

}  // namespace

Objection meetsFinished(const StepContext& context) {
    const State& s = context.state;
    const Fan& fan = s.pivot.fan;
    const PointSet& points = context.points;
    const Index p = s.rings.point(s.pivot.pivot);
    if (isFlat(points, p, context.params.thresholds.flatCosine)) return {};
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

}  // namespace se
