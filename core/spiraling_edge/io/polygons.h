/// Polygons of a file, cut into triangles.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se::io {

/// The polygons of a reader. A file may name corners before their positions, so a polygon becomes a
/// fan at first.
class Polygons {
  public:
    /// Appends the fan of a polygon around its first corner; none for fewer than three corners.
    void append(std::span<const Index> corners, std::vector<Triangle>& faces);
    /// Replaces the fans that have a triangle without area, or one that faces the other way, by
    /// ears: triangles of three consecutive corners with no other corner within. Polygons of
    /// over 1,000 corners stay fans, as do those without ears, which cross themselves. Requires
    /// the positions of all corners, and the list of faces that append() has filled. O(n^2) for a
    /// polygon of n corners, but for spirals.
    void cutConcave(std::span<const Vec3> position, std::vector<Triangle>& faces) const;

  private:
    /// The fan of a polygon with more than three corners in the list of faces.
    struct Fan {
        std::size_t first;
        std::size_t triangles;
    };
    std::vector<Fan> fans_;
};

}  // namespace se::io
