/// A rule's value in JSON: true or false, a number, or the name of an option.
#pragma once

#include <nlohmann/json.hpp>

#include "spiraling_edge/stepper/rule_settings.h"

namespace se::cli {

inline nlohmann::ordered_json ruleJson(const RuleSetting& rule, double value) {
    if (rule.kind == SettingKind::Switch) return value != 0.0;
    if (rule.kind == SettingKind::Option) return valueText(rule, value);
    if (rule.kind == SettingKind::Whole) return static_cast<std::int64_t>(value);
    return value;
}

}  // namespace se::cli
