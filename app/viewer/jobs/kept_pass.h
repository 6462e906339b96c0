/// Passes through the run for what is wanted, each for all that is not known yet. What is known is
/// kept until another run is open: hits of breakpoints, and values of watched expressions.
#pragma once

#include <algorithm>
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
#include "spiraling_edge/run/watch.h"

namespace se::view {

/// `Known`: what is known of a text, such as the line of a breakpoint.
template <typename Wanted, typename Known, typename Found>
class KeptPass {
  public:
    KeptPass() = default;
    virtual ~KeptPass() = default;
    KeptPass(const KeptPass&) = delete;
    KeptPass& operator=(const KeptPass&) = delete;

    /// Sets another run, of which nothing is known.
    void open(std::shared_ptr<const Model> model) {
        job_.cancel();
        model_ = std::move(model);
        known_.clear();
        resume();
    }
    /// Sets what is wanted. Cheap if nothing is new.
    void want(std::span<const Wanted> wanted) {
        if (std::equal(wanted_.begin(), wanted_.end(), wanted.begin(), wanted.end())) return;
        wanted_.assign(wanted.begin(), wanted.end());
        resume();
    }
    const std::vector<Wanted>& wanted() const { return wanted_; }
    /// Takes the results. True if there was anything new.
    bool poll() {
        if (!busy()) return false;
        auto taken = job_.take();
        const bool failed = !taken.complaint.empty();
        const bool news = add(taken.items, taken.ended && !failed);
        if (failed) {
            complaint_ = std::move(taken.complaint);
            giveUp();
        } else if (taken.ended) {
            startNext();
        }
        return taken.ended || news;
    }
    /// Blocks until all that is wanted is known.
    void waitUntilDone() {
        while (busy()) {
            job_.waitUntilDone();
            poll();
        }
    }
    /// Cancels the pass, until something else is wanted or resume() is called.
    void cancel() {
        poll();
        // The pass may just have ended.
        if (busy()) giveUp();
    }
    void resume() {
        givenUp_ = false;
        if (model_) startNext();
    }

    bool busy() const { return job_.busy(); }
    /// In [0, 1], while busy.
    double share() const { return job_.share(); }
    /// Cancelled before all was known, or ended by a failure.
    bool cancelled() const { return givenUp_; }
    /// Why a pass failed: a sentence, once; empty if none has failed since.
    std::string takeComplaint() { return std::exchange(complaint_, {}); }
    /// Null if the text was never wanted, or is not understood.
    const Known* of(const std::string& text) const {
        const auto found = known_.find(text);
        return found == known_.end() ? nullptr : &found->second;
    }

  protected:
    /// Begins a pass for what is missing, if anything is.
    virtual void startNext() = 0;
    /// Adds what the pass has found since; `complete`: it is all of it. True if that is news.
    virtual bool add(std::vector<Found>& found, bool complete) = 0;
    /// The pass will not end: drops what is of no use without the rest.
    virtual void dropPart() {}

    std::shared_ptr<const Model> model_;
    std::vector<Wanted> wanted_;
    std::map<std::string, Known> known_;
    bool givenUp_ = false;
    std::string complaint_;
    BackgroundJob<Found> job_;

  private:
    void giveUp() {
        dropPart();
        job_.cancel();
        givenUp_ = true;
    }
};

// Hits of the breakpoint lines, searched in a thread of its own: one run for all new lines.
// Results are kept until another run is open.

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

/// A hit of a line of the search in progress.
struct FoundHit {
    std::size_t line;
    se::Hit hit;
    std::string sentence;
};

/// The lines of enabled breakpoints are searched.
class HitSearch : public KeptPass<Breakpoint, LineHits, FoundHit> {
  public:
    /// Whether the result of stop() is final.
    enum class Known : std::uint8_t { Yes, NotYet, GivenUp };
    struct Answer {
        Known known = Known::Yes;
        std::optional<Stop> stop;  ///< Its breakpoint is the position in the wanted list.
    };
    /// The next (1) or previous (-1) stop from `here`.
    Answer stop(RunPosition here, int direction) const;

  private:
    struct Line {
        std::string text;
        DecisionQuery query;
        bool listed = false;  ///< Lines with sentences.
    };
    static PivotVisitor visitorFor(const Model& model, const std::vector<Line>& lines,
                                   BackgroundJob<FoundHit>::Results& results);
    std::vector<Line> missing() const;
    void startNext() override;
    bool add(std::vector<FoundHit>& found, bool complete) override;
    void dropPart() override;

    std::vector<Line> sought_;  ///< Current search.
};

// Values of the watched expressions over the whole run, computed by one run in a thread of its own
// for all new expressions.

/// A watched number, pivot by pivot.
struct WatchSeries {
    std::vector<double> values;  ///< [pivot], from 0, the start; computed so far.
    bool complete = false;
};

/// Values of one pivot, one for each expression in progress.
struct WatchValues {
    std::uint32_t pivot;
    std::vector<double> values;
};

/// Known values stay if a scan is cancelled.
class WatchScan : public KeptPass<std::string, WatchSeries, WatchValues> {
  private:
    void startNext() override;
    bool add(std::vector<WatchValues>& found, bool complete) override;

    std::vector<std::string> sought_;  ///< Current scan.
};

}  // namespace se::view
