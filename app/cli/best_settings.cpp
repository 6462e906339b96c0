#include "best_settings.h"

#include <cassert>

namespace se::cli {

Trials tryOthers(const PointFile& file, const RunSettings& settings, const std::string& input,
                 ProgressLine& line) {
    std::string what = "trying settings";
    const auto visit = [&](const Trials& trials, const SettingsChange& next) {
        what = trialText(next) + ", run " + std::to_string(trials.tried.size() + 1);
    };
    return runWithProgress(what, input, line, [&](const Progress& progress) {
        return tryChanges(file, settings, visit, progress);
    });
}

RunSettings bestOf(const Trials& trials, const RunSettings& settings) {
    assert(trials.best < trials.tried.size());
    const Trial& best = trials.tried[trials.best];
    RunSettings chosen = changed(settings, best.change);
    chosen.prepare.leaveOut = best.leaveOut;
    return chosen;
}

}  // namespace se::cli
