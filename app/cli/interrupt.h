/// Ctrl+C as a question that long work asks now and then.
#pragma once

namespace se::cli {

/// From now on the first Ctrl+C is only noted; the second ends the program as usual.
void catchInterrupts();
bool interrupted();
/// From now on Ctrl+C ends the program at once.
void releaseInterrupts();

}  // namespace se::cli
