// spiraling-edge: finds the verb, runs it, and maps every outcome to an exit code.
#include <fmt/format.h>

#include <array>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "options/option_list.h"
#include "output/output.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/operating_system.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/io/write_mesh.h"
#include "verbs.h"

namespace se::cli {
namespace {

struct Verb {
    std::string_view name;
    std::string_view summary;      ///< In the list of verbs.
    std::string_view description;  ///< In its own help; empty: that is the viewer's.
    ExitCode (*function)(CLI::App& app, const Arguments& words);

    ExitCode run(const Arguments& words) const {
        CLI::App app(std::string(description), fmt::format("spiraling-edge {}", name));
        return function(app, words);
    }
};

constexpr std::array kVerbs{
    Verb{"run", "triangulate points; write the mesh, a report, a trace",
         "Triangulates points with normals.", runVerb},
    Verb{"info", "print file information", "Prints the content of a file.", infoVerb},
    Verb{"doctor", "find problems in a file, and fix them",
         "Finds what in a file causes the algorithm trouble, and fixes what needs no guessing.",
         doctorVerb},
    Verb{"why", "explain why a point, an edge or a triangle is in the mesh, or why not",
         "Explains why a point, an edge or a triangle is in the mesh or is not, and what went "
         "wrong. Give exactly one of --point, --edge, --triangle, --ring, --charts, --closest, "
         "--find, --failure or --failures, described at the end of the options.",
         whyVerb},
    Verb{"check", "find the faults of a mesh from any program",
         "Finds the faults of a mesh, of this program or of any other.", checkVerb},
    Verb{"compare", "compare two runs, or a run and a mesh, down to the first differing decision",
         "Compares two runs on the same points, or a run and the mesh of another program.",
         compareVerb},
    Verb{"diff", "compare the trace of another implementation with a run",
         "Compares the trace of another implementation (docs/file-formats.md) with a run: the "
         "first difference, the decisions that account for it, and the rule that, changed alone, "
         "gives the whole trace.",
         diffVerb},
    Verb{"reduce", "reduce an input to a minimal failing case",
         "Reduces an input to a minimal set of points that still fails in the same class.",
         reduceVerb},
    Verb{"sample", "sample points evenly on a shape or an isosurface of a volume",
         "Distributes particles evenly over an isosurface and writes them as points.", sampleVerb},
    Verb{"scenes", "list the built-in scenes",
         "Lists the built-in scenes, the default first, then those that fail, with the class of "
         "the failure and the address of the decision that causes it.",
         scenesVerb},
    Verb{"figures", "list the figures of the paper with their scenes, and check them",
         "Lists the figures of the paper, all or those numbered N: the scene and the decision to "
         "open, the points by the paper's letters, and what goes wrong without the rule.",
         figuresVerb},
    Verb{"lesson", "list, show, check and begin lessons; sum up the results of a class",
         "Lists the lessons, shows one, checks one against its runs (exit code 1 if an answer "
         "disagrees, 3 if the file is malformed), begins a new one on an input, or sums up the "
         "results of a class (docs/lessons.md).",
         lessonVerb},
    Verb{"practice", "print a pivot to play by hand, and grade a try",
         "Prints a pivot to play by hand, drawn from a seed: coordinates, neighbors, edge ring, "
         "and the form of the answer; with --answer, names the first wrong decision.",
         practiceVerb},
    Verb{"table1", "reproduce the paper's Table 1",
         "Samples the five sets of the paper's Table 1, triangulates them and prints the paper's "
         "table beside the result.",
         table1Verb},
    Verb{"view", "open the viewer on a file", "", viewVerb},
    Verb{"render", "write a picture without opening a window",
         "Writes a picture of a run without opening a window. All other options are passed to "
         "spiraling-edge-viewer.",
         renderVerb},
    Verb{"export", "write frames as pictures, an animation or a page",
         "Writes frames of a run or a lesson without opening a window: as pictures, an animation "
         "or a page. All other options are passed to spiraling-edge-viewer.",
         exportVerb},
};

constexpr std::string_view kSummary = "Spiraling Edge surface reconstruction.";

/// The end of the help, after the list of verbs.
std::string footerText() {
    return fmt::format(
        "`spiraling-edge VERB --help` lists the options of a verb; with --json, as JSON.\n"
        "An input is a {} file, `-` for standard input, or scene:ID.\n"
        "\n"
        "  -h, --help     print this and exit\n"
        "  --version      print the version and exit\n"
        "\n"
        "Exit codes: 0 success, 1 ran but a check failed, 2 wrong usage, 3 input missing or\n"
        "malformed, 4 no display, 5 internal error, 130 interrupted.\n",
        listText(pointFormats(), &PointFormat::name, "or"));
}

std::string helpText() {
    std::string text =
        std::string(kSummary) +
        "\n\n"
        "Usage: spiraling-edge VERB [OPTIONS]\n"
        "       spiraling-edge FILE          the same as spiraling-edge view FILE\n\n"
        "Verbs:\n";
    for (const Verb& verb : kVerbs) text += fmt::format("  {:<8} {}\n", verb.name, verb.summary);
    return text + "\n" + footerText();
}

/// A line of JSON about the program, and one with the options of each verb, except those of view,
/// which are the viewer's.
void printOptionLists() {
    nlohmann::ordered_json list{{"name", "spiraling-edge"},
                                {"description", kSummary},
                                {"version", SPIRALING_EDGE_VERSION},
                                {"verbs", nlohmann::ordered_json::array()},
                                {"footer", footerText()}};
    for (const Verb& verb : kVerbs)
        list["verbs"].push_back({{"name", verb.name}, {"summary", verb.summary}});
    printText(list.dump() + "\n");
    for (const Verb& verb : kVerbs) {
        if (!verb.description.empty()) verb.run({"--help", "--json"});
    }
}

/// Handles a first word that is no verb: an input for the viewer, or a mistake.
ExitCode runWithoutVerb(const Arguments& arguments) {
    const std::string& word = arguments.front();
    std::error_code ignored;
    if (std::filesystem::exists(word, ignored) || word.starts_with("scene:"))
        return findNamed(kVerbs, "view")->run(arguments);
    if (word.starts_with("-")) refuse("{}: no such option; see spiraling-edge --help", word);
    if (word.find_first_of("./") != std::string::npos)
        throw Failure(ExitCode::Input, word + ": no such file");
    refuse("{}: neither a verb nor a file; see spiraling-edge --help", word);
}

ExitCode dispatch(const Arguments& arguments) {
    if (arguments.empty()) {
        printNote(helpText());
        return ExitCode::Usage;
    }
    const std::string& word = arguments.front();
    if (asksForOptionList(arguments)) {
        printOptionLists();
        return ExitCode::Good;
    }
    const Verb* second = arguments.size() > 1 ? findNamed(kVerbs, arguments[1]) : nullptr;
    if (word == "help" && second != nullptr) return second->run({"--help"});
    if (word == "-h" || word == "--help" || word == "help") {
        printText(helpText());
        return ExitCode::Good;
    }
    if (word == "--version") {
        printText(fmt::format("spiraling-edge {}\n", SPIRALING_EDGE_VERSION));
        return ExitCode::Good;
    }
    if (const Verb* verb = findNamed(kVerbs, word))
        return verb->run(Arguments(arguments.begin() + 1, arguments.end()));
    return runWithoutVerb(arguments);
}

}  // namespace

std::optional<ExitCode> parseArguments(CLI::App& app, const Arguments& arguments) {
    if (asksForOptionList(arguments)) {
        printText(optionList(app));
        return ExitCode::Good;
    }
    Arguments reversed(arguments.rbegin(), arguments.rend());  // in the order that CLI11 expects
    try {
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        printText(app.help());
        return ExitCode::Good;
    } catch (const CLI::ParseError& problem) {
        refuse("{}; see {} --help", problem.what(), app.get_name());
    }
    return std::nullopt;
}

}  // namespace se::cli

int main(int argc, char** argv) {
    using se::cli::ExitCode;
    const auto say = [](const char* message) {
        se::cli::printNote(fmt::format("spiraling-edge: {}\n", se::printable(message)));
    };
    se::os::returnFreedMemory();
    se::removeUnfinishedFilesAtSignals(
        "\nspiraling-edge: interrupted; no file is left half written\n");
    ExitCode code = ExitCode::Internal;
    try {
        code = se::cli::dispatch(se::cli::Arguments(argv + 1, argv + argc));
    } catch (const se::cli::Failure& failure) {
        say(failure.what());
        code = failure.code();
    } catch (const std::bad_alloc&) {
        say("out of memory");
    } catch (const std::exception& problem) {
        say(problem.what());
    }
    return static_cast<int>(code);
}
