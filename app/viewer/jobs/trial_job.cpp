#include "trial_job.h"

#include <utility>

#if defined(__linux__)
#include <sys/resource.h>
#endif

namespace se::view {

namespace {

/// Lowers the priority of this thread, and of those that it starts, so that the window and the
/// user's own work come first. Elsewhere than on Linux, where that is one call, nothing changes.
void lowerPriority() {
#if defined(__linux__)
    constexpr int kLow = 10;
    static_cast<void>(setpriority(PRIO_PROCESS, 0, kLow));
#endif
}

}  // namespace

void TrialJob::open(std::shared_ptr<const PointFile> file, RunSettings settings) {
    job_.cancel();
    file_ = std::move(file);
    settings_ = std::move(settings);
    // One core stays free for the window.
    settings_.prepare.neighbors.threads = 1;
    started_ = false;
    trials_ = {};
    trying_.clear();
}

void TrialJob::start() {
    if (started_ || file_ == nullptr) return;
    started_ = true;
    job_.start([file = file_, settings = settings_](auto& results) {
        lowerPriority();
        double share = 0.0;
        const auto visit = [&](const Trials& trials, const SettingsChange& next) {
            const bool first = next == SettingsChange{};
            results.add({trials, first ? "measuring this run" : "trying " + wordsOf(next)});
            results.report(share);
        };
        Result<Trials> all = tryChanges(*file, settings, visit, [&](double done) {
            share = done;
            return results.report(done);
        });
        if (all) results.add({std::move(all.value()), {}});
    });
}

void TrialJob::stop() {
    job_.cancel();
    trying_.clear();
}

bool TrialJob::poll() {
    if (!job_.busy()) return false;
    const bool ended = job_.ended();
    std::vector<Progressed> found = job_.take();
    if (!found.empty()) {
        trials_ = std::move(found.back().trials);
        trying_ = std::move(found.back().next);
    }
    if (ended) {
        trying_.clear();
        job_.close();
    }
    return ended || !found.empty();
}

}  // namespace se::view
