/// How the memory of a program that works on large point sets goes back to the system.
#pragma once

namespace se {

/// From now on blocks of a megabyte and more go back to the system as soon as they are freed. By
/// default the C library of GNU keeps them once some were freed, and the peak of a run is the sum
/// of its parts. For programs, once at their start; does nothing with other C libraries.
void returnFreedMemory();

}  // namespace se
