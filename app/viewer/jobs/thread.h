/// Work beside the window, in slices, that can be cancelled and that no exception leaves: an
/// uncaught one would end the program. Each has a thread, except in a build without threads
/// (SPIRALING_EDGE_THREADS=OFF, as for the browser): there slices are run between two frames. The
/// threads of C++20 with a stop token are not in the library of that build.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

#include "spiraling_edge/base/parallel.h"
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

/// Next step after a slice of work.
enum class Slice : std::uint8_t {
    More,   ///< It is called again at once.
    Pause,  ///< It is called again after a moment, or at wake().
    Idle,   ///< It is called again after wake().
    Done,   ///< It is not called again.
};

/// False in a build without threads, and where the environment has SPIRALING_EDGE_ONE_THREAD, for
/// tests.
bool usesThreads();
/// How long a slice should take at most: without threads the window waits for it.
std::chrono::milliseconds sliceTime();

/// Calls work, slice by slice, in a thread of its own; without threads, from runSlices() and
/// during waitFor(). The destructor cancels it and waits until it has returned.
class Thread {
  public:
    using Work = std::function<Slice(const CancelFlag& cancelled)>;

    /// Starts `work`, which must not throw and may use nothing that this object outlives.
    explicit Thread(Work work);
    ~Thread();
    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;

    /// Sets the flag; the work ends when it reads it.
    void cancel();
    /// Ends a pause.
    void wake();
    /// The work is done.
    bool ended() const { return ended_.load(); }
    /// Blocks until the work is done or `holds` returns true, asked after each slice; at most for
    /// `timeout`. True if either holds.
    bool waitFor(std::chrono::milliseconds timeout, const std::function<bool()>& holds = {});
    /// Blocks until the work is done.
    void waitUntilDone() {
        while (!waitFor(std::chrono::hours(1))) {
        }
    }

  private:
    friend bool runSlices(std::chrono::milliseconds time);

    void run();
    Slice runSlice();

    CancelFlag cancelled_;
    Work work_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool woken_ = false;  ///< Since the last slice began; under the mutex, as the next one.
    bool idle_ = false;   ///< Until wake().
    std::atomic<bool> ended_ = false;
    std::thread thread_;  // last: it uses all members above
};

/// Without threads: runs slices of all work in turn while there is some and `time` is left, at
/// least one. True if there is more. With threads it does nothing.
bool runSlices(std::chrono::milliseconds time);

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
