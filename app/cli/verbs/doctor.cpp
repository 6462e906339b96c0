// spiraling-edge doctor: what in a file causes the algorithm trouble, and what can be fixed.
#include "spiraling_edge/doctor/doctor.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <span>

#include "input.h"
#include "output/sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/why/tried_fixes.h"
#include "verbs.h"

namespace se::cli {
namespace {

struct DoctorArguments : AnswerOptions {
    InputArguments input;
    std::string fixed;
    std::vector<std::string> drop;
    bool tryMany = false;
    ForceOption force;

    void addTo(CLI::App& app) {
        input.addTo(app, {SpecGroup::Reading});
        auto* fix = addOutputOption(
            app, "--fix", "OUT.ply", fixed,
            "Fix what needs no guessing and write it to this file; - : to standard output");
        addOption(app, "--drop", "CHECK", drop,
                  "With --fix: also drop what this check proposes; may be repeated")
            ->allow_extra_args(false)
            ->needs(fix);
        force.addTo(app, ", or where fewer than half of the distinct points would be left");
        app.add_flag("--try", tryMany,
                     fmt::format("Try all commands that are named, also on more than {} points or "
                                 "where it takes long",
                                 kManyForFixes));
        addAnswerOptions(app, "As JSON, with all indices",
                         "Only the exit code: 1 if something was found");
        std::string footer = "\nChecks (docs/doctor.md), * fixed by --fix:\n";
        for (const DoctorCheck& check : doctorChecks()) {
            footer += fmt::format("{} {:<18} {:<4} {}\n", check.hasSafeFix() ? "*" : " ",
                                  check.name, check.section, check.upsets);
        }
        footer.pop_back();
        app.footer(footer);
    }

