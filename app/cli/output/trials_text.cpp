#include "trials_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cassert>

#include "sentences.h"

namespace se::cli {

using Json = nlohmann::ordered_json;

namespace {

/// "--rules robust, on the points of doctor --fix OUT.ply --drop noise". Requires a change.
std::string optionsText(const SettingsChange& change) {
    assert(change != SettingsChange{});
    std::string text = fmt::format("{}", fmt::join(optionsOf(change), " "));
    if (change.drop.empty()) return text;
    return fmt::format("{}on the points of doctor --fix OUT.ply --drop {}",
                       text.empty() ? "" : text + ", ", change.drop);
}

Json trialJson(const Trial& trial) {
    const MeshNumbers& numbers = trial.numbers;
    Json json = {{"options", optionsOf(trial.change)}};
    json["drop"] = trial.change.drop.empty() ? Json() : Json(trial.change.drop);
    json["faults"] = faultCount(numbers.totals);
    json["sound"] = isSound(numbers);
    json["points_lost"] = numbers.lost;
    json["points_set_aside"] = numbers.setAside;
    json["openings"] = numbers.openings;
    json["openings_closed"] = numbers.closed;
    json["greatest_distance"] = numbers.fidelity.greatestDistance;
    json["mean_distance"] = numbers.fidelity.meanDistance;
    json["triangles"] = numbers.triangles;
    json["capped"] = numbers.capped;
    return json;
}

}  // namespace

std::string trialsText(const Trials& trials) {
    const Trial& first = trials.tried.front();
    const Trial& best = trials.tried[trials.best];
    const auto line = [](const char* label, const std::string& text) {
        return fmt::format("  {:<10} {}\n", label, text);
    };
    std::string text =
        line("tried", counted(trials.tried.size() - 1, "change") + " of the settings") +
        line("before", describe(first.numbers));
    if (trials.best == 0) return text + line("best", "as given; no change is better");
    return text + line("best", describe(best.numbers)) + line("instead", optionsText(best.change));
}

Json trialsJson(const Trials& trials) {
    Json tried = Json::array();
    for (const Trial& each : trials.tried) tried.push_back(trialJson(each));
    return {{"chosen", trials.best}, {"tried", tried}};
}

}  // namespace se::cli
