/// A query line is a conjunction of words; the table of terms (decision_terms.cpp) gives each word
/// its condition once, and a scan then tests every decision of one run against it. Nothing of the
/// run is stored. Failures are detected only where a term needs them, since that doubles the cost.
#include "spiraling_edge/run/decision_query.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/run/live_check.h"

namespace se {
namespace {

/// The classes detected at a single decision: by LiveCheck, or by plainFailures().
constexpr std::string_view kInRun[] = {"non_manifold_edges",
                                       "non_manifold_vertices",
                                       "inconsistent_edges",
                                       "duplicate_triangles",
                                       "degenerate_triangles",
                                       "intersecting_triangles",
                                       "folded_edges",
                                       "second_layers",
                                       "flipped_triangles",
                                       "slivers",
                                       "holes",
                                       "lost_points",
                                       "leftover_rings",
                                       "triangle_cap"};

std::uint32_t bitOf(std::string_view name) { return failureBit(*findFailureClass(name)); }

/// The failures that one event causes by itself.
std::uint32_t plainFailures(const Event& event, const PointSet& points) {
    if (const auto* emit = as<EmitEvidence>(event)) {
        const bool thin = leastAngleCosine(points, emit->corners) > kSliverCosine;
        return thin && !isDegenerate(points, emit->corners) ? bitOf("slivers") : 0;
    }
    const auto* alert = as<AlertEvidence>(event);
    if (alert == nullptr) return 0;
    if (alert->kind == AlertKind::TriangleCap) return bitOf("triangle_cap");
    return bitOf("leftover_rings") | (alert->kind == AlertKind::Hole ? bitOf("holes") : 0);
}

/// The meaning of a word; an empty condition if it is of no known form.
struct WordMeaning {
    DecisionCondition condition;
    bool needsFailures = false;
};
Result<WordMeaning> meaningOf(std::string_view word) {
    WordMeaning found;
    for (const QueryTerm& term : queryTerms()) {
        Result<DecisionCondition> condition = term.read(word);
        if (!condition) return condition.error();
        if (condition.value()) found = {std::move(condition.value()), term.needsFailures};
    }
    return found;
}

/// Prefixes of the number of a point, or several: "edge=812,640", "among=3..9".
constexpr std::string_view kNaming[] = {
    "point=", "pivot=", "used=", "done=", "stranded=", "edge=", "among=", "status="};

constexpr std::string_view kDigits = "0123456789";

bool namesPoints(std::string_view word) {
    return std::any_of(std::begin(kNaming), std::end(kNaming),
                       [&](std::string_view each) { return word.starts_with(each); });
}

/// The first number in `word` that is not below `points`; empty if there is none.
std::string_view beyond(std::string_view word, std::size_t points) {
    while (true) {
        word.remove_prefix(std::min(word.find_first_of(kDigits), word.size()));
        if (word.empty()) return {};
        const std::string_view digits = word.substr(0, word.find_first_not_of(kDigits));
        if (numberIn<std::size_t>(digits).value_or(points) >= points) return digits;
        word.remove_prefix(digits.size());
    }
}

}  // namespace

std::uint32_t failureBit(const FailureClass& kind) {
    return std::uint32_t{1} << static_cast<unsigned>(&kind - failureClasses().data());
}

bool appearsInRun(const FailureClass& kind) {
    return std::find(std::begin(kInRun), std::end(kInRun), kind.name) != std::end(kInRun);
}

PivotVisitor decisionVisitor(const PointSet& points, const Params& params, bool failures,
                             std::function<void(const Decision&, RunPosition)> visit) {
    struct Scan {
        std::optional<LiveCheck> live;
        RunPosition place;
    };
    const auto scan = std::make_shared<Scan>();
    if (failures) scan->live.emplace(points, params.start);
    return [&points, &params, scan, visit = std::move(visit)](const SweptPivot& pivot) {
        auto& [live, place] = *scan;
        for (const Event& event : pivot.events) {
            const auto reading = readingOf(event, {points, params, pivot.point});
            std::uint32_t bits = live ? plainFailures(event, points) : 0;
            if (live)
                for (const LiveFailure& each : live->check(event)) bits |= failureBit(*each.kind);
            const bool same = event.address.pivot == place.pivot;
            place = {event.address.pivot, same ? place.event + 1 : 0};
            visit({event, pivot.point, reading, points, pivot.events, bits}, place);
        }
    };
}

std::optional<QueryMistake> mistakeIn(std::string_view line) {
    for (const std::string& word : io::wordsIn(line)) {
        const Result<WordMeaning> meaning = meaningOf(word);
        if (!meaning) return QueryMistake{word, meaning.error().message, false};
        if (!meaning.value().condition)
            return QueryMistake{word, inQuotes(word) + " is not understood.", true};
    }
    return {};
}

std::string missingPointIn(std::string_view line, std::size_t points) {
    for (const std::string& word : io::wordsIn(line)) {
        const std::string_view number = namesPoints(word) ? beyond(word, points) : "";
        if (number.empty()) continue;
        return "There is no point " + std::string(number) +
               (points == 0 ? ": there are no points."
                            : ": the points are 0 to " + std::to_string(points - 1) + ".");
    }
    return {};
}

Result<DecisionQuery> DecisionQuery::parse(std::string_view line) {
    if (const auto mistake = mistakeIn(line)) {
        if (!mistake->isUnknown) return Error{mistake->message};
        const std::string forms =
            joined(queryTerms(), ", ", [](const QueryTerm& term) { return term.form; });
        return Error{inQuotes(mistake->word) + " is not understood; there are " + forms + "."};
    }
    DecisionQuery query;
    for (const std::string& word : io::wordsIn(line)) {
        WordMeaning meaning = meaningOf(word).value();
        query.conditions_.push_back(std::move(meaning.condition));
        query.needsFailures_ = query.needsFailures_ || meaning.needsFailures;
    }
    return query;
}

bool DecisionQuery::matches(const Decision& decision) const {
    return std::all_of(conditions_.begin(), conditions_.end(),
                       [&](const DecisionCondition& holds) { return holds(decision); });
}

Question<FoundDecisions> decisionsQuestion(const PointSet& points, const Params& params,
                                           const DecisionQuery& query, std::size_t limit) {
    const auto found = std::make_shared<FoundDecisions>();
    const auto onDecision = [&points, &params, query, limit, found](const Decision& decision,
                                                                    RunPosition) {
        if (!query.matches(decision)) return;
        ++found->total;
        if (found->lines.size() < limit)
            found->lines.push_back(lineOf(decision.event, {points, params, decision.pivot}));
    };
    return {decisionVisitor(points, params, query.needsFailures(), onDecision),
            [found](const State&) -> Result<FoundDecisions> { return std::move(*found); }};
}

Result<FoundDecisions> findDecisions(const PointSet& points, const Params& params,
                                     const DecisionQuery& query, std::size_t limit,
                                     const Progress& progress) {
    return ask(points, params, decisionsQuestion(points, params, query, limit), progress);
}

}  // namespace se
