/// What `why --failures --prove` says, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "spiraling_edge/explain/failure_proof.h"

namespace se::cli {

/// A failure with its proof, and where it stands in its class, from 1.
struct ProvenFailure {
    const RunFailure* failure;
    std::size_t number;
    FailureProof proof;
};

/// How many of each class went which way, then each that did not go as the decision promises.
std::string proofsText(const std::vector<ProvenFailure>& proven);
/// All of them.
std::string proofsJson(const std::string& input, const std::vector<ProvenFailure>& proven);

}  // namespace se::cli
