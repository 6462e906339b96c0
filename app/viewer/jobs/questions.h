/// What a person asks about the run: why something is in the mesh, or why not; which decisions are
/// such and such. Each question makes the run again in a thread of its own (core's ledger.h and
/// decision_query.h); another run makes all answers void.
#pragma once

#include <memory>

#include "background_query.h"
#include "run/model.h"
#include "run/selection.h"
#include "spiraling_edge/explain/closest_calls.h"
#include "spiraling_edge/explain/ledger.h"
#include "spiraling_edge/explain/ring_history.h"
#include "spiraling_edge/replay/decision_query.h"
#include "spiraling_edge/replay/run_charts.h"

namespace se::view {

/// A ledger: of a point, an edge, a triangle, or a ring.
struct WhyAnswer {
    std::string name;                    ///< "point 812", "ring #2 at 137".
    bool present = false;                ///< In the mesh at the end of the run; of a ring: true.
    std::vector<LedgerLine> lines = {};  ///< In the order of the run; never none.
    std::size_t cause = 0;               ///< The line that settled it.
    std::string answer = {};             ///< Ends with the address of the cause.
};

struct ClosestAnswer {
    ClosestCalls calls;
    std::vector<LedgerLine> lines;  ///< The calls as lines, in the same order.
};

class Questions {
  public:
    /// So many decisions of a query are listed.
    static constexpr std::size_t kMostFound = 10'000;
    static constexpr std::size_t kClosest = 200;

    /// Another run is open: no question, no answer.
    void begin(std::shared_ptr<const Model> model);
    /// Takes over what was found. True if that is news.
    bool poll();
    /// Blocks until all that was asked is answered.
    void finish();
    bool busy() const;

    // Everything below requires a run.
    /// Why is it in the mesh, or why is it not? Requires a selection that is not empty.
    void askWhy(const Selection& what);
    void askWhy(const RingPlace& ring);
    /// What askWhy() was asked last, again.
    void askAgain();
    /// What askWhy() was asked last; nothing if that was a ring.
    const Selection& subject() const { return subject_; }
    /// The same in words; empty if nothing was asked.
    const std::string& subjectName() const { return subjectName_; }
    Inquiry<WhyAnswer>& ledger() { return ledger_; }
    const Inquiry<WhyAnswer>& ledger() const { return ledger_; }

    /// The decisions that a line of words asks for. Fails with a sentence, and changes nothing
    /// then.
    Status find(const std::string& line);
    /// What find() was asked last.
    const std::string& line() const { return line_; }
    Inquiry<FoundDecisions>& found() { return found_; }
    const Inquiry<FoundDecisions>& found() const { return found_; }

    /// Asks for the closest calls unless that was done in this run.
    void wantClosest();
    Inquiry<ClosestAnswer>& closest() { return closest_; }
    const Inquiry<ClosestAnswer>& closest() const { return closest_; }
    /// Least margin per point; empty before it is known.
    std::span<const double> leastMargin() const;

    /// Asks for the charts unless that was done in this run.
    void wantCharts();
    Inquiry<std::vector<RunChart>>& charts() { return charts_; }
    const Inquiry<std::vector<RunChart>>& charts() const { return charts_; }

  private:
    std::shared_ptr<const Model> model_;
    Selection subject_;
    RingPlace ring_;
    std::string subjectName_;
    std::string line_;
    Inquiry<WhyAnswer> ledger_;
    Inquiry<FoundDecisions> found_;
    Inquiry<ClosestAnswer> closest_;
    Inquiry<std::vector<RunChart>> charts_;
};

/// As core names it. Requires a selection that is not empty.
Subject toSubject(const Selection& what);
/// Reads "812", "812,640" or "1 2 3": a point, an edge, a triangle of `points` points. Fails with a
/// sentence.
Result<Selection> selectionFromText(std::string_view text, std::size_t points);
/// Reads "ring", "ring #2", "ring 137#2": a ring, at `here` where no address stands. Nothing if the
/// text is not about a ring; fails with a sentence.
std::optional<Result<RingPlace>> ringFromText(std::string_view text, const Address& here);

}  // namespace se::view
