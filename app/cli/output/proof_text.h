/// Results of `why --failures --prove`, as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "spiraling_edge/explain/failure_proof.h"

namespace se::cli {

/// A failure with the result of its inverted decision, and its number within its class, from 1.
struct ProvenFailure {
    const RunFailure* failure;
    std::size_t number;
    FailureProof proof;
};

/// Counts per class and result, then each failure that did not disappear as predicted.
std::string proofsText(const std::vector<ProvenFailure>& proven);
/// All results.
std::string proofsJson(const std::string& input, const std::vector<ProvenFailure>& proven);

}  // namespace se::cli
