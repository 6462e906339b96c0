/// The check of points on curves in one plane, where there is no surface to find: curves with
/// normals in the plane, or one curve without normals. Curves in space cannot be told from the
/// slices of a surface. O(points), and distances from up to 256 points to all where normals turn in
/// one plane or a thin curve has none.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/prepare/normals.h"
#include "spiraling_edge/prepare/scan_lines.h"

namespace se {
namespace {

/// The points of a file in one plane.
struct PlanePoints {
    const ExaminedFile& examined;
    std::vector<Index> points;
    Vec3 plane{0.0};  ///< Unit normal; zero if the points lie in no plane, or all in line.

    Vec3 at(Index p) const { return examined.file.position[p]; }
    /// About 256 of the points, spread over the file.
    std::vector<Index> places() const {
        constexpr std::size_t kPlaces = 256;
        const std::size_t step = points.size() / kPlaces + 1;
        std::vector<Index> some;
        for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
        return some;
    }
};

PlanePoints planePointsOf(const ExaminedFile& examined) {
    constexpr std::size_t kFewest = 30;  // Lists then have all their 12 entries.
    constexpr double kThickness = 1e-4;  // Of the length: files have five digits or more.
    PlanePoints all{examined, examined.presentPoints()};
    if (all.points.size() < kFewest) return all;
    const PlaneFit fit =
        planeAt(examined.file.position, all.points.front(), std::span(all.points).subspan(1));
    if (fit.variance[0] <= kThickness * kThickness * fit.variance[2]) all.plane = fit.normal;
    return all;
}

// ---- curves with normals ------------------------------------------------------------------------

/// True if the normals lie in the plane and turn there. Those of parallel lines do not turn: such
/// lines may be a scan of the plane, with wrong normals.
bool normalsTurnInPlane(const PlanePoints& all) {
    constexpr double kSine = 0.1;    // 6 degrees off the plane, at most, are
    constexpr double kShare = 0.95;  // this share of the normals.
    constexpr double kTurn = 0.9;    // Length of the mean vector of doubled angles.
    const Vec3 aside = std::abs(all.plane.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 u = glm::normalize(glm::cross(all.plane, aside));
    const Vec3 v = glm::cross(all.plane, u);
    double normals = 0.0;
    double inPlane = 0.0;
    std::array<double, 2> doubled{};
    for (const Index p : all.points) {
        const Vec3& n = all.examined.normal()[p];
        if (n == Vec3(0.0)) continue;
        ++normals;
        if (std::abs(glm::dot(n, all.plane)) > kSine) continue;
        ++inPlane;
        const double x = glm::dot(n, u);
        const double y = glm::dot(n, v);
        doubled[0] += x * x - y * y;
        doubled[1] += 2.0 * x * y;
    }
    return 2.0 * normals > static_cast<double>(all.points.size()) && inPlane >= kShare * normals &&
           std::hypot(doubled[0], doubled[1]) <= kTurn * inPlane;
}

/// Numbers of points within distances of a point that double from one to the next.
constexpr std::size_t kRadii = 20;
std::array<double, kRadii> pointsWithin(const PlanePoints& all, Index p) {
    std::array<double, kRadii> within{};
    const double unit = all.examined.middleSpacing * all.examined.middleSpacing;
    for (const Index q : all.points) {
        const double square = distanceSquared(all.at(p), all.at(q)) / unit;
        const auto i = square < 1.0 ? 0 : static_cast<std::size_t>(std::ilogb(square) / 2 + 1);
        if (i < kRadii) ++within[i];
    }
    for (std::size_t i = 1; i < kRadii; ++i) within[i] += within[i - 1];
    return within;
}

/// The power of the distance with which the number of points grows: 1 along curves, also noisy
/// ones, 2 over an area. Median over places, at the distances where it is least.
double dimensionOf(const PlanePoints& all) {
    const std::vector<Index> places = all.places();
    std::array<std::vector<double>, kRadii> powers;
    for (const Index p : places) {
        const std::array<double, kRadii> within = pointsWithin(all, p);
        // Circles of more than half of the points reach beyond the area.
        for (std::size_t i = 1; i < kRadii; ++i) {
            if (2.0 * within[i] <= static_cast<double>(all.points.size()))
                powers[i].push_back(std::log2(within[i] / within[i - 1]));
        }
    }
    double least = 2.0;
    for (std::vector<double>& each : powers) {
        if (2 * each.size() >= places.size()) least = std::min(least, medianOf(each));
    }
    return least;
}

bool areCurves(const PlanePoints& all) {
    constexpr double kOfCurves = 1.5;
    return normalsTurnInPlane(all) && dimensionOf(all) < kOfCurves;
}

// ---- one curve without normals ------------------------------------------------------------------

/// The median distance of a point to the two nearest.
double distanceAlong(const PlanePoints& all) {
    std::vector<double> distances;
    for (const Index p : all.points) {
        const auto list = all.examined.nearest()[p];
        distances.push_back(
            0.5 * (all.examined.distance(p, list[0]) + all.examined.distance(p, list[1])));
    }
    return medianOf(distances);
}

/// True if steps of at most 3.5 distances along the curve connect all points: shorter than any from
/// line to line (lieInLines()).
bool isConnected(const PlanePoints& all, double along) {
    constexpr double kLongest = 3.5;
    DisjointSets chains(all.examined.size());
    std::size_t count = all.points.size();
    for (const Index p : all.points) {
        for (const Index q : all.examined.nearest()[p]) {
            if (all.examined.distance(p, q) <= kLongest * along && chains.unite(p, q)) --count;
        }
    }
    return count == 1;
}

/// True if points lie to the left and to the right of p, within 200 distances along the curve and
/// 45 degrees, as between the lines of a scan.
bool isBetween(const PlanePoints& all, Index p, double along) {
    constexpr double kReach = 200.0;
    const Vec3 axis = glm::normalize(all.at(all.examined.nearest()[p].back()) - all.at(p));
    const Vec3 left = glm::cross(all.plane, axis);
    std::array<bool, 2> sides{};
    for (const Index q : all.points) {
        const Vec3 d = all.at(q) - all.at(p);
        const double across = glm::dot(d, left);
        if (std::abs(across) > kReach * along || std::abs(across) < std::abs(glm::dot(d, axis)))
            continue;
        if (across != 0.0) sides[across > 0.0 ? 1 : 0] = true;
    }
    return sides[0] && sides[1];
}

bool isOneCurve(const PlanePoints& all) {
    constexpr double kMostBetween = 0.25;
    const ExaminedFile& examined = all.examined;
    if (!lieInLines(examined.file.position, examined.present(), examined.nearest())) return false;
    const double along = distanceAlong(all);
    if (!isConnected(all, along)) return false;
    const std::vector<Index> places = all.places();
    const auto between = std::count_if(places.begin(), places.end(),
                                       [&](Index p) { return isBetween(all, p, along); });
    return static_cast<double>(between) <= kMostBetween * static_cast<double>(places.size());
}

}  // namespace

std::optional<Finding> findCurves(const ExaminedFile& examined) {
    const PlanePoints all = planePointsOf(examined);
    if (all.plane == Vec3(0.0)) return std::nullopt;
    if (examined.intake.judge->facts.hasNormals) {
        if (!areCurves(all)) return std::nullopt;
        return findingOf(examined, Severity::Error,
                         "the points lie on curves in one plane, and their normals in that plane, "
                         "too: no surface is between them");
    }
    if (!isOneCurve(all)) return std::nullopt;
    return findingOf(examined, Severity::Error,
                     "the points lie on a curve in one plane: no surface is beside it");
}

}  // namespace se
