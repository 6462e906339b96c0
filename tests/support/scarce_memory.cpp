#include "support/scarce_memory.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t kPlenty = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> mostBytes = kPlenty;
thread_local bool spared = false;

void* allocate(std::size_t size) {
    if (size > mostBytes && !spared) throw std::bad_alloc();
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}

}  // namespace

namespace se {

ScarceMemory::ScarceMemory(std::size_t limit) {
    spared = true;
    mostBytes = limit;
}

ScarceMemory::~ScarceMemory() {
    mostBytes = kPlenty;
    spared = false;
}

}  // namespace se

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
// Sanitizers have their own versions, which do not match the delete below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
