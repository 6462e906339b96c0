/// The values that rules can have, for tests that hold for every one of them.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "spiraling_edge/stepper/rule_settings.h"

namespace se::test {

/// Values to try: all of a switch or option, both ends and something between of a number.
inline std::vector<double> valuesOf(const RuleSetting& setting) {
    if (setting.kind == SettingKind::Number || setting.kind == SettingKind::Whole) {
        const double middle = 0.5 * (setting.low + setting.high);
        return {setting.low, setting.kind == SettingKind::Whole ? std::floor(middle) : middle,
                setting.high};
    }
    std::vector<double> values;
    for (double value = 0.0; value <= setting.high; ++value) values.push_back(value);
    return values;
}

/// Calls visit(params, line of the value) for each set of rules that differs from `base` by one
/// value of one of the paper's rules.
template <typename Visit>
void forEachPaperRule(const Params& base, Visit&& visit) {
    for (const RuleSetting& setting : ruleSettings()) {
        if (setting.beyondPaper) continue;
        for (const double value : valuesOf(setting)) {
            if (value == setting.get(base)) continue;
            Params params = base;
            setting.set(params, value);
            visit(params, lineOf({std::string(setting.name), value}));
        }
    }
}

}  // namespace se::test
