/// The decisions of a run in order, and a filter over them, written as one line:
/// `stage=sphere kept margin<1e-4 point=812`. A breakpoint is such a line: it stops at the same
/// addresses in both directions of time.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/sweep.h"

namespace se {

/// The subject of a condition: one decision with its surroundings.
struct Decision {
    const Event& event;
    Index pivot;  ///< The point that was the pivot.
    const std::optional<Reading>& reading;
    const PointSet& points;
    std::span<const Event> events;  ///< All events of the pivot, see tallyOf().
    /// The classes of failures that appear at this decision (live_check.h), one bit each:
    /// failureBit(). Always 0 unless they were requested.
    std::uint32_t failures = 0;
};
/// Calls `visit` with each decision of a run, in order. `failures`: fills Decision::failures, which
/// doubles the cost of the pass. Borrows the points and params of the run.
PivotVisitor decisionVisitor(const PointSet& points, const Params& params, bool failures,
                             std::function<void(const Decision&, RunPosition)> visit);

/// The bit of a class in Decision::failures.
std::uint32_t failureBit(const FailureClass& kind);
/// True if the class can be detected during the run; false for those of the mesh as a whole.
bool appearsInRun(const FailureClass& kind);

using DecisionCondition = std::function<bool(const Decision&)>;

/// One row of the table of terms: a new term is one function and one row.
struct QueryTerm {
    std::string_view form;     ///< "stage=NAME"
    std::string_view meaning;  ///< One sentence.
    /// The condition that `word` describes; empty if it is not of this form; an error if it is, but
    /// its value is wrong.
    Result<DecisionCondition> (*read)(std::string_view word);
    bool needsFailures = false;  ///< Reads Decision::failures.
};
/// All terms, for help and completion.
std::span<const QueryTerm> queryTerms();

/// The first word of a line that is not understood.
struct QueryMistake {
    std::string word;
    std::string message;     ///< One sentence that names the word.
    bool isUnknown = false;  ///< No term has this form; else one has, but the value is wrong.
};
std::optional<QueryMistake> mistakeIn(std::string_view line);

/// A sentence about the first point that `line`, of a query or a watch, names and that is not below
/// `points`; empty if there is none. Words that do not name points are ignored.
std::string missingPointIn(std::string_view line, std::size_t points);

/// A parsed line. A decision matches if all conditions hold; an empty line matches everything.
class DecisionQuery {
  public:
    /// Words are separated by blanks. Fails with the word that is not understood.
    static Result<DecisionQuery> parse(std::string_view line);
    bool matches(const Decision& decision) const;
    /// True if some term reads Decision::failures: the run must be checked during the pass.
    bool needsFailures() const { return needsFailures_; }

  private:
    std::vector<DecisionCondition> conditions_;
    bool needsFailures_ = false;
};

struct FoundDecisions {
    std::vector<LedgerLine> lines;  ///< The first matches, in the order of the run.
    std::size_t total = 0;          ///< Of the whole run.
};

/// The question for the decisions that match, `limit` of them listed. O(run).
Question<FoundDecisions> decisionsQuestion(const PointSet& points, const Params& params,
                                           const DecisionQuery& query, std::size_t limit);
/// The answer to decisionsQuestion(). Fails if cancelled.
Result<FoundDecisions> findDecisions(const PointSet& points, const Params& params,
                                     const DecisionQuery& query, std::size_t limit,
                                     const Progress& progress = {});

}  // namespace se
