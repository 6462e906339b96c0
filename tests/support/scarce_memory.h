/// A shortage of memory, for tests.
#pragma once

#include <cstddef>

namespace se {

/// While it exists, every allocation of more than `limit` bytes throws std::bad_alloc in all
/// threads but the one that created it. One at a time.
class ScarceMemory {
  public:
    explicit ScarceMemory(std::size_t limit = 256);
    ~ScarceMemory();
    ScarceMemory(const ScarceMemory&) = delete;
    ScarceMemory& operator=(const ScarceMemory&) = delete;
};

}  // namespace se
