// spiraling-edge why: the decisions that put a point, an edge or a triangle into the mesh or not.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "failure_choice.h"
#include "input.h"
#include "output/ledger_text.h"
#include "output/output.h"
#include "progress.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/why/cause_inversion.h"
#include "teach/json_text.h"
#include "verbs.h"

namespace se::cli {
namespace {

/// A failure with the result of its inverted decision, and its number within its class, from 1.
struct InvertedFailure {
    const RunFailure* failure;
    std::size_t number;
    CauseInversion inversion;
};

constexpr std::array kInversions{Inversion::Gone,     Inversion::Later,
                                 Inversion::Earlier,  Inversion::Replaced,
                                 Inversion::NoEffect, Inversion::NotInvertible};

std::size_t countOf(const std::vector<InvertedFailure>& inverted, const FailureClass& kind,
                    std::optional<Inversion> inversion = {}) {
    return static_cast<std::size_t>(
        std::count_if(inverted.begin(), inverted.end(), [&](const InvertedFailure& each) {
            return each.failure->failure.kind == &kind &&
                   (!inversion || each.inversion.outcome == *inversion);
        }));
}

std::string lineFor(const InvertedFailure& each) {
    const LedgerLine& decision = each.failure->moments.unavoidable;
    std::string text = fmt::format("{}:{} {}: {} {}\n", each.failure->failure.kind->name,
                                   each.number, inversionName(each.inversion.outcome),
                                   toString(decision.event.address), describe(decision.event));
    for (const WhatIf& inverse : each.inversion.inverses)
        text += fmt::format("    --what-if \"{}\"\n", lineOf(inverse));
    if (!each.inversion.reason.empty()) text += "    " + each.inversion.reason + "\n";
    return text;
}

/// Counts per class and result, then each failure that did not disappear as predicted.
std::string inversionsText(const std::vector<InvertedFailure>& inverted) {
    if (inverted.empty()) return "No failures found.\n";
    std::string text = fmt::format("{:<24}{:>7}", "decision inverted", "tried");
    const auto column = [](Inversion inversion) { return inversionName(inversion).size() + 3; };
    for (const Inversion inversion : kInversions)
        text += fmt::format("{:>{}}", inversionName(inversion), column(inversion));
    text += "\n";
    for (const FailureClass& kind : failureClasses()) {
        if (countOf(inverted, kind) == 0) continue;
        text += fmt::format("{:<24}{:>7}", kind.name, countOf(inverted, kind));
        for (const Inversion inversion : kInversions)
            text += fmt::format("{:>{}}", countOf(inverted, kind, inversion), column(inversion));
        text += "\n";
    }
    for (const InvertedFailure& each : inverted) {
        if (each.inversion.outcome != Inversion::Gone) text += "\n" + lineFor(each);
    }
    return text;
}

/// All results.
std::string inversionsJson(const std::string& input, const std::vector<InvertedFailure>& inverted) {
    nlohmann::ordered_json json{{"input", input}};
    for (const FailureClass& kind : failureClasses()) {
        if (countOf(inverted, kind) == 0) continue;
        auto& row = json["proved"][std::string(kind.name)];
        for (const Inversion inversion : kInversions)
            row[std::string(inversionName(inversion))] = countOf(inverted, kind, inversion);
    }
    json["proofs"] = nlohmann::ordered_json::array();
    for (const InvertedFailure& each : inverted) {
        nlohmann::ordered_json row{{"class", each.failure->failure.kind->name},
                                   {"number", each.number},
                                   {"points", each.failure->failure.points},
                                   {"unavoidable", lineJson(each.failure->moments.unavoidable)},
                                   {"proof", inversionName(each.inversion.outcome)}};
        for (const WhatIf& inverse : each.inversion.inverses)
            row["what_if"].push_back(lineOf(inverse));
        if (!each.inversion.reason.empty()) row["reason"] = each.inversion.reason;
        json["proofs"].push_back(row);
    }
    return teach::jsonText(json);
}

/// Point numbers from "812,640". Throws Failure unless there are `count` of them.
std::array<Index, 3> pointsFrom(const std::string& option, const std::string& text,
                                std::size_t count) {
    std::array<Index, 3> points{};
    std::size_t found = 0;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (found < count) {
        const auto [next, error] = std::from_chars(at, end, points[found]);
        if (error != std::errc()) break;
        ++found;
        at = next;
        if (at == end || *at != ',') break;
        ++at;
    }
    if (found == count && at == end) return points;
    throw Failure(ExitCode::Usage, "{} {}: expected {}", option, text,
                  count == 1   ? "a point number, such as 812"
                  : count == 2 ? "two points, such as 812,640"
                               : "three points, such as 812,640,77");
}

std::string wordList() {
    std::string text;
    for (const QueryTerm& term : queryTerms())
        text += fmt::format("  {:<18} {}\n", term.form, term.meaning);
    return text;
}

struct WhyArguments {
    InputArguments input;
    std::string point;
    std::string edge;
    std::string triangle;
    std::string ring;
    bool charts = false;
    std::string query;
    std::string failure;
    bool failures = false;
    bool remedy = false;
    bool prove = false;
    std::size_t closest = 0;
    std::size_t limit = 100;
    bool json = false;
    bool quiet = false;

