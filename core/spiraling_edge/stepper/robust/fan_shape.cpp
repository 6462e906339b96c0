/// Rules on the shape of a fan: nofold, rim, delay.
#include <algorithm>
#include <cmath>

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

/// The spacing at p: the squared distance of its sixth neighbor, or of the last if there are fewer.
/// On an even surface a point has six neighbors around it.
double spacingSq(const PointSet& points, Index p) {
    const auto list = points.neighbors[p];
    const Index sixth = list[std::min<std::size_t>(5, list.size() - 1)];
    const Vec3 d = points.position[sixth] - points.position[p];
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
        return !isOnWall(points.type[x]) && isRim(points, x, thresholds.rimGapCosine);
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

}  // namespace se
