/// Conversion of a file's content to the input of the stepper: normals, types and neighbor lists
/// derived where absent or requested, unusable points set aside, lists cleaned (docs/choices.md,
/// "Input").
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/points/wall_types.h"

namespace se {

/// The k nearest points.
struct KNearest {
    std::size_t k = 12;
    friend bool operator==(const KNearest&, const KNearest&) = default;
};
/// All points not farther than `radius`, in scene units.
struct WithinRadius {
    double radius = 0.0;
    friend bool operator==(const WithinRadius&, const WithinRadius&) = default;
};
/// All points not farther than `spacings` times the mean distance of a point to its nearest
/// neighbor, as for particles that repel each other within a radius (§3 and §6.4, "search range";
/// docs/performance.md).
struct WithinSpacings {
    double spacings = 1.6;
    friend bool operator==(const WithinSpacings&, const WithinSpacings&) = default;
};

/// Options of the computation of neighbor lists.
struct NeighborOptions {
    std::variant<KNearest, WithinRadius, WithinSpacings> reach = KNearest{};
    /// Leave out points whose normal opposes (normalsOppose()), before the k nearest are taken.
    /// The paper is silent; without it, sheets that come close are joined. The search for the k
    /// nearest examines only the first 8 k + 64 points, so that a flipped normal amid thousands of
    /// others gets a short list instead of a search through all points.
    bool dropOpposingNormals = true;
    /// Number of threads; 0: as many as the machine has. The result is the same for any.
    unsigned threads = 0;
    /// Compute lists even if the file has some.
    bool recompute = false;
    /// Makes lists symmetric (symmetricLists).
    bool symmetric = false;
    /// Cosine of the angle from which normals oppose; a right one.
    double opposingCosine = 0.0;
    friend bool operator==(const NeighborOptions&, const NeighborOptions&) = default;
};

/// Source of normals.
enum class NormalSource : std::uint8_t {
    AsGiven,   ///< From the file; derived if it has none.
    Oriented,  ///< From the file, turned to agree with each other; derived if it has none.
    Derived,   ///< From the positions, even if the file has some.
};

/// Options of prepare().
struct PrepareOptions {
    NeighborOptions neighbors;
    NormalSource normals = NormalSource::AsGiven;
    /// Derived normals are those of the planes nearest to this many neighbors.
    std::size_t planeNeighbors = 12;
    /// Derived and oriented normals face this position, component by component (facing.h). Nothing:
    /// they face outward.
    std::optional<Vec3> scanner{};
    /// Types are those of the walls of this box, even if the file has some.
    std::optional<WallBox> walls{};
    /// Rim points are those that findRim() finds (rim.h), even if the file has some.
    bool rim = false;
    /// Where lists are computed and noise along the normals exceeds kNoisy, points are set aside
    /// and normals averaged (setNoiseAside(), noise.h) until it does not.
    bool setNoiseAside = false;
    /// Points far from all others (strayPoints(), strays.h) are set aside before anything is
    /// derived.
    bool setStraysAside = false;
    /// Points to set aside at the user's request, ascending.
    std::vector<Index> leaveOut = {};
};

/// The derived pieces and their costs: the answer to "quantify the costs" of the paper's last
/// paragraph. Seconds are 0 for pieces that were not derived.
struct DerivedPieces {
    bool normals = false;
    bool orientation = false;
    bool types = false;
    bool rim = false;                  ///< Rim points were found, or those of the file dropped.
    std::size_t turnedNormals = 0;     ///< Sides changed by the orientation.
    std::size_t normalComponents = 0;  ///< Parts that were oriented independently.
    std::size_t unknownSides = 0;      ///< Of these: OrientationReport::unknownSides.
    /// Of points whose given normals have no direction, beside others that have: completeNormals().
    std::size_t completedNormals = 0;
    std::size_t rimPoints = 0;
    std::size_t rimChains = 0;   ///< Closed, one per opening.
    double normalSeconds = 0.0;  ///< Including the search for the neighbors that they need.
    double orientationSeconds = 0.0;
    double typeSeconds = 0.0;
    double rimSeconds = 0.0;
    double neighborSeconds = 0.0;  ///< PrepareReport::neighborsComputed.
};

/// "which side faces out is unknown", or "... is unknown for 1 of 2 parts".
std::string unknownSidesText(std::size_t unknown, std::size_t parts);

/// The points and list entries that were set aside, by reason. The points stay in the set, with
/// their index, but have an empty list and are in no list.
struct PrepareReport {
    std::array<std::size_t, kAsides> aside{};  ///< Number of points by Aside.
    /// Normals whose length was off by more than 1e-3. Smaller errors, as of rounded numbers in a
    /// file, are corrected without mention.
    std::size_t unscaledNormals = 0;
    /// Of points with copies that have other normals, and take the mean: averageOverCopies().
    std::size_t averagedNormals = 0;
    std::size_t droppedListEntries =
        0;  ///< In lists from the file: self, repeated, unusable, opposing.
    bool neighborsComputed = false;
    double noise = 0.0;  ///< noiseAlongNormals() before any point was set aside; 0: not measured.
    DerivedPieces derived;  ///< Derived pieces other than lists.

