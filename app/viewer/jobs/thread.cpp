#include "thread.h"

#include <new>
#include <stdexcept>
#include <string>

namespace se::view {

Thread::Thread(Work work)
    : thread_([this, work = std::move(work)] {
          work(cancelled_);
          const std::lock_guard lock(mutex_);
          ended_ = true;
          changed_.notify_all();
      }) {}

Thread::~Thread() {
    cancel();
    thread_.join();
}

bool Thread::waitFor(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, timeout, [this] { return ended_.load(); });
}

void Thread::waitUntilDone() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ended_.load(); });
}

namespace {

Error outOfMemory() {
    return Error{"Out of memory. Close other programs, or use fewer points or shorter lists."};
}

}  // namespace

Error errorOf(const std::exception_ptr& exception) {
    try {
        std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    } catch (const std::length_error&) {
        // More than any memory holds: containers refuse it before they allocate.
        return outOfMemory();
    } catch (const std::exception& problem) {
        return Error{std::string("Internal error: ") + problem.what() + "."};
    } catch (...) {
        return Error{"Internal error: unknown exception."};
    }
}

}  // namespace se::view
