/// Check of a figure of the paper: whether its run decides what the figure shows, and does not
/// without the figure's rule.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/scenes/figures.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

/// Outcome of a decision in words: the verdict of a test in the words of verdictText(), else what
/// is done: "made", "enters, USED 1", "leaves, DONE", "passed over", "splits into 19 and 13",
/// "joins, a ring of 30", "closed", "next pivot", "seed", "stranded", "freed". Empty for events
/// that change nothing.
std::string outcomeText(const Event& event);

/// The words that outcomes begin with: "kept", ..., "made", "splits into".
std::vector<std::string_view> outcomeWords();

/// An expectation and the decision at its address.
struct CheckedExpectation {
    FigureExpectation expected;
    bool holds = false;
    /// The sentence of the decision, with the names of the figure; empty if there is none.
    std::string found;
};

/// The result of a check.
struct FigureCheck {
    std::vector<CheckedExpectation> expectations;  ///< Under the set `paper`.
    std::vector<CheckedExpectation> without;       ///< Figure::without, without the rule.
    std::size_t brokenWithout = 0;  ///< Expectations that do not hold without the rule.
    std::size_t faultsWith = 0;     ///< Faults of Figure::fault, with the rule,
    std::size_t faultsWithout = 0;  ///< ... and without it.
    /// Without the rule an expectation breaks, the mesh differs, and Figure::fault, if there is
    /// one, appears only there.
    bool showsAbsence = false;
    bool holds() const;
};

/// The expectations of a figure under some params; their start is replaced by that of the figure.
/// Requires a figure with a scene.
std::vector<CheckedExpectation> expectationsOf(const Figure& figure, Params params);

/// `params` without the rule of the figure.
Params withoutRule(const Figure& figure, Params params);

/// Runs a figure with and without its rule. Requires a figure with a scene.
FigureCheck checkFigure(const Figure& figure);

}  // namespace se
