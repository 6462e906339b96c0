// The handler only sets a flag that long work polls, and lets a second signal end the program
// without unfinished files; nothing else is safe in a handler. SA_RESTART keeps reads and writes
// from failing meanwhile.
#include "interrupt.h"

#include <csignal>

#include "spiraling_edge/atomic_file.h"

namespace se::cli {
namespace {

volatile std::sig_atomic_t interruptSeen = 0;

void noteInterrupt(int) {
    interruptSeen = 1;
    // A second signal ends the program; no partial file is left.
    removeUnfinishedFilesAtSignals();
}

}  // namespace

void catchInterrupts() {
    struct sigaction action {};
    action.sa_handler = noteInterrupt;
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
}

void releaseInterrupts() { removeUnfinishedFilesAtSignals(); }

bool interrupted() { return interruptSeen != 0; }

}  // namespace se::cli
