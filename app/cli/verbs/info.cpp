// spiraling-edge info: the content of a file, before any processing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "input.h"
#include "output/sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "verbs.h"

namespace se::cli {
namespace {

/// Everything that is reported about a file.
struct Contents : InputPiece {
    InputFacts facts = {};
    MeshReport mesh = {};
};

/// The points as they are in the file, for a mesh of points without normals.
PointSet withoutNormals(const PointFile& file) {
    PointSet points;
    points.position = file.position;
    points.normal.assign(file.position.size(), Vec3(0.0));
    return points;
}

Contents gather(const RunSpec& spec) {
    Contents contents{readPiece(spec)};
    const auto judge = require(judgeFor(contents.file), ExitCode::Input, spec.source + ": ");
    contents.facts = judge->facts;
    contents.mesh =
        reportMesh(contents.facts.hasNormals ? judge->points : withoutNormals(contents.file),
                   contents.file.faces);
    return contents;
}

/// Significant digits that resolve the sides of the box, also far from the origin.
int boxDigits(const InputFacts& facts) {
    constexpr double kUsual = 6.0;
    constexpr double kMax = 17.0;
    const Vec3 size = facts.extent();
    const Vec3 reach = glm::max(glm::abs(facts.low), glm::abs(facts.high));
    double digits = kUsual;
    for (int i = 0; i < 3; ++i) {
        if (size[i] > 0.0 && std::isfinite(reach[i]))
            digits = std::max(digits, 4.0 + std::log10(reach[i] / size[i]));
    }
    return static_cast<int>(std::min(digits, kMax));
}

void addPoints(const Contents& contents, Answer& answer) {
    const PointFile& file = contents.file;
    const Vec3& low = contents.facts.low;
    const Vec3& high = contents.facts.high;
    answer.json.update({{"points", file.position.size()},
                        {"piece", keptJson(contents)},
                        {"columns", orNull(file.columns.names)},
                        {"columns_reason", orNull(file.columns.reason)},
                        {"notes", file.notes},
                        {"viewpoint", file.viewpoint ? Json(*file.viewpoint) : Json()},
                        {"normals", file.hasNormals()}});
    if (const auto& place = file.viewpoint) {
        answer.line("viewpoint",
                    fmt::format("{:g} {:g} {:g}: the sensor; open sheets without normals face it",
                                place->x, place->y, place->z));
    }
    answer.line("kept", keptSentence(contents));
    answer.line("columns", columnsSentence(file.columns));
    addNotes(file.notes, answer);
    if (contents.facts.measured > 0) {
        answer.line("box", fmt::format("{0:.{6}g} {1:.{6}g} {2:.{6}g} to {3:.{6}g} {4:.{6}g} "
                                       "{5:.{6}g}",
                                       low.x, low.y, low.z, high.x, high.y, high.z,
                                       boxDigits(contents.facts)));
    }
    addInputFacts(contents.facts, file.hasNormals(), answer);
}

void addNeighborhood(const Contents& contents, Answer& answer) {
    const PointFile& file = contents.file;
    const std::size_t entries = file.neighbors.ids.size();
    const std::size_t walls = countOfType(file, isOnWall);
    const std::size_t corners = countOfType(file, isCorner);
    const std::size_t rims = countOfType(file, isRimPoint);
    answer.json.update({{"wall_points", walls},
                        {"corner_points", corners},
                        {"rim_points", rims},
                        {"neighbor_lists", file.hasNeighbors()},
                        {"neighbor_entries", entries}});
    if (file.hasTypes() && (walls > 0 || rims == 0))
        answer.line("walls",
                    fmt::format("{} on a wall, {} of them on two or more", walls, corners));
    if (rims > 0) answer.line("rims", fmt::format("{} away from walls", counted(rims, "point")));
    answer.line("neighbors", file.hasNeighbors() ? fmt::format("{} in lists", entries)
                                                 : "none in the file: a run computes them");
}

void addTriangles(const Contents& contents, Answer& answer) {
    const MeshReport& mesh = contents.mesh;
    std::string names;
    answer.json["attributes"] = Json::array();
    for (const Attribute& attribute : contents.file.attributes) {
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
    if (contents.file.faces.empty()) return;
    answer.line("mesh", meshSentence(mesh));
    answer.line("defects", defectSentence(mesh));
}

}  // namespace

ExitCode infoVerb(CLI::App& app, const Arguments& words) {
    InputArguments arguments;
    bool json = false;
    arguments.addTo(app, {SpecGroup::Reading});
    app.add_flag("--json", json, "As JSON");
    if (const auto code = parseArguments(app, words)) return *code;
    const std::string& input = arguments.input();
    const Contents contents = gather(arguments.spec());
    Answer answer{
        fmt::format("{}: {}\n", printable(input), counted(contents.file.position.size(), "point")),
        {{"input", input}}};
    addPoints(contents, answer);
    addNeighborhood(contents, answer);
    addTriangles(contents, answer);
    print(answer, json);
    return ExitCode::Good;
}

}  // namespace se::cli
