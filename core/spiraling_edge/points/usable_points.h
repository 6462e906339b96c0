/// Points of a file that the algorithm can use, and those that a mesh uses; removal of the others.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/points/point_file.h"

namespace se {

/// A reason to set points aside: its name, as in JSON, its words after a number of points, and as a
/// clause about one; that of a copy ends before the number of the other point.
struct AsideWords {
    Aside reason;
    std::string_view name;
    std::string_view words;
    std::string_view clause;
};
/// All but Aside::No, in the order of Aside.
std::span<const AsideWords> asideReasons();
/// The words of one reason. Requires one that is not Aside::No.
const AsideWords& wordsOf(Aside reason);

/// The reason why a point was set aside, as a sentence: "Point 5 was set aside before the run:
/// it is a copy of point 2." Requires one that was.
std::string asideText(const PointSet& points, Index p);

/// The points that no run can use, by positions alone.
struct PlacedPoints {
    std::vector<Aside> aside;  ///< NotFinite, Copy, Sentinel (markSentinels()), or No.
    /// For each point the first at its position; kNone if that is not finite, or a sentinel's.
    std::vector<Index> original;
};
/// Expected O(points).
PlacedPoints placedPoints(std::span<const Vec3> position, FarValues farValues = FarValues::Missing);
/// True for the reasons of placedPoints().
inline bool isUnusable(Aside aside) {
    return aside == Aside::NotFinite || aside == Aside::Copy || aside == Aside::Sentinel;
}
/// Number of distinct finite positions. O(points).
std::size_t countPlaces(std::span<const Vec3> position);

/// True if a normal has a direction: it is finite and not zero.
inline bool hasDirection(const Vec3& normal) { return isFinite(normal) && normal != Vec3(0.0); }

/// Scales `normal` to unit length; one without direction is unchanged. True if its length was off
/// by more than 1e-3: smaller errors come from rounded numbers in a file.
bool scaleToUnit(Vec3& normal);

/// Adds the direction of `normal` to unit vectors, unless it has none, or one of them is the same.
void addDirection(std::vector<Vec3>& directions, Vec3 normal);
/// The unit vector in the mean of several; the first where they cancel out. Requires one.
Vec3 meanOfDirections(const std::vector<Vec3>& directions);
/// The mean as above; adds 1 to `averaged` if there are several, and it is not the first of them.
Vec3 meanOfDirections(const std::vector<Vec3>& directions, std::size_t& averaged);
/// "12 places with several normals: the mean of them is used"; empty for none.
std::string averagedText(std::size_t places);

/// Fails if the columns of the file differ in length, the offsets do not divide the lists, or
/// there are too many points for an Index.
Status checkColumns(const PointFile& file);

/// The points of `points` that are in a triangle, in their order, with their normals, types,
/// attributes and neighbor lists; list entries for other points are dropped. `faces` of the result
/// are `triangles`, in their order, with the new indices. Requires triangles that name existing
/// points and columns of equal length. O(points + list entries + triangles).
PointFile withUsedPoints(const PointFile& points, std::span<const Triangle> triangles);
/// For each of `points` points: true if it is in a triangle. Requires triangles that name them.
std::vector<bool> usedPoints(std::size_t points, std::span<const Triangle> triangles);
/// Number of points that are in a triangle. Requires triangles that name points below `points`.
std::size_t countUsedPoints(std::size_t points, std::span<const Triangle> triangles);

/// Keeps the marked rows of all columns; neighbor lists and faces stay as they are.
void keepColumns(PointFile& file, const std::vector<bool>& keep);
/// The index of each kept point among those kept, kNone for the others.
std::vector<Index> keptNumbers(const std::vector<bool>& keep);
/// The lists of the kept points, in their order, without the entries that are not kept. `number` is
/// the result of keptNumbers().
NeighborLists keptLists(const NeighborLists& lists, const std::vector<Index>& number);

}  // namespace se
