/// Hits of the breakpoint lines, searched in a thread of its own: one run for all new lines.
/// Results are kept until another run is open.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "background_job.h"
#include "run/model.h"
#include "spiraling_edge/run/breakpoint.h"

namespace se::view {

/// Maximum number of hits of a log-only line that keep their sentences.
inline constexpr std::size_t kMaxLogged = 10000;

/// Results for a line.
struct LineHits {
    HitList list;
    /// The sentences of the first hits; fewer than hits if the line is not a log-only one.
    std::vector<std::string> sentences;
    /// Nothing is missing up to this pivot.
    std::uint32_t knownTo = 0;
    bool complete = false;
};

/// The pivots with hits that the breakpoint picks, at most one for each of `columns` stretches of
/// the range from `window.first` to `window.second`; for marks. O(columns log hits).
std::vector<std::uint32_t> stopPivots(const Breakpoint& breakpoint, const HitList& list,
                                      std::pair<double, double> window, std::size_t columns);

class HitSearch {
  public:
    /// Sets another run, of which nothing is known.
    void open(std::shared_ptr<const Model> model);
    /// Sets the breakpoints; the lines of enabled ones are searched. Cheap if nothing is new.
    void want(std::span<const Breakpoint> breakpoints);
    /// Takes the results. True if there was anything new.
    bool poll();
    /// Blocks until all wanted lines are known.
    void waitUntilDone();
    /// Cancels the search, until something else is wanted or resume() is called.
    void cancel();
    void resume();

    bool busy() const { return job_.busy(); }
    /// Cancelled before all was known, or ended by a failure.
    bool cancelled() const { return givenUp_; }
    /// Why a search failed: a sentence, once; empty if none has failed since.
    std::string takeComplaint() { return std::exchange(complaint_, {}); }
    /// In [0, 1], while busy.
    double share() const { return job_.share(); }
    /// Null if the line was never searched, or is not understood.
    const LineHits* of(const std::string& line) const;

    /// Whether the result of stop() is final.
    enum class Known : std::uint8_t { Yes, NotYet, GivenUp };
    struct Answer {
        Known known = Known::Yes;
        std::optional<Stop> stop;  ///< Its breakpoint is the position in the wanted list.
    };
    /// The next (1) or previous (-1) stop from `here`.
    Answer stop(RunPosition here, int direction) const;
    const std::vector<Breakpoint>& wanted() const { return wanted_; }

  private:
    struct Line {
        std::string text;
        DecisionQuery query;
        bool listed = false;  ///< Lines with sentences.
    };
    struct Found {
        std::size_t line;
        se::Hit hit;
        std::string sentence;
    };
    static PivotVisitor visitorFor(const Model& model, const std::vector<Line>& lines,
                                   BackgroundJob<Found>::Results& results);
    std::vector<Line> missing() const;
    void startNext();
    bool take();

    std::shared_ptr<const Model> model_;
    std::vector<Breakpoint> wanted_;
    std::map<std::string, LineHits> known_;
    bool givenUp_ = false;
    std::string complaint_;
    std::vector<Line> sought_;  ///< Current search.
    BackgroundJob<Found> job_;
};

}  // namespace se::view
