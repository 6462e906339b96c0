#include "sentences.h"

#include <fmt/format.h>

#include <array>
#include <utility>

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

constexpr std::array kSetAsides{
    SetAside{"non_finite", "not finite", &PrepareReport::nonFinitePoints},
    SetAside{"zero_normals", "without a normal direction", &PrepareReport::zeroNormals},
    SetAside{"duplicates", "copies of another point", &PrepareReport::duplicatePoints},
    SetAside{"noise", "above or below others, where noise is as wide as the spacing",
             &PrepareReport::noisyPoints},
    SetAside{"strays", "far from all others", &PrepareReport::strays},
    SetAside{"dropped", "that the doctor proposes to drop", &PrepareReport::leftOut},
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

std::span<const SetAside> setAsides() { return kSetAsides; }

std::string setAsideSentence(const PrepareReport& report) {
    std::string text;
    for (const SetAside& each : kSetAsides) {
        if (report.*each.count > 0)
            appendPart(text, fmt::format("{} {}", report.*each.count, each.words));
    }
    return text;
}

std::string keptSentence(const KeptPoints& points) {
    const Piece& piece = points.piece;
    if (piece.isWhole()) return {};
    std::string how;
    if (piece.crop) appendPart(how, "crop");
    if (piece.thin > 0.0) appendPart(how, fmt::format("thin {}", piece.thin));
    return fmt::format("{} of {}: {}", points.kept, counted(points.inFile, "point"), how);
}

Json keptJson(const KeptPoints& points) {
    const Piece& piece = points.piece;
    if (piece.isWhole()) return {};
    Json json = {{"crop", Json()}, {"thin", Json()}};
    if (piece.crop) {
        const Vec3& low = piece.crop->low;
        const Vec3& high = piece.crop->high;
        json["crop"] = {low.x, low.y, low.z, high.x, high.y, high.z};
    }
    if (piece.thin > 0.0) json["thin"] = piece.thin;
    json["kept"] = points.kept;
    json["points_in_file"] = points.inFile;
    return json;
}

void addNotes(const std::vector<std::string>& notes, Answer& answer) {
    const char* label = "read";
    for (const std::string& note : notes) answer.line(std::exchange(label, ""), note);
}

std::string columnsSentence(const ColumnReading& columns) {
    return columns.reason.empty() ? columns.names
                                  : fmt::format("{} ({})", columns.names, columns.reason);
}

}  // namespace se::cli
