// spiraling-edge why: the decisions that put a point, an edge or a triangle into the mesh or not.
#include <fmt/format.h>
#include <array>
#include <charconv>
#include <string>

#include "input.h"
#include "output/failures.h"
#include "output/ledger_text.h"
#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/why/proof.h"
#include "verbs.h"

namespace se::cli {
namespace {

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
    refuse("{} {}: expected {}", option, text,
           count == 1   ? "a point number, such as 812"
           : count == 2 ? "two points, such as 812,640"
                        : "three points, such as 812,640,77");
}

struct WhyArguments : AnswerOptions {
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
    bool more = false;
    std::size_t closest = 0;
    std::size_t limit = 100;

    void addTo(CLI::App& app) {
        input.addTo(app);
        auto* subject = app.add_option_group("Subjects");
        addOption(*subject, "--point", "P", point, "A point, by its number from 0");
        addOption(*subject, "--edge", "P,Q", edge, "The edge of two points");
        addOption(*subject, "--triangle", "P,Q,R", triangle, "The triangle of three points");
        addOption(*subject, "--ring", "ADDRESS[#K]", ring,
                  "The edge ring at an address: the active one, or with #K the K-th on the "
                  "stack");
        subject->add_flag("--charts", charts,
                          "No subject: refusals by stage; ring length, candidates and tests of the "
                          "pivots; each with the --find line that lists them");
        addOption(*subject, "--closest", "N", closest,
                  "No subject: the N decisions closest to going the other way")
            ->check(wholeNumber(1));
        addOption(*subject, "--find", "LINE", query,
                  "No subject: the decisions that a line such as \"stage=sphere kept "
                  "margin<1e-4\" matches");
        addOption(*subject, "--failure", "CLASS[:N]", failure,
                  "No subject: how the first failure of a class, or the Nth, came about; "
                  "classes: spiraling-edge check --help, and leftover_rings, triangle_cap");
        subject->add_flag("--failures", failures,
                          "No subject: everything that went wrong, with its three moments");
        subject->require_option(1);
        app.add_flag("--remedy", remedy,
                     "Not needed: the answer names a change, if one prevents it")
            ->group("");
        app.add_flag("--prove", prove, "Not needed: --failure proves")->group("");
        app.add_flag("--more", more,
                     "With --point, --edge, --triangle and --failure: look for the proof with up "
                     "to 200 inverted decisions instead of 20");
        addOption(app, "--most", "N", limit, "With --find and --failures: list N, of each class");
        addAnswerOptions(app, "As JSON", "Show no progress");
        std::string footer = "\nTerms of a LINE; all of them must hold:\n";
        for (const QueryTerm& term : queryTerms())
            footer += fmt::format("  {:<18} {}\n", term.form, term.meaning);
        app.footer(footer +
                   "\nEvery line begins with an address: spiraling-edge-viewer IN --goto ADDRESS "
                   "shows it.\nThe line marked > is the decisive one; the answer says whether it "
                   "is proved.");
    }

