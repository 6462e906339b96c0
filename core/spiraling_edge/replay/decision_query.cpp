#include "spiraling_edge/replay/decision_query.h"

#include <algorithm>

#include "spiraling_edge/replay/decision_line.h"
#include "spiraling_edge/replay/decision_scan.h"

namespace se {

namespace {

/// Takes the first word off the line; empty if there is none.
std::string_view takeWord(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(" \t"));
    line.remove_prefix(word.size());
    return word;
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

}  // namespace

std::optional<QueryMistake> mistakeIn(std::string_view line) {
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
        const Result<WordMeaning> meaning = meaningOf(word);
        if (!meaning) return QueryMistake{std::string(word), meaning.error().message, false};
        if (!meaning.value().condition) {
            const std::string message = "\"" + std::string(word) + "\" is not understood.";
            return QueryMistake{std::string(word), message, true};
        }
    }
    return {};
}

Result<DecisionQuery> DecisionQuery::parse(std::string_view line) {
    if (const auto mistake = mistakeIn(line)) {
        if (!mistake->isUnknown) return Error{mistake->message};
        std::string forms;
        for (const QueryTerm& term : queryTerms())
            forms += (forms.empty() ? "" : ", ") + std::string(term.form);
        return Error{"\"" + mistake->word + "\" is not understood; there are " + forms + "."};
    }
    DecisionQuery query;
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
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

Result<FoundDecisions> findDecisions(const PointSet& points, const Params& params,
                                     const DecisionQuery& query, std::size_t limit,
                                     const Progress& progress) {
    FoundDecisions found;
    const auto onDecision = [&](const Decision& decision, RunPosition) {
        if (!query.matches(decision)) return;
        ++found.total;
        if (found.lines.size() < limit)
            found.lines.push_back(lineOf(decision.event, {points, params, decision.pivot}));
    };
    if (!scanDecisions(points, params, query.needsFailures(), onDecision, progress))
        return Error{"Cancelled."};
    return found;
}

}  // namespace se
