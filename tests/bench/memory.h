// Memory allocated by operator new: counted in memory.cpp, which replaces it.
#pragma once

#include <cstddef>

namespace se::bench {

// Bytes held now.
std::size_t heldBytes();
// Maximum of bytes held since the last call of forgetPeak().
std::size_t peakBytes();
void forgetPeak();

}  // namespace se::bench
