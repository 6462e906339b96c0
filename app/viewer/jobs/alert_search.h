/// Searches in threads of their own: for all failures of a run (core's failure_moments.h), and for
/// the fewest points that still end in the one that is shown (core's reduce.h).
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "background_job.h"
#include "run/model.h"
#include "run/repair_diff.h"
#include "runner.h"
#include "spiraling_edge/spec/run_spec.h"
#include "spiraling_edge/why/failure_moments.h"
#include "spiraling_edge/why/reduce.h"
#include "spiraling_edge/why/trial.h"

namespace se::view {

/// Alerts of one class, which are adjacent in the list.
struct AlertGroup {
    const FailureClass* kind = nullptr;
    std::size_t first = 0;
    std::size_t count = 0;
    ClassTotal total;  ///< Of the run; more than `count` if not all are listed.
};

/// The boundary loops of a mesh, holes and openings.
struct OpenLoops {
    std::size_t count = 0;
    double width = 0.0;  ///< Of the widest, scene units.
};

/// The alerts of the open run: the search for all of them, and the one that is shown.
class RunAlerts {
  public:
    /// Sets another run, of which nothing is known; searches in progress are cancelled.
    void open(std::shared_ptr<const Model> model);
    /// Starts the search for all failures of the run, unless it was done or the user has stopped
    /// it. `end`: of the run; null if it could not be made.
    void start(std::shared_ptr<const RunEnd> end = nullptr);
    /// Whether failures are followed to their causes, as lists of them need. Without that, only
    /// their places are found, in a fraction of the time.
    void setFollows(bool on) { follows_ = on; }
    /// Stops the search at the user's request.
    void stop();
    /// Starts the search again, after stop() or a failure. Requires !busy().
    void resume();
    /// Takes the results, or the complaints. True if there was anything new.
    bool poll();
    /// Blocks until there are results to take, or nothing was started.
    void waitUntilDone();

    bool busy() const { return query_.busy(); }
    bool done() const { return query_.answer() != nullptr; }
    bool stopped() const { return stopped_; }
    /// True once, when all alerts are known.
    bool takeNews() { return std::exchange(news_, false); }
    /// A sentence why the search failed; then it is never done. Empty if it did not.
    const std::string& complaint() const { return query_.complaint(); }
    /// In [0, 1], while busy.
    double share() const { return query_.share(); }
    /// Results by class; empty before the search is done.
    std::span<const RunFailure> failures() const {
        return done() ? std::span<const RunFailure>(query_.answer()->failures)
                      : std::span<const RunFailure>{};
    }
    /// All failures of the run are listed, or it is not done.
    bool complete() const { return !done() || isComplete(query_.answer()->verdict.totals); }
    /// The search is done, and the mesh is sound (MeshVerdict::isSound()).
    bool sound() const { return done() && query_.answer()->verdict.isSound(); }
    /// Results; null until the search is done.
    const RunFailureSearch* found() const { return query_.answer(); }
    std::span<const AlertGroup> groups() const { return groups_; }
    const OpenLoops& openLoops() const { return openLoops_; }
    /// Places with faults, the most severe first: of all failures, followed or not.
    std::span<const FaultPlace> places() const {
        return done() ? std::span<const FaultPlace>(query_.answer()->places)
                      : std::span<const FaultPlace>{};
    }
    /// Positions in failures() of the faults at a place that were followed, the most severe first.
    std::vector<std::size_t> alertsAt(std::size_t place) const;
    /// The place of an alert; empty if it is no fault.
    std::optional<std::size_t> placeOf(std::size_t alert) const;
    /// Positions in failures(), by the moment at which each was created.
    std::span<const std::size_t> inOrder() const { return inOrder_; }

    /// The alert that is shown; null if none is.
    const RunFailure* shown() const { return chosen_ ? &failures()[*chosen_] : nullptr; }
    std::optional<std::size_t> chosen() const { return chosen_; }
    /// Sets a position in failures(), or none.
    void choose(std::optional<std::size_t> alert);
    /// Sets a position in places(), with its most severe alert if one was followed.
    void choosePlace(std::size_t place);
    /// The place that is shown as a whole; empty if an alert alone is, or nothing.
    std::optional<std::size_t> place() const { return place_; }

