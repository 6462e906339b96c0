/// Single rules turned on or off, beside the set of rules that was chosen.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/params.h"
#include "spiraling_edge/result.h"

namespace se::view {

struct RuleChoice {
    std::string name;  ///< One of ruleSwitches().
    bool on = true;
    friend bool operator==(const RuleChoice&, const RuleChoice&) = default;
};

/// Reads "closetwo=off". Fails with a sentence that names what there is.
Result<RuleChoice> ruleChoiceFromText(std::string_view text);
/// Carries the choices out in their order. Fails if there is no rule of a name.
Status applyChoices(const std::vector<RuleChoice>& choices, Rules& rules);

}  // namespace se::view
