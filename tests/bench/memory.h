// What the program has taken by operator new: counted in memory.cpp, which replaces it.
#pragma once

#include <cstddef>

namespace se::bench {

// Bytes held now.
std::size_t heldBytes();
// The most that were held since the last call of forgetPeak().
std::size_t peakBytes();
void forgetPeak();

}  // namespace se::bench
