#include "compare_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "ledger_text.h"
#include "sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/replay/event_text.h"
#include "teach/json_text.h"

namespace se::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string addressText(const std::optional<Address>& address) {
    return address ? toString(*address) : "-";
}

std::string countsText(const Comparison& c) {
    const MeshDifference& m = c.meshes;
    std::string text = counted(m.both, "triangle") + " in both";
    appendPart(text, fmt::format("{} only in A", m.onlyA));
    appendPart(text, fmt::format("{} only in B", m.onlyB));
    if (m.reversed > 0) appendPart(text, fmt::format("{} reversed", m.reversed));
    return text + "\n";
}

std::string sideText(char name, const DifferenceSide& side) {
    if (!side.line) return fmt::format("  {}  the run has ended\n", name);
    const LedgerLine& line = *side.line;
    std::string text =
        fmt::format("  {}  {:<18} {:<8} {:<4} {}\n", name, toString(line.event.address),
                    side.decides ? roleName(line.role) : "instead",
                    stageSection(line.event.address.stage), describe(line.event));
    if (line.reading) text += fmt::format("{:38}{}\n", "", readingText(*line.reading));
    return text;
}

std::string differenceText(const RunDifference& difference) {
    return difference.words + "\n" + sideText('A', difference.a) + sideText('B', difference.b);
}

std::string runsText(const RunComparison& runs) {
    std::string text;
    if (runs.first) {
        text += fmt::format("\nFirst difference, after {} alike:\n",
                            counted(runs.commonPivots, "pivot")) +
                differenceText(*runs.first);
    } else {
        text += fmt::format("\nNo difference: {} alike.\n", counted(runs.commonPivots, "pivot"));
    }
    if (runs.harmless) {
        text += fmt::format("\nWithout a consequence, at {}; the first:\n",
                            counted(runs.harmlessPivots, "earlier pivot")) +
                differenceText(*runs.harmless);
    }
    return text;
}

std::string regionsText(const Comparison& c, std::size_t limit) {
    const auto& regions = c.meshes.regions;
    if (regions.empty()) return "";
    std::string text =
        "\n" + counted(regions.size(), "region") + " of difference, largest first:\n";
    for (std::size_t i = 0; i < std::min(limit, regions.size()); ++i) {
        const DifferenceRegion& r = regions[i];
        text += fmt::format(
            "{:>4}  A {:<14} B {:<14} {} in A, {} in B, at ({:.6g}, {:.6g}, {:.6g})\n", i + 1,
            addressText(firstMade(c.a.mesh, r.inA)), addressText(firstMade(c.b.mesh, r.inB)),
            counted(r.inA.size(), "triangle"), r.inB.size(), r.place.x, r.place.y, r.place.z);
    }
    if (regions.size() > limit) text += "      ... all of them by --json\n";
    return text;
}

/// The next question about a mesh of another program: a triangle of points that only it has.
std::string nextQuestion(const Comparison& c) {
    if (c.runs) return "";
    for (std::size_t i = 0; i < c.meshes.b.size(); ++i) {
        const Triangle& t = c.b.mesh.triangles[i];
        if (c.meshes.b[i] != Match::Missing || std::max({t.a, t.b, t.c}) >= c.points) continue;
        return fmt::format(
            "\nspiraling-edge why {} --triangle {},{},{} explains why the run lacks this triangle "
            "of B.\n",
            shellPath(c.input), t.a, t.b, t.c);
    }
    return "";
}

Json trianglesJson(const MadeMesh& mesh, const std::vector<Index>& list) {
    Json json = Json::array();
    for (const Index i : list) {
        const Triangle& t = mesh.triangles[i];
        json.push_back({t.a, t.b, t.c});
    }
    return json;
}

Json addressJson(const std::optional<Address>& address) {
    return address ? Json(toString(*address)) : Json();
}

Json sideJson(const DifferenceSide& side) {
    if (!side.line) return {};
    Json json = lineJson(*side.line);
    json["decides"] = side.decides;
    return json;
}

Json differenceJson(const std::optional<RunDifference>& difference) {
    if (!difference) return {};
    Json json;
    json["text"] = difference->words;
    json["a"] = sideJson(difference->a);
    json["b"] = sideJson(difference->b);
    return json;
}

Json regionJson(const Comparison& c, const DifferenceRegion& r) {
    Json json;
    json["a"] = addressJson(firstMade(c.a.mesh, r.inA));
    json["b"] = addressJson(firstMade(c.b.mesh, r.inB));
    json["in_a"] = trianglesJson(c.a.mesh, r.inA);
    json["in_b"] = trianglesJson(c.b.mesh, r.inB);
    json["points"] = r.points;
    json["at"] = {r.place.x, r.place.y, r.place.z};
    json["radius"] = r.radius;
    return json;
}

}  // namespace

std::string comparisonText(const Comparison& c, std::size_t limit) {
    const auto side = [](char name, const ComparedSide& s) {
        return fmt::format("{}  {}: {}\n", name, printable(s.title),
                           counted(s.mesh.triangles.size(), "triangle"));
    };
    std::string text = side('A', c.a) + side('B', c.b) + countsText(c);
    if (!c.unmatchedVertices.empty()) {
        text += fmt::format("{} of B on no point of {}, the first {}\n",
                            counted(c.unmatchedVertices.size(), "vertex", "vertices"),
                            printable(c.input), c.unmatchedVertices.front());
    }
    if (c.runs) text += runsText(*c.runs);
    return text + regionsText(c, limit) + nextQuestion(c);
}

std::string comparisonJson(const Comparison& c) {
    Json json;
    json["input"] = c.input;
    for (const auto& [name, side] : {std::pair{"a", &c.a}, {"b", &c.b}}) {
        json[name]["title"] = side->title;
        json[name]["triangles"] = side->mesh.triangles.size();
    }
    json["same"] = c.meshes.same();
    json["both"] = c.meshes.both;
    json["only_a"] = c.meshes.onlyA;
    json["only_b"] = c.meshes.onlyB;
    json["turned"] = c.meshes.reversed;
    if (c.runs) {
        json["pivots_alike"] = c.runs->commonPivots;
        json["first_difference"] = differenceJson(c.runs->first);
        json["harmless_pivots"] = c.runs->harmlessPivots;
        json["first_harmless"] = differenceJson(c.runs->harmless);
    } else {
        json["unmatched_vertices"] = c.unmatchedVertices;
    }
    json["regions"] = Json::array();
    for (const DifferenceRegion& region : c.meshes.regions)
        json["regions"].push_back(regionJson(c, region));
    return teach::jsonText(json);
}

}  // namespace se::cli
