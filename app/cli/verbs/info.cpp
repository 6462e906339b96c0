// spiraling-edge info: the content of a file, before any processing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "input.h"
#include "options.h"
#include "output/output.h"
#include "output/piece_text.h"
#include "output/sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/points/wall_types.h"
#include "teach/json_text.h"
#include "verbs.h"

namespace se::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Distances to the nearest point, over the points that have one.
struct Spacing {
    std::size_t count = 0;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    double mean = 0.0;
};

/// Everything that is reported about a file.
struct Facts {
    PointFile file;
    KeptPoints points;
    WallBox box;
    Spacing spacing;
    std::size_t wallPoints = 0;
    std::size_t cornerPoints = 0;
    std::size_t rimPoints = 0;
    PrepareReport prepared;
    MeshReport mesh;
};

Spacing spacingOf(const PointSet& points, const NeighborLists& nearest) {
    Spacing spacing;
    double sum = 0.0;
    for (Index p = 0; p < nearest.size(); ++p) {
        if (nearest[p].empty()) continue;
        const Vec3 d = points.position[nearest[p][0]] - points.position[p];
        const double distance = std::sqrt(glm::dot(d, d));
        spacing.least = std::min(spacing.least, distance);
        spacing.most = std::max(spacing.most, distance);
        sum += distance;
        ++spacing.count;
    }
    if (spacing.count > 0) spacing.mean = sum / static_cast<double>(spacing.count);
    return spacing;
}

/// Points from which spacing and mesh can be computed even if the file has no normals.
PointSet withSomeNormals(const PointFile& file) {
    PointSet points;
    points.position = file.position;
    points.normal.assign(file.position.size(), Vec3(0.0));
    return points;
}

Facts gather(const RunSpec& spec) {
    Facts facts;
    InputPiece read = readPiece(spec);
    facts.file = std::move(read.file);
    facts.points = read.points;
    facts.box = boxAround(facts.file.position);
    for (const std::uint8_t type : facts.file.type) {
        facts.wallPoints += isOnWall(type) ? 1U : 0U;
        facts.rimPoints += isRimPoint(type) ? 1U : 0U;
        facts.cornerPoints += isCorner(type) ? 1U : 0U;
    }
    PointSet points = withSomeNormals(facts.file);
    NeighborOptions options;
    options.reach = KNearest{1};
    Result<Prepared> prepared = prepare(facts.file, {options});
    if (!prepared && facts.file.hasNormals())
        throw Failure(ExitCode::Input, spec.source + ": " + prepared.error().message);
    if (prepared) facts.prepared = prepared.value().report;
    if (facts.file.hasNormals()) points = std::move(prepared.value().points);
    std::vector<bool> usable(points.size());
    std::transform(points.position.begin(), points.position.end(), usable.begin(), isFinite);
    NeighborOptions nearest;
    nearest.reach = KNearest{1};
    nearest.dropOpposingNormals = false;
    const auto lists = findNeighbors(points.position, {}, usable, nearest);
    if (lists) facts.spacing = spacingOf(points, lists.value());
    facts.mesh = reportMesh(points, facts.file.faces);
    return facts;
}

