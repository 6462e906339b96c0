/// Checks of positions: single points, then distances: near duplicates, isolated and collinear
/// points, uneven spacing and exact ties, each from the lists of the 12 nearest. O(points), but for
/// ties with the cube of the eight nearest.
#include <algorithm>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/prepare/normals.h"
#include "spiraling_edge/prepare/strays.h"
#include "spiraling_edge/stepper/rules.h"

namespace se {

// ---- single points ------------------------------------------------------------------------------

namespace {

std::vector<Index> unusableFor(Aside reason, const ExaminedFile& examined) {
    return pointsWhere(examined.size(),
                       [&](Index p) { return examined.intake.placed.aside[p] == reason; });
}

}  // namespace

std::optional<Finding> findNonFinite(const ExaminedFile& examined) {
    return findingAt(unusableFor(Aside::NotFinite, examined), Severity::Error,
                     "with a coordinate that is NaN or infinite");
}

std::optional<Finding> findDuplicates(const ExaminedFile& examined) {
    return findingAt(unusableFor(Aside::Copy, examined), Severity::Warning,
                     "exactly where a point with a lower index stands");
}

std::optional<Finding> findSentinels(const ExaminedFile& examined) {
    std::vector<Index> points = unusableFor(Aside::Sentinel, examined);
    if (points.empty()) return std::nullopt;
    const Vec3& first = examined.file.position[points.front()];
    // In full, so that it can be searched for in the file.
    return findingAt(std::move(points), Severity::Warning,
                     "far off all others, as where a missing value was written (--keep-sentinels: "
                     "places like all others); the first is at (" +
                         plainNumbers(first, ", ") + ")");
}

std::optional<Finding> findTooFewPoints(const ExaminedFile& examined) {
    // Three points make one triangle, which may be intended but is no surface.
    constexpr std::size_t kTriangle = 3;
    if (examined.presentCount > kTriangle) return std::nullopt;
    const std::string text = counted(examined.presentCount, "point") + " with a place of " +
                             (examined.presentCount == 1 ? "its" : "their") + " own: ";
    if (examined.presentCount == kTriangle)
        return findingOf(examined, Severity::Warning, text + "one triangle at most");
    return findingOf(examined, Severity::Error, text + "no triangle");
}

// ---- near duplicates ----------------------------------------------------------------------------

std::optional<Finding> findNearDuplicates(const ExaminedFile& examined) {
    // A thousandth of the spacing: a triangle on such a pair has an angle of 0.06 degrees, and no
    // surface sampled at that spacing has a detail of that size. Strong noise stays above 0.01.
    constexpr double kSamePointTolerance = 1e-3;
    std::vector<Index> points;
    for (Index p = 0; p < examined.size(); ++p) {
        for (const Index q : examined.nearest()[p]) {
            if (!(examined.distance(p, q) < kSamePointTolerance * examined.spacing[p])) break;
            points.push_back(std::max(p, q));
        }
    }
    sortUnique(points);
    return findingAt(std::move(points), Severity::Warning,
                     "nearer to one with a lower index than a thousandth of the spacing");
}

// ---- isolated points ----------------------------------------------------------------------------

namespace {

/// In spacings. Lists of twelve reach about two; no useful list reaches four times as far.
constexpr double kFar = 8.0;

/// Median of the spacings of the points that p lists.
double spacingAround(const ExaminedFile& examined, Index p, std::vector<double>& room) {
    room.clear();
    for (const Index q : examined.nearest()[p]) room.push_back(examined.spacing[q]);
    return medianOf(room);
}

/// Of the strays, those far by the second nearest point as well: single ones and pairs. The rest is
/// found on clean sets, too.
std::vector<bool> farStrays(const ExaminedFile& examined) {
    std::vector<bool> far =
        strayPoints(examined.file.position, examined.present(), examined.nearest());
    std::vector<double> room;
    for (Index p = 0; p < examined.size(); ++p) {
        const auto list = examined.nearest()[p];
        if (!far[p] || list.size() < 2) continue;
        far[p] = examined.distance(p, list[1]) > kFar * spacingAround(examined, p, room);
    }
    return far;
}

/// Points that are scattered off the surface, as outliers that lie near enough to each other to
/// have neighbors: sparse, in no list of a point where the spacing is usual, and either all alone
/// beside a dense part or amid points in no surface.
std::vector<bool> scatteredPoints(const ExaminedFile& examined) {
    // In spacings of the middle; sparse parts of clean sets have lists within a surface.
    constexpr double kSparse = 3.0;
    constexpr double kUsual = 2.0;
    constexpr double kOffSurface = 0.35;  // Heights, in spacings.
    const double middle = examined.middleSpacing;
    std::vector<bool> wanted(examined.size(), false);
    for (Index p = 0; p < examined.size(); ++p) {
        if (examined.spacing[p] >= kUsual * middle) continue;
        for (const Index q : examined.nearest()[p]) wanted[q] = true;
    }
    std::vector<bool> scattered(examined.size(), false);
    for (Index p = 0; p < examined.size(); ++p) {
        if (wanted[p] || examined.spacing[p] <= kSparse * middle) continue;
        const Index nearest = examined.nearest()[p].front();
        scattered[p] = examined.roughness[p].narrow > kOffSurface ||
                       examined.distance(p, nearest) > kSparse * examined.spacing[nearest];
    }
    // Clean sets have up to one in five thousand, and corners of coarse models are sparse.
    constexpr std::size_t kOneIn = 2000;
    constexpr std::size_t kLeast = 5;
    const auto count =
        static_cast<std::size_t>(std::count(scattered.begin(), scattered.end(), true));
    if (count < kLeast || count * kOneIn < examined.presentCount)
        scattered.assign(examined.size(), false);
    return scattered;
}

}  // namespace

std::optional<Finding> findIsolatedPoints(const ExaminedFile& examined) {
    const std::vector<bool> far = farStrays(examined);
    const std::vector<bool> scattered = scatteredPoints(examined);
    auto points = pointsWhere(examined.size(), [&](Index p) { return far[p] || scattered[p]; });
    return findingAt(std::move(points), Severity::Warning,
                     "off the surface: far from the others, and in no list of the 12 nearest but "
                     "each other's");
}

// ---- collinear points ---------------------------------------------------------------------------

std::optional<Finding> findInLine(const ExaminedFile& examined) {
    if (examined.presentCount < 3) return std::nullopt;
    const Result<std::vector<Vec3>> planes =
        estimateNormals(examined.file.position, examined.nearest());
    auto points = pointsWhere(examined.size(), [&](Index p) {
        return examined.present()[p] && planes.value()[p] == Vec3(0.0);
    });
    const bool all = points.size() == examined.presentCount;
    return findingAt(std::move(points), all ? Severity::Error : Severity::Warning,
                     "in line with all of the nearest others");
}

// ---- spacing ------------------------------------------------------------------------------------

std::optional<Finding> findUnevenSpacing(const ExaminedFile& examined) {
    // A list with a reach of two spacings is empty where points are this much sparser, and sixteen
    // times too long where they are this much denser.
    constexpr double kUneven = 4.0;
    const double middle = examined.middleSpacing;
    double least = middle;
    double most = middle;
    std::vector<Index> points;
    for (Index p = 0; p < examined.size(); ++p) {
        const double spacing = examined.spacing[p];
        if (spacing == 0.0) continue;
        least = std::min(least, spacing);
        most = std::max(most, spacing);
        if (spacing > kUneven * middle || spacing * kUneven < middle) points.push_back(p);
    }
    return findingAt(std::move(points), Severity::Note,
                     "with a spacing off the middle of " + shortNumber(middle) +
                         " by more than four times; it runs from " + shortNumber(least) + " to " +
                         shortNumber(most));
}

// ---- ties ---------------------------------------------------------------------------------------

namespace {

/// The four sides and the four diagonals of a square lattice.
constexpr std::size_t kSquare = 8;

struct Offset {
    Vec3 offset;
    double lengthSq;
};

/// True if another point lies exactly on the sphere of 6.3 through p, a and b, and none in it.
bool tieAbout(const std::vector<Offset>& near, std::size_t a, std::size_t b) {
    bool tie = false;
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (i == a || i == b) continue;
        const SphereTest test = testSphere(near[a].offset, near[a].lengthSq, near[b].offset,
                                           near[b].lengthSq, near[i].offset, near[i].lengthSq);
        if (test.noCircle || test.inside()) return false;
        tie = tie || test.power <= 1e-12 * test.scale;  // As in SphereTest::inside().
    }
    return tie;
}

bool hasTie(const ExaminedFile& examined, Index p, std::vector<Offset>& near) {
    near.clear();
    const auto list = examined.nearest()[p];
    for (const Index q : list.first(std::min(kSquare, list.size()))) {
        const Vec3 offset = examined.file.position[q] - examined.file.position[p];
        near.push_back({offset, glm::dot(offset, offset)});
    }
    for (std::size_t a = 0; a < near.size(); ++a) {
        for (std::size_t b = a + 1; b < near.size(); ++b) {
            if (tieAbout(near, a, b)) return true;
        }
    }
    return false;
}

}  // namespace

std::optional<Finding> findTies(const ExaminedFile& examined) {
    std::vector<Offset> near;
    auto points = pointsWhere(examined.size(), [&](Index p) {
        return examined.present()[p] && hasTie(examined, p, near);
    });
    // A lattice has ties everywhere. Ties in places occur in many scans and in machine parts whose
    // coordinates have few digits, and are no problem.
    const bool lattice = 10 * points.size() >= 9 * examined.presentCount;
    return findingAt(std::move(points), lattice ? Severity::Warning : Severity::Note,
                     "of " + std::to_string(examined.presentCount) +
                         " exactly on a circle through three others" +
                         (lattice ? ": an exact lattice" : ""));
}

}  // namespace se
