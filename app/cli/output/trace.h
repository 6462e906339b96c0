/// The trace of a run: one line per event, `ADDRESS<tab>SENTENCE`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/stepper/event.h"

namespace se::cli {

/// A trace that is written during the run, since it may be larger than memory. The file gets its
/// name only by commit(): a run that ends early leaves none.
class TraceWriter {
  public:
    /// `path` empty: writes nothing; `-`: to standard output. Throws Failure(Internal) if the file
    /// cannot be created.
    explicit TraceWriter(const std::string& path);

    bool active() const { return active_; }
    /// Appends a line per event. Requires active(). Throws Failure(Internal).
    void write(const std::vector<Event>& events);
    /// Ends and names the file. Throws Failure(Internal) if anything could not be written.
    void commit();

  private:
    void flush();

    bool active_ = false;
    std::optional<AtomicFile> file_;  ///< Empty: standard output.
    std::string buffer_;
};

}  // namespace se::cli
