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

#include "spiraling_edge/point_set.h"
#include "spiraling_edge/result.h"

namespace se {

/// The scalar types of PLY.
enum class ScalarType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

/// A per-point column that the algorithm does not use but that output must keep.
struct Attribute {
    std::string name;
    ScalarType type = ScalarType::Float;
    std::vector<double> values;  ///< One per point; every ScalarType fits a double exactly.
};

/// How the columns of a file that has no header for them (XYZ) were read.
struct ColumnReading {
    std::string names;   ///< "x y z red green blue"; empty for other formats.
    std::string reason;  ///< The evidence, in words; empty for x, y and z alone.
};

/// What a point file held, as it stood there: nothing repaired, nothing normalized, nothing
/// dropped. `prepare.h` turns it into a PointSet that the stepper accepts.
struct PointFile {
    std::vector<Vec3> position;
    /// Float or Double: how positions are written, so that no digit is lost. Text formats without
    /// types and PLY with other scalar types read as Double.
    ScalarType positionType = ScalarType::Float;
    std::vector<Vec3> normal;                   ///< Empty where the file has none.
    ScalarType normalType = ScalarType::Float;  ///< As positionType.
    std::vector<std::uint8_t> type;             ///< Empty where the file has none.
    NeighborLists neighbors;                    ///< size() == 0 where the file has none.
    std::vector<Triangle> faces;  ///< Polygons are split into fans. Empty for plain points.
    std::vector<Attribute> attributes;
    ColumnReading columns;

    bool hasNormals() const { return !normal.empty(); }
    bool hasTypes() const { return !type.empty(); }
    bool hasNeighbors() const { return neighbors.size() > 0; }
};

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
