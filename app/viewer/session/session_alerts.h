/// The alerts of the run: their search, the one that is shown, and the search for rules that would
/// have prevented it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "jobs/alert_search.h"
#include "jobs/remedy_search.h"

namespace se::view {

class SessionAlerts {
  public:
    /// Sets another run, of which nothing is known.
    void open(std::shared_ptr<const Model> model);
    /// Starts the search, unless it was done or the user has stopped it.
    void start() { search_.start(); }
    /// Takes the results. True if there was anything new.
    bool poll();
    /// Blocks until there are results to take.
    void waitUntilDone();

    /// Search for all failures of the run; it starts once the run is complete.
    const AlertSearch& search() const { return search_; }
    AlertSearch& search() { return search_; }
    /// True once, when all alerts are known.
    bool takeNews() { return std::exchange(news_, false); }

    /// The alert that is shown; null if none is.
    const RunFailure* shown() const { return chosen_ ? &search_.failures()[*chosen_] : nullptr; }
    std::optional<std::size_t> chosen() const { return chosen_; }
    /// Sets a position in search().failures(), or none.
    void choose(std::optional<std::size_t> alert);

    /// Rules that would have prevented the alert that is shown; started by seekRemedies().
    const RemedySearch& remedies() const { return remedies_; }
    RemedySearch& remedies() { return remedies_; }
    /// Requires that an alert is shown.
    void seekRemedies();
    /// Grows when another alert is shown.
    std::uint32_t revision() const { return revision_; }

  private:
    std::shared_ptr<const Model> model_;
    AlertSearch search_;
    std::optional<std::size_t> chosen_;
    bool news_ = false;
    RemedySearch remedies_;
    std::uint32_t revision_ = 0;
};

}  // namespace se::view
