/// Loops over independent items, split over threads.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <thread>
#include <utility>
#include <vector>

#include "spiraling_edge/base/progress.h"

namespace se {

/// False in a build without threads, as for the browser (SPIRALING_EDGE_THREADS).
#ifdef SPIRALING_EDGE_NO_THREADS
inline constexpr bool kHasThreads = false;
#else
inline constexpr bool kHasThreads = true;
#endif

/// Threads in addition to the caller's, in a build that has them. An exception in one of them
/// reaches the caller.
class Workers {
  public:
    /// Calls work() in a thread of its own. Everything it uses must outlive this object. Requires
    /// kHasThreads.
    template <typename Work>
    void start(Work&& work) {
        assert(kHasThreads);
        running_.push_back(std::async(std::launch::async, std::forward<Work>(work)));
    }
    /// Waits for all of them; then rethrows the first exception, in the order of start(). The
    /// destructor waits as well, and throws nothing.
    void join() {
        for (const std::future<void>& each : running_) each.wait();
        for (std::future<void>& each : std::exchange(running_, {})) each.get();
    }

  private:
    std::vector<std::future<void>> running_;
};

/// Number of threads that `threads` stands for. 0: as many as the machine has. At least 1; without
/// threads exactly that.
inline unsigned threadCount(unsigned threads) {
    if (!kHasThreads) return 1;
    return threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
}

/// Calls work(from, to) for consecutive pieces of 0 .. count, one per thread. `threads` 0: as many
/// as the machine has, but none for fewer than `least` items. Results are the same for any number
/// if work on one item does not depend on another. An exception of `work` is rethrown once all
/// threads have ended.
template <typename Work>
void forRanges(std::size_t count, unsigned threads, std::size_t least, Work&& work) {
    const std::size_t pieces =
        std::clamp<std::size_t>(count / least, 1, std::size_t{threadCount(threads)});
    Workers others;
    for (std::size_t i = 1; i < pieces; ++i) {
        others.start(
            [&work, count, pieces, i] { work(count * i / pieces, count * (i + 1) / pieces); });
    }
    work(std::size_t{0}, count / pieces);
    others.join();
}

/// As forRanges(), but calls work(i) for each item.
template <typename Work>
void forEachItem(std::size_t count, unsigned threads, std::size_t least, Work&& work) {
    forRanges(count, threads, least, [&work](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) work(i);
    });
}

/// As forEachItem(), for items of unequal length: a thread takes the next one when it is free. An
/// exception of `work` is rethrown once all threads have ended; of several, any one.
template <typename Work>
void forEachTask(std::size_t count, unsigned threads, Work&& work) {
    std::atomic<std::size_t> next = 0;
    const auto takeTasks = [&] {
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    Workers others;
    for (std::size_t i = 1; i < std::min<std::size_t>(count, threadCount(threads)); ++i)
        others.start(takeTasks);
    takeTasks();
    others.join();
}

/// Calls each of the functions once, as forEachTask() does.
template <typename... Task>
void runTasks(unsigned threads, Task&&... tasks) {
    const std::array<std::function<void()>, sizeof...(tasks)> all{std::ref(tasks)...};
    forEachTask(all.size(), threads, [&all](std::size_t i) { all[i](); });
}

/// As forRanges(), but calls work(i) for each item, and `progress` at intervals from the caller's
/// thread with the share of its range. False if it cancelled: then some items are left out.
template <typename Work>
bool forEachWithProgress(std::size_t count, unsigned threads, std::size_t least,
                         const Progress& progress, Work&& work) {
    std::atomic<bool> cancelled = false;
    forRanges(count, threads, least, [&](std::size_t from, std::size_t to) {
        const std::size_t between = std::clamp<std::size_t>((to - from) / 64, 1, 1024);
        for (std::size_t i = from; i < to; ++i) {
            if ((i - from) % between == 0) {
                const double share = static_cast<double>(i - from) / static_cast<double>(to - from);
                if (from == 0 && progress && !progress(share)) cancelled = true;
                if (cancelled) return;
            }
            work(i);
        }
    });
    return !cancelled;
}

/// Pivots of a run between two calls of its progress function.
inline constexpr std::uint32_t kPivotsPerReport = 1024;

/// The progress of a part of the work, which covers the shares `from` to `to` of the whole.
inline Progress partOf(const Progress& progress, double from, double to) {
    if (!progress) return {};
    return [progress, from, to](double share) { return progress(from + (to - from) * share); };
}

}  // namespace se
