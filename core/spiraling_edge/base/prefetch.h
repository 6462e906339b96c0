/// A hint to the processor.
#pragma once

namespace se {

/// Memory at `where` will be read soon. Changes nothing but the time; any address will do. A
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