    /// The scope of proofs for the run of a file's points; both must outlive it.
    ProofScope proofScope(const PointFile& file, const PreparedInput& run) const {
        ProofScope scope = more ? ProofScope::wide() : ProofScope{};
        scope.alternatives = [&](const Progress& progress) -> Result<Alternatives> {
            const auto judge = judgeOf(file, run, progress);
            if (!judge) return judge.error();
            return alternativesOf(file, input.spec(), judge.value());
        };
        return scope;
    }
    /// The judge of the meshes of a run, once.
    Result<std::shared_ptr<const MeshJudge>> judgeOf(const PointFile& file,
                                                     const PreparedInput& run,
                                                     const Progress& progress) const {
        if (run.points.judge) return run.points.judge;
        return judgeOfRun(file, input.prepareOptions(file), run.params, run.points, progress);
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

/// Runs a search with the line of progress. Throws Failure if it fails.
template <typename Search>
auto searched(const WhyArguments& arguments, const char* what, ProgressLine& line,
              const Search& search) {
    return runWithProgress(what, arguments.input.input(), line, search);
}

/// Answer about what went wrong in a run: all of it, or the failure of a choice, with its three
/// moments, the proof of its cause, and what prevents it.
Answer askFailures(const WhyArguments& arguments, const std::optional<FailureChoice>& choice,
                   const PreparedInput& run, const ProofScope& scope, ProgressLine& line) {
    const RunFailureSearch found = searched(
        arguments, "asking", line,
        [&](const Progress& progress) { return searchFailures(run.points, run.params, progress); });
    if (!choice) return answerOf(found, arguments.limit);
    const auto kindOf = [](const RunFailure& each) { return each.failure.kind; };
    const RunFailure& failure =
        pickFailure(found.failures, kindOf, found.verdict.totals, *choice, arguments.input.input());
    Answer answer = answerOf(failure);
    const Answer proof =
        answerOf(searched(arguments, "proving", line, [&](const Progress& progress) {
            return provedWhy(run.points, run.params, failure, found.all, scope, progress);
        }));
    answer.text += "\n" + proof.text;
    answer.json.update(proof.json);
    return answer;
}

/// Answer about the subject, the ring, the charts, the closest decisions or those of a query.
Answer askRun(const WhyArguments& arguments, const std::optional<RingAddress>& ring,
              const DecisionQuery& query, const PreparedInput& run, const ProofScope& scope,
              ProgressLine& line) {
    // A search that takes the run, and these values.
    const auto ask = [&](const auto& search, const auto&... values) {
        return answerOf(searched(arguments, "asking", line, [&](const Progress& progress) {
            return search(run.points, run.params, values..., progress);
        }));
    };
    if (arguments.asksSubject()) {
        const Subject subject = arguments.subject();
        Answer answer = answerOf(searched(arguments, "asking", line, [&](const Progress& progress) {
            return provedWhy(run.points, run.params, subject, scope, progress);
        }));
        answer.json["subject"] = subject.points();
        return answer;
    }
    if (ring) return ask(whyRing, *ring);
    if (arguments.charts) return ask(runCharts);
    if (arguments.closest > 0) return ask(nearestDecisions, arguments.closest);
    return ask(findDecisions, query, arguments.limit);
}

}  // namespace

ExitCode whyVerb(CLI::App& app, const Arguments& words) {
    WhyArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    // Mistakes in the query are reported before the long work.
    const auto parsed = DecisionQuery::parse(arguments.query);
    if (arguments.remedy && !arguments.quiet)
        printNote(
            "--remedy is not needed: the answer names a change that prevents it, if one does.\n");
    if (arguments.prove && !arguments.quiet && arguments.failures)
        printNote("--prove is not needed: --failure CLASS:N proves its cause.\n");
    if (arguments.more && !arguments.asksSubject() && arguments.failure.empty())
        refuse("--more: needs --point, --edge, --triangle or --failure");
    const DecisionQuery query = require(parsed, ExitCode::Usage, "--find: ");
    std::optional<FailureChoice> choice;
    if (!arguments.failure.empty()) choice = failureChoiceFrom(arguments.failure);
    if (arguments.asksSubject()) (void)arguments.subject();
    std::optional<RingAddress> ring;
    if (!arguments.ring.empty())
        ring = require(ringAddressFromString(arguments.ring), ExitCode::Usage, "--ring ");
    ProgressLine line(!arguments.quiet);
    const PointFile file = arguments.input.read(line);
    PreparedInput run = arguments.input.prepare(file, arguments.input.spec(), line);
    const bool asksFailures = arguments.failures || choice;
    if (asksFailures) {
        run.points.judge = searched(arguments, "preparing", line, [&](const Progress& progress) {
            return arguments.judgeOf(file, run, progress);
        });
    }
    const std::string missing = missingPointIn(arguments.query, run.points.size());
    if (!missing.empty())
        throw Failure(ExitCode::Input, "{}: {}", arguments.input.input(), missing);
    const ProofScope scope = arguments.proofScope(file, run);
    const Answer answer = asksFailures ? askFailures(arguments, choice, run, scope, line)
                                       : askRun(arguments, ring, query, run, scope, line);
    Json json{{"input", arguments.input.input()}};
    json.update(answer.json);
    print({answer.text, json}, arguments.json);
    return ExitCode::Good;
}

}  // namespace se::cli
