#include "interrupt.h"

#include <csignal>

namespace se::cli {
namespace {

volatile std::sig_atomic_t interruptSeen = 0;

void noteInterrupt(int) { interruptSeen = 1; }

}  // namespace

void catchInterrupts() {
    struct sigaction action {};
    action.sa_handler = noteInterrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigaction(SIGINT, &action, nullptr);
}

bool interrupted() { return interruptSeen != 0; }

}  // namespace se::cli
