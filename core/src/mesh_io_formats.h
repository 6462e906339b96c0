/// The bytes of the formats of mesh_io.h, one function each. All require checked input.
#pragma once

#include "spiraling_edge/io.h"

namespace se::io {

/// Points, normals where there are any, triangles; numbers that read back exactly.
std::string objBytes(const PointFile& points, std::span<const Triangle> triangles);
/// OFF, or NOFF with normals.
std::string offBytes(const PointFile& points, std::span<const Triangle> triangles);
/// Binary: three corners per triangle, as float.
std::string stlBytes(const PointFile& points, std::span<const Triangle> triangles);
/// Binary glTF 2.0. Positions are floats about the middle of the box, which is the node's place, so
/// that a set far from the origin keeps its shape.
std::string glbBytes(const PointFile& points, std::span<const Triangle> triangles);

/// What would make a file that cannot be read back: columns of different length, a triangle that
/// names a point that does not exist.
Status checkWritable(const PointFile& points, std::span<const Triangle> triangles);

}  // namespace se::io
