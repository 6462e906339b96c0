/// Which rule would have prevented an alert (core's remedy.h), tried by a thread of its own.
#pragma once

#include <memory>
#include <optional>

#include "background_query.h"
#include "run/model.h"
#include "spiraling_edge/explain/remedy.h"

namespace se::view {

class RemedySearch {
  public:
    /// Nothing is asked about any more: another run.
    void forget();
    /// Tries all rules for the alert at that place of the list; what is under way is cancelled.
    void begin(std::shared_ptr<const Model> model, std::size_t alert, const MeshFailure& failure);
    void stop() { inquiry_.stop(); }
    /// Takes over what was found. True if that is news.
    bool poll() { return inquiry_.poll(); }
    void finish() { inquiry_.finish(); }

    bool busy() const { return inquiry_.busy(); }
    double share() const { return inquiry_.share(); }
    /// The alert that is or was asked about.
    std::optional<std::size_t> about() const { return about_; }
    /// Why nothing was found, a sentence; empty if nothing went wrong.
    const std::string& complaint() const { return inquiry_.complaint(); }
    /// What was found about it; null before.
    const Remedies* found() const { return inquiry_.answer(); }

  private:
    std::optional<std::size_t> about_;
    Inquiry<Remedies> inquiry_;
};

}  // namespace se::view
