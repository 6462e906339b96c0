/// Search for the one setting of the paper's rules under which a run gives a trace.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/stepper/rule_settings.h"
#include "trace_diff.h"

namespace se::teach {

/// Every value that one setting of the paper's can have instead of that of `base`: of a switch and
/// of one of several ways each other value, of a number a lower and a higher one.
std::vector<RuleValue> singleSettings(const Params& base);

/// The settings that account for a trace.
struct RuleGuess {
    /// Under each of these alone a run gives the whole trace.
    std::vector<RuleValue> whole;
    /// If `whole` is empty: the setting under which a run agrees with the trace for longest, if
    /// that is longer than under `base`.
    std::optional<RuleValue> nearest;
    std::size_t alike = 0;  ///< Pivots, with `nearest`.
};
/// Runs each of singleSettings() as far as it goes along with the fans of the trace, or with its
/// stages where `upto` is before the fans or these are alike. Fails if cancelled.
/// Requires requireTraceOf().
Result<RuleGuess> guessRules(const Trace& trace, const SharedPoints& points, const Params& base,
                             std::optional<TraceStage> upto, const Progress& progress = {});

/// "your whole trace, 83 pivots, behaves like --rule limits=off"
std::string guessText(const RuleGuess& guess, const Trace& trace);

}  // namespace se::teach
