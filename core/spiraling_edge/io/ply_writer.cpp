// PLY: a header of the point's columns, then rows, in text or binary.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/scalars.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {
namespace {

using namespace io;

/// The name under which types are written (docs/file-formats.md says why it begins with "scalar").
constexpr std::string_view kTypeName = "scalar_se_type";
/// Read as types where there is no kTypeName, so that no other column may have this name there.
constexpr std::string_view kOldTypeName = "se_type";

/// `value` as `Scalar`; out of range of an integer type, the nearest value that it can hold.
template <typename Scalar>
Scalar toScalar(double value) {
    if constexpr (std::is_integral_v<Scalar>) {
        using Limits = std::numeric_limits<Scalar>;
        if (std::isnan(value)) return 0;
        return static_cast<Scalar>(std::clamp(value, static_cast<double>(Limits::lowest()),
                                              static_cast<double>(Limits::max())));
    } else {
        return static_cast<Scalar>(value);
    }
}

/// One scalar of the vertex element.
struct OutColumn {
    std::string name;
    ScalarType type;
    const double* first;
    std::size_t stride;
};

bool canNameProperty(const std::string& name) {
    return !name.empty() &&
           std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c != '\x7f'; });
}

/// All columns but the type, in the order in which they are written.
std::vector<OutColumn> columnsOf(const PointFile& points) {
    std::vector<OutColumn> columns;
    const auto addVectors = [&](const std::vector<Vec3>& vectors, ScalarType type, const char* x,
                                const char* y, const char* z) {
        const double* first = vectors.empty() ? nullptr : &vectors.front().x;
        for (const char* name : {x, y, z}) {
            columns.push_back({name, type, first, 3});
            if (first != nullptr) ++first;
        }
    };
    addVectors(points.position, points.positionType, "x", "y", "z");
    if (points.hasNormals()) addVectors(points.normal, points.normalType, "nx", "ny", "nz");
    for (const Attribute& attribute : points.attributes) {
        const bool taken =
            attribute.name == kTypeName || (!points.hasTypes() && attribute.name == kOldTypeName) ||
            std::any_of(columns.begin(), columns.end(),
                        [&](const OutColumn& c) { return c.name == attribute.name; });
        if (taken || !canNameProperty(attribute.name)) continue;
        columns.push_back({attribute.name, attribute.type, attribute.values.data(), 1});
    }
    return columns;
}

/// The type of the length of a list: two bytes for short lists, the usual case.
ScalarType neighborCountType(const NeighborLists& lists) {
    for (Index p = 0; p < lists.size(); ++p) {
        if (lists[p].size() > std::numeric_limits<std::uint16_t>::max()) return ScalarType::UInt32;
    }
    return ScalarType::UInt16;
}

std::string headerText(const PointFile& points, const std::vector<OutColumn>& columns,
                       std::size_t triangleCount) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment written by spiraling-edge\n";
    const std::string count = std::to_string(points.position.size());
    text += "element vertex " + count + '\n';
    for (const OutColumn& column : columns) {
        text += "property " + std::string(nameOf(column.type)) + ' ' + column.name + '\n';
    }
    if (points.hasTypes()) text += "property uchar " + std::string(kTypeName) + '\n';
    // Programs expect int here; uint has the same size for larger numbers.
    const bool fitsInt = points.position.size() <= std::numeric_limits<std::int32_t>::max();
    text += "element face " + std::to_string(triangleCount) + "\nproperty list uchar " +
            (fitsInt ? "int" : "uint") + " vertex_indices\n";
    if (points.hasNeighbors()) {
        text += "element se_neighbors " + count + "\nproperty list " +
                std::string(nameOf(neighborCountType(points.neighbors))) + " uint id\n";
    }
    return text + "end_header\n";
}

/// Writes column by column into rows, so that the scalar's type is looked up once per column.
void appendPoints(const PointFile& points, const std::vector<OutColumn>& columns,
                  std::string& bytes) {
    std::size_t rowSize = points.hasTypes() ? 1 : 0;
    for (const OutColumn& column : columns) rowSize += sizeOf(column.type);
    const std::size_t count = points.position.size();
    const std::size_t begin = bytes.size();
    bytes.resize(begin + rowSize * count);
    char* first = bytes.data() + begin;
    for (const OutColumn& column : columns) {
        withScalar(column.type, [&](auto zero) {
            for (std::size_t row = 0; row < count; ++row) {
                storeScalar(first + row * rowSize,
                            toScalar<decltype(zero)>(column.first[row * column.stride]));
            }
        });
        first += sizeOf(column.type);
    }
    for (std::size_t row = 0; row < points.type.size(); ++row) {
        storeScalar(first + row * rowSize, points.type[row]);
    }
}

void appendTriangles(std::span<const Triangle> triangles, std::string& bytes) {
    constexpr std::size_t kRowSize = 1 + 3 * sizeof(Index);
    const std::size_t begin = bytes.size();
    bytes.resize(begin + kRowSize * triangles.size());
    char* at = bytes.data() + begin;
    for (const Triangle& triangle : triangles) {
        at = storeScalar(at, std::uint8_t{3});
        for (const Index corner : {triangle.a, triangle.b, triangle.c})
            at = storeScalar(at, corner);
    }
}

void appendNeighbors(const NeighborLists& lists, std::string& bytes) {
    const ScalarType countType = neighborCountType(lists);
    const std::size_t begin = bytes.size();
    bytes.resize(begin + lists.size() * sizeOf(countType) + lists.ids.size() * sizeof(Index));
    char* at = bytes.data() + begin;
    for (Index p = 0; p < lists.size(); ++p) {
        const auto count = static_cast<double>(lists[p].size());
        at = withScalar(
            countType, [&](auto zero) { return storeScalar(at, toScalar<decltype(zero)>(count)); });
        for (const Index id : lists[p]) at = storeScalar(at, id);
    }
}

}  // namespace

Status io::checkWritable(const PointFile& points, std::span<const Triangle> triangles) {
    const std::size_t count = points.position.size();
    const bool same = checkColumns(points).ok() &&
                      std::all_of(points.attributes.begin(), points.attributes.end(),
                                  [&](const Attribute& a) { return a.values.size() == count; });
    if (!same) return Error{"the columns of the points to be written differ in length"};
    if (cornersBelow(triangles, count)) return success();
    return Error{"a triangle to be written names a point that does not exist"};
}

std::string meshPlyBytes(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkWritable(points, triangles).ok());
    const std::vector<OutColumn> columns = columnsOf(points);
    std::string bytes = headerText(points, columns, triangles.size());
    appendPoints(points, columns, bytes);
    appendTriangles(triangles, bytes);
    if (points.hasNeighbors()) appendNeighbors(points.neighbors, bytes);
    return bytes;
}

Status writeMeshPly(const std::filesystem::path& path, const PointFile& points,
                    std::span<const Triangle> triangles) {
    if (const Status status = checkWritable(points, triangles); !status) {
        return Error{path.string() + ": " + status.error().message};
    }
    return writeFileAtomically(path, meshPlyBytes(points, triangles));
}

}  // namespace se
