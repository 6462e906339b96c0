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

std::string spacingSentence(const InputFacts& facts) {
    if (facts.nearestMost == 0.0) return {};
    return fmt::format("nearest point at {:g} on average, {:g} to {:g}{}", facts.nearestMean,
                       facts.nearestLeast, facts.nearestMost,
                       facts.across > 0.0 ? "; in lines: " + spacingText(facts) : "");
}

std::string normalsSentence(const InputFacts& facts, bool given) {
    if (!facts.hasNormals) {
        std::string text =
            given ? "most are zero or not finite: a run derives all" : "none: a run derives them";
        if (facts.unknownSides > 0)
            text += "; " + unknownSidesText(facts.unknownSides, facts.sideParts);
        return text;
    }
    std::string text = "yes";
    if (facts.completedNormals > 0)
        text +=
            fmt::format(", but {} zero or not finite: a run derives these", facts.completedNormals);
    if (!facts.normalsFit)
        text += fmt::format(
            "; they do not fit: {:.1f} degrees off the planes of the points in the median, {} of "
            "{} "
            "within 30",
            facts.normalDegrees, facts.nearNormals, facts.measuredNormals);
    if (facts.flippedNormals > 0)
        text += fmt::format("; {} against those about them", facts.flippedNormals);
    if (facts.unscaledNormals > 0)
        text += fmt::format("; {} not of unit length", facts.unscaledNormals);
    return text;
}

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

std::string setAsideSentence(const std::array<std::size_t, kAsides>& aside) {
    std::string text;
    for (const AsideWords& each : asideReasons()) {
        const std::size_t count = aside[static_cast<std::size_t>(each.reason)];
        if (count > 0) appendPart(text, fmt::format("{} {}", count, each.words));
    }
    return text;
}

Json setAsideJson(const std::array<std::size_t, kAsides>& aside) {
    Json json = Json::object();
    for (const AsideWords& each : asideReasons())
        json[std::string(each.name)] = aside[static_cast<std::size_t>(each.reason)];
    return json;
}

void addInputFacts(const InputFacts& facts, bool givenNormals, Answer& answer) {
    answer.json["facts"] = inputFactsJson(facts);
    answer.line("spacing", spacingSentence(facts));
    answer.line("normals", normalsSentence(facts, givenNormals));
    answer.line("", averagedText(facts.averagedNormals));
    answer.line("set aside", setAsideSentence(facts.asideAlways()));
    answer.line("by robust", setAsideSentence(facts.asideByRobust()));
    if (facts.twins > 0)
        answer.line("twins", fmt::format("{} much nearer to another than to the rest",
                                         counted(facts.twins, "point")));
    answer.line("shape", piecesText(facts));
}

Json inputFactsJson(const InputFacts& facts) {
    return {
        {"points", facts.points},
        {"in_run", facts.count(Aside::No)},
        {"set_aside", setAsideJson(facts.aside)},
        {"twins", facts.twins},
        {"box", facts.measured == 0 ? Json() : Json({{"low", facts.low}, {"high", facts.high}})},
        {"nearest_distance",
         {{"least", facts.nearestLeast},
          {"mean", facts.nearestMean},
          {"median", facts.nearestMedian},
          {"most", facts.nearestMost}}},
        {"lines",
         facts.across > 0.0 ? Json({{"along", facts.along}, {"across", facts.across}}) : Json()},
        {"normals",
         {{"given", facts.hasNormals},
          {"fit", facts.normalsFit},
          {"degrees_off", facts.normalDegrees},
          {"flipped", facts.flippedNormals},
          {"completed_normals", facts.completedNormals},
          {"unscaled_normals", facts.unscaledNormals},
          {"averaged_normals", facts.averagedNormals},
          {"parts_of_unknown_side", facts.unknownSides}}},
        {"pieces", facts.pieces},
        {"openings", facts.openings}};
}

std::string keptSentence(const InputPiece& read) {
    const Piece& piece = read.piece;
    if (piece.isWhole() && !piece.isScaled()) return {};
    const Vec3& scale = piece.scale;
    std::string how;
    if (piece.crop) appendPart(how, "crop");
    if (piece.thin > 0.0) appendPart(how, fmt::format("thin {}", piece.thin));
    if (piece.isScaled()) appendPart(how, fmt::format("scale {},{},{}", scale.x, scale.y, scale.z));
    return fmt::format("{} of {}: {}", read.kept, counted(read.inFile, "point"), how);
}

Json keptJson(const InputPiece& read) {
    const Piece& piece = read.piece;
    if (piece.isWhole() && !piece.isScaled()) return {};
    Json crop;
    if (piece.crop) {
        const auto& [low, high] = *piece.crop;
        crop = {low.x, low.y, low.z, high.x, high.y, high.z};
    }
    return {{"crop", crop},
            {"thin", piece.thin > 0.0 ? Json(piece.thin) : Json()},
            {"scale", piece.isScaled() ? Json(piece.scale) : Json()},
            {"kept", read.kept},
            {"points_in_file", read.inFile}};
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
