#include "thread.h"

#include <cstdlib>
#include <new>
#include <string>
#include <vector>

namespace se::view {

namespace {

constexpr std::chrono::milliseconds kPause{5};

/// All work in progress, without threads.
std::vector<Thread*>& allWork() {
    static std::vector<Thread*> all;
    return all;
}

}  // namespace

bool usesThreads() {
    static const bool uses = kHasThreads && std::getenv("SPIRALING_EDGE_ONE_THREAD") == nullptr;
    return uses;
}

std::chrono::milliseconds sliceTime() {
    return std::chrono::milliseconds(usesThreads() ? 120 : 30);
}

Thread::Thread(Work work) : work_(std::move(work)) {
    if (usesThreads()) {
        thread_ = std::thread([this] { run(); });
    } else {
        allWork().push_back(this);
    }
}

Thread::~Thread() {
    cancel();
    if (thread_.joinable()) thread_.join();
    std::erase(allWork(), this);
}

Slice Thread::runSlice() {
    {
        const std::lock_guard lock(mutex_);
        woken_ = false;
    }
    const Slice next = work_(cancelled_);
    if (next == Slice::Done) work_ = nullptr;  // What it held may be large.
    const std::lock_guard lock(mutex_);
    idle_ = next == Slice::Idle;
    ended_ = next == Slice::Done;
    changed_.notify_all();
    return next;
}

/// Body of the thread.
void Thread::run() {
    while (true) {
        const Slice next = runSlice();
        if (next == Slice::Done) return;
        std::unique_lock lock(mutex_);
        const auto goesOn = [this] { return woken_ || cancelled_.isSet(); };
        if (next == Slice::Pause) changed_.wait_for(lock, kPause, goesOn);
        if (next == Slice::Idle) changed_.wait(lock, goesOn);
    }
}

void Thread::cancel() {
    const std::lock_guard lock(mutex_);
    cancelled_.set();
    // Without threads, no slice of it is running.
    if (!usesThreads()) ended_ = true;
    changed_.notify_all();
}

void Thread::wake() {
    const std::lock_guard lock(mutex_);
    woken_ = true;
    changed_.notify_all();
}

bool Thread::waitFor(std::chrono::milliseconds timeout, const std::function<bool()>& holds) {
    const auto holdsNow = [&] { return ended_.load() || (holds && holds()); };
    if (usesThreads()) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, timeout, holdsNow);
    }
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (!holdsNow()) {
        if (runSlice() == Slice::Idle || std::chrono::steady_clock::now() > end) return holdsNow();
    }
    return true;
}

bool runSlices(std::chrono::milliseconds time) {
    static std::size_t turn = 0;  // Where the last call ended, the next one goes on.
    const auto end = std::chrono::steady_clock::now() + time;
    // A slice may start other work, or end some.
    for (std::size_t resting = 0; resting < allWork().size();) {
        Thread& each = *allWork()[turn++ % allWork().size()];
        const bool rests = each.ended() || (each.idle_ && !each.woken_);
        resting = !rests && each.runSlice() == Slice::More ? 0 : resting + 1;
        if (std::chrono::steady_clock::now() >= end) return resting < allWork().size();
    }
    return false;
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