    void validate() const {
        if (!fixed.empty() && fixed != "-" && !fixed.ends_with(".ply"))
            refuse("--fix {}: only .ply is written", fixed);
        if (fixed == "-" && json)
            refuse("--fix -: standard output takes the points or --json, not both");
        force.require({{"", input.input()}}, {{"--fix", fixed}});
        for (const std::string& name : drop) {
            if (findDoctorCheck(name) == nullptr)
                refuse("--drop {}: no such check; see spiraling-edge doctor --help", name);
        }
    }
};

/// Result of the examination and of the fixes.
struct Visit {
    const DoctorArguments& arguments;
    const InputPiece& read;
    Diagnosis findings;
    FixedFile fixed = {};  ///< With --fix.
    Diagnosis left = {};   ///< Findings that the written file still has.
};

/// Leaves out factors for points that are scaled already: one option has one value, and degrees are
/// none any longer.
void dropFactors(Diagnosis& diagnosis) {
    for (Finding& finding : diagnosis.findings) {
        if (!finding.scale) continue;
        finding.scale.reset();
        finding.text.resize(std::min(finding.text.size(), finding.text.find(kWithFactors)));
    }
}

Diagnosis examineInput(const PointFile& file, const std::string& name, ProgressLine& line) {
    return runWithProgress("examining", name, line,
                           [&](const Progress& progress) { return examine(file, progress); });
}

/// Tries the commands that the findings name.
void tryCommands(const DoctorArguments& arguments, const PointFile& file, ProgressLine& line,
                 Diagnosis& diagnosis) {
    if (arguments.quiet || (file.position.size() > kManyForFixes && !arguments.tryMany)) return;
    const std::uint64_t work =
        arguments.tryMany ? std::numeric_limits<std::uint64_t>::max() : kWorkOfFixes;
    runWithProgress(
        "trying fixes on", arguments.input.input(), line,
        [&](const Progress& progress) { return tryFixes(file, diagnosis, progress, work); });
}

std::string placesText(const std::vector<Index>& points) {
    constexpr std::size_t kShown = 10;
    const std::span<const Index> shown(points.data(), std::min(kShown, points.size()));
    return fmt::format("{}{}", fmt::join(shown, ", "), points.size() > kShown ? ", ..." : "");
}

Answer findingAnswer(const Finding& finding, const std::string& input) {
    const DoctorCheck& check = *finding.check;
    const std::string remedy = remedyFor(finding, input);
    Answer answer{
        fmt::format("  {:<8} {}: {}\n", severityName(finding.severity), check.name, finding.text),
        {{"name", check.name},
         {"severity", severityName(finding.severity)},
         {"count", finding.count},
         {"text", finding.text},
         {"section", check.section},
         {"upsets", check.upsets},
         {"remedy", orNull(remedy)},
         {"tried", finding.tried
                       ? Json({{"helps", finding.tried->helps}, {"text", finding.tried->text}})
                       : Json()},
         {"mended", check.hasSafeFix()},
         {"points", finding.points}}};
    const auto addLine = [&](std::string_view label, std::string_view sentence) {
        if (!sentence.empty()) answer.text += fmt::format("           {} {}\n", label, sentence);
    };
    addLine("at point", placesText(finding.points));
    addLine(fmt::format("section {}:", check.section), check.upsets);
    addLine(finding.tried || remedy.empty() ? "try:" : "try (not tried here):", remedy);
    if (finding.tried && finding.tried->helps) addLine("tried:", finding.tried->text);
    if (finding.tried && !finding.tried->helps)
        addLine("without gain:", commandOf(finding, input) + ": " + finding.tried->text);
    return answer;
}

Answer findingsAnswer(const Diagnosis& diagnosis, const std::string& input) {
    Answer all{"", Json::array()};
    for (const Finding& finding : diagnosis.findings) {
        const Answer each = findingAnswer(finding, input);
        all.text += each.text;
        all.json.push_back(each.json);
    }
    return all;
}

/// Adds what was fixed, and what is left.
void addFixed(const Visit& visit, Answer& answer) {
    const std::string& output = visit.arguments.fixed;
    const std::size_t points = visit.fixed.file.position.size();
    answer.text += fmt::format("{}: written, {}\n", printable(output), counted(points, "point"));
    Json fixes = Json::array();
    for (const AppliedFix& fix : visit.fixed.fixes) {
        answer.text += "  fixed    " + fix.text + "\n";
        fixes.push_back({{"name", fix.name}, {"count", fix.count}, {"text", fix.text}});
    }
    for (const Finding& finding : visit.left.findings) {
        if (finding.isProblem())
            answer.text += fmt::format("  left     {}: {}\n", finding.check->name, finding.text);
    }
    answer.json["fixed"] = {{"output", output},
                            {"points", points},
                            {"repairs", fixes},
                            {"findings", findingsAnswer(visit.left, shellPath(output)).json}};
}

/// A line on commands that were not tried; empty if all were.
std::string untriedText(const Diagnosis& diagnosis) {
    const auto isUntried = [](const Finding& each) { return each.hasRemedy() && !each.tried; };
    const auto& findings = diagnosis.findings;
    if (std::none_of(findings.begin(), findings.end(), isUntried)) return {};
    return "  not tried: commands whose runs would take long together; --try tries them, too\n";
}

Answer visitAnswer(const Visit& visit) {
    const std::size_t count = visit.findings.findings.size();
    const InputFacts& facts = visit.findings.facts;
    const std::string size = sizeText(facts);
    const std::string kept = keptSentence(visit.read);
    const RunSpec& spec = visit.arguments.input.spec();
    const std::string words = shellPath(spec.source) + optionsText(spec, {SpecGroup::Reading});
    const Answer found = findingsAnswer(visit.findings, words);
    Answer answer{fmt::format("{}: {}{}{}, {}\n", printable(spec.source),
                              counted(visit.read.kept, "point"), size.empty() ? "" : ", ", size,
                              count == 0 ? "nothing found" : counted(count, "finding")),
                  {{"input", spec.source},
                   {"points", visit.read.kept},
                   {"piece", keptJson(visit.read)},
                   {"facts", inputFactsJson(facts)},
                   {"accused", hasProblem(visit.findings)},
                   {"findings", found.json},
                   {"fixed", Json()}}};
    if (!kept.empty()) answer.text += "  kept     " + kept + "\n";
    answer.text += found.text;
    if (visit.arguments.fixed.empty())
        answer.text += untriedText(visit.findings);
    else
        addFixed(visit, answer);
    return answer;
}

/// Throws Failure(CheckFailed) if the fixes took most points, unless that is permitted.
void requireMostKept(const DoctorArguments& arguments, const PointFile& before,
                     const FixedFile& fixed) {
    const Status most = requireMostLeft(before.position, fixed.file.position, fixed.texts());
    if (most || arguments.force.given()) return;
    const std::string others =
        arguments.drop.empty()
            ? "correct the file at its source"
            : fmt::format("leave out --drop {}", fmt::join(arguments.drop, ", --drop "));
    throw Failure(ExitCode::CheckFailed, "{}: {} not written: {}; {}, or add {} to write the rest",
                  nameOfInput(arguments.input.input()), arguments.fixed, most.error().message,
                  others, kForceOption);
}

}  // namespace

ExitCode doctorVerb(CLI::App& app, const Arguments& words) {
    DoctorArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    arguments.validate();
    const RunSpec& spec = arguments.input.spec();
    ProgressLine line(!arguments.quiet);
    const InputPiece read = readPiece(spec);
    const PointFile& file = read.file;
    Visit visit{arguments, read, examineInput(file, spec.source, line)};
    if (spec.piece.isScaled()) dropFactors(visit.findings);
    if (arguments.fixed.empty()) tryCommands(arguments, file, line, visit.findings);
    if (!arguments.fixed.empty()) {
        const ProposedDrop drop = proposedDrop(visit.findings, arguments.drop);
        visit.fixed = applyFixes(file, drop.points, drop.reason);
        requireMostKept(arguments, file, visit.fixed);
        const PointFile& fixed = visit.fixed.file;
        visit.left = examineInput(fixed, arguments.fixed, line);
        writeMeshOutput(arguments.fixed, fixed, fixed.faces);
    }
    // The text goes to standard error if the points go to standard output.
    if (arguments.fixed == "-" && !arguments.quiet) {
        printNote(visitAnswer(visit).text);
    } else if (!arguments.quiet) {
        print(visitAnswer(visit), arguments.json);
    }
    const bool problemFound = hasProblem(arguments.fixed.empty() ? visit.findings : visit.left);
    return problemFound ? ExitCode::CheckFailed : ExitCode::Good;
}

}  // namespace se::cli
