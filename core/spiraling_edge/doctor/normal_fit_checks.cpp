/// The check of normals against the planes of the points (given_normals.h), and the kinds of
/// normals that do not fit: each kind is tried on the points, and named only where the trial
/// succeeds. O(points), and 35 trials on about two thousand points.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/prepare/normals.h"

namespace se {
namespace {

/// About as many points are tried.
constexpr std::size_t kTried = 2000;

double angleOf(double cosine) {
    return std::acos(std::min(cosine, 1.0)) * 180.0 / std::numbers::pi;
}

/// "93 %", rounded down, so that "100 %" are all.
std::string percentOf(std::size_t part, std::size_t whole) {
    return std::to_string(100 * part / std::max<std::size_t>(whole, 1)) + " %";
}

std::string placeText(const Vec3& x) {
    return "(" + shortNumber(x.x) + ", " + shortNumber(x.y) + ", " + shortNumber(x.z) + ")";
}

/// Points spread over the file that have normals.
std::vector<Index> triedPoints(const ExaminedFile& examined) {
    const std::size_t step = std::max<std::size_t>(1, examined.presentCount / kTried);
    std::size_t next = 0;
    return pointsWhere(examined.size(),
                       [&](Index p) { return examined.hasSide(p) && next++ % step == 0; });
}

/// The points of a trial, and the normals as they are in the file.
struct NormalTrial {
    const ExaminedFile& examined;
    std::vector<Index> points;

    /// True if the normals of the points fit after turned(normal).
    template <typename Turned>
    bool fits(Turned&& turned) const {
        std::vector<Vec3> normal(examined.size(), Vec3(0.0));
        std::vector<bool> present(examined.size(), false);
        for (const Index p : points) {
            normal[p] = turned(examined.file.normal[p]);
            present[p] = true;
        }
        const NormalFit fit = fitOf(
            {examined.file.position, unitNormals(std::move(normal)), present, examined.nearest()});
        return fit.places >= kFitLimits.leastPlaces &&
               fit.medianCosine >= kFitLimits.medianCosine && normalsFit(fit);
    }
};

// ---- kinds: a piece of a sentence, or nothing ---------------------------------------------------

/// Unsigned bytes, or shares of one, that were not moved to -1 to 1.
std::string asUnsigned(const NormalTrial& trial) {
    double least = 0.0;
    double most = 0.0;
    for (const Index p : trial.points) {
        const Vec3& n = trial.examined.file.normal[p];
        least = std::min({least, n.x, n.y, n.z});
        most = std::max({most, n.x, n.y, n.z});
    }
    if (least < 0.0) return {};
    for (const double top : {1.0, 255.0}) {
        if (most > top) continue;
        const auto moved = [top](const Vec3& n) { return 2.0 / top * n - Vec3(1.0); };
        if (!trial.fits(moved)) continue;
        return std::string("no component is negative, and they fit as ") +
               (top == 1.0 ? "2 v - 1" : "2 v / 255 - 1");
    }
    return {};
}

/// Axes in another order, or with other signs.
std::string asOtherAxes(const NormalTrial& trial) {
    constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    // Sides are ignored, so one sign is free.
    constexpr std::array<std::array<double, 3>, 4> kSigns{
        {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}}};
    for (const auto& order : kOrders) {
        for (const auto& sign : kSigns) {
            const auto turned = [&](const Vec3& n) {
                return Vec3(sign[0] * n[order[0]], sign[1] * n[order[1]], sign[2] * n[order[2]]);
            };
            if (!trial.fits(turned)) continue;
            std::string text = "read as (";
            for (std::size_t i = 0; i < order.size(); ++i) {
                text += i == 0 ? "" : ", ";
                text += sign[i] < 0.0 ? "-" : "";
                text += std::string("xyz")[static_cast<std::size_t>(order[i])];
            }
            return text + ") they fit";
        }
    }
    return {};
}

/// One axis of the points in another unit than the others: feet or millimeters beside meters.
std::string asOtherUnits(const NormalTrial& trial) {
    for (const double factor : {0.3048, 1.0 / 0.3048, 0.001, 1000.0}) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 factors(1.0);
            factors[axis] = factor;
            if (!trial.fits([&](const Vec3& n) { return factors * n; })) continue;
            return "they fit the points in one unit: --scale-by " + plainNumbers(factors) +
                   " --derive-normals";
        }
    }
    return {};
}

/// One direction everywhere.
std::string asOneDirection(const NormalTrial& trial) {
    constexpr double kAlike = 0.98480775301220802;  // 10 degrees
    constexpr std::size_t kMostOfTwenty = 19;
    Vec3 sum(0.0);
    for (const Index p : trial.points) sum += trial.examined.normal()[p];
    if (!hasDirection(sum)) return {};
    const Vec3 mean = glm::normalize(sum);
    const std::size_t alike = countWhere(trial.points, [&](Index p) {
        return glm::dot(trial.examined.normal()[p], mean) >= kAlike;
    });
    if (20 * alike < kMostOfTwenty * trial.points.size()) return {};
    return "they are alike: " + percentOf(alike, trial.points.size()) +
           " are within 10 degrees of " + placeText(mean);
}