    /// The number of points that were set aside for this reason.
    std::size_t count(Aside reason) const { return aside[static_cast<std::size_t>(reason)]; }
    /// The number of points that were set aside.
    std::size_t countAside() const;
};

struct Prepared {
    PointSet points;
    PrepareReport report;
};

/// Coordinates of most points must not be greater, in magnitude.
inline constexpr double kGreatestCoordinate = 1e152;
/// Most points must have one that is not smaller, in magnitude; the origin may be among them.
inline constexpr double kLeastCoordinate = 1e-162;

/// Makes a PointSet: it passes validate(), positions are those of the file, and lists from the file
/// are put in order and cleaned. Fails if k is 0, if the radius is not positive or the scanner not
/// finite, if a list names a point that does not exist, if most points are beyond
/// kGreatestCoordinate or within kLeastCoordinate, or if cancelled. Neighbor lists are ordered
/// by distance, ties by index: the result does not depend on the search method. Requires `leaveOut`
/// to name existing points.
Result<Prepared> prepare(const PointFile& file, const PrepareOptions& options,
                         const Progress& progress = {});
/// Stores in `file` the normals and types that prepare() has derived, so that a mesh is written
/// with those it was made from. Unchanged given ones, and neighbor lists, are not touched. `points`
/// and `report` are the result of prepare() for `file`.
void storeDerived(const PointSet& points, const PrepareReport& report, PointFile& file);
/// Prepared points as a file from which the same are prepared: with their lists, in double.
PointFile fileOf(const PointSet& points);
/// The ordered lists alone, for points with usable[p] true; all others get an empty list and are in
/// none. Requires finite usable positions. Points at the same place are no neighbors of each other,
/// nor are points so far apart (1e154) that the square of their distance is no number. `normal` may
/// be empty if opposing normals are not dropped. Deterministic: ordered by distance, ties by index,
/// and unchanged if all points are moved without rounding.
Result<NeighborLists> findNeighbors(std::span<const Vec3> position, std::span<const Vec3> normal,
                                    const std::vector<bool>& usable, const NeighborOptions& options,
                                    const Progress& progress = {});

/// Symmetric lists: for each entry q in the list of p, also p in the list of q. Where the spacing
/// changes, points of the sparse side list some that do not list them. Ordered by distance, ties by
/// index. Of each list the first `most` entries count. Fails if there would be more entries than an
/// Index counts. `threads` as in NeighborOptions; the result is the same for any. Fails if
/// cancelled.
Result<NeighborLists> symmetricLists(std::span<const Vec3> position, const NeighborLists& lists,
                                     unsigned threads = 0, const Progress& progress = {},
                                     std::size_t most = kNone);

}  // namespace se
