// Lines are collected and written in blocks of 64 KiB, to standard output or to a temporary file
// that gets its name only on commit(), so that a run that ends early leaves no partial trace.
#include "trace.h"

#include <array>
#include <cassert>

#include "exit_code.h"
#include "output.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/replay/event_text.h"

namespace se::cli {

struct TraceFormat {
    std::string_view extension;  ///< Empty: any other.
    std::string (*header)(const PointSet&);
    /// Runs the stepper to the end of its next pivot, and appends the lines of that pivot.
    bool (*step)(Stepper&, EventLog&, teach::TraceDetail, std::string&);
};

namespace {

void require(const Status& status) {
    if (!status) throw Failure(ExitCode::Internal, status.error().message);
}

std::string noHeader(const PointSet&) { return {}; }

/// One line per event.
bool stepWithSentences(Stepper& stepper, EventLog& log, teach::TraceDetail, std::string& out) {
    stepper.setLog(&log);
    const bool ran = stepper.stepPivot();
    for (const Event& event : log.events()) {
        out += toString(event.address);
        out += '\t';
        out += describe(event);
        out += '\n';
    }
    log.clear();
    return ran;
}

/// One line per pivot.
bool stepWithPivotLine(Stepper& stepper, EventLog&, teach::TraceDetail detail, std::string& out) {
    const teach::TraceStep step = teach::stepTraced(stepper, detail);
    if (step.pivot) out += teach::traceLine(*step.pivot);
    return step.ran;
}

constexpr std::array kTraceFormats{
    TraceFormat{teach::kTraceExtension, teach::traceHeader, stepWithPivotLine},
    TraceFormat{"", noHeader, stepWithSentences},
};

const TraceFormat* traceFormatOf(const std::string& path) {
    const std::string extension = lowerExtension(path);
    for (const TraceFormat& each : kTraceFormats) {
        if (each.extension == extension || each.extension.empty()) return &each;
    }
    return nullptr;
}

}  // namespace

bool isPivotTrace(const std::string& path) {
    return lowerExtension(path) == teach::kTraceExtension;
}

TraceWriter::TraceWriter(const std::string& path, teach::TraceDetail detail) : detail_(detail) {
    if (path.empty()) return;
    format_ = traceFormatOf(path);
    if (path == "-") return;
    Result<AtomicFile> file = AtomicFile::create(path);
    if (!file) throw Failure(ExitCode::Internal, file.error().message);
    file_ = std::move(file.value());
}

void TraceWriter::begin(const PointSet& points) {
    assert(active());
    buffer_ += format_->header(points);
}

bool TraceWriter::step(Stepper& stepper) {
    assert(active());
    constexpr std::size_t kBlock = 1U << 16U;
    const bool ran = format_->step(stepper, log_, detail_, buffer_);
    if (buffer_.size() >= kBlock) flush();
    return ran;
}

void TraceWriter::flush() {
    if (file_) {
        require(file_->write(buffer_));
    } else {
        writeOutput("-", buffer_);
    }
    buffer_.clear();
}

void TraceWriter::commit() {
    if (!active()) return;
    flush();
    if (file_) require(file_->commit());
}

}  // namespace se::cli
