/// Answers of `why`, as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/run_charts.h"
#include "spiraling_edge/why/failure_moments.h"
#include "spiraling_edge/why/ledger.h"
#include "spiraling_edge/why/nearest_decisions.h"
#include "spiraling_edge/why/remedy.h"
#include "spiraling_edge/why/ring_history.h"

namespace se::cli {

/// "distance from the center 0.041 against 0.039, margin -0.02".
std::string readingText(const Reading& reading);
/// A line of a ledger with all its data.
nlohmann::ordered_json lineJson(const LedgerLine& line);

std::string ledgerText(const Ledger& ledger);
std::string ledgerJson(const std::string& input, const Ledger& ledger);
std::string historyText(const RingHistory& history);
std::string historyJson(const std::string& input, const RingHistory& history);
std::string chartsText(const std::vector<RunChart>& charts);
std::string chartsJson(const std::string& input, const std::vector<RunChart>& charts);
std::string nearestText(const NearestDecisions& decisions);
std::string nearestJson(const std::string& input, const NearestDecisions& decisions);
std::string foundText(const FoundDecisions& found);
std::string foundJson(const std::string& input, const FoundDecisions& found);
std::string momentsText(const RunFailure& failure);
/// With the rules that would have prevented it, if they were requested.
std::string momentsJson(const std::string& input, const RunFailure& failure,
                        const Remedies* remedies = nullptr);
std::string remediesText(const Remedies& remedies);
/// All failures of a run, by class; of each class the first `most` with their moments.
std::string failuresText(const RunFailureSearch& found, std::size_t limit);
std::string failuresJson(const std::string& input, const RunFailureSearch& found);
std::string momentsJson(const std::string& input, const MeshFailure& failure,
                        const FailureMoments& moments);

}  // namespace se::cli
