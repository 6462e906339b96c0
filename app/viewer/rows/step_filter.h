/// The filter line above the tree of steps.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "run/overview.h"

namespace se::view {

/// Words that must all match: the beginning of a stage's name, a word of a verdict, the number
/// of a point or pivot, or `x` for refused tests. Case is ignored.
class StepFilter {
  public:
    StepFilter() = default;
    explicit StepFilter(std::string_view text);

    bool empty() const { return words_.empty(); }
    /// Whether the pivot may have such a decision.
    bool matches(std::uint32_t pivot, const PivotSummary& summary) const;
    /// Matches also words of the sentence that describes the event.
    bool matches(const Event& event) const;

  private:
    struct Word {
        std::string text;
        Findings found;
        bool refused = false;
        Index number = kNone;
    };
    static Word read(std::string text);

    std::vector<Word> words_;
};

}  // namespace se::view
