/// The trace of a run: one line per event, `ADDRESS<tab>SENTENCE`, or in a file .setrace one line
/// per pivot (teach/trace/setrace.h).
#pragma once

#include <optional>
#include <string>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/stepper/stepper.h"
#include "teach/trace/trace_run.h"

namespace se::cli {

/// A format of traces: a new one is two functions and a row in trace.cpp.
struct TraceFormat;

/// True if the extension is that of traces with a line per pivot.
bool isPivotTrace(const std::string& path);

/// A trace that is written during the run, since it may be larger than memory. The file gets its
/// name only by commit(): a run that ends early leaves none.
class TraceWriter {
  public:
    /// `path` empty: writes nothing; `-`: to standard output. Throws Failure(Internal) if the file
    /// cannot be created.
    TraceWriter(const std::string& path, teach::TraceDetail detail);

    bool active() const { return format_ != nullptr; }
    /// Writes what stands before the first pivot. Requires active().
    void begin(const PointSet& points);
    /// Runs `stepper` to the end of its next pivot, as Stepper::stepPivot(), and appends the lines
    /// of that pivot. Requires active(). Throws Failure(Internal).
    bool step(Stepper& stepper);
    /// Ends and names the file. Throws Failure(Internal) if anything could not be written.
    void commit();

  private:
    void flush();

    const TraceFormat* format_ = nullptr;
    teach::TraceDetail detail_;
    EventLog log_;
    std::optional<AtomicFile> file_;  ///< Empty: standard output.
    std::string buffer_;
};

}  // namespace se::cli
