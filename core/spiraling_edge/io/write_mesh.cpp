#include "spiraling_edge/io/write_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/io/formats.h"

namespace se {
namespace {

constexpr double kGreatestDouble = std::numeric_limits<double>::max();
constexpr double kGreatestFloat = std::numeric_limits<float>::max();

constexpr std::array kFormats{
    MeshFormat{"PLY", ".ply", "PLY, binary", "", meshPlyBytes, meshPlyBytes, nullptr},
    MeshFormat{"OBJ", ".obj", "Wavefront OBJ, text", "types, lists, other columns", io::objBytes,
               io::objBytes, nullptr},
    MeshFormat{"OFF", ".off", "OFF, text", "normals, types, lists, other columns", io::offBytes,
               io::noffBytes, nullptr},
    MeshFormat{"STL", ".stl", "STL, binary", "all but the corners of triangles", io::stlBytes,
               nullptr, io::floatShift, kGreatestFloat, false},
    MeshFormat{"GLB", ".glb", "glTF 2.0, binary",
               "types, lists, other columns; digits beyond float", io::glbBytes, io::glbBytes,
               nullptr, kGreatestFloat},
};

/// True if all finite coordinates stay finite in this format.
bool fits(const MeshFormat& format, std::span<const Vec3> positions) {
    return std::all_of(positions.begin(), positions.end(), [&](const Vec3& x) {
        for (int i = 0; i < 3; ++i) {
            if (std::isfinite(x[i]) && std::abs(x[i]) > format.greatest) return false;
        }
        return true;
    });
}

}  // namespace

std::span<const MeshFormat> meshFormats() { return kFormats; }

const MeshFormat* meshFormatOf(const std::filesystem::path& path) {
    const std::string extension = lowerExtension(path);
    if (extension.empty()) return kFormats.data();
    return rowWhere(kFormats, [&](const MeshFormat& f) { return f.extension == extension; });
}

std::optional<Vec3> shiftOf(const MeshFormat& format, const PointFile& points,
                            std::span<const Triangle> triangles) {
    return format.shift == nullptr ? std::nullopt : format.shift(points, triangles);
}

std::string shiftText(const Vec3& shift) { return "(" + plainNumbers(shift, ", ") + ")"; }

Status writeMesh(const std::filesystem::path& path, const PointFile& points,
                 std::span<const Triangle> triangles, const WriteOptions& options) {
    const auto fail = [&](const std::string& what) { return Error{path.string() + ": " + what}; };
    const MeshFormat* format = meshFormatOf(path);
    if (format == nullptr) {
        return fail("a mesh can be written as " +
                    listText(meshFormats(), &MeshFormat::extension, "or") +
                    "; choose one of these extensions");
    }
    if (const Status status = io::checkWritable(points, triangles); !status)
        return fail(status.error().message);
    if (!fits(*format, points.position)) {
        const auto holdsAll = [](const MeshFormat& f) { return f.greatest == kGreatestDouble; };
        return fail("a coordinate is too large for " + std::string(format->extension) +
                    "; choose " + listText(meshFormats(), &MeshFormat::extension, "or", holdsAll) +
                    ", or scale the points");
    }
    const MeshBytes bytes = options.normals ? format->bytesWithNormals : format->bytes;
    if (bytes == nullptr) {
        return fail(std::string(format->extension) +
                    " has no place for normals of points; choose another extension");
    }
    return writeFileAtomically(path, bytes(points, triangles));
}

}  // namespace se
