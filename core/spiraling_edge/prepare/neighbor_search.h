/// What preparing points from a file and searching their neighbors share.
#pragma once

#include <glm/geometric.hpp>

#include "spiraling_edge/prepare/prepare.h"

namespace se {

/// A candidate for a list. Ordered by distance, ties by index: by this order lists are sorted.
struct Neighbor {
    double distanceSquared = 0.0;
    Index id = kNone;
    friend bool operator==(const Neighbor&, const Neighbor&) = default;
    friend bool operator<(const Neighbor& a, const Neighbor& b) {
        return a.distanceSquared < b.distanceSquared ||
               (a.distanceSquared == b.distanceSquared && a.id < b.id);
    }
};

/// From coordinate differences, in a fixed order: the same for (p, q) and (q, p), and the same
/// after a move by which no coordinate was rounded.
inline double distanceSquared(const Vec3& p, const Vec3& q) {
    const Vec3 d = q - p;
    return d.x * d.x + d.y * d.y + d.z * d.z;
}

/// Whether the surface at p and at q faces away from each other: then lists leave the pair out.
inline bool normalsOppose(const Vec3& p, const Vec3& q) { return glm::dot(p, q) <= 0.0; }

/// Puts the list of point p in order, and drops entries that stand in it twice. Requires finite
/// positions.
void sortNearestFirst(std::span<const Vec3> position, Index p, std::vector<Index>& list);

/// Fails if k is 0 or the radius is not positive.
Status checkReach(const NeighborOptions& options);

}  // namespace se
