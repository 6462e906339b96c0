#include "spiraling_edge/points/point_set.h"

#include <cmath>

namespace se {
namespace {

constexpr double kUnitTolerance = 1e-6;

std::string pointText(Index p) { return "point " + std::to_string(p); }

Error listError(Index p, const std::string& named) {
    return Error{"the list of " + pointText(p) + " names " + named};
}

Status checkLengths(const PointSet& points) {
    const std::size_t n = points.size();
    if (n >= kNone) return Error{std::to_string(n) + " points; at most 4294967294 are possible"};
    const auto& offset = points.neighbors.offset;
    if (points.normal.size() != n || points.type.size() != n || offset.size() != n + 1) {
        return Error{"there are " + std::to_string(n) + " positions, but " +
                     std::to_string(points.normal.size()) + " normals, " +
                     std::to_string(points.type.size()) + " types and " +
                     std::to_string(offset.empty() ? 0 : offset.size() - 1) + " neighbor lists"};
    }
    if (!points.aside.empty() && points.aside.size() != n) {
        return Error{"there are " + std::to_string(n) + " positions, but " +
                     std::to_string(points.aside.size()) + " marks of points set aside"};
    }
    return points.neighbors.checkDivided();
}

Status checkOrder(const PointSet& points) {
    if (points.order.empty()) return success();
    std::vector<bool> seen(points.size(), false);
    for (const Index p : points.order) {
        if (p >= points.size())
            return Error{"the order names " + pointText(p) + ", which does not exist"};
        if (seen[p]) return Error{"the order names " + pointText(p) + " twice"};
        seen[p] = true;
    }
    if (points.order.size() == points.size()) return success();
    return Error{"the order holds " + std::to_string(points.order.size()) + " of " +
                 std::to_string(points.size()) + " points"};
}

Status checkRim(const PointSet& points) {
    if (points.rim.empty()) return success();
    const std::size_t n = points.size();
    if (points.rim.size() != n) {
        return Error{"there are " + std::to_string(n) + " positions, but gaps of " +
                     std::to_string(points.rim.size()) + " rim points"};
    }
    for (Index p = 0; p < n; ++p) {
        const RimGap& gap = points.rim[p];
        if (gap == RimGap{}) continue;
        if (gap.from >= n || gap.to >= n || gap.from == p || gap.to == p)
            return Error{"the gap of " + pointText(p) + " has an end that is no other point"};
    }
    return success();
}

/// Checks the values that the stepper computes with. NaN fails both comparisons.
Status checkPoint(const PointSet& points, Index p) {
    if (!isFinite(points.position[p])) {
        return Error{pointText(p) + " is in a neighbor list, but its position is not finite"};
    }
    if (!(std::abs(glm::length(points.normal[p]) - 1.0) <= kUnitTolerance)) {
        return Error{pointText(p) + " is in a neighbor list, but its normal is not of unit length"};
    }
    return success();
}

}  // namespace

Status validate(const PointSet& points) {
    if (Status status = checkLengths(points); !status) return status;
    if (Status status = checkOrder(points); !status) return status;
    if (Status status = checkRim(points); !status) return status;
    const auto n = static_cast<Index>(points.size());
    std::vector<Index> lastList(n, kNone);  // per point: the last list that holds it
    for (Index p = 0; p < n; ++p) {
        const auto list = points.neighbors[p];
        if (list.empty()) continue;
        if (Status status = checkPoint(points, p); !status) return status;
        for (const Index q : list) {
            if (q >= n) return listError(p, pointText(q) + ", which does not exist");
            if (q == p) return listError(p, "the point itself");
            if (lastList[q] == p) return listError(p, pointText(q) + " twice");
            if (lastList[q] == kNone) {
                if (Status status = checkPoint(points, q); !status) return status;
            }
            lastList[q] = p;
        }
    }
    return success();
}

}  // namespace se
