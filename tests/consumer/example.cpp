#include <cstdio>

#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/stepper.h"

int main(int argc, char** argv) {
    // Points with normals: from a file, or one of the built-in scenes.
    const auto file = argc > 1 ? se::readPoints(std::filesystem::path(argv[1]))
                               : se::Result<se::PointFile>(se::scenes().front().build());
    if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 3;
    // Normals and neighbor lists, unless the file has some.
    const auto prepared = se::prepare(file.value(), {});
    if (!prepared) return std::fprintf(stderr, "%s\n", prepared.error().message.c_str()), 3;
    const se::PointSet& points = prepared.value().points;

    se::Stepper stepper(points, se::Params{});
    stepper.run();  // or stepPivot(), or advance(): one phase of one pivot

    const auto& triangles = stepper.state().mesh();
    const se::MeshReport report = se::reportMesh(points, triangles);
    std::printf("%zu points, %zu triangles, Euler characteristic %lld\n", report.points,
                report.triangles, report.eulerCharacteristic);
    if (argc <= 2) return 0;
    return se::writeMeshPly(argv[2], file.value(), triangles).ok() ? 0 : 5;
}
