#include "thread.h"

#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace se::view {

namespace {

constexpr std::chrono::milliseconds kPause{5};

/// All work of a build without threads, which this one list must reach.
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
    const Slice next = work_(cancelled_);
    const std::lock_guard lock(mutex_);
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
        woken_ = false;
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
    const auto isSo = [&] { return ended_.load() || (holds && holds()); };
    if (usesThreads()) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, timeout, isSo);
    }
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (!isSo()) {
        if (runSlice() == Slice::Idle || std::chrono::steady_clock::now() > end) return isSo();
    }
    return true;
}

bool runSlices(std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    bool more = !usesThreads();
    while (more && std::chrono::steady_clock::now() < end) {
        more = false;
        // A slice may start other work, or end some.
        for (std::size_t i = 0; i < allWork().size(); ++i) {
            Thread& each = *allWork()[i];
            if (!each.ended() && each.runSlice() == Slice::More) more = true;
            if (std::chrono::steady_clock::now() >= end) return true;
        }
    }
    return more;
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
