// spiraling-edge compare: two runs on the same points, or a run and the mesh of another program.
#include <fmt/format.h>
#include <algorithm>
#include <string>
#include <tuple>

#include "input.h"
#include "output/ledger_text.h"
#include "output/sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/mesh/mesh_compare.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/why/run_compare.h"
#include "verbs.h"

namespace se::cli {
namespace {

/// One of the two meshes that were compared.
struct ComparedSide {
    std::string title;  ///< "--rules paper", or the name of a file.
    MadeMesh mesh;      ///< Of a file: `made` is empty.
};

/// Everything that the comparison found.
struct Comparison {
    std::string input;
    std::size_t points = 0;
    ComparedSide a, b;
    MeshDifference meshes;
    /// Course of two runs; empty for a mesh from a file.
    std::optional<RunComparison> runs;
    std::vector<Index> unmatchedVertices;  ///< Vertices of the file that lie on no point.
};

void addCounts(const MeshDifference& m, Answer& answer) {
    std::string text = counted(m.both, "triangle") + " in both";
    appendPart(text, fmt::format("{} only in A", m.onlyA));
    appendPart(text, fmt::format("{} only in B", m.onlyB));
    if (m.reversed > 0) appendPart(text, fmt::format("{} reversed", m.reversed));
    answer.text += text + "\n";
    answer.json["same"] = m.same();
    answer.json["both"] = m.both;
    answer.json["only_a"] = m.onlyA;
    answer.json["only_b"] = m.onlyB;
    answer.json["turned"] = m.reversed;
}

/// One of the two runs at a difference.
Answer sideAnswer(char name, const DifferenceSide& side) {
    if (!side.line) return {fmt::format("  {}  the run has ended\n", name)};
    const LedgerLine& line = *side.line;
    Answer answer{fmt::format("  {}  {:<18} {:<8} {:<4} {}\n", name, toString(line.event.address),
                              side.decides ? roleName(line.role) : "instead",
                              stageSection(line.event.address.stage), describe(line.event)),
                  lineJson(line)};
    if (line.reading) answer.text += fmt::format("{:38}{}\n", "", readingText(*line.reading));
    answer.json["decides"] = side.decides;
    return answer;
}

/// A difference under `key`; in text below a title.
void addDifference(const std::optional<RunDifference>& difference, const char* key,
                   const std::string& title, Answer& answer) {
    answer.json[key] = Json();
    if (!difference) return;
    const Answer a = sideAnswer('A', difference->a);
    const Answer b = sideAnswer('B', difference->b);
    answer.text += "\n" + title + "\n" + difference->words + "\n" + a.text + b.text;
    answer.json[key] = {{"text", difference->words}, {"a", a.json}, {"b", b.json}};
}

void addRuns(const RunComparison& runs, Answer& answer) {
    const std::string alike = counted(runs.commonPivots, "pivot") + " alike";
    answer.json["pivots_alike"] = runs.commonPivots;
    addDifference(runs.first, "first_difference", "First difference, after " + alike + ":", answer);
    if (!runs.first) answer.text += "\nNo difference: " + alike + ".\n";
    answer.json["harmless_pivots"] = runs.harmlessPivots;
    addDifference(runs.harmless, "first_harmless",
                  fmt::format("Without a consequence, at {}; the first:",
                              counted(runs.harmlessPivots, "earlier pivot")),
                  answer);
}

Json trianglesJson(const MadeMesh& mesh, const std::vector<Index>& list) {
    Json json = Json::array();
    for (const Index i : list) {
        const auto& [a, b, c] = mesh.triangles[i];
        json.push_back({a, b, c});
    }
    return json;
}

/// The address of the first of these triangles; empty if it is unknown.
std::string firstAddress(const MadeMesh& mesh, const std::vector<Index>& list) {
    const std::optional<Address> address = firstMade(mesh, list);
    return address ? toString(*address) : std::string();
}

/// The regions, in text at most `limit`.
void addRegions(const Comparison& c, std::size_t limit, Answer& answer) {
    const auto orDash = [](const std::string& text) { return text.empty() ? "-" : text; };
    const auto& regions = c.meshes.regions;
    answer.json["regions"] = Json::array();
    if (!regions.empty())
        answer.text +=
            "\n" + counted(regions.size(), "region") + " of difference, largest first:\n";
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const DifferenceRegion& r = regions[i];
        const std::string a = firstAddress(c.a.mesh, r.inA);
        const std::string b = firstAddress(c.b.mesh, r.inB);
        answer.json["regions"].push_back({{"a", orNull(a)},
                                          {"b", orNull(b)},
                                          {"in_a", trianglesJson(c.a.mesh, r.inA)},
                                          {"in_b", trianglesJson(c.b.mesh, r.inB)},
                                          {"points", r.points},
                                          {"at", r.place},
                                          {"radius", r.radius}});
        if (i == limit) answer.text += "      ... all of them by --json\n";
        if (i >= limit) continue;
        answer.text +=
            fmt::format("{:>4}  A {:<14} B {:<14} {} in A, {} in B, at ({:.6g}, {:.6g}, {:.6g})\n",
                        i + 1, orDash(a), orDash(b), counted(r.inA.size(), "triangle"),
                        r.inB.size(), r.place.x, r.place.y, r.place.z);
    }
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

/// All that was found, in text at most `limit` regions.
Answer comparisonAnswer(const Comparison& c, std::size_t limit) {
    Answer answer;
    answer.json["input"] = c.input;
    for (const auto& [key, name, side] : {std::tuple{"a", 'A', &c.a}, {"b", 'B', &c.b}}) {
        const std::size_t count = side->mesh.triangles.size();
        answer.json[key] = {{"title", side->title}, {"triangles", count}};
        answer.text +=
            fmt::format("{}  {}: {}\n", name, printable(side->title), counted(count, "triangle"));
    }
    addCounts(c.meshes, answer);
    if (!c.unmatchedVertices.empty()) {
        answer.text += fmt::format("{} of B on no point of {}, the first {}\n",
                                   counted(c.unmatchedVertices.size(), "vertex", "vertices"),
                                   printable(c.input), c.unmatchedVertices.front());
    }
    if (c.runs) {
        addRuns(*c.runs, answer);
    } else {
        answer.json["unmatched_vertices"] = c.unmatchedVertices;
    }
    addRegions(c, limit, answer);
    answer.text += nextQuestion(c);
    return answer;
}

/// Words after the verb, split into the two runs.
struct ComparedWords {
    Arguments a;     ///< Includes the options that belong to neither run, such as --json.
    Arguments with;  ///< After --with; a single quoted word is split at its blanks.
    bool hasWith = false;
};

/// Number of words from `i` on that belong to neither run, wherever they occur.
std::size_t wordsForBothRuns(const Arguments& words, std::size_t i) {
    const std::string& word = words[i];
    if (word == "--json" || word == "-q" || word == "--quiet" || word.starts_with("--most="))
        return 1;
    return word == "--most" ? std::min<std::size_t>(2, words.size() - i) : 0;
}

ComparedWords splitAtWith(const Arguments& words) {
    ComparedWords split;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--with") {
            split.hasWith = true;
            continue;
        }
        const std::size_t count = split.hasWith ? wordsForBothRuns(words, i) : 1;
        (count > 0 ? split.a : split.with).push_back(words[i]);
        if (count == 2) split.a.push_back(words[++i]);
    }
    // A word among others is one value, spaces included, such as the value of --what-if.
    if (split.with.size() == 1) split.with = io::wordsIn(split.with.front());
    return split;
}

