/// Rules on the shape of a fan: nofold, rim, delay; and on other parts of the mesh in its place:
/// nocross, nomeet, nolayer. These search only around the points that the pivot lists: the cost of
/// a fan is its length times the ring steps or triangles there.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/geometry/edge_planes.h"
#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/geometry/second_layer.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/stepper/robust/fan_rules.h"

namespace se {
namespace {

// ---- nofold -------------------------------------------------------------------------------------

/// True if the old triangle across u -> v is folded onto one with the area vector `area`.
bool foldsOver(const StepContext& context, Index u, Index v, const Vec3& area) {
    const State& s = context.state;
    const HalfEdge h = s.edges.find(u, v);
    if (h == kNone) return false;
    const std::vector<Vec3>& position = context.points.position;
    const Vec3 old = areaVector(position[u], position[v], position[s.edges.opposite(h)]);
    return encloseMore(old, area, context.params.thresholds.foldCosine);
}

/// True if a triangle of the pivot, a and b is against the normal of a corner or, once that is
/// allowed, only against the sum of all three.
bool isAgainstNormals(const StepContext& context, const Vec3& area, Index a, Index b) {
    const double atPivot = glm::dot(area, context.state.pivot.frame.normal);
    const double atA = glm::dot(area, context.points.normal[a]);
    const double atB = glm::dot(area, context.points.normal[b]);
    const bool faces = context.state.retryLevel >= kCornerAllowed
                           ? atPivot + atA + atB > 0.0
                           : atPivot > 0.0 && atA > 0.0 && atB > 0.0;
    return !faces;
}

}  // namespace

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

// ---- rim ----------------------------------------------------------------------------------------

namespace {

/// The square of the spacing at p.
double spacingSq(const PointSet& points, Index p) {
    const Vec3 d = points.position[sixthOf(points.neighbors[p])] - points.position[p];
    return glm::dot(d, d);
}

/// True if the radius of the circle through the pivot, a and b exceeds the spacing.
bool isLarge(const FanPoint& a, const FanPoint& b, double spacingSquared) {
    const Vec3 area = glm::cross(a.offset, b.offset);
    const Vec3 side = a.offset - b.offset;
    return a.lengthSq * b.lengthSq * glm::dot(side, side) >
           4.0 * glm::dot(area, area) * spacingSquared;
}

}  // namespace

Objection overRim(const StepContext& context) {
    const PointSet& points = context.points;
    const Fan& fan = context.state.pivot.fan;
    const Index p = context.state.rings.point(context.state.pivot.pivot);
    if (points.neighbors[p].empty()) return {};
    const double spacing = spacingSq(points, p);
    const RobustThresholds& thresholds = context.params.thresholds;
    const auto endsHere = [&](Index x) {
        return !isOnWall(points.type[x]) && context.passesRim(x);
    };
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        const bool wide = exceedsAngle(fan[i].angle, fan[i + 1].angle, thresholds.rimAngleCosine) ||
                          isLarge(fan[i], fan[i + 1], spacing);
        if (wide && endsHere(p) && endsHere(fan[i].point) && endsHere(fan[i + 1].point)) {
            return {Verdict::OverRim, i, true};
        }
    }
    return {};
}

namespace {

/// The bits of the walls of which at least two corners are points.
unsigned wallsOfSides(const PointSet& points, const std::array<Index, 3>& corner) {
    const auto type = [&](std::size_t k) -> unsigned { return points.type[corner[k]] & kFaceBits; };
    return (type(0) & type(1)) | (type(1) & type(2)) | (type(2) & type(0));
}

/// True if the triangle lies beyond a wall: outside of the side between two of its points; of the
/// three sides between three points, outside of two.
bool liesBeyond(const PointSet& points, const std::array<Index, 3>& corner, unsigned wall,
                const Vec3& outward) {
    const auto onWall = [&](Index p) { return (points.type[p] & wall) != 0; };
    std::size_t sides = 0;
    std::size_t outside = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Index u = corner[k];
        const Index v = corner[(k + 1) % 3];
        if (!onWall(u) || !onWall(v)) continue;
        ++sides;
        // The triangle is to the left of its sides: outside if the direction outward is, too.
        const Vec3 turn = glm::cross(points.position[v] - points.position[u], outward);
        const bool isOutside =
            glm::dot(turn, points.normal[u]) > 0.0 && glm::dot(turn, points.normal[v]) > 0.0;
        outside += isOutside ? 1 : 0;
    }
    return sides == 3 ? outside > 1 : outside > 0;
}

bool liesBeyondWall(const PointSet& points, const std::array<Index, 3>& corner) {
    const unsigned walls = wallsOfSides(points, corner);
    for (unsigned i = 0; walls >> i != 0; ++i) {
        const unsigned wall = 1U << i;
        if ((walls & wall) == 0) continue;
        Vec3 outward(0.0);
        outward[static_cast<Vec3::length_type>(i % 3)] = wall <= kPositiveZ ? 1.0 : -1.0;
        if (liesBeyond(points, corner, wall, outward)) return true;
    }
    return false;
}

}  // namespace

