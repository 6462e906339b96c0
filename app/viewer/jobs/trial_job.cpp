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

void TrialJob::open(std::shared_ptr<const PointFile> file, RunSpec spec) {
    job_.cancel();
    file_ = std::move(file);
    spec_ = std::move(spec);
    // Preparing takes one thread; the search for faults takes all, at low priority.
    spec_.neighbors.threads = 1;
    started_ = false;
    trials_ = {};
    trying_.clear();
    change_.reset();
    complaint_.clear();
}

void TrialJob::start() {
    if (started_ || file_ == nullptr) return;
    started_ = true;
    trying_ = trialText({});
    job_.start([file = file_, spec = spec_](auto& results) {
        if (usesThreads()) lowerPriority();
        double share = 0.0;
        std::size_t best = 0;
        std::shared_ptr<const MeshChange> change;
        // Of the meshes, only their difference is handed on.
        const auto add = [&](Trials trials, std::string next) {
            if (trials.best != std::exchange(best, trials.best)) {
                change = std::make_shared<const MeshChange>(
                    changeOf(file->position, *trials.tried.front().mesh, *trials.tried[best].mesh));
            }
            for (Trial& each : trials.tried) each.mesh.reset();
            results.add({std::move(trials), std::move(next), change});
        };
        const auto visit = [&](const Trials& trials, const SpecChange& next) {
            add(trials, trialText(next));
            results.report(share);
        };
        Result<Trials> all = tryChanges(*file, spec, visit, [&](double done) {
            share = done;
            return results.report(done);
        });
        if (all) {
            add(std::move(all.value()), {});
        } else {
            results.add({{}, {}, nullptr, all.error().message});
        }
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
    for (Progressed& each : found) {
        complaint_ = std::move(each.complaint);
        if (!complaint_.empty()) break;
        trials_ = std::move(each.trials);
        trying_ = std::move(each.next);
        change_ = std::move(each.change);
    }
    if (ended) {
        if (!job_.complaint().empty()) complaint_ = job_.complaint();
        trying_.clear();
        job_.close();
    }
    return ended || !found.empty();
}

}  // namespace se::view
