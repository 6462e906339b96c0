#include "trials_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cassert>

#include "sentences.h"
#include "verdict_text.h"

namespace se::cli {

using Json = nlohmann::ordered_json;

namespace {

/// "--rules robust, on the points of doctor --fix OUT.ply --drop noise". Requires a change.
std::string insteadText(const SpecChange& change) {
    assert(!change.empty());
    std::string text = fmt::format("{}", fmt::join(optionsOf(change), " "));
    const std::string_view drop = textOf(change, "doctor");
    if (drop.empty()) return text;
    return fmt::format("{}on the points of doctor --fix OUT.ply --drop {}",
                       text.empty() ? "" : text + ", ", drop);
}

Json trialJson(const Trial& trial) {
    Json json = {{"options", optionsOf(trial.change)}};
    const std::string_view drop = textOf(trial.change, "doctor");
    json["drop"] = drop.empty() ? Json() : Json(drop);
    json["work"] = trial.work;
    json["verdict"] = verdictJson(trial.verdict);
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
        line("before", describe(first.verdict));
    if (trials.best == 0) return text + line("best", "as given; no change is better");
    text += line("best", describe(best.verdict)) + line("instead", insteadText(best.change));
    const std::string losses = lossesText(best.verdict, first.verdict);
    return losses.empty() ? text : text + line("but", losses);
}

Json trialsJson(const Trials& trials) {
    Json tried = Json::array();
    for (const Trial& each : trials.tried) tried.push_back(trialJson(each));
    return {{"chosen", trials.best}, {"tried", tried}};
}

}  // namespace se::cli
