/// The writers of the formats in write_mesh.h, one function each. All expect input that passes
/// checkWritable().
#pragma once

#include <optional>

#include "spiraling_edge/io/read_points.h"

namespace se::io {

/// Points, normals where there are any, triangles; numbers that read back exactly.
std::string objBytes(const PointFile& points, std::span<const Triangle> triangles);
/// Plain OFF, which every program reads: no normals.
std::string offBytes(const PointFile& points, std::span<const Triangle> triangles);
/// NOFF, with the normals; plain OFF where the points have none.
std::string noffBytes(const PointFile& points, std::span<const Triangle> triangles);
/// Binary: three corners per triangle, as float, relative to floatShift(), which the header names.
std::string stlBytes(const PointFile& points, std::span<const Triangle> triangles);
/// Binary glTF 2.0. Positions are floats relative to the center of the box, which is the
/// translation of the node, so that a set far from the origin keeps its shape.
std::string glbBytes(const PointFile& points, std::span<const Triangle> triangles);

/// `value` rounded to float.
double asFloat(double value);
/// An origin with few digits near the center of the triangles, for positions written as float
/// relative to it. Empty where no corner moves by more than a thousandth of the mean edge without
/// it, or where it would not help.
std::optional<Vec3> floatShift(const PointFile& points, std::span<const Triangle> triangles);

/// Fails for input whose file could not be read back: columns of different length, a triangle that
/// names a nonexistent point.
Status checkWritable(const PointFile& points, std::span<const Triangle> triangles);

}  // namespace se::io
