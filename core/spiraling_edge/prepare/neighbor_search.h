/// Order and distance of neighbors, shared by prepare() and findNeighbors().
#pragma once

#include <glm/geometric.hpp>

#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

/// A candidate for a list. Ordered by distance, ties by index, as in lists.
struct Neighbor {
    double distanceSquared = 0.0;
    Index id = kNone;
    friend bool operator==(const Neighbor&, const Neighbor&) = default;
    friend bool operator<(const Neighbor& a, const Neighbor& b) {
        return a.distanceSquared < b.distanceSquared ||
               (a.distanceSquared == b.distanceSquared && a.id < b.id);
    }
};

/// Squared distance, from coordinate differences in a fixed order: the same for (p, q) and (q, p),
/// and after a translation without rounding.
inline double distanceSquared(const Vec3& p, const Vec3& q) {
    const Vec3 d = q - p;
    return d.x * d.x + d.y * d.y + d.z * d.z;
}

/// True if the surface at p and at q faces in opposite directions, by normals that differ by the
/// angle of that cosine or more: then lists leave the pair out.
inline bool normalsOppose(const Vec3& p, const Vec3& q, double cosine) {
    return glm::dot(p, q) <= cosine;
}

/// A list shorter than this does not go round its point.
inline constexpr std::size_t kGoRound = 3;

/// The lists of the `count` nearest usable points, with any normals: findNeighbors().
Result<NeighborLists> nearestPoints(std::span<const Vec3> position, const std::vector<bool>& usable,
                                    std::size_t count, unsigned threads = 0,
                                    const Progress& progress = {});

/// Sorts the list of point p and drops repeated entries. Requires finite positions.
void sortNearestFirst(std::span<const Vec3> position, Index p, std::vector<Index>& list);

/// For each point, the points that list it: the inverse of the lists.
NeighborLists listersOf(const NeighborLists& lists);

/// Fails if k is 0 or the radius is not positive.
Status checkReach(const NeighborOptions& options);

}  // namespace se
