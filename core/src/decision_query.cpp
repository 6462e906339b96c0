#include "spiraling_edge/decision_query.h"

#include <algorithm>

#include "ledger_line.h"
#include "spiraling_edge/run_scan.h"

namespace se {

Result<DecisionQuery> DecisionQuery::parse(std::string_view line) {
    DecisionQuery query;
    for (;;) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        if (line.empty()) return query;
        const std::string_view word = line.substr(0, line.find_first_of(" \t"));
        line.remove_prefix(word.size());
        DecisionCondition found;
        for (const QueryTerm& term : queryTerms()) {
            Result<DecisionCondition> condition = term.read(word);
            if (!condition) return condition.error();
            if (condition.value()) found = std::move(condition.value());
        }
        if (!found) {
            std::string forms;
            for (const QueryTerm& term : queryTerms())
                forms += (forms.empty() ? "" : ", ") + std::string(term.form);
            return Error{"\"" + std::string(word) + "\" is not understood; there are " + forms +
                         "."};
        }
        query.conditions_.push_back(std::move(found));
    }
}

bool DecisionQuery::matches(const Decision& decision) const {
    return std::all_of(conditions_.begin(), conditions_.end(),
                       [&](const DecisionCondition& holds) { return holds(decision); });
}

Result<FoundDecisions> findDecisions(const PointSet& points, const Params& params,
                                     const DecisionQuery& query, std::size_t most,
                                     const Progress& progress) {
    FoundDecisions found;
    const auto see = [&](const ScannedPivot& pivot) {
        for (const Event& event : pivot.events) {
            const LedgerLine line = lineOf(event, {points, params, pivot.point});
            if (!query.matches({event, pivot.point, line.reading, points})) continue;
            ++found.total;
            if (found.lines.size() < most) found.lines.push_back(line);
        }
    };
    if (!scanRun(points, params, see, progress)) return Error{"Cancelled."};
    return found;
}

}  // namespace se