Json vectorJson(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

std::string factsJson(const std::string& input, const Facts& facts) {
    const PointFile& file = facts.file;
    Json json;
    json["input"] = input;
    json["points"] = file.position.size();
    json["piece"] = keptJson(facts.points);
    json["columns"] = file.columns.names.empty() ? Json() : Json(file.columns.names);
    json["columns_reason"] = file.columns.reason.empty() ? Json() : Json(file.columns.reason);
    json["normals"] = file.hasNormals();
    json["unknown_sides"] = facts.prepared.derived.unknownSides;
    json["box"] = {{"low", vectorJson(facts.box.low)}, {"high", vectorJson(facts.box.high)}};
    json["nearest_distance"] = Json();
    if (facts.spacing.count > 0) {
        json["nearest_distance"] = {{"least", facts.spacing.least},
                                    {"mean", facts.spacing.mean},
                                    {"most", facts.spacing.most}};
    }
    json["wall_points"] = facts.wallPoints;
    json["corner_points"] = facts.cornerPoints;
    json["rim_points"] = facts.rimPoints;
    json["neighbor_lists"] = file.hasNeighbors();
    json["neighbor_entries"] = file.neighbors.ids.size();
    json["set_aside"] = {{"non_finite", facts.prepared.nonFinitePoints},
                         {"zero_normals", facts.prepared.zeroNormals},
                         {"duplicates", facts.prepared.duplicatePoints}};
    json["completed_normals"] = facts.prepared.derived.completedNormals;
    json["unscaled_normals"] = facts.prepared.unscaledNormals;
    json["attributes"] = Json::array();
    for (const Attribute& attribute : file.attributes) json["attributes"].push_back(attribute.name);
    json["triangles"] = facts.mesh.triangles;
    json["components"] = facts.mesh.components;
    json["boundary_edges"] = facts.mesh.boundaryEdges;
    json["boundary_loops"] = facts.mesh.boundaryLoops;
    json["non_manifold_edges"] = facts.mesh.nonManifoldEdges;
    json["inconsistent_edges"] = facts.mesh.inconsistentEdges;
    json["euler_characteristic"] = facts.mesh.eulerCharacteristic;
    json["closed_manifold"] = facts.mesh.closedManifold();
    return teach::jsonText(json);
}

std::string normalsSentence(const Facts& facts) {
    const DerivedPieces& derived = facts.prepared.derived;
    const bool given = facts.file.hasNormals();
    if (given && !derived.normals) {
        if (derived.completedNormals == 0) return "yes";
        return fmt::format("yes, but {} zero or not finite: a run derives these",
                           derived.completedNormals);
    }
    std::string text =
        given ? "most are zero or not finite: a run derives all" : "none: a run derives them";
    if (derived.unknownSides > 0)
        text += "; " + unknownSidesText(derived.unknownSides, derived.normalComponents);
    return text;
}

/// Significant digits that resolve the sides of the box, also far from the origin.
int boxDigits(const Facts& facts) {
    constexpr double kUsual = 6.0;
    constexpr double kMax = 17.0;
    const Vec3 size = facts.box.high - facts.box.low;
    const Vec3 reach = glm::max(glm::abs(facts.box.low), glm::abs(facts.box.high));
    double digits = kUsual;
    for (int i = 0; i < 3; ++i) {
        if (size[i] > 0.0 && std::isfinite(reach[i]))
            digits = std::max(digits, 4.0 + std::log10(reach[i] / size[i]));
    }
    return static_cast<int>(std::min(digits, kMax));
}

std::string factsText(const std::string& input, const Facts& facts) {
    const PointFile& file = facts.file;
    std::string text =
        fmt::format("{}: {}\n", printable(input), counted(file.position.size(), "point"));
    const auto addLine = [&](const char* label, const std::string& sentence) {
        if (!sentence.empty()) text += fmt::format("  {:<10} {}\n", label, sentence);
    };
    addLine("kept", keptSentence(facts.points));
    const WallBox& box = facts.box;
    addLine("box", fmt::format("{0:.{6}g} {1:.{6}g} {2:.{6}g} to {3:.{6}g} {4:.{6}g} {5:.{6}g}",
                               box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z,
                               boxDigits(facts)));
    if (facts.spacing.count > 0) {
        addLine("spacing",
                fmt::format("nearest point at {:g} on average, {:g} to {:g}", facts.spacing.mean,
                            facts.spacing.least, facts.spacing.most));
    }
    addLine("columns", columnsSentence(file.columns));
    addLine("normals", normalsSentence(facts));
    if (facts.prepared.unscaledNormals > 0)
        addLine("", fmt::format("{} not of unit length", facts.prepared.unscaledNormals));
    addLine("set aside", setAsideSentence(facts.prepared));
    if (file.hasTypes() && (facts.wallPoints > 0 || facts.rimPoints == 0)) {
        addLine("walls", fmt::format("{} on a wall, {} of them on two or more", facts.wallPoints,
                                     facts.cornerPoints));
    }
    if (facts.rimPoints > 0)
        addLine("rims", fmt::format("{} away from walls", counted(facts.rimPoints, "point")));
    addLine("neighbors", file.hasNeighbors() ? fmt::format("{} in lists", file.neighbors.ids.size())
                                             : "none in the file: a run computes them");
    std::string names;
    for (const Attribute& attribute : file.attributes) appendPart(names, attribute.name);
    addLine("also", names);
    if (!file.faces.empty()) {
        addLine("mesh", meshSentence(facts.mesh));
        addLine("defects", defectSentence(facts.mesh));
    }
    return text;
}

}  // namespace

ExitCode infoVerb(const Arguments& words) {
    CLI::App app("Prints the content of a file.", "spiraling-edge info");
    InputArguments arguments;
    bool json = false;
    arguments.addTo(app, {SpecGroup::Reading});
    app.add_flag("--json", json, "As JSON");
    if (const auto code = parseArguments(app, words)) return *code;
    const std::string& input = arguments.input();
    const Facts facts = gather(arguments.spec());
    printText(json ? factsJson(input, facts) : factsText(input, facts));
    return ExitCode::Good;
}

}  // namespace se::cli
