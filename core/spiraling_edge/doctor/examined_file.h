/// Values that several checks of the doctor share, computed once.
#pragma once

#include <cassert>
#include <string>

#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

/// Connected components of points, and the points whose normals are flipped (sheet_checks.cpp).
struct Sides {
    std::vector<Index> component;  ///< The name of each point's component; kNone without a normal.
    std::vector<bool> flipped;     ///< Against the rest of the component.
};

/// A file under examination. Everything except `file` is derived from it.
struct ExaminedFile {
    explicit ExaminedFile(const PointFile& points) : file(points) {}

    const PointFile& file;
    std::vector<Fitness> fitness;
    /// Points that are finite and no copy, with any normal.
    std::vector<bool> present;
    std::size_t presentCount = 0;
    std::vector<Vec3> normal;  ///< Scaled; zero where there is no direction. Empty if none at all.
    NeighborLists nearest;     ///< The 12 nearest present points, with any normals.
    /// Distance to the sixth nearest point, or to the last if there are fewer: on an even surface
    /// a point has six others about it. 0 without others.
    std::vector<double> spacing;
    double middleSpacing = 0.0;  ///< Median over the present points.
    Sides sides;

    Index size() const { return static_cast<Index>(file.position.size()); }
    /// True if the point is present and has a normal. Requires a file with normals.
    bool hasSide(Index p) const {
        assert(p < normal.size());
        return present[p] && normal[p] != Vec3(0.0);
    }
    /// Its normal, turned to the side of the rest of its component if it is flipped.
    Vec3 side(Index p) const { return sides.flipped[p] ? -normal[p] : normal[p]; }
    double distance(Index p, Index q) const;
};

/// The sides of a file whose other members are filled in.
Sides sidesOf(const ExaminedFile& examined);

/// Fails as examine() does.
Result<ExaminedFile> examineFile(const PointFile& file, const Progress& progress);

/// "1 point", "2 points".
std::string countText(std::size_t count, const std::string& noun);
/// A number with three digits, the same on every machine.
std::string shortNumber(double value);

/// A finding at these points (ascending), or nothing if there are none.
std::optional<Finding> findingAt(std::vector<Index> points, Severity severity,
                                 const std::string& text);

}  // namespace se
