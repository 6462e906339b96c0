// spiraling-edge-peer-tool: what the comparison needs besides the methods.
//   shape sphere|torus COUNT OUT.ply   an even cover, as the benchmarks use it
//   check MESH.ply                     faults of a mesh, as JSON
#include <cstdio>
#include <cstdlib>
#include <string>

#include "../shapes.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/mesh/mesh_report.h"

namespace {

int writeShape(const std::string& name, const std::string& count, const std::string& path) {
    const std::size_t points = std::strtoull(count.c_str(), nullptr, 10);
    if (points == 0 || (name != "sphere" && name != "torus")) return 2;
    const se::PointFile file =
        name == "sphere" ? se::bench::sphere(points) : se::bench::torus(points);
    const se::Status status = se::writeMeshPly(path, file, {});
    if (!status) std::fprintf(stderr, "%s\n", status.error().message.c_str());
    return status ? 0 : 5;
}

/// Triangles against their corners' normals can only be counted where there are normals.
int checkMesh(const std::string& path) {
    const auto file = se::readPoints(std::filesystem::path(path));
    if (!file) {
        std::fprintf(stderr, "%s\n", file.error().message.c_str());
        return 3;
    }
    se::PointSet points;
    points.position = file.value().position;
    points.normal = file.value().normal;
    const auto& faces = file.value().faces;
    const se::MeshReport mesh = [&] {
        se::PointSet counted = points;
        counted.normal.resize(points.size(), se::Vec3(0.0));
        return se::reportMesh(counted, faces);
    }();
    const se::MeshInspection found = se::inspectWithTotals(points, faces);
    std::printf("{\n  \"points\": %zu,\n  \"triangles\": %zu,\n  \"boundary_loops\": %zu",
                mesh.points, mesh.triangles, mesh.boundaryLoops);
    for (std::size_t i = 0; i < found.totals.size(); ++i) {
        const std::string name(se::failureClasses()[i].name);
        if (name == "flipped_triangles" && !file.value().hasNormals()) continue;
        std::printf(",\n  \"%s\": %zu", name.c_str(), found.totals[i].total);
    }
    std::printf("\n}\n");
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string verb = argc > 1 ? argv[1] : "";
    if (verb == "shape" && argc == 5) return writeShape(argv[2], argv[3], argv[4]);
    if (verb == "check" && argc == 3) return checkMesh(argv[2]);
    std::fputs(
        "usage: spiraling-edge-peer-tool shape sphere|torus COUNT OUT.ply | check MESH.ply\n",
        stderr);
    return 2;
}
