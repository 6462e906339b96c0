/// Numbers of a run that are watched from pivot to pivot: the length of the ring, the status of a
/// point, any counter.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "spiraling_edge/run/sweep.h"

namespace se {

/// The input of a watch, between two pivots.
struct WatchedRun {
    const State& state;
    std::uint64_t tests = 0;    ///< Decisions so far that took or refused something.
    std::uint64_t refused = 0;  ///< Those of `tests` that refused.
    std::size_t used = 0;       ///< Points that are USED.
};

/// One row of the table of watch terms: a new term is one row.
struct WatchTerm {
    std::string_view form;                                ///< "ring", "status=N"
    std::string_view meaning;                             ///< One sentence.
    double (*value)(const WatchedRun& run, Index point);  ///< `point` where the form ends in =N.
};
std::span<const WatchTerm> watchTerms();

class WatchExpression {
  public:
    /// One of the terms, such as `ring` or `status=812`. Fails with a sentence.
    static Result<WatchExpression> parse(std::string_view text);
    /// The value at a place of a run; 0 if the point of the expression does not exist.
    double valueIn(const WatchedRun& run) const { return term_->value(run, point_); }
    /// The point of the expression; kNone if none.
    Index point() const { return point_; }
    const WatchTerm& term() const { return *term_; }

  private:
    WatchExpression(const WatchTerm& term, Index point) : term_(&term), point_(point) {}
    const WatchTerm* term_;
    Index point_;
};

/// Calls `visit` with the values of all expressions after each pivot of a run, in order; at once
/// with those of its start, pivot 0. A step after the last pivot without a number of its own is
/// reported under the number before it. An expression about a nonexistent point has the value 0.
PivotVisitor watchVisitor(
    const PointSet& points, const Params& params, std::vector<WatchExpression> expressions,
    std::function<void(std::uint32_t pivot, std::span<const double> values)> visit);

}  // namespace se