/// The place nearest to the lines through the points along their normals, by least squares from
/// `middle`; nothing if they are parallel.
std::optional<Vec3> meetingOf(const NormalTrial& trial, const Vec3& middle) {
    glm::dmat3 sum(0.0);
    Vec3 right(0.0);
    for (const Index p : trial.points) {
        const Vec3& n = trial.examined.normal()[p];
        const glm::dmat3 across = glm::dmat3(1.0) - glm::outerProduct(n, n);
        sum += across;
        right += across * (trial.examined.file.position[p] - middle);
    }
    sum /= static_cast<double>(trial.points.size());
    right /= static_cast<double>(trial.points.size());
    constexpr double kParallel = 1e-9;
    if (!(glm::determinant(sum) > kParallel)) return std::nullopt;
    return middle + glm::inverse(sum) * right;
}

/// Directions to one place, as of a scanner or a camera.
std::string asLinesOfSight(const NormalTrial& trial) {
    constexpr double kAlong = 0.99619469809174555;  // 5 degrees
    constexpr std::size_t kMostOfTen = 9;
    Vec3 middle(0.0);
    for (const Index p : trial.points)
        middle += trial.examined.file.position[p] / static_cast<double>(trial.points.size());
    const std::optional<Vec3> place = meetingOf(trial, middle);
    if (!place) return {};
    const std::size_t along = countWhere(trial.points, [&](Index p) {
        const Vec3 sight = *place - trial.examined.file.position[p];
        return std::abs(glm::dot(trial.examined.normal()[p], sight)) >= kAlong * glm::length(sight);
    });
    if (10 * along < kMostOfTen * trial.points.size()) return {};
    return "they are lines of sight: " + percentOf(along, trial.points.size()) +
           " are within 5 degrees of the direction from or to " + placeText(*place);
}

/// No relation, not even between nearest points.
std::string asChance(const NormalTrial& trial) {
    // Of directions by chance the angle is 60 degrees in the median, whatever their sides.
    constexpr double kLeast = 0.38;
    constexpr double kMost = 0.62;
    const auto byChance = [](double cosine) { return cosine > kLeast && cosine < kMost; };
    std::vector<double> cosines;
    for (const Index p : trial.points) {
        const auto list = trial.examined.nearest()[p];
        if (list.empty()) continue;
        cosines.push_back(
            std::abs(glm::dot(trial.examined.normal()[p], trial.examined.normal()[list.front()])));
    }
    if (cosines.empty()) return {};
    const double median = medianOf(cosines);
    if (!byChance(median) || !byChance(trial.examined.intake.fit.medianCosine)) return {};
    return "they look random: those of nearest points are " + shortNumber(angleOf(median)) +
           " degrees apart in the median";
}

/// About the same angle everywhere.
std::string asTilted(const NormalTrial& trial) {
    const NormalFit& fit = trial.examined.intake.fit;
    constexpr double kSteep = 50.0;
    constexpr double kLeastShare = 0.4;
    constexpr double kMostShare = 1.6;
    const double median = angleOf(fit.medianCosine);
    const double least = angleOf(fit.mostTenth);
    const double most = angleOf(fit.leastTenth);
    if (median > kSteep || least < kLeastShare * median || most > kMostShare * median) return {};
    return "they are tilted: eight in ten by " + shortNumber(least) + " to " + shortNumber(most) +
           " degrees";
}

constexpr std::array kKinds{asUnsigned,     asOtherAxes, asOtherUnits, asOneDirection,
                            asLinesOfSight, asTilted,    asChance};

/// The points off their planes with as many as six such points among their twelve nearest: single
/// ones stand at creases, too.
std::optional<Finding> findUnfitPatch(const ExaminedFile& examined) {
    constexpr std::size_t kOfPatch = 6;
    std::vector<Index> points = examined.intake.fit.off;
    std::erase_if(points, [&](Index p) {
        return countWhere(examined.nearest()[p], [&](Index q) { return examined.isOff(q); }) <
               kOfPatch;
    });
    return findingAt(std::move(points), Severity::Warning,
                     "side by side whose normals are over 30 degrees off the planes of the points");
}

}  // namespace

std::optional<Finding> findUnfitNormals(const ExaminedFile& examined) {
    const NormalFit& fit = examined.intake.fit;
    if (examined.normalsFit()) return findUnfitPatch(examined);
    // Where most are missing, all are derived.
    if (fit.normals == 0 || lacksNormals(examined.file.normal, examined.present()))
        return std::nullopt;
    std::string text = "the normals do not fit the points: they are " +
                       shortNumber(angleOf(fit.medianCosine)) +
                       " degrees off the planes of the points in the median, " +
                       percentOf(fit.near, fit.places) + " within 30";
    const NormalTrial trial{examined, triedPoints(examined)};
    for (const auto kind : kKinds) {
        const std::string which = kind(trial);
        if (which.empty()) continue;
        text += "; " + which;
        break;
    }
    const Severity severity = examined.normalsNear ? Severity::Note : Severity::Warning;
    Finding finding{nullptr, severity, fit.normals, {}, std::move(text)};
    const double length = 1.5 * examined.middleSpacing;
    const auto normalAt = [&](const std::vector<Vec3>& normal, bool asItShouldBe) {
        return evidenceAt(examined, [&](Index p) -> std::optional<EvidenceLine> {
            const Vec3& x = examined.file.position[p];
            if (normal[p] == Vec3(0.0)) return std::nullopt;
            return EvidenceLine{x, x + length * normal[p], asItShouldBe};
        });
    };
    finding.lines = normalAt(examined.normal(), false);
    // The judge's are derived, where given ones do not fit.
    const auto right = normalAt(examined.intake.judge->points.normal, true);
    if (!examined.normalsNear)
        finding.lines.insert(finding.lines.end(), right.begin(), right.end());
    return finding;
}

}  // namespace se
