// spiraling-edge info: the content of a file, before any processing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "input.h"
#include "options.h"
#include "output/answer.h"
#include "output/sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/points/wall_types.h"
#include "verbs.h"

namespace se::cli {
namespace {

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

void addFacts(const Facts& facts, Answer& answer) {
    const PointFile& file = facts.file;
    const Spacing& spacing = facts.spacing;
    const Vec3& low = facts.box.low;
    const Vec3& high = facts.box.high;
    answer.json.update(
        {{"points", file.position.size()},
         {"piece", keptJson(facts.points)},
         {"columns", orNull(file.columns.names)},
         {"columns_reason", orNull(file.columns.reason)},
         {"notes", file.notes},
         {"viewpoint", Json()},
         {"normals", file.hasNormals()},
         {"unknown_sides", facts.prepared.derived.unknownSides},
         {"box", {{"low", {low.x, low.y, low.z}}, {"high", {high.x, high.y, high.z}}}},
         {"nearest_distance", Json()}});
    if (const auto& place = file.viewpoint) {
        answer.json["viewpoint"] = {place->x, place->y, place->z};
        answer.line("viewpoint",
                    fmt::format("{:g} {:g} {:g}: the sensor; open sheets without normals face it",
                                place->x, place->y, place->z));
    }
    answer.line("kept", keptSentence(facts.points));
    answer.line("box", fmt::format("{0:.{6}g} {1:.{6}g} {2:.{6}g} to {3:.{6}g} {4:.{6}g} {5:.{6}g}",
                                   low.x, low.y, low.z, high.x, high.y, high.z, boxDigits(facts)));
    if (spacing.count > 0) {
        answer.json["nearest_distance"] = {
            {"least", spacing.least}, {"mean", spacing.mean}, {"most", spacing.most}};
        answer.line("spacing", fmt::format("nearest point at {:g} on average, {:g} to {:g}",
                                           spacing.mean, spacing.least, spacing.most));
    }
    answer.line("columns", columnsSentence(file.columns));
    addNotes(file.notes, answer);
    answer.line("normals", normalsSentence(facts));
    if (facts.prepared.unscaledNormals > 0)
        answer.line("", fmt::format("{} not of unit length", facts.prepared.unscaledNormals));
    answer.line("set aside", setAsideSentence(facts.prepared));
}

void addNeighborhood(const Facts& facts, Answer& answer) {
    const PointFile& file = facts.file;
    const std::size_t entries = file.neighbors.ids.size();
    answer.json.update({{"wall_points", facts.wallPoints},
                        {"corner_points", facts.cornerPoints},
                        {"rim_points", facts.rimPoints},
                        {"neighbor_lists", file.hasNeighbors()},
                        {"neighbor_entries", entries},
                        {"set_aside",
                         {{"non_finite", facts.prepared.nonFinitePoints},
                          {"zero_normals", facts.prepared.zeroNormals},
                          {"duplicates", facts.prepared.duplicatePoints}}},
                        {"completed_normals", facts.prepared.derived.completedNormals},
                        {"unscaled_normals", facts.prepared.unscaledNormals}});
    if (file.hasTypes() && (facts.wallPoints > 0 || facts.rimPoints == 0)) {
        answer.line("walls", fmt::format("{} on a wall, {} of them on two or more",
                                         facts.wallPoints, facts.cornerPoints));
    }
    if (facts.rimPoints > 0)
        answer.line("rims", fmt::format("{} away from walls", counted(facts.rimPoints, "point")));
    answer.line("neighbors", file.hasNeighbors() ? fmt::format("{} in lists", entries)
                                                 : "none in the file: a run computes them");
}

void addTriangles(const Facts& facts, Answer& answer) {
    const MeshReport& mesh = facts.mesh;
    std::string names;
    answer.json["attributes"] = Json::array();
    for (const Attribute& attribute : facts.file.attributes) {
        appendPart(names, attribute.name);
        answer.json["attributes"].push_back(attribute.name);
    }
    answer.line("also", names);
    answer.json.update({{"triangles", mesh.triangles},
                        {"components", mesh.components},
                        {"boundary_edges", mesh.boundaryEdges},
                        {"boundary_loops", mesh.boundaryLoops},
                        {"non_manifold_edges", mesh.nonManifoldEdges},
                        {"inconsistent_edges", mesh.inconsistentEdges},
                        {"euler_characteristic", mesh.eulerCharacteristic},
                        {"closed_manifold", mesh.closedManifold()}});
    if (facts.file.faces.empty()) return;
    answer.line("mesh", meshSentence(mesh));
    answer.line("defects", defectSentence(mesh));
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
    Answer answer{
        fmt::format("{}: {}\n", printable(input), counted(facts.file.position.size(), "point")),
        {{"input", input}}};
    addFacts(facts, answer);
    addNeighborhood(facts, answer);
    addTriangles(facts, answer);
    print(answer, json);
    return ExitCode::Good;
}

}  // namespace se::cli