    void addTo(CLI::App& app) {
        input.addTo(app);
        auto* subject = app.add_option_group("Subjects");
        subject->add_option("--point", point, "A point, by its number from 0")->type_name("P");
        subject->add_option("--edge", edge, "The edge of two points")->type_name("P,Q");
        subject->add_option("--triangle", triangle, "The triangle of three points")
            ->type_name("P,Q,R");
        subject
            ->add_option("--ring", ring,
                         "The edge ring at an address: the active one, or with #K the K-th on the "
                         "stack")
            ->type_name("ADDRESS[#K]");
        subject->add_flag("--charts", charts,
                          "No subject: refusals by stage; ring length, candidates and tests of the "
                          "pivots; each with the --find line that lists them");
        subject
            ->add_option("--closest", closest,
                         "No subject: the N decisions closest to going the other way")
            ->type_name("N")
            ->check(CLI::PositiveNumber);
        subject
            ->add_option("--find", query,
                         "No subject: the decisions that a line such as \"stage=sphere kept "
                         "margin<1e-4\" matches")
            ->type_name("LINE");
        subject
            ->add_option("--failure", failure,
                         "No subject: how the first failure of a class, or the Nth, came about; "
                         "classes: spiraling-edge check --help, and leftover_rings, triangle_cap")
            ->type_name("CLASS[:N]");
        subject->add_flag("--failures", failures,
                          "No subject: everything that went wrong, with its three moments");
        subject->require_option(1);
        app.add_flag(
            "--remedy", remedy,
            "With --failure: also the rules of --rules robust that would have prevented it, "
            "by running again with each of them on");
        app.add_flag(
            "--prove", prove,
            "With --failures: inverts the decision that made each of them unavoidable, and "
            "shows which failures disappear");
        app.add_option("--most", limit,
                       "With --find and --failures: list N, of each class; with --prove "
                       "try N of each, spread over all")
            ->type_name("N");
        app.add_flag("--json", json, "As JSON");
        app.add_flag("-q,--quiet", quiet, "Show no progress");
        app.footer("\nTerms of a LINE; all of them must hold:\n" + wordList() +
                   "\nEvery line begins with an address: spiraling-edge-viewer IN --goto ADDRESS "
                   "shows it.\nThe line marked > is the decisive one.");
    }

