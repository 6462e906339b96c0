/// The checks of the doctor, in the order of the table in doctor.cpp, and the values that several
/// of them share, computed once.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/median.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/two_heaps.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/prepare/given_normals.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

/// Heights about a point over the surface that fits its surroundings, in its spacings
/// (surface_checks.cpp). Negative: too few points for a fit.
struct Roughness {
    double narrow = -1.0;  ///< Root mean square, about a fit to its list.
    double wide = -1.0;    ///< About a fit to its list and the lists of that.
    TwoHeaps heaps{};      ///< Of the latter.
};

/// Two layers of one surface (surface_checks.cpp). Lengths in spacings.
struct Layers {
    std::vector<Index> points;  ///< Where there are two.
    double apart = 0.0;
    double noise = 0.0;  ///< Of each.

    /// Root mean square of the heights over the middle of both.
    double height() const { return std::sqrt(0.25 * apart * apart + noise * noise); }
};

/// Points with other units, judged as a surface (unit_checks.cpp).
struct ScaledSurface {
    double planar = 0.0;  ///< Share of planar places (given_normals.h).
    double even = 0.0;    ///< Mean ratio of the distances to the nearest and to the twelfth.
    NeighborLists nearest{};
};

/// A conversion of the coordinates to one unit.
struct UnitScale {
    Vec3 factors{1.0};
    std::string_view words;  ///< "x and y as degrees of longitude and latitude, in meters".
    std::string_view ifSo;   ///< "x is the longitude in degrees".
    ScaledSurface surface{};
    /// Other conversions, where the points do not tell: "if x is the latitude: --scale-by ...".
    std::string otherwise{};
};

/// Axes with different units (unit_checks.cpp).
struct MixedUnits {
    Vec3 extent{0.0};                  ///< Of the points, along each axis.
    double planar = 0.0;               ///< Share of planar places (given_normals.h),
    double planarScaled = 0.0;         ///< and that with equal extents.
    std::optional<UnitScale> scale{};  ///< Nothing: none of a few that makes a surface.
    NeighborLists scaled{};            ///< The lists of the nearest by `scale`, or equal extents.
};

/// A file under examination. Everything except `file` is derived from it.
struct ExaminedFile {
    explicit ExaminedFile(const PointFile& points) : file(points) {}

    const PointFile& file;
    Intake intake;
    std::size_t presentCount = 0;
    /// Distance to the sixth nearest point, or to the last if there are fewer: on an even surface
    /// a point has six others about it. 0 without others.
    std::vector<double> spacing;
    double middleSpacing = 0.0;  ///< Median over the present points.
    /// The normals fit, or are rough: near enough to the planes that their sides tell something.
    bool normalsNear = false;
    Sides sides;  ///< Without normals that are near: no components.
    std::vector<Roughness> roughness;
    std::optional<Layers> layers;     ///< Nothing: one layer.
    std::optional<MixedUnits> units;  ///< Nothing: one unit, as far as the points show.

    Index size() const { return static_cast<Index>(file.position.size()); }
    const std::vector<bool>& present() const { return intake.present; }
    std::vector<Index> presentPoints() const;
    const NeighborLists& nearest() const { return intake.nearest; }
    const std::vector<Vec3>& normal() const { return intake.normal; }
    /// The given normals fit the points.
    bool normalsFit() const { return intake.judge->facts.normalsFit; }
    /// True if the point is present and has a normal. Requires a file with normals.
    bool hasSide(Index p) const {
        assert(p < normal().size());
        return present()[p] && normal()[p] != Vec3(0.0);
    }
    /// True if its normal is far off the plane of the points about it.
    bool isOff(Index p) const {
        return std::binary_search(intake.fit.off.begin(), intake.fit.off.end(), p);
    }
    /// Its normal, turned to the side of the rest of its component if it is flipped.
    Vec3 side(Index p) const { return sides.flipped[p] ? -normal()[p] : normal()[p]; }
    double distance(Index p, Index q) const;
};

/// The roughness about each point of a file whose other members are filled in.
std::vector<Roughness> roughnessOf(const ExaminedFile& examined);
/// The layers of a file whose other members are filled in, `roughness` too.
std::optional<Layers> layersOf(const ExaminedFile& examined);

/// The units of a file whose lists are filled in.
std::optional<MixedUnits> mixedUnitsOf(const ExaminedFile& examined);

/// Fails as examine() does.
Result<ExaminedFile> examineFile(const PointFile& file, const Progress& progress);