/// The spec of B: that of A, changed by `with` (otherRun()). Throws Failure(Usage) if a word is
/// not understood, or changes the points.
RunSpec specOfB(const RunSpec& a, const Arguments& with) {
    const SpecChange change = require(changeFromWords(with), ExitCode::Usage, "--with ");
    for (const char* key : {"crop", "thin", "scale"}) {
        if (textOf(change, key).empty()) continue;
        refuse("{}: two runs are compared on the same points; give it before --with",
               findSpecField(key)->option);
    }
    return otherRun(a, change);
}

/// "--rules robust"; "the paper's rules" if nothing is set.
std::string titleOf(const RunSpec& spec) {
    const std::string title = optionsText(
        spec, {SpecGroup::Reading, SpecGroup::Rules, SpecGroup::Lists, SpecGroup::Derived});
    return title.empty() ? "the paper's rules" : title.substr(1);
}

struct CompareArguments : AnswerOptions {
    InputArguments input;
    std::string mesh;
    std::size_t limit = 10;

    void addTo(CLI::App& app) {
        input.addTo(app);
        // Removed before the words are parsed; declared here for the help.
        app.add_flag_callback(
            "--with", [] {},
            "The other run: the options after this word are those in which B "
            "differs from A");
        addOption(app, "--mesh", "FILE", mesh,
                  "Instead of another run: a mesh (" +
                      listText(pointFormats(), &PointFormat::name, "or", &PointFormat::faces) +
                      ") made from the same points; its vertices are matched by position");
        addOption(app, "--most", "N", limit, "List N regions of difference")->capture_default_str();
        addAnswerOptions(app, "As JSON, with all triangles that only one of the two has",
                         "Only the exit code: 1 if the meshes differ");
        app.footer(app.get_footer() +
                   "\n\nExample: spiraling-edge compare scene:torus --rules paper --with --rules "
                   "robust\nEvery decision begins with an address: spiraling-edge-viewer IN "
                   "OPTIONS --goto ADDRESS shows it.");
    }
};

