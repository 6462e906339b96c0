/// Scalar fields over a box, whose isosurfaces can be sampled (sampler.h): shapes given by a
/// formula here, measured volumes in volume.h.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// The side of an isosurface that counts as outside, to which normals point.
enum class Outside : std::uint8_t {
    LowerValues,   ///< For a density: normals are minus the gradient.
    HigherValues,  ///< For a distance: normals follow the gradient.
};

/// A continuous function in a box and the isovalue of its surface.
struct Field {
    /// Defined everywhere in the box.
    std::function<double(const Vec3&)> value;
    /// Gradient of the value, or of a smoothed one: normals follow it. Never called outside the
    /// box.
    std::function<Vec3(const Vec3&)> gradient;
    /// The domain. Its faces are the walls that cut the surface (§7).
    Vec3 low{0.0}, high{0.0};
    double isovalue = 0.0;
    Outside outside = Outside::LowerValues;
    /// Cells along each axis in the search for the surface: a part within a single cell, with all
    /// corners on one side, may be missed.
    glm::ivec3 cells{96};

    /// Unit normal on the outer side; zero where the gradient has no direction.
    Vec3 normal(const Vec3& x) const;
};

/// `field` restricted to the box from `low` to `high`, with cells as small as before, at most 1024
/// along an axis. Requires low < high, and that the field is defined in all of that box.
Field inBox(Field field, const Vec3& low, const Vec3& high);

/// A named implicit surface.
struct Shape {
    std::string_view id;     ///< As on the command line: `two-tori`.
    std::string_view title;  ///< For display.
    double (*value)(const Vec3&);
    Vec3 (*gradient)(const Vec3&);
    Vec3 low, high;
    double isovalue;
    Outside outside;
};

/// All shapes. A new one is a value, a gradient and a row.
std::span<const Shape> shapes();
/// Null if there is none of that id.
const Shape* findShape(std::string_view id);
/// The field of a shape, in its own box.
Field fieldOf(const Shape& shape);

}  // namespace se
