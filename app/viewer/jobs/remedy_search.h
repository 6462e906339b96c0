/// Search for a rule that would have prevented an alert (core's remedy.h), in a thread of its own.
#pragma once

#include <memory>
#include <optional>

#include "background_query.h"
#include "run/model.h"
#include "spiraling_edge/explain/remedy.h"

namespace se::view {

class RemedySearch {
  public:
    /// Discards the search: another run.
    void cancel();
    /// Tries all rules for the alert at that position of the list; a search in progress is
    /// cancelled.
    void start(std::shared_ptr<const Model> model, std::size_t alert, const MeshFailure& failure);
    void stop() { query_.stop(); }
    /// Takes the result. True if there was anything new.
    bool poll() { return query_.poll(); }
    void waitUntilDone() { query_.waitUntilDone(); }

    bool busy() const { return query_.busy(); }
    double share() const { return query_.share(); }
    /// The alert of the current or last search.
    std::optional<std::size_t> about() const { return about_; }
    /// A sentence why nothing was found; empty if nothing failed.
    const std::string& complaint() const { return query_.complaint(); }
    /// The result; null before there is one.
    const Remedies* found() const { return query_.answer(); }

  private:
    std::optional<std::size_t> about_;
    BackgroundQuery<Remedies> query_;
};

}  // namespace se::view