    Subject subject() const {
        if (!point.empty()) return Subject::point(pointsFrom("--point", point, 1)[0]);
        if (!edge.empty()) {
            const auto p = pointsFrom("--edge", edge, 2);
            return Subject::edge(p[0], p[1]);
        }
        const auto p = pointsFrom("--triangle", triangle, 3);
        return Subject::triangle(p[0], p[1], p[2]);
    }
};

/// Answer about one subject.
std::string askWhy(const WhyArguments& arguments, const PreparedInput& run, ProgressLine& line) {
    const std::string& input = arguments.input.input();
    const Ledger ledger = runWithProgress("asking", input, line, [&](const Progress& progress) {
        return why(run.points, run.params, arguments.subject(), progress);
    });
    return arguments.json ? ledgerJson(input, ledger) : ledgerText(ledger);
}

std::string askQuery(const WhyArguments& arguments, const DecisionQuery& query,
                     const PreparedInput& run, ProgressLine& line) {
    const std::string& input = arguments.input.input();
    const FoundDecisions found =
        runWithProgress("asking", input, line, [&](const Progress& progress) {
            return findDecisions(run.points, run.params, query, arguments.limit, progress);
        });
    return arguments.json ? foundJson(input, found) : foundText(found);
}

/// Answer about all failures of the run.
RunFailureSearch failuresIn(const WhyArguments& arguments, const PreparedInput& run,
                            ProgressLine& line) {
    return runWithProgress("asking", arguments.input.input(), line, [&](const Progress& progress) {
        return searchFailures(run.points, run.params, progress);
    });
}

/// Answer about the three moments of a failure.
std::string askFailure(const WhyArguments& arguments, const FailureChoice& choice,
                       const PreparedInput& run, ProgressLine& line) {
    const std::string& input = arguments.input.input();
    const RunFailureSearch found = failuresIn(arguments, run, line);
    const RunFailure failure = pickFailure(found, choice, input);
    if (!arguments.remedy)
        return arguments.json ? momentsJson(input, failure) : momentsText(failure);
    const Remedies remedies = runWithProgress("trying", input, line, [&](const Progress& progress) {
        return findRemedies(run.points, run.params, failure.failure, progress);
    });
    return arguments.json ? momentsJson(input, failure, &remedies)
                          : momentsText(failure) + remediesText(remedies);
}

/// Answer about whether the decisions are the causes. Of large classes a sample is tried.
std::string askInversions(const WhyArguments& arguments, const PreparedInput& run,
                          const std::vector<RunFailure>& all, ProgressLine& line) {
    const std::string& input = arguments.input.input();
    const std::vector<std::size_t> chosen = sampleOfEach(all, arguments.limit);
    const auto inversions = runWithProgress("turning", input, line, [&](const Progress& progress) {
        return invertCauses(run.points, run.params, all, chosen, progress);
    });
    std::vector<InvertedFailure> inverted;
    inverted.reserve(chosen.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const auto at = all.begin() + static_cast<std::ptrdiff_t>(chosen[i]);
        const auto before = std::count_if(all.begin(), at, [&](const RunFailure& each) {
            return each.failure.kind == at->failure.kind;
        });
        inverted.push_back({&*at, static_cast<std::size_t>(before) + 1, inversions[i]});
    }
    return arguments.json ? inversionsJson(input, inverted) : inversionsText(inverted);
}

std::string askFailures(const WhyArguments& arguments, const PreparedInput& run,
                        ProgressLine& line) {
    const RunFailureSearch found = failuresIn(arguments, run, line);
    if (arguments.prove) return askInversions(arguments, run, found.failures, line);
    return arguments.json ? failuresJson(arguments.input.input(), found)
                          : failuresText(found, arguments.limit);
}

std::string askRing(const WhyArguments& arguments, const RingAddress& ring,
                    const PreparedInput& run, ProgressLine& line) {
    const std::string& input = arguments.input.input();
    const RingHistory history = runWithProgress(
        "asking", input, line,
        [&](const Progress& progress) { return whyRing(run.points, run.params, ring, progress); });
    return arguments.json ? historyJson(input, history) : historyText(history);
}

std::string askCharts(const WhyArguments& arguments, const PreparedInput& run, ProgressLine& line) {
    const std::string& input = arguments.input.input();
    const auto charts = runWithProgress("asking", input, line, [&](const Progress& progress) {
        return runCharts(run.points, run.params, progress);
    });
    return arguments.json ? chartsJson(input, charts) : chartsText(charts);
}

std::string askClosest(const WhyArguments& arguments, const PreparedInput& run,
                       ProgressLine& line) {
    const std::string& input = arguments.input.input();
    const NearestDecisions decisions =
        runWithProgress("asking", input, line, [&](const Progress& progress) {
            return nearestDecisions(run.points, run.params, arguments.closest, progress);
        });
    return arguments.json ? nearestJson(input, decisions) : nearestText(decisions);
}

}  // namespace

ExitCode whyVerb(const Arguments& words) {
    WhyArguments arguments;
    CLI::App app(
        "Explains why a point, an edge or a triangle is in the mesh or is not, and what went "
        "wrong. Give exactly one of --point, --edge, --triangle, --ring, --charts, --closest, "
        "--find, --failure or --failures, described at the end of the options.",
        "spiraling-edge why");
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    // Mistakes in the query are reported before the long work.
    const auto parsed = DecisionQuery::parse(arguments.query);
    if (arguments.remedy && arguments.failure.empty())
        throw Failure(ExitCode::Usage, "--remedy: needs --failure CLASS[:N]");
    if (arguments.prove && !arguments.failures)
        throw Failure(ExitCode::Usage, "--prove: needs --failures");
    const DecisionQuery query = require(parsed, ExitCode::Usage, "--find: ");
    const bool asksFailure = !arguments.failure.empty();
    const auto choice =
        asksFailure ? std::optional(failureChoiceFrom(arguments.failure)) : std::nullopt;
    const bool asksSubject =
        !(arguments.point.empty() && arguments.edge.empty() && arguments.triangle.empty());
    if (asksSubject) (void)arguments.subject();
    std::optional<RingAddress> ring;
    if (!arguments.ring.empty())
        ring = require(ringAddressFromString(arguments.ring), ExitCode::Usage, "--ring ");
    ProgressLine line(!arguments.quiet);
    const PointFile file = arguments.input.read(line);
    PreparedInput run = arguments.input.prepare(file, line);
    if (arguments.failures || choice) {
        run.points.judge = runWithProgress(
            "preparing", arguments.input.input(), line, [&](const Progress& progress) {
                return judgeFor(file, arguments.input.prepareOptions(file), run.points, progress);
            });
    }
    const std::string missing = missingPointIn(arguments.query, run.points.size());
    if (!missing.empty()) throw Failure(ExitCode::Input, arguments.input.input() + ": " + missing);
    const std::string answer = arguments.failures      ? askFailures(arguments, run, line)
                               : choice                ? askFailure(arguments, *choice, run, line)
                               : asksSubject           ? askWhy(arguments, run, line)
                               : ring                  ? askRing(arguments, *ring, run, line)
                               : arguments.charts      ? askCharts(arguments, run, line)
                               : arguments.closest > 0 ? askClosest(arguments, run, line)
                                                       : askQuery(arguments, query, run, line);
    printText(answer);
    return ExitCode::Good;
}

}  // namespace se::cli
