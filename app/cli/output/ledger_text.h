/// Answers of `why`: of each kind its text, and its fields in JSON.
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

std::string answerText(const Ledger& ledger);
std::string answerText(const RingHistory& history);
std::string answerText(const std::vector<RunChart>& charts);
std::string answerText(const NearestDecisions& decisions);
std::string answerText(const FoundDecisions& found);
/// A failure with its moments.
std::string answerText(const RunFailure& failure);
/// The rules that would have prevented a failure.
std::string answerText(const Remedies& remedies);
/// All failures of a run, by class; of each class the first `limit` with their moments.
std::string failuresText(const RunFailureSearch& found, std::size_t limit);

nlohmann::ordered_json answerJson(const Ledger& ledger);
nlohmann::ordered_json answerJson(const RingHistory& history);
nlohmann::ordered_json answerJson(const std::vector<RunChart>& charts);
nlohmann::ordered_json answerJson(const NearestDecisions& decisions);
nlohmann::ordered_json answerJson(const FoundDecisions& found);
nlohmann::ordered_json answerJson(const RunFailure& failure);
nlohmann::ordered_json answerJson(const Remedies& remedies);
nlohmann::ordered_json answerJson(const RunFailureSearch& found);

}  // namespace se::cli
