#include "progress.h"

#include <fmt/format.h>

#include <cstdio>

#include "spiraling_edge/base/operating_system.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::cli {

std::string nameOfInput(const std::string& input) {
    return isStandardInput(input) ? "standard input" : input;
}

namespace {

constexpr std::chrono::milliseconds kInterval{100};

}  // namespace

ProgressLine::ProgressLine(bool wanted)
    : wanted_(wanted),
      enabled_(wanted && os::isTerminal(os::Stream::Error)),
      last_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() { clear(); }

bool ProgressLine::due() {
    if (!enabled_) return false;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < kInterval) return false;
    last_ = now;
    return true;
}

void ProgressLine::write(const std::string& what, double share) {
    fmt::print(stderr, "\r{} {:3.0f} %", printable(what), 100.0 * share);
    std::fflush(stderr);
    dirty_ = true;
}

void ProgressLine::clear() {
    if (dirty_) fmt::print(stderr, "\r{:40}\r", "");
    dirty_ = false;
}

}  // namespace se::cli
