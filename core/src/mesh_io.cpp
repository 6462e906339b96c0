#include "spiraling_edge/mesh_io.h"

#include <algorithm>
#include <array>

#include "extension.h"
#include "mesh_io_formats.h"
#include "spiraling_edge/atomic_file.h"

namespace se {
namespace {

constexpr std::array kFormats{
    MeshFormat{".ply", "PLY, binary", "", meshPlyBytes},
    MeshFormat{".obj", "Wavefront OBJ, text", "types, lists, other columns", io::objBytes},
    MeshFormat{".off", "OFF or NOFF, text", "types, lists, other columns", io::offBytes},
    MeshFormat{".stl", "STL, binary", "all but the corners of triangles", io::stlBytes},
    MeshFormat{".glb", "glTF 2.0, binary", "types, lists, other columns; digits beyond float",
               io::glbBytes},
};

}  // namespace

std::span<const MeshFormat> meshFormats() { return kFormats; }

const MeshFormat* meshFormatOf(const std::filesystem::path& path) {
    const std::string extension = lowerExtension(path);
    if (extension.empty()) return kFormats.data();
    const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                    [&](const MeshFormat& f) { return f.extension == extension; });
    return found == kFormats.end() ? nullptr : &*found;
}

Status writeMesh(const std::filesystem::path& path, const PointFile& points,
                 std::span<const Triangle> triangles) {
    const MeshFormat* format = meshFormatOf(path);
    if (format == nullptr) {
        std::string known;
        for (const MeshFormat& each : kFormats) {
            known += (known.empty() ? "" : " ") + std::string(each.extension);
        }
        return Error{path.string() + ": a mesh can be written as " + known +
                     "; choose one of these extensions"};
    }
    if (const Status status = io::checkWritable(points, triangles); !status) {
        return Error{path.string() + ": " + status.error().message};
    }
    return writeFileAtomically(path, format->bytes(points, triangles));
}

}  // namespace se
