/// Results of `why --failures --prove`, as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "spiraling_edge/explain/cause_inversion.h"

namespace se::cli {

/// A failure with the result of its inverted decision, and its number within its class, from 1.
struct InvertedFailure {
    const RunFailure* failure;
    std::size_t number;
    CauseInversion inversion;
};

/// Counts per class and result, then each failure that did not disappear as predicted.
std::string inversionsText(const std::vector<InvertedFailure>& inverted);
/// All results.
std::string inversionsJson(const std::string& input, const std::vector<InvertedFailure>& inverted);

}  // namespace se::cli