/// The indices up to `count` for which has(p) is true.
template <typename Has>
std::vector<Index> pointsWhere(std::size_t count, Has&& has) {
    std::vector<Index> points;
    for (Index p = 0; p < count; ++p) {
        if (has(p)) points.push_back(p);
    }
    return points;
}

/// Lines at about 400 of the present points: `at(p)` returns one, or nothing.
template <typename At>
std::vector<EvidenceLine> evidenceAt(const ExaminedFile& examined, At&& at) {
    constexpr std::size_t kPlaces = 400;
    const std::size_t step = examined.presentCount / kPlaces + 1;
    std::vector<EvidenceLine> lines;
    std::size_t next = 0;
    for (Index p = 0; p < examined.size(); ++p) {
        if (!examined.present()[p] || next++ % step != 0) continue;
        const std::optional<EvidenceLine> line = at(p);
        if (line) lines.push_back(*line);
    }
    return lines;
}

/// Of these points those that --thin with this spacing leaves out.
std::vector<Index> thinnedOut(const ExaminedFile& examined, const std::vector<Index>& points,
                              double spacing);

/// Lines from points to the farthest of their lists.
std::vector<EvidenceLine> alongLists(const ExaminedFile& examined, const NeighborLists& lists);

/// A finding at these points (ascending), or nothing if there are none. Its text is their number,
/// as "3 points", and `what`.
std::optional<Finding> findingAt(std::vector<Index> points, Severity severity,
                                 const std::string& what, std::string_view noun = "point");

/// A finding about the file as a whole: about all points with a place of their own.
inline Finding findingOf(const ExaminedFile& examined, Severity severity, std::string text) {
    return {nullptr, severity, examined.presentCount, {}, std::move(text)};
}

// position_checks.cpp: single points
std::optional<Finding> findNonFinite(const ExaminedFile& examined);
std::optional<Finding> findDuplicates(const ExaminedFile& examined);
std::optional<Finding> findSentinels(const ExaminedFile& examined);
std::optional<Finding> findTooFewPoints(const ExaminedFile& examined);
// Distances between points.
std::optional<Finding> findNearDuplicates(const ExaminedFile& examined);
std::optional<Finding> findIsolatedPoints(const ExaminedFile& examined);
std::optional<Finding> findInLine(const ExaminedFile& examined);
std::optional<Finding> findUnevenSpacing(const ExaminedFile& examined);
std::optional<Finding> findTies(const ExaminedFile& examined);

// unit_checks.cpp
std::optional<Finding> findMixedUnits(const ExaminedFile& examined);
std::optional<Finding> findExtremeSize(const ExaminedFile& examined);
// pattern_checks.cpp
std::optional<Finding> findTwins(const ExaminedFile& examined);
std::optional<Finding> findLines(const ExaminedFile& examined);

// curve_checks.cpp
std::optional<Finding> findCurves(const ExaminedFile& examined);

// digit_checks.cpp
std::optional<Finding> findLostDigits(const ExaminedFile& examined);

// surface_checks.cpp
std::optional<Finding> findNoise(const ExaminedFile& examined);
std::optional<Finding> findTwoLayers(const ExaminedFile& examined);

// normal_checks.cpp
std::optional<Finding> findNoNormals(const ExaminedFile& examined);
std::optional<Finding> findZeroNormals(const ExaminedFile& examined);
std::optional<Finding> findUnscaledNormals(const ExaminedFile& examined);
std::optional<Finding> findCloseSheets(const ExaminedFile& examined);
// normal_fit_checks.cpp: normals against the planes of the points
std::optional<Finding> findUnfitNormals(const ExaminedFile& examined);
// normal_checks.cpp: normals against each other
std::optional<Finding> findFlippedNormals(const ExaminedFile& examined);
std::optional<Finding> findInsideOut(const ExaminedFile& examined);

// list_checks.cpp: neighbor lists in the file
std::optional<Finding> findEntriesOutside(const ExaminedFile& examined);
std::optional<Finding> findRepeatedEntries(const ExaminedFile& examined);
std::optional<Finding> findUnsortedLists(const ExaminedFile& examined);
std::optional<Finding> findShortLists(const ExaminedFile& examined);
std::optional<Finding> findUnsymmetricLists(const ExaminedFile& examined);
/// True if the list of p is ordered by distance, up to the rounding of floats. Points that do not
/// exist, or have no finite position, are ignored.
bool isNearestFirst(std::span<const Vec3> position, Index p, std::span<const Index> list);

// type_checks.cpp
std::optional<Finding> findCornerBits(const ExaminedFile& examined);
std::optional<Finding> findTypesOffBox(const ExaminedFile& examined);
std::optional<Finding> findOpenBorder(const ExaminedFile& examined);

}  // namespace se
