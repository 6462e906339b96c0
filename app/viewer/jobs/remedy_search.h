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
    void forget();
    /// Tries all rules for the alert at that position of the list; a search in progress is
    /// cancelled.
    void begin(std::shared_ptr<const Model> model, std::size_t alert, const MeshFailure& failure);
    void stop() { inquiry_.stop(); }
    /// Takes the result. True if there was anything new.
    bool poll() { return inquiry_.poll(); }
    void finish() { inquiry_.finish(); }

    bool busy() const { return inquiry_.busy(); }
    double share() const { return inquiry_.share(); }
    /// The alert of the current or last search.
    std::optional<std::size_t> about() const { return about_; }
    /// A sentence why nothing was found; empty if nothing failed.
    const std::string& complaint() const { return inquiry_.complaint(); }
    /// The result; null before there is one.
    const Remedies* found() const { return inquiry_.answer(); }

  private:
    std::optional<std::size_t> about_;
    Inquiry<Remedies> inquiry_;
};

}  // namespace se::view
