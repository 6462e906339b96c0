#include "sentences.h"

#include <fmt/format.h>

#include "spiraling_edge/base/number_text.h"

namespace se::cli {

std::string counted(std::size_t count, const std::string& noun, const std::string& plural) {
    if (count == 1) return "1 " + noun;
    return fmt::format("{} {}", count, plural.empty() ? noun + "s" : plural);
}

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
    const auto add = [&](std::size_t count, const char* noun, const char* plural) {
        if (count > 0) appendPart(text, counted(count, noun, plural));
    };
    add(mesh.nonManifoldEdges, "non-manifold edge", "non-manifold edges");
    add(mesh.nonManifoldVertices, "non-manifold point", "non-manifold points");
    add(mesh.inconsistentEdges, "inconsistent edge", "inconsistent edges");
    add(mesh.degenerateTriangles, "degenerate triangle", "degenerate triangles");
    add(mesh.flippedTriangles, "flipped triangle", "flipped triangles");
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
