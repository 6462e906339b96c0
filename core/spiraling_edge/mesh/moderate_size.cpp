/// One pass over the corners finds the size of usual meshes; others are measured by the median of
/// their corners, which a few far ones do not move.
#include "spiraling_edge/mesh/moderate_size.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "spiraling_edge/base/median.h"
#include "spiraling_edge/mesh/mesh_judge.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {
namespace {

/// Products of eight lengths of meshes in this range, with edges of a millionth of the mesh, are
/// numbers of double precision.
constexpr double kLargest = 1e30;
constexpr double kSmallest = 1e-30;

double magnitude(const Vec3& x) { return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}); }

bool isModerate(double size) { return size >= kSmallest && size <= kLargest; }

/// The power of two that brings the mesh to a size of about 1; 0 for one of moderate size.
int moderatingPower(const PointSet& points, std::span<const Triangle> triangles) {
    double most = 0.0;
    for (const Triangle& t : triangles) {
        for (const Index p : {t.a, t.b, t.c}) most = std::max(most, magnitude(points.position[p]));
    }
    if (most == 0.0 || isModerate(most)) return 0;
    const std::vector<bool> used = usedPoints(points.size(), triangles);
    std::vector<double> sizes;
    for (Index p = 0; p < points.size(); ++p) {
        if (used[p]) sizes.push_back(magnitude(points.position[p]));
    }
    const double middle = medianOf(sizes);
    return middle == 0.0 || isModerate(middle) ? 0 : -std::ilogb(middle);
}

Vec3 scaledBy(int power, const Vec3& x) {
    return {std::ldexp(x.x, power), std::ldexp(x.y, power), std::ldexp(x.z, power)};
}

PointSet scaledBy(int power, PointSet points) {
    for (Vec3& x : points.position) x = scaledBy(power, x);
    if (!points.judge) return points;
    MeshJudge judge = *points.judge;
    judge.points = scaledBy(power, std::move(judge.points));
    InputFacts& facts = judge.facts;
    facts.low = scaledBy(power, facts.low);
    facts.high = scaledBy(power, facts.high);
    facts.across = std::ldexp(facts.across, power);
    for (double& spacing : judge.spacing) spacing = std::ldexp(spacing, power);
    for (double& reach : judge.reach) reach = std::ldexp(reach, power);
    points.judge = std::make_shared<const MeshJudge>(std::move(judge));
    return points;
}

}  // namespace

ModerateSize::ModerateSize(const PointSet& points, std::span<const Triangle> triangles)
    : given_(&points), power_(moderatingPower(points, triangles)) {
    if (power_ != 0) scaled_ = scaledBy(power_, points);
}

Vec3 ModerateSize::place(const Vec3& moderate) const { return scaledBy(-power_, moderate); }

}  // namespace se
