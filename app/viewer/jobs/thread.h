/// A thread for work that can be cancelled, and that no exception leaves: an uncaught one would end
/// the program. The threads of C++20 with a stop token are not in the library of the browser build.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

#include "spiraling_edge/base/result.h"

namespace se::view {

/// The request to end early. Work reads it now and then.
class CancelFlag {
  public:
    bool isSet() const { return set_.load(); }
    void set() { set_ = true; }

  private:
    std::atomic<bool> set_ = false;
};

/// Runs one function. The destructor cancels it and waits until it has returned.
class Thread {
  public:
    using Work = std::function<void(const CancelFlag& cancelled)>;

    /// Starts `work`, which must not throw and may use nothing that this object outlives.
    explicit Thread(Work work);
    ~Thread();
    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;

    /// Sets the flag; the work ends when it reads it.
    void cancel() { cancelled_.set(); }
    /// The work has returned.
    bool ended() const { return ended_.load(); }
    /// Blocks until the work has returned, at most for `timeout`. True if it has.
    bool waitFor(std::chrono::milliseconds timeout);
    /// Blocks until the work has returned.
    void waitUntilDone();

  private:
    CancelFlag cancelled_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::atomic<bool> ended_ = false;
    std::thread thread_;  // last: it uses all members above
};

/// A sentence for the user: too little memory, or the text of the exception.
Error errorOf(const std::exception_ptr& exception);

/// Calls `work` and returns the error of an exception it throws. A template, because constructing a
/// std::function might throw outside of the guard.
template <typename Work>
Status guarded(Work&& work) {
    try {
        std::forward<Work>(work)();
    } catch (...) {
        return errorOf(std::current_exception());
    }
    return success();
}

}  // namespace se::view
