// Lines are collected and written in blocks of 64 KiB, to standard output or to a temporary file
// that gets its name only on commit(), so that a run that ends early leaves no partial trace.
#include "trace.h"

#include <cassert>

#include "exit_code.h"
#include "output.h"
#include "spiraling_edge/replay/event_text.h"

namespace se::cli {
namespace {

void require(const Status& status) {
    if (!status) throw Failure(ExitCode::Internal, status.error().message);
}

}  // namespace

TraceWriter::TraceWriter(const std::string& path) : active_(!path.empty()) {
    if (path.empty() || path == "-") return;
    Result<AtomicFile> file = AtomicFile::create(path);
    if (!file) throw Failure(ExitCode::Internal, file.error().message);
    file_ = std::move(file.value());
}

void TraceWriter::write(const std::vector<Event>& events) {
    assert(active());
    constexpr std::size_t kBlock = 1U << 16U;
    for (const Event& event : events) {
        buffer_ += toString(event.address);
        buffer_ += '\t';
        buffer_ += describe(event);
        buffer_ += '\n';
    }
    if (buffer_.size() >= kBlock) flush();
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
    if (!active_) return;
    flush();
    if (file_) require(file_->commit());
}

}  // namespace se::cli
