#include "spiraling_edge/base/freed_memory.h"

#include <cstdlib>  // defines __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace se {

void returnFreedMemory() {
#ifdef __GLIBC__
    // A threshold that is set is no longer raised by every block that is freed.
    constexpr int kLargeBlock = 1 << 20;  // bytes
    mallopt(M_MMAP_THRESHOLD, kLargeBlock);
#endif
}

}  // namespace se