    /// Reduces the points of a run to the fewest that still end in the alert that is shown; a
    /// reduction in progress is cancelled. `input` is the file that prepare() took. Requires that
    /// an alert is shown whose class a mesh alone can have.
    void reduce(const RunSpec& spec, std::shared_ptr<const PointFile> input,
                std::shared_ptr<const RunEnd> end);
    /// The class of the alert of the current or last reduction; null before the first.
    const FailureClass* reducedClass() const { return reducedClass_; }
    BackgroundQuery<Reduced>& reduction() { return reduction_; }
    const BackgroundQuery<Reduced>& reduction() const { return reduction_; }
    /// Grows when another alert is shown.
    std::uint32_t revision() const { return revision_; }

  private:
    static constexpr std::size_t kNoAlert = std::numeric_limits<std::size_t>::max();

    void indexAnswer();

    std::shared_ptr<const Model> model_;
    std::shared_ptr<const RunEnd> end_;
    bool follows_ = true;
    bool started_ = false;
    bool stopped_ = false;
    std::vector<AlertGroup> groups_;
    OpenLoops openLoops_;
    std::vector<std::size_t> inOrder_;
    std::vector<std::size_t> alertOfFailure_;  ///< Per failure of all: its alert, or kNoAlert.
    std::vector<std::size_t> placeOf_;         ///< Per alert: its place, or kNoAlert.
    BackgroundQuery<RunFailureSearch> query_;
    std::optional<std::size_t> chosen_;
    std::optional<std::size_t> place_;
    bool news_ = false;
    const FailureClass* reducedClass_ = nullptr;
    BackgroundQuery<Reduced> reduction_;
    std::uint32_t revision_ = 0;
};

/// "intersecting_triangles:2": the class and the number in it from 1, as on the command line.
std::string alertName(const RunAlerts& alerts, std::size_t index);
/// The alert of that name, without a number the first of its class; "first" is the one that was
/// created first. Empty if there is none.
std::optional<std::size_t> alertNamed(const RunAlerts& alerts, std::string_view name);

// Trials of other settings for the open input (core's trial.h), in a thread of low priority.

class TrialJob {
  public:
    /// Sets the input to try, prepared by `spec`; trials in progress are cancelled.
    void open(std::shared_ptr<const PointFile> file, RunSpec spec);
    /// Starts the trials, unless they were started.
    void start();
    /// Ends them at the user's request; what was tried stays.
    void stop();
    /// Takes the results. True if there was anything new.
    bool poll();
    /// Blocks until all trials are made, or none are in progress.
    void waitUntilDone() { job_.waitUntilDone(); }

    bool busy() const { return job_.busy(); }
    /// All trials were made, or the user has ended them.
    bool ended() const { return started_ && !busy(); }
    /// In [0, 1], while busy.
    double share() const { return job_.share(); }
    /// Trials so far.
    const Trials& trials() const { return now_.trials; }
    /// The best of them; null if none is better than the open run.
    const Trial* best() const {
        return trials().best > 0 ? &trials().tried[trials().best] : nullptr;
    }
    /// The triangles in which the mesh of best() differs from that of the open run; null if there
    /// is no best().
    const MeshChange* change() const { return now_.change.get(); }
    /// A sentence why the trials ended early; empty if they did not.
    const std::string& complaint() const { return now_.complaint; }
    /// The trial in progress: "trying robust rules".
    const std::string& trying() const { return now_.next; }

  private:
    struct Progressed {
        Trials trials;
        std::string next;
        std::shared_ptr<const MeshChange> change = nullptr;
        std::string complaint = {};
    };

    std::shared_ptr<const PointFile> file_;
    RunSpec spec_;
    bool started_ = false;
    Progressed now_;
    BackgroundJob<Progressed> job_;
};

}  // namespace se::view
