/// A piece of a scan that is too large as a whole: the points in a box, thinned to a spacing; and
/// factors for its coordinates, where they have other units.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/points/point_file.h"

namespace se {

/// The choice of a piece, in the units of the file.
struct Piece {
    /// Only the points within this box, bounds included; points that are not finite are outside.
    std::optional<Box> crop;
    /// Above 0: of the points in the box, in their order, each that is not nearer than this to one
    /// kept before. Points that are not finite are all kept. 0: all points.
    double thin = 0.0;
    /// Factors of x, y and z, each above 0; applied last.
    Vec3 scale{1.0};
    FarValues farValues = FarValues::Missing;  ///< PointFile::farValues.

    /// True if it has all points of the file.
    bool isWhole() const { return !crop && thin == 0.0; }
    bool isScaled() const { return scale != Vec3(1.0); }
    friend bool operator==(const Piece&, const Piece&) = default;
};

/// Name of the column in which a piece holds the index of each point in its file.
inline constexpr std::string_view kIndexColumn = "index";

/// For each point: true if it is in the piece, by box and spacing. Requires finite and ordered
/// corners of the box, and a finite spacing that is not negative. Depends on nothing but the
/// arguments. Expected O(points), but for points farther than 2^54 spacings from the origin.
std::vector<bool> pointsIn(std::span<const Vec3> position, const Piece& piece);

/// The points of `file` in the piece, in their order, with their normals, types, attributes and
/// neighbor lists; entries of other points leave the lists, and only triangles whose corners are
/// all in the piece remain. A column `index` holds the index of each point in `file`, unless there
/// is one already; not for the whole file. Then its coordinates are scaled. Requires columns of
/// equal length, triangles that name existing points, and what pointsIn() requires.
PointFile pieceOf(PointFile file, const Piece& piece);
/// `file` with its positions and viewpoint multiplied by these factors, written as doubles. Normals
/// with a direction are divided by them and made unit vectors: so they stay perpendicular to the
/// surface. All else is kept. Requires finite factors above 0. O(points).
PointFile scaled(PointFile file, const Vec3& factors);
/// The marked points of `file`, with all that follows them as above. `keep` has a value for each.
PointFile keptPoints(PointFile file, const std::vector<bool>& keep);
/// pieceOf(). Fails if the box holds none of the points, with the box around them all; `name` is
/// that of the file in the message.
Result<PointFile> cutPiece(PointFile file, const Piece& piece, const std::string& name);

}  // namespace se
