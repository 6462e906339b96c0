/// The trials of `run --best`, as lines of the summary and in JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "spiraling_edge/explain/trial.h"

namespace se::cli {

/// Lines of the summary: the numbers before and of the best, and its options.
std::string trialsText(const Trials& trials);
/// All trials with their numbers, in the order in which they were made, and the position of the
/// best.
nlohmann::ordered_json trialsJson(const Trials& trials);

}  // namespace se::cli
