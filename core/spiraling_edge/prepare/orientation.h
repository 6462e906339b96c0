/// Orientation of normals to a common side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/geometry/renumbering.h"
#include "spiraling_edge/points/point_set.h"

namespace se {

/// The side of a component that is known neither from its shape nor from a scanner.
enum class UnknownSide : std::uint8_t {
    ByVote,  ///< The majority of its votes, few as they may be: normals on either side.
    AsMost,  ///< The side of most of its normals: normals from a file.
};

/// Options of orientNormals().
struct OrientationOptions {
    UnknownSide unknown = UnknownSide::ByVote;
    /// Position of the scanner, finite; components face it. Nothing: they face outward.
    std::optional<Vec3> scanner{};
    /// Place of the sensor that a file names, finite; components whose shape tells no side face it.
    std::optional<Vec3> viewpoint{};
    unsigned threads = 0;  ///< As in NeighborOptions; the result is the same for any.
};

/// The result of orientNormals().
struct OrientationReport {
    std::size_t turned = 0;      ///< Normals that changed sides.
    std::size_t components = 0;  ///< Parts without a list entry from one to another.
    /// Of these: open sheets, and others of which no side is outward by its shape (facing.h). Their
    /// normals agree, but may all face the wrong way.
    std::size_t unknownSides = 0;
};

/// Turns normals so that neighbors agree, along the minimum spanning tree of each component of the
/// lists, cheapest where normals agree best (Riemannian graph; Hoppe et al. 1992, section 3.3). Two
/// are compared after one is mirrored at the plane halfway between the points (Xie et al. 2003),
/// which holds across creases and thin parts, where Hoppe's plain cosine turns whole patches
/// (docs/choices.md). If over 1 % of the list entries then disagree, as in layers less than a
/// spacing apart, a tree that avoids steep edges is tried too, and taken if it leaves 57 % of the
/// disagreement or less, unless only the first makes a body. Each component is then turned as a
/// whole, so that it faces outward, or toward the scanner, by the votes of facing.h. Lists need not
/// be symmetric. Points with a zero normal are left out. Deterministic: ties by index. Scattered
/// points (areScattered()) are renumbered for the time of the work, with the same result. Fails if
/// `progress` cancels; then no normal has been turned.
Result<OrientationReport> orientNormals(std::span<const Vec3> position,
                                        const NeighborLists& neighbors, std::vector<Vec3>& normal,
                                        const OrientationOptions& options = {},
                                        const Progress& progress = {});

/// orientNormals() for points whose normals are in the order of their new numbers.
Result<OrientationReport> orientNormals(const OrderedPoints& points, std::vector<Vec3>& normal,
                                        const OrientationOptions& options = {},
                                        const Progress& progress = {});

}  // namespace se
