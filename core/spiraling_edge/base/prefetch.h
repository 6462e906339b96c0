/// Prefetch hints.
#pragma once

namespace se {

/// Announces a read of the memory at `where`; any address is allowed. Affects only the time. A
/// function that only prefetches must be always_inline, too: GCC finds no effect in it and drops
/// its calls.
[[gnu::always_inline]] inline void prefetch(const void* where) {
#if defined(__GNUC__)
    __builtin_prefetch(where);
#else
    static_cast<void>(where);
#endif
}

}  // namespace se
