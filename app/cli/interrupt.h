/// Ctrl+C as a flag that long work polls.
#pragma once

namespace se::cli {

/// From now on the first Ctrl+C only sets the flag; the second ends the program as usual.
void catchInterrupts();
bool interrupted();
/// From now on Ctrl+C ends the program at once.
void releaseInterrupts();

}  // namespace se::cli
