/// The trace of a run: one line per event, `ADDRESS<tab>SENTENCE`.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "spiraling_edge/event.h"

namespace se::cli {

/// Writes while the run goes on; traces may be larger than memory. The file gets its name only by
/// commit(): a run that ends early leaves none.
class TraceWriter {
  public:
    /// `path` empty: writes nothing. Throws Failure if the file cannot be opened.
    explicit TraceWriter(const std::string& path);
    ~TraceWriter();
    TraceWriter(const TraceWriter&) = delete;
    TraceWriter& operator=(const TraceWriter&) = delete;

    bool active() const { return stream_ != nullptr; }
    void write(const std::vector<Event>& events);
    /// Ends and names the file. Throws Failure if something could not be written.
    void commit();

  private:
    std::string path_;
    std::filesystem::path temporary_;  ///< Empty if written to directly.
    std::FILE* stream_ = nullptr;
    std::string buffer_;
};

}  // namespace se::cli
