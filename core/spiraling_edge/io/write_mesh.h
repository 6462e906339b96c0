/// Writers of points and meshes: PLY, and for other programs the format that the extension names
/// (docs/file-formats.md). No writer leaves a partial file (atomic_file.h). Formats of both tables
/// as text for options and messages: "PLY, OBJ or OFF".
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/read_points.h"

namespace se {

/// The bytes of a file. Requires triangles that name existing points.
using MeshBytes = std::string (*)(const PointFile& points, std::span<const Triangle> triangles);

/// A file format that a mesh can be written in.
struct MeshFormat {
    std::string_view name;       ///< "OBJ"
    std::string_view extension;  ///< ".obj", lower case
    std::string_view title;      ///< "Wavefront OBJ, text"
    /// The content it leaves out, for display; empty if none.
    std::string_view leavesOut;
    MeshBytes bytes;
    /// The bytes with the normals of the points: `bytes` itself where it writes them anyway, null
    /// where the format has no place for them.
    MeshBytes bytesWithNormals;
    /// The origin of the positions in the file, which a reader adds; empty if they are those of
    /// `points`. Null where the format needs no shift, or stores it.
    std::optional<Vec3> (*shift)(const PointFile& points, std::span<const Triangle> triangles);
    /// The greatest coordinate, in magnitude, that the format can hold.
    double greatest = std::numeric_limits<double>::max();
    bool loosePoints = true;  ///< Points in no triangle are kept.
};

/// Options of a writer besides the extension.
struct WriteOptions {
    /// Normals also where the usual kind of file has none: NOFF, which fewer programs read than
    /// OFF. No effect where they are written anyway; an error where they cannot be.
    bool normals = false;
};

/// PLY (binary), OBJ, OFF, STL (binary), GLB.
std::span<const MeshFormat> meshFormats();
/// The format of a path's extension, in upper or lower case; PLY if it has none. Null if no format
/// fits.
const MeshFormat* meshFormatOf(const std::filesystem::path& path);
/// True if files of this format hold the attributes of the points.
inline bool keepsColumns(const MeshFormat& format) { return format.leavesOut.empty(); }
/// True if points without triangles can be written in this format, and read again.
inline bool keepsPoints(const MeshFormat& format) { return format.loosePoints; }

/// True for every format.
inline constexpr auto kAllFormats = [](const auto&) { return true; };
/// Names or extensions (`text`) of the formats that `keeps` is true for, as wordList() joins them:
/// listText(pointFormats(), &PointFormat::name, "or", &PointFormat::faces).
template <typename Format, typename Keeps = decltype(kAllFormats)>
std::string listText(std::span<const Format> formats, std::string_view Format::*text,
                     std::string_view conjunction, Keeps keeps = kAllFormats) {
    std::vector<std::string_view> words;
    for (const Format& each : formats) {
        if (std::invoke(keeps, each)) words.push_back(each.*text);
    }
    return wordList(words, conjunction);
}

/// The shift of `format` for this mesh: empty where positions in the file are those of `points`.
std::optional<Vec3> shiftOf(const MeshFormat& format, const PointFile& points,
                            std::span<const Triangle> triangles);
/// Text of a shift, with all its digits: "(500000, 5400000, 300)".
std::string shiftText(const Vec3& shift);

/// Writes points and triangles in the format that the extension of `path` names. Fails where
/// writeMeshPly() does, and with the extensions that can be written if it is none of them.
/// Positions in STL may be relative to shiftOf(), which callers should show to their users.
Status writeMesh(const std::filesystem::path& path, const PointFile& points,
                 std::span<const Triangle> triangles, const WriteOptions& options = {});

/// Writes `points` (all of them, in order, with their attributes) and `triangles` as binary little
/// endian PLY; `points.faces` are not written unless passed as `triangles`. Types and neighbor
/// lists are written if the file holds them. Fails also if the columns of `points` differ in length
/// or a triangle names a point that does not exist. Attributes are left out if their name is that
/// of an own property or is not allowed in a header (empty, or with blanks).
Status writeMeshPly(const std::filesystem::path& path, const PointFile& points,
                    std::span<const Triangle> triangles);
/// The bytes that writeMeshPly() writes. Requires columns of equal length and triangles that name
/// existing points.
std::string meshPlyBytes(const PointFile& points, std::span<const Triangle> triangles);

}  // namespace se
