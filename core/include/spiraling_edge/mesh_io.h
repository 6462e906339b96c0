/// Writing meshes for other programs, in the kind that the extension names (docs/file-formats.md).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "spiraling_edge/io.h"

namespace se {

/// One kind of file that a mesh can be written as.
struct MeshFormat {
    std::string_view extension;  ///< ".obj", lower case
    std::string_view title;      ///< "Wavefront OBJ, text"
    /// What it leaves out, for a person; empty if nothing.
    std::string_view leavesOut;
    /// The bytes of a file. Requires triangles that name existing points.
    std::string (*bytes)(const PointFile& points, std::span<const Triangle> triangles);
};

/// PLY (binary), OBJ, OFF, STL (binary), GLB.
std::span<const MeshFormat> meshFormats();
/// The one of a path's extension, whatever the case; PLY if it has none. Null if nothing fits.
const MeshFormat* meshFormatOf(const std::filesystem::path& path);

/// Writes points and triangles in the format that the extension of `path` names. Fails where
/// writeMeshPly() does, and with the extensions that can be written if it is none of them.
Status writeMesh(const std::filesystem::path& path, const PointFile& points,
                 std::span<const Triangle> triangles);

}  // namespace se
