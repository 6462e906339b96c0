#include "sentences.h"

#include <fmt/format.h>

#include <array>

#include "spiraling_edge/base/number_text.h"

namespace se::cli {
namespace {

constexpr std::array kMeshDefects{
    MeshDefect{"non_manifold_edges", "non-manifold edge", &MeshReport::nonManifoldEdges},
    MeshDefect{"non_manifold_vertices", "non-manifold point", &MeshReport::nonManifoldVertices},
    MeshDefect{"inconsistent_edges", "inconsistent edge", &MeshReport::inconsistentEdges},
    MeshDefect{"degenerate_triangles", "degenerate triangle", &MeshReport::degenerateTriangles},
    MeshDefect{"flipped_triangles", "flipped triangle", &MeshReport::flippedTriangles},
};

}  // namespace

std::span<const MeshDefect> meshDefects() { return kMeshDefects; }

void appendPart(std::string& list, const std::string& part) {
    if (!list.empty()) list += ", ";
    list += part;
}

std::string meshSentence(const MeshReport& mesh) {
    std::string text = counted(mesh.triangles, "triangle");
    if (mesh.triangles == 0) return text;
    text += " in " + counted(mesh.components, "component");
    appendPart(text, mesh.boundaryEdges == 0 ? "no boundary"
                                             : counted(mesh.boundaryEdges, "boundary edge") +
                                                   " in " + counted(mesh.boundaryLoops, "loop"));
    appendPart(text, fmt::format("Euler characteristic {}", mesh.eulerCharacteristic));
    return text;
}

std::string openSentence(const MeshReport& mesh) {
    if (mesh.boundaryLoops == 0) return "";
    return fmt::format("{}, {}{} across ({})", counted(mesh.boundaryLoops, "loop"),
                       mesh.boundaryLoops == 1 ? "" : "the widest ",
                       shortNumber(mesh.widestLoopWidth), counted(mesh.widestLoopEdges, "edge"));
}

std::string defectSentence(const MeshReport& mesh) {
    std::string text;
    for (const MeshDefect& defect : kMeshDefects) {
        const std::size_t count = mesh.*defect.count;
        if (count > 0) appendPart(text, counted(count, defect.noun));
    }
    return text;
}

std::string setAsideSentence(const PrepareReport& report) {
    std::string text;
    const auto add = [&](std::size_t count, const char* what) {
        if (count > 0) appendPart(text, fmt::format("{} {}", count, what));
    };
    add(report.nonFinitePoints, "not finite");
    add(report.zeroNormals, "without a normal direction");
    add(report.duplicatePoints, "copies of another point");
    add(report.strays, "far from all others");
    add(report.noisyPoints, "above or below others, where noise is as wide as the spacing");
    add(report.leftOut, "that the doctor proposes to drop");
    return text;
}

std::string columnsSentence(const ColumnReading& columns) {
    return columns.reason.empty() ? columns.names
                                  : fmt::format("{} ({})", columns.names, columns.reason);
}

}  // namespace se::cli