Objection beyondWall(const StepContext& context) {
    const Fan& fan = context.state.pivot.fan;
    const Index p = context.state.rings.point(context.state.pivot.pivot);
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        if (liesBeyondWall(context.points, {p, fan[i].point, fan[i + 1].point}))
            return {Verdict::OverRim, i, true};
    }
    return {};
}

// ---- delay --------------------------------------------------------------------------------------

Objection steep(const StepContext& context) {
    const Fan& fan = context.state.pivot.fan;
    if (context.state.retryLevel >= kDelayedAllowed) return {};
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        const Vec3 area = glm::cross(fan[i].offset, fan[i + 1].offset);
        const double limit =
            context.params.thresholds.steepCosine * std::sqrt(glm::dot(area, area));
        if (glm::dot(area, context.points.normal[fan[i].point]) < limit ||
            glm::dot(area, context.points.normal[fan[i + 1].point]) < limit ||
            glm::dot(area, context.state.pivot.frame.normal) < limit) {
            return {Verdict::Steep, i, true};
        }
    }
    return {};
}

namespace {

// ---- nocross ------------------------------------------------------------------------------------

using Spot = glm::dvec2;

double turn(const Spot& a, const Spot& b, const Spot& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// True if the three are collinear up to rounding.
bool inLine(const Spot& a, const Spot& b, const Spot& c) {
    const double t = turn(a, b, c);
    return t * t <= 1e-24 * glm::dot(b - a, b - a) * glm::dot(c - a, c - a);
}

/// True if a b and c d cross, where a and b lie on different sides of c d. Along a straight border
/// all four points are collinear, and signs would be those of rounding errors.
bool properlyCross(const Spot& a, const Spot& b, const Spot& c, const Spot& d) {
    return turn(a, b, c) * turn(a, b, d) < 0.0 && !(inLine(a, b, c) && inLine(a, b, d));
}

/// Finds ring steps near the pivot that a new edge crosses, in the pivot's tangent plane.
class CrossingSearch {
  public:
    explicit CrossingSearch(const StepContext& context)
        : context_(context), frame_(context.state.pivot.frame) {
        y_ = glm::cross(frame_.normal, frame_.z);
        x_ = glm::cross(y_, frame_.normal);
        tested_.fill(kNone);
    }

    Objection find() {
        const State& s = context_.state;
        const Index p = s.rings.point(s.pivot.pivot);
        for (const Index x : context_.points.neighbors[p]) {
            for (Index e = s.rings.firstEntryOf(x); e != kNone; e = s.rings[e].nextOfPoint) {
                const Index before = s.rings.prev(e);
                if (isNew(e)) {
                    if (const Objection found = againstStep(e, s.rings.next(e))) return found;
                }
                if (isNew(before)) {
                    if (const Objection found = againstStep(before, e)) return found;
                }
            }
        }
        return {};
    }

  private:
    /// A step between two listed points comes up at both: true for the first time, mostly.
    bool isNew(Index from) { return std::exchange(tested_[from % tested_.size()], from) != from; }
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
        const double sideOfPivot = turn(fu, fv, {0.0, 0.0});
        Spot next = flat(fan.front().offset);
        double sideOfNext = turn(fu, fv, next);
        for (std::size_t i = 0; i < fan.size(); ++i) {
            const Spot a = next;
            const double side = sideOfNext;
            if (i + 1 < fan.size()) {
                next = flat(fan[i + 1].offset);
                sideOfNext = turn(fu, fv, next);
            }
            if (fan[i].point == u || fan[i].point == v) continue;
            // Also to ring points that start and end have passed, since points between may have
            // been left out.
            const bool isNew = i > 0 && i + 1 < fan.size();
            if (isNew && sideOfPivot * side < 0.0 && properlyCross({0.0, 0.0}, a, fu, fv))
                return {Verdict::Crosses, i, false};
            if (i + 1 == fan.size() || fan[i + 1].point == u || fan[i + 1].point == v) continue;
            if (!fan[i].candidate && !fan[i + 1].candidate) continue;
            if (side * sideOfNext < 0.0 && properlyCross(a, next, fu, fv))
                return {Verdict::Crosses, i, true};
        }
        return {};
    }

    const StepContext& context_;
    const Frame& frame_;
    Vec3 x_, y_;
    std::array<Index, 16> tested_;  ///< Steps, by their entry; later ones replace earlier ones.
};

// ---- nomeet, nolayer ----------------------------------------------------------------------------

/// A triangle of the fan, with the planes that tell most finished ones apart from it.
struct FanTriangle {
    FanTriangle(const PointSet& points, const Triangle& t)
        : made(points, t), planes(points, made) {}

    ShapedTriangle made;
    EdgePlanes planes;
};

/// Finds a finished triangle near the pivot that is in conflict with one of the fan: one pass for
/// both rules, in which the sides of each point are found once for all triangles at it.
class FinishedSearch {
  public:
    /// Most triangles of a fan at once: the sides of a point in the planes of each fit a word.
    static constexpr std::size_t kAtOnce = 12;

