/// Reading points and writing meshes (docs/file-formats.md). The type of a file is found by its
/// content first, then by its extension. No reader returns a partial result, and no writer leaves
/// a partial file (atomic_file.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_file.h"

namespace se {

/// Reads PLY (ascii, binary little and big endian), XYZ (`x y z` with normals, colors, both or an
/// intensity), OBJ (`v`, `vn`, `f`), OFF/NOFF or PCD. Errors name the file and the line or byte,
/// what was expected and what to do.
Result<PointFile> readPoints(const std::filesystem::path& path);
/// The same from memory; `name` is what errors call it, and its extension is the second hint.
Result<PointFile> readPoints(std::string_view bytes, const std::string& name);

/// Points from standard input, read to its end; a second call finds nothing. Errors begin with
/// "standard input".
Result<PointFile> readStandardInput();

/// Writes `points` (all of them, in order, with their attributes) and `triangles` as binary little
/// endian PLY; `points.faces` are not written unless passed as `triangles`. Types and neighbor
/// lists are written if the file holds them. Fails also if the columns of `points` differ in length
/// or a triangle names a point that does not exist. Attributes whose name is taken by an own
/// property or cannot stand in a header (empty, or with blanks) are left out.
Status writeMeshPly(const std::filesystem::path& path, const PointFile& points,
                    std::span<const Triangle> triangles);
/// The bytes that writeMeshPly() writes. Requires what writeMeshPly() checks.
std::string meshPlyBytes(const PointFile& points, std::span<const Triangle> triangles);

}  // namespace se
