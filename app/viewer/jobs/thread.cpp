#include "thread.h"

#include <utility>

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

}  // namespace se::view
