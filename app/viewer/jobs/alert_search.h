/// Looks for everything that went wrong in a run, in a thread of its own (core's
/// failure_moments.h).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "background_query.h"
#include "run/model.h"
#include "spiraling_edge/explain/failure_moments.h"

namespace se::view {

/// The alerts of one class: they stand beside each other in the list.
struct AlertGroup {
    const FailureClass* kind = nullptr;
    std::size_t first = 0;
    std::size_t count = 0;
    ClassTotal total;  ///< Of the run; more than `count` where not all are listed.
};

class AlertSearch {
  public:
    /// Another run, to be looked through when begin() says so; what was going on is cancelled.
    void wait(std::shared_ptr<const Model> model);
    /// Begins, unless that was done or a person has stopped it.
    void begin();
    /// A person does not want to wait.
    void stop();
    /// Starts the search again, after stop() or a failure. Requires !busy().
    void resume();
    /// Takes over what was found, or the complaint. True if that is news.
    bool poll();
    /// Blocks until there is something to take over, or nothing was begun.
    void finish() { inquiry_.finish(); }

    bool busy() const { return inquiry_.busy(); }
    bool done() const { return inquiry_.answer() != nullptr; }
    bool stopped() const { return stopped_; }
    /// Why it failed, a sentence; then it is never done. Empty if it did not.
    const std::string& complaint() const { return inquiry_.complaint(); }
    /// In [0, 1], while busy.
    double share() const { return inquiry_.share(); }
    /// By class; empty before it is done.
    std::span<const RunFailure> failures() const {
        return done() ? std::span<const RunFailure>(inquiry_.answer()->failures)
                      : std::span<const RunFailure>{};
    }
    /// All failures of the run are listed, or it is not done.
    bool complete() const { return !done() || isComplete(inquiry_.answer()->totals); }
    std::span<const AlertGroup> groups() const { return groups_; }
    /// Places in failures(), by the moment at which each was created.
    std::span<const std::size_t> inOrder() const { return inOrder_; }

  private:
    void sortOut();

    std::shared_ptr<const Model> model_;
    bool begun_ = false;
    bool stopped_ = false;
    std::vector<AlertGroup> groups_;
    std::vector<std::size_t> inOrder_;
    Inquiry<RunFailureSearch> inquiry_;
};

/// "intersecting_triangles:2": the class and the place in it from 1, as on the command line.
std::string alertName(const AlertSearch& alerts, std::size_t index);
/// The alert of that name, without a number the first of its class; "first" is the one that was
/// created first. Nothing if there is none.
std::optional<std::size_t> alertNamed(const AlertSearch& alerts, std::string_view name);

}  // namespace se::view
