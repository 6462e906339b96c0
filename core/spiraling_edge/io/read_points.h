/// Reading points of any format (docs/file-formats.md); write_mesh.h writes them. The type of a
/// file is found by its content first, then by its extension. No reader returns a partial result.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_file.h"

namespace se {

namespace io {
struct FileStart;
}

/// A file format that points can be read from.
struct PointFormat {
    std::string_view name;     ///< "XYZ"
    std::string_view details;  ///< "ascii or binary", for display; may be empty.
    /// Lower case, the usual one first: ".xyz", ".txt".
    std::span<const std::string_view> extensions;
    bool faces;  ///< Files can have triangles.
    /// By the content; by the extension only where the content leaves it open. No two formats
    /// recognize the same file.
    bool (*recognizes)(const io::FileStart& start);
    /// The whole file, without a byte order mark; `name` is its name in errors.
    Result<PointFile> (*read)(std::string_view bytes, const std::string& name);
};

/// PLY (ascii, binary little and big endian), STL, GLB, LAS, PTX, XYZ (`x y z` with normals,
/// colors, both or an intensity), OBJ (`v`, `vn`, `f`), OFF/NOFF and PCD.
std::span<const PointFormat> pointFormats();
/// The format of a path's extension, in upper or lower case, before ".gz". Null if no format has
/// it.
const PointFormat* pointFormatOf(const std::filesystem::path& path);

/// A function that unpacks a gzip stream, to at most `limit` bytes. Its errors name the file. This
/// library has none of its own; that of `spiraling_edge::sampling` is unpackGzip().
using Unpack = Result<std::string> (*)(std::string_view packed, const std::string& name,
                                       const ByteLimit& limit);

/// Reads a file in one of the pointFormats(), also in UTF-16, with line ends of any kind, and
/// packed by gzip if there is an `unpack`. Errors name the file and the line or byte, what was
/// expected and what to do.
Result<PointFile> readPoints(const std::filesystem::path& path, const ByteLimit& limit = {},
                             Unpack unpack = nullptr);
/// Reads points from memory; `name` is the name in errors, and its extension is the second hint.
Result<PointFile> readPoints(std::string_view bytes, const std::string& name,
                             const ByteLimit& limit = {}, Unpack unpack = nullptr);

/// Points from standard input, read to its end; a second call finds nothing. Errors begin with
/// "standard input".
Result<PointFile> readStandardInput(const ByteLimit& limit = {}, Unpack unpack = nullptr);

}  // namespace se