/// A and B as two runs.
Comparison compareTwoRuns(const CompareArguments& arguments, const RunSpec& other,
                          ProgressLine& line) {
    const std::string& input = arguments.input.input();
    // Read once: standard input cannot be read a second time.
    const PointFile file = arguments.input.read(line);
    const PreparedInput a = arguments.input.prepare(file, arguments.input.spec(), line);
    const PreparedInput b = arguments.input.prepare(file, other, line);
    RunComparison runs = runWithProgress("comparing", input, line, [&](const Progress& progress) {
        return compareRuns({a.points, a.params}, {b.points, b.params}, progress);
    });
    MeshDifference meshes = compareMeshes(a.points.position, runs.a.triangles, runs.b.triangles);
    return {input,
            a.points.size(),
            {titleOf(arguments.input.spec()), runs.a},
            {titleOf(other), runs.b},
            std::move(meshes),
            std::move(runs),
            {}};
}

/// A as a run, B as the finished mesh of a file.
Comparison compareWithMesh(const CompareArguments& arguments, ProgressLine& line) {
    const std::string& input = arguments.input.input();
    const PointFile file = readInput(arguments.mesh, arguments.input.limit());
    if (file.faces.empty())
        throw Failure(ExitCode::Input, arguments.mesh + ": has no triangles to compare with");
    const PreparedInput a = arguments.input.prepare(line);
    MatchedMesh matched = matchMesh(a.points.position, file);
    // The run without B, to know where each triangle was made.
    MadeMesh run = runWithProgress("running", input, line, [&](const Progress& progress) {
        return makeMesh({a.points, a.params}, progress);
    });
    std::vector<Vec3> position = a.points.position;
    position.insert(position.end(), matched.unmatchedVertices.begin(),
                    matched.unmatchedVertices.end());
    MeshDifference meshes = compareMeshes(position, run.triangles, matched.triangles);
    MadeMesh other;
    other.triangles = std::move(matched.triangles);
    return {input,
            a.points.size(),
            {titleOf(arguments.input.spec()), std::move(run)},
            {arguments.mesh, std::move(other)},
            std::move(meshes),
            std::nullopt,
            std::move(matched.unmatchedNumbers)};
}

}  // namespace

ExitCode compareVerb(CLI::App& app, const Arguments& words) {
    const ComparedWords split = splitAtWith(words);
    CompareArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, split.a)) return *code;
    if (split.hasWith == !arguments.mesh.empty())
        refuse("give the other run after --with, or a mesh by --mesh");
    if (split.hasWith && split.with.empty())
        refuse(
            "--with: nothing follows it; give the options in which B differs from A, such "
            "as --rules robust");
    if (arguments.input.input() == kStandardInput && arguments.mesh == kStandardInput)
        refuse("--mesh -: standard input is IN already; name a file");
    // Mistakes in B are reported before the long work.
    const RunSpec other = specOfB(arguments.input.spec(), split.with);
    ProgressLine line(!arguments.quiet);
    const Comparison found =
        split.hasWith ? compareTwoRuns(arguments, other, line) : compareWithMesh(arguments, line);
    if (!arguments.quiet) print(comparisonAnswer(found, arguments.limit), arguments.json);
    return found.meshes.same() ? ExitCode::Good : ExitCode::CheckFailed;
}

}  // namespace se::cli
