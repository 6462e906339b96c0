// The handler only sets a flag that long work polls, and lets a second signal end the program
// without unfinished files; nothing else is safe in a handler. SA_RESTART keeps reads and writes
// from failing meanwhile.
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/outside_text.h"

namespace se::cli {

namespace {

volatile std::sig_atomic_t interruptSeen = 0;

void noteInterrupt(int) {
    interruptSeen = 1;
    // A second signal ends the program; no partial file is left.
    removeUnfinishedFilesAtSignals();
}

constexpr std::chrono::milliseconds kInterval{100};

}  // namespace

void catchInterrupts() {
    struct sigaction action {};
    action.sa_handler = noteInterrupt;
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
}

void releaseInterrupts() { removeUnfinishedFilesAtSignals(); }

bool interrupted() { return interruptSeen != 0; }

ProgressLine::ProgressLine(bool wanted)
    : wanted_(wanted),
      enabled_(wanted && ::isatty(STDERR_FILENO) == 1),
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
