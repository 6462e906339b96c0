/// The overlap of a possible triangle with finished ones, seen along the pivot's normal.
#pragma once

#include "disc.h"

namespace se::view {

/// A triangle that is not made, and its parts that lie on finished triangles.
struct Overlap {
    std::vector<std::vector<glm::vec3>> parts;  ///< Convex, in the plane of the triangle.
    std::vector<Triangle> covered;              ///< Those finished triangles.
    float share = 0.0F;                         ///< Of its area; slivers do not count.
    glm::vec3 middle{0.0F};                     ///< Of the parts.
};

Overlap overlapOf(const LayerInput& in, const Disc& disc, const Triangle& wouldBe);

/// Filled and hatched in the color of errors.
void addOverlap(const LayerInput& in, const Overlap& overlap, DrawList& out);

}  // namespace se::view
