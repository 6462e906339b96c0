#include "trace.h"

#include <utility>

#include "exit_code.h"

namespace se::cli {

namespace fs = std::filesystem;

TraceWriter::TraceWriter(const std::string& path) : path_(path) {
    if (path.empty()) return;
    if (path == "-") {
        stream_ = stdout;
        return;
    }
    std::error_code ignored;
    const bool special = fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
    if (!special) temporary_ = path + ".part";
    stream_ = std::fopen(special ? path.c_str() : temporary_.c_str(), "wb");
    if (stream_ == nullptr) {
        temporary_.clear();
        throw Failure(ExitCode::Internal, path + ": cannot be written");
    }
}

TraceWriter::~TraceWriter() {
    if (stream_ != nullptr && stream_ != stdout) std::fclose(stream_);
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void TraceWriter::write(const std::vector<Event>& events) {
    buffer_.clear();
    for (const Event& event : events) {
        buffer_ += toString(event.address);
        buffer_ += '\t';
        buffer_ += describe(event);
        buffer_ += '\n';
    }
    if (std::fwrite(buffer_.data(), 1, buffer_.size(), stream_) != buffer_.size())
        throw Failure(ExitCode::Internal, path_ + ": cannot be written");
}

void TraceWriter::commit() {
    if (stream_ == nullptr) return;
    std::FILE* stream = std::exchange(stream_, nullptr);
    bool good = std::fflush(stream) == 0;
    if (stream != stdout) good = std::fclose(stream) == 0 && good;
    std::error_code problem;
    if (good && !temporary_.empty()) {
        fs::rename(temporary_, path_, problem);
        if (!problem) temporary_.clear();
    }
    if (!good || problem) throw Failure(ExitCode::Internal, path_ + ": cannot be written");
}

}  // namespace se::cli
