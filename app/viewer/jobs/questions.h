/// The user's queries about the run: why something is in the mesh or not, and which decisions match
/// a line. Each query makes one more pass through the run (core's sweep.h), in the background;
/// that about a ring runs the points itself. Another run discards all answers.
#pragma once

#include <functional>
#include <memory>
#include <tuple>

#include "background_job.h"
#include "run/model.h"
#include "run/selection.h"
#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/run_charts.h"
#include "spiraling_edge/why/failure_moments.h"
#include "spiraling_edge/why/ledger.h"
#include "spiraling_edge/why/nearest_decisions.h"
#include "spiraling_edge/why/proof.h"
#include "spiraling_edge/why/ring_history.h"

namespace se::view {

/// Lines of a list that follow each other and are alike: one row stands for them.
struct LineFold {
    std::size_t first = 0;
    std::size_t count = 0;
};
/// The repeats in a ledger: lines of the same role and stage with the same outcome as the one
/// before them, at least three. The decisive line is in none.
std::vector<LineFold> foldsOf(std::span<const LedgerLine> lines, std::size_t cause);

struct ClosestAnswer {
    NearestDecisions decisions;
    std::vector<LedgerLine> lines;  ///< The decisions as lines, in the same order.
};

class Questions {
  public:
    /// Maximum number of decisions of a query that are listed.
    static constexpr std::size_t kMaxFound = 10'000;
    static constexpr std::size_t kClosest = 200;

    /// Sets another run, of that file by that spec without fixes, without queries and answers.
    void open(std::shared_ptr<const Model> model, std::shared_ptr<const PointFile> file,
              RunSpec spec);
    /// Takes the results. True if there was anything new.
    bool poll();
    /// Blocks until all queries are answered.
    void waitUntilDone();
    bool busy() const;

    // Everything below requires a run.
    /// Starts the query why the selection is in the mesh, or why not, and its proof (core's
    /// why/proof.h), which takes its place; without threads, for small inputs only. Requires a
    /// selection that is not empty.
    void askWhy(const Selection& what);
    void askWhy(const RingAddress& ring);
    /// Starts the query why a failure is there, one of `known`, and its proof in the same way.
    /// Until it is proved its moments are the answer, or the ledger of a lost point. `standIn`:
    /// what is selected for it; empty for a loop.
    void askWhy(const RunFailure& failure, std::vector<MeshFailure> known,
                const Selection& standIn);
    /// Repeats the last query of askWhy(). Requires one.
    void askAgain();
    /// Selection of the last query of askWhy(); empty if that was a ring or a loop.
    const Selection& subject() const { return subject_; }
    /// True if the last query of askWhy() was about this failure and has an answer, or will have.
    bool isAbout(const MeshFailure& failure) const;
    /// The last query of askWhy() in words; empty if there was none.
    const std::string& subjectName() const { return subjectName_; }
    /// The answer so far: proved, if that is done; null before there is one.
    const Ledger* why() const {
        const bool proved = ledger_.answer() != nullptr && proof_.answer() != nullptr;
        return proved ? proof_.answer() : ledger_.answer();
    }
    /// The repeats among the lines of why().
    std::span<const LineFold> folds() const { return folds_; }
    bool isProving() const { return proof_.busy(); }
    BackgroundQuery<Ledger>& ledger() { return ledger_; }
    const BackgroundQuery<Ledger>& ledger() const { return ledger_; }

    /// Starts the query for the decisions that match a line. Fails with a sentence, and changes
    /// nothing then.
    Status find(const std::string& line);
    /// The last line given to find().
    const std::string& line() const { return line_; }
    BackgroundQuery<FoundDecisions>& found() { return found_; }
    const BackgroundQuery<FoundDecisions>& found() const { return found_; }

    /// Starts the query for the closest decisions, unless it was started in this run.
    void requestClosest();
    BackgroundQuery<ClosestAnswer>& closest() { return closest_; }
    const BackgroundQuery<ClosestAnswer>& closest() const { return closest_; }
    /// Least margin per point; empty before it is known.
    std::span<const double> leastMargin() const;

    /// Starts the query for the charts, unless it was started in this run.
    void requestCharts();
    BackgroundQuery<std::vector<RunChart>>& charts() { return charts_; }
    const BackgroundQuery<std::vector<RunChart>>& charts() const { return charts_; }

  private:
    template <typename Action>
    void forEach(const Action& action) {
        std::apply([&action](auto&... query) { (action(query), ...); },
                   std::tie(ledger_, proof_, found_, closest_, charts_));
    }

    std::shared_ptr<const Model> model_;
    std::shared_ptr<const PointFile> file_;  ///< Not null with a model.
    RunSpec spec_;                           ///< Without fixes.
    using Proof =
        std::function<Result<Ledger>(const Model&, const ProofScope&, const Progress& progress)>;
    /// Starts the search for a proof; without threads, for small inputs only.
    void startProof(Proof proof);

    Selection subject_;
    std::optional<MeshFailure> failure_;  ///< Of the last query, if it was about one.
    std::string subjectName_;
    std::function<void()> again_;  ///< Repeats the last query of askWhy().
    std::string line_;
    BackgroundQuery<Ledger> ledger_;
    BackgroundQuery<Ledger> proof_;
    std::vector<LineFold> folds_;
    BackgroundQuery<FoundDecisions> found_;
    BackgroundQuery<ClosestAnswer> closest_;
    BackgroundQuery<std::vector<RunChart>> charts_;
};

/// The subject in core's terms. Requires a selection that is not empty.
Subject toSubject(const Selection& what);
/// Parses "812", "812,640" or "1 2 3": a point, an edge, a triangle of `points` points. Fails with
/// a sentence.
Result<Selection> selectionFromText(std::string_view text, std::size_t points);
/// Parses "ring", "ring #2", "ring 137#2": a ring, at `here` if no address is given. Empty if the
/// text is not about a ring; fails with a sentence.
std::optional<Result<RingAddress>> ringFromText(std::string_view text, const Address& here);

}  // namespace se::view