    /// Of the triangles of the fan, those from number `from` on.
    FinishedSearch(const StepContext& context, std::size_t from)
        : context_(context),
          points_(context.points),
          from_(from),
          all_(context.positionAt(context.state.pivot.pivot)) {
        const Fan& fan = context.state.pivot.fan;
        const Index p = context.state.rings.point(context.state.pivot.pivot);
        const std::size_t end = std::min(from + kAtOnce, fan.size() - 1);
        fan_.reserve(end - from);
        for (std::size_t i = from; i < end; ++i) {
            const ShapedTriangle& made =
                fan_.emplace_back(points_, Triangle{p, fan[i].point, fan[i + 1].point}).made;
            reach_ = std::max(reach_, made.shape.reach);
            all_.add(made.box.low);
            all_.add(made.box.high);
        }
        tested_.fill(kNone);
        point_.fill(kNone);
    }

    Objection find() {
        const State& s = context_.state;
        for (const Index x : points_.neighbors[s.rings.point(s.pivot.pivot)]) {
            for (HalfEdge h = s.edges.firstFrom(x); h != kNone; h = s.edges.nextFrom(h)) {
                // A triangle comes up at each of its corners; this remembers most of them.
                const Index t = h / 3;
                if (std::exchange(tested_[t % tested_.size()], t) == t) continue;
                if (const Objection found = against(s.triangles[t])) return found;
            }
        }
        return {};
    }

  private:
    static constexpr unsigned kBits = 5;  ///< Of EdgePlanes::Side.
    static constexpr std::uint64_t kMask = (1U << kBits) - 1;

    /// EdgePlanes::sidesOf() a point for each triangle of the fan, the first one in the low bits.
    std::uint64_t sidesOf(Index p) {
        const std::size_t slot = p % point_.size();
        if (std::exchange(point_[slot], p) == p) return sides_[slot];
        std::uint64_t sides = 0;
        for (auto each = fan_.rbegin(); each != fan_.rend(); ++each)
            sides = sides << kBits | each->planes.sidesOf(p);
        return sides_[slot] = sides;
    }

    Objection against(const Triangle& old) {
        std::uint64_t common = sidesOf(old.a) & sidesOf(old.b) & sidesOf(old.c);
        std::optional<ShapedTriangle> shaped;
        for (std::size_t i = 0; i < fan_.size(); ++i, common >>= kBits) {
            if ((common & EdgePlanes::kBeyondEdge) != 0) continue;
            if (!shaped) {
                const Box box = boxOf(points_, old);
                if (!box.meets(all_, reach_ + mostReachIn(box))) return {};
                shaped.emplace(points_, old);
            }
            const ShapedTriangle& made = fan_[i].made;
            const auto sides = static_cast<unsigned>(common & kMask);
            if (EdgePlanes::tellApart(sides, made.shape, shaped->shape)) continue;
            const Verdict verdict = verdictOn(made, *shaped);
            if (verdict != Verdict::Kept) return {verdict, from_ + i, true};
        }
        return {};
    }
    Verdict verdictOn(const ShapedTriangle& made, const ShapedTriangle& old) const {
        const RobustRules& rules = context_.params.robust;
        if (!conflict(points_, made, old)) return Verdict::Kept;
        if (rules.noMeet && made.box.meets(old.box) &&
            trianglesShareMore(points_.position, made.triangle, old.triangle))
            return Verdict::Meets;
        const bool covers = rules.noLayer && isSecondLayer(points_, made.triangle, made.shape,
                                                           old.triangle, old.shape);
        return covers ? Verdict::Covers : Verdict::Kept;
    }

    const StepContext& context_;
    const PointSet& points_;
    std::size_t from_;
    std::vector<FanTriangle> fan_;
    Box all_;             ///< Around these triangles.
    double reach_ = 0.0;  ///< The longest LayerShape::reach.
    std::array<Index, 64> tested_{};
    // By index of a point; later ones replace earlier ones.
    std::array<Index, 64> point_{};
    std::array<std::uint64_t, 64> sides_{};
};

}  // namespace

bool isFlatAround(const StepContext& context) {
    const PointSet& points = context.points;
    const Index p = context.state.rings.point(context.state.pivot.pivot);
    const auto list = points.neighbors[p];
    return std::all_of(list.begin(), list.end(), [&](Index x) {
        return glm::dot(points.normal[x], points.normal[p]) > context.params.thresholds.flatCosine;
    });
}

Objection crossing(const StepContext& context) { return CrossingSearch(context).find(); }

Objection conflictsWithFinished(const StepContext& context) {
    const std::size_t count = context.state.pivot.fan.size() - 1;
    for (std::size_t from = 0; from < count; from += FinishedSearch::kAtOnce) {
        if (const Objection found = FinishedSearch(context, from).find()) return found;
    }
    return {};
}

}  // namespace se
