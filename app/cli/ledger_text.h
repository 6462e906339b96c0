/// What `why` says, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "spiraling_edge/closest_calls.h"
#include "spiraling_edge/decision_query.h"
#include "spiraling_edge/failure_moments.h"
#include "spiraling_edge/ledger.h"

namespace se::cli {

std::string ledgerText(const Ledger& ledger);
std::string ledgerJson(const std::string& input, const Ledger& ledger);
std::string callsText(const ClosestCalls& calls);
std::string callsJson(const std::string& input, const ClosestCalls& calls);
std::string foundText(const FoundDecisions& found);
std::string foundJson(const std::string& input, const FoundDecisions& found);
std::string momentsText(const MeshFailure& failure, const FailureMoments& moments);
std::string momentsJson(const std::string& input, const MeshFailure& failure,
                        const FailureMoments& moments);

}  // namespace se::cli
