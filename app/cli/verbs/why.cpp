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

using Json = nlohmann::ordered_json;

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
Json inversionsJson(const std::vector<InvertedFailure>& inverted) {
    Json json;
    for (const FailureClass& kind : failureClasses()) {
        if (countOf(inverted, kind) == 0) continue;
        auto& row = json["proved"][std::string(kind.name)];
        for (const Inversion inversion : kInversions)
            row[std::string(inversionName(inversion))] = countOf(inverted, kind, inversion);
    }
    json["proofs"] = Json::array();
    for (const InvertedFailure& each : inverted) {
        Json row{{"class", each.failure->failure.kind->name},
                 {"number", each.number},
                 {"points", each.failure->failure.points},
                 {"unavoidable", lineJson(each.failure->moments.unavoidable)},
                 {"proof", inversionName(each.inversion.outcome)}};
        for (const WhatIf& inverse : each.inversion.inverses)
            row["what_if"].push_back(lineOf(inverse));
        if (!each.inversion.reason.empty()) row["reason"] = each.inversion.reason;
        json["proofs"].push_back(row);
    }
    return json;
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

    bool asksSubject() const { return !(point.empty() && edge.empty() && triangle.empty()); }
    /// The subject. Throws Failure(Usage) if its points are no numbers. Requires asksSubject().
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

/// The JSON of an answer.
std::string documentOf(const WhyArguments& arguments, const Json& fields) {
    Json json{{"input", arguments.input.input()}};
    json.update(fields);
    return teach::jsonText(json);
}

/// Runs a search with the line of progress. Throws Failure if it fails.
template <typename Search>
auto searched(const WhyArguments& arguments, const char* what, ProgressLine& line,
              const Search& search) {
    return runWithProgress(what, arguments.input.input(), line, search);
}

/// Answer by a search whose result has answerText() and answerJson().
template <typename Search>
std::string ask(const WhyArguments& arguments, ProgressLine& line, const Search& search) {
    const auto found = searched(arguments, "asking", line, search);
    return arguments.json ? documentOf(arguments, answerJson(found)) : answerText(found);
}

/// Answer about the failure of a choice: its three moments, and what would have prevented it.
std::string askFailure(const WhyArguments& arguments, const FailureChoice& choice,
                       const RunFailureSearch& found, const PreparedInput& run,
                       ProgressLine& line) {
    const RunFailure failure = pickFailure(found, choice, arguments.input.input());
    std::string text = answerText(failure);
    Json json = answerJson(failure);
    if (arguments.remedy) {
        const Remedies remedies =
            searched(arguments, "trying", line, [&](const Progress& progress) {
                return findRemedies(run.points, run.params, failure.failure, progress);
            });
        text += answerText(remedies);
        json["remedies"] = answerJson(remedies);
    }
    return arguments.json ? documentOf(arguments, json) : text;
}

/// Answer about whether the decisions are the causes. Of large classes a sample is tried.
std::string askInversions(const WhyArguments& arguments, const PreparedInput& run,
                          const std::vector<RunFailure>& all, ProgressLine& line) {
    const std::vector<std::size_t> chosen = sampleOfEach(all, arguments.limit);
    const auto inversions = searched(arguments, "turning", line, [&](const Progress& progress) {
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
    return arguments.json ? documentOf(arguments, inversionsJson(inverted))
                          : inversionsText(inverted);
}

/// Answer about what went wrong in a run: all of it, or the failure of a choice.
std::string askFailures(const WhyArguments& arguments, const std::optional<FailureChoice>& choice,
                        const PreparedInput& run, ProgressLine& line) {
    const RunFailureSearch found = searched(
        arguments, "asking", line,
        [&](const Progress& progress) { return searchFailures(run.points, run.params, progress); });
    if (choice) return askFailure(arguments, *choice, found, run, line);
    if (arguments.prove) return askInversions(arguments, run, found.failures, line);
    return arguments.json ? documentOf(arguments, answerJson(found))
                          : failuresText(found, arguments.limit);
}

/// Answer about the subject, the ring, the charts, the closest decisions or those of a query.
std::string askRun(const WhyArguments& arguments, const std::optional<RingAddress>& ring,
                   const DecisionQuery& query, const PreparedInput& run, ProgressLine& line) {
    if (arguments.asksSubject())
        return ask(arguments, line, [&](const Progress& progress) {
            return why(run.points, run.params, arguments.subject(), progress);
        });
    if (ring)
        return ask(arguments, line, [&](const Progress& progress) {
            return whyRing(run.points, run.params, *ring, progress);
        });
    if (arguments.charts)
        return ask(arguments, line, [&](const Progress& progress) {
            return runCharts(run.points, run.params, progress);
        });
    if (arguments.closest > 0)
        return ask(arguments, line, [&](const Progress& progress) {
            return nearestDecisions(run.points, run.params, arguments.closest, progress);
        });
    return ask(arguments, line, [&](const Progress& progress) {
        return findDecisions(run.points, run.params, query, arguments.limit, progress);
    });
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
    std::optional<FailureChoice> choice;
    if (!arguments.failure.empty()) choice = failureChoiceFrom(arguments.failure);
    if (arguments.asksSubject()) (void)arguments.subject();
    std::optional<RingAddress> ring;
    if (!arguments.ring.empty())
        ring = require(ringAddressFromString(arguments.ring), ExitCode::Usage, "--ring ");
    ProgressLine line(!arguments.quiet);
    const PointFile file = arguments.input.read(line);
    PreparedInput run = arguments.input.prepare(file, line);
    const bool asksFailures = arguments.failures || choice;
    if (asksFailures) {
        run.points.judge = searched(arguments, "preparing", line, [&](const Progress& progress) {
            return judgeFor(file, arguments.input.prepareOptions(file), run.points, progress);
        });
    }
    const std::string missing = missingPointIn(arguments.query, run.points.size());
    if (!missing.empty())
        throw Failure(ExitCode::Input, "{}: {}", arguments.input.input(), missing);
    printText(asksFailures ? askFailures(arguments, choice, run, line)
                           : askRun(arguments, ring, query, run, line));
    return ExitCode::Good;
}

}  // namespace se::cli
