/// Answers of `why`.
#pragma once

#include <string>

#include "output.h"
#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/run_charts.h"
#include "spiraling_edge/why/failure_moments.h"
#include "spiraling_edge/why/ledger.h"
#include "spiraling_edge/why/nearest_decisions.h"
#include "spiraling_edge/why/ring_history.h"

namespace se::cli {

/// "distance from the center 0.041 against 0.039, margin -0.02".
std::string readingText(const Reading& reading);
/// A line of a ledger with all its data.
Json lineJson(const LedgerLine& line);

Answer answerOf(const Ledger& ledger);
Answer answerOf(const RingHistory& history);
Answer answerOf(const std::vector<RunChart>& charts);
Answer answerOf(const NearestDecisions& decisions);
Answer answerOf(const FoundDecisions& found);
/// A failure with its moments.
Answer answerOf(const RunFailure& failure);
/// All failures of a run, by class; in the text of each class the first `limit`.
Answer answerOf(const RunFailureSearch& found, std::size_t limit);

}  // namespace se::cli
