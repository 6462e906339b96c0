// spiraling-edge figures: the figures of the paper, where to see them, and whether they hold.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "input.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/why/figure_check.h"
#include "teach/trace/conformance.h"
#include "teach/trace/setrace.h"
#include "verbs.h"

namespace se::cli {
namespace {

struct FigureArguments {
    std::vector<int> numbers;
    std::string volumes;
    std::string conformance;
    bool check = false;
    ByteLimit limit;

    void addTo(CLI::App& app) {
        app.add_option("N", numbers, "Numbers of figures (default: all)")
            ->check(CLI::Range(1, static_cast<int>(figures().size())));
        app.add_flag("--check", check,
                     "Run each figure, with and without its rule; exit with 1 if one does not "
                     "show what it should");
        addOption(
            app, "--volumes", "DIR", volumes,
            "With --check: folder with the volumes of Figures 22 and 25 (docs/performance.md)");
        addByteLimit(app, limit);
        addOption(app, "--conformance", "DIR", conformance,
                  "Write inputs that show all of the paper's rules, the figures among them, "
                  "to this folder: points with lists, starts and traces");
    }
    bool isWanted(const Figure& figure) const {
        return numbers.empty() ||
               std::find(numbers.begin(), numbers.end(), figure.number) != numbers.end();
    }
};

/// The text of a figure, and whether it holds; unchecked ones do.
struct FigureText {
    std::string text;
    bool holds = true;
};

std::string namesText(const Figure& figure) {
    std::string text;
    for (const PointName& each : figure.pointNames())
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", each.name, each.point);
    return text;
}

std::string ruleText(const Figure& figure) {
    const RuleSetting& rule = *findRuleSetting(figure.rule.name);
    return fmt::format("--rule {}={}", rule.name, valueText(rule, figure.rule.value));
}

std::string headText(const Figure& figure) {
    std::string text = fmt::format("{}\n  {}\n", figure.scene.title, figure.scene.watch);
    const std::string source = sourceOf(figure);
    if (!figure.hasScene()) {
        text += source.empty() ? fmt::format("  needs    the volume {}\n", figure.volume)
                               : fmt::format("  open     {} (in the viewer)\n", source);
        return text + fmt::format("  table 1  {} points, {} triangles\n", figure.counts.points,
                                  figure.counts.triangles);
    }
    text += fmt::format("  open     {} --goto {}\n", source, figure.scene.address);
    if (!figure.names.empty()) text += fmt::format("  points   {}\n", namesText(figure));
    text += fmt::format("  without  {}: {}\n", ruleText(figure), figure.absence);
    if (!figure.without.empty() && !figure.without.front().outcome.empty()) {
        text += fmt::format("  seen     {} {} --goto {}\n", source, ruleText(figure),
                            figure.without.front().address);
    }
    return text;
}

/// "t: removed"
std::string expectedText(const FigureExpectation& expected) {
    return fmt::format("{}{}{}", expected.points, expected.points.empty() ? "" : ": ",
                       expected.outcome.empty() ? "no such decision" : expected.outcome);
}

/// A line for each expectation; `run` names the run that they are of.
std::string checkedText(const std::vector<CheckedExpectation>& list, std::string_view run) {
    std::string text;
    for (const CheckedExpectation& each : list) {
        text += fmt::format("  {:<8} {}{} {}\n", each.holds ? "holds" : "FAILS", run,
                            each.expected.address, expectedText(each.expected));
        if (!each.holds) {
            text += fmt::format("           found: {}\n",
                                each.found.empty() ? "no such decision" : each.found);
        }
    }
    return text;
}

FigureText checkedScene(const Figure& figure) {
    const FigureCheck check = checkFigure(figure);
    FigureText checked{checkedText(check.expectations, ""), check.holds()};
    checked.text += fmt::format("  {:<8} {}: {} of {} decisions change",
                                check.showsAbsence ? "differs" : "FAILS", ruleText(figure),
                                check.brokenWithout, check.expectations.size());
    if (figure.fault)
        checked.text += fmt::format("; faults: {} without the rule, {} with it",
                                    check.faultsWithout, check.faultsWith);
    checked.text += "\n" + checkedText(check.without, "without it: ");
    return checked;
}

/// A figure of the results: as many points as in the paper, and within 2 % as many triangles.
FigureText checkedResult(const Figure& figure, const FigureArguments& arguments,
                         ProgressLine& line) {
    constexpr std::size_t kPercent = 2;
    const std::string surface = surfaceOf(figure, arguments.volumes);
    if (surface.empty()) return {"  skipped  give its volume with --volumes\n", true};
    SamplerOptions sampling;
    sampling.count = figure.counts.points;
    const PointFile file =
        samplePoints(readSurface(surface, std::nullopt, arguments.limit), sampling, surface, line);
    PrepareOptions options;
    options.neighbors.reach = WithinSpacings{};
    const Prepared prepared = require(prepare(file, options), ExitCode::Internal);
    const std::size_t made = reconstruct(prepared.points, {}).state.mesh().size();
    const std::size_t wanted = figure.counts.triangles;
    const std::size_t off = made > wanted ? made - wanted : wanted - made;
    const bool holds =
        file.position.size() == figure.counts.points && 100 * off <= kPercent * wanted;
    return {fmt::format("  {:<8} {} points, {} triangles\n", holds ? "holds" : "FAILS",
                        file.position.size(), made),
            holds};
}

ExitCode writeConformance(const std::filesystem::path& folder) {
    std::error_code problem;
    std::filesystem::create_directory(folder, problem);
    if (!std::filesystem::is_directory(folder))
        refuse("--conformance {}: no folder, and it cannot be made", folder.string());
    for (const teach::ConformanceInput& input : teach::conformanceInputs()) {
        const teach::ConformanceCase made = teach::conformanceCase(input);
        const std::string path = (folder / input.name).string();
        writeMeshOutput(path + ".ply", made.file, {});
        if (!made.start.empty()) writeOutput(path + ".start.json", startJson(made.start) + "\n");
        writeOutput(path + std::string(teach::kTraceExtension), teach::conformanceTrace(made));
        printText(fmt::format("{:<16}  {:>4} points  {}\n", input.name, made.points->size(),
                              input.shows));
    }
    return ExitCode::Good;
}

}  // namespace

ExitCode figuresVerb(CLI::App& app, const Arguments& words) {
    FigureArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    if (!arguments.volumes.empty() && !std::filesystem::is_directory(arguments.volumes))
        refuse("--volumes {}: no such folder", arguments.volumes);
    if (!arguments.conformance.empty()) {
        if (arguments.check || !arguments.numbers.empty())
            refuse("--conformance: takes neither numbers nor --check");
        return writeConformance(arguments.conformance);
    }
    ProgressLine line(arguments.check);
    std::size_t failed = 0;
    for (const Figure& figure : figures()) {
        if (!arguments.isWanted(figure)) continue;
        FigureText checked;
        if (arguments.check) {
            checked =
                figure.hasScene() ? checkedScene(figure) : checkedResult(figure, arguments, line);
        }
        printText(headText(figure) + checked.text);
        failed += checked.holds ? 0 : 1;
    }
    if (failed > 0) {
        throw Failure(ExitCode::CheckFailed, "{} of the figures {} not hold", failed,
                      failed == 1 ? "does" : "do");
    }
    return ExitCode::Good;
}

}  // namespace se::cli
