/// Makers of the rows of the table of settings (rule_settings.cpp).
#pragma once

#include "spiraling_edge/base/degrees.h"
#include "spiraling_edge/stepper/rule_settings.h"

namespace se::table {

inline constexpr std::string_view kOnOff[] = {"off", "on"};

/// A switch, on or off.
constexpr RuleSetting onOff(std::string_view name, std::string_view section, bool beyond,
                            std::string_view summary, std::string_view paper,
                            double (*get)(const Params&), void (*set)(Params&, double),
                            bool isRuleSwitch) {
    return {name, section, beyond, summary, paper, SettingKind::Switch, 0.0,
            1.0,  "",      kOnOff, get,     set,   isRuleSwitch};
}

/// A switch of `part`: Params::readings or Params::robust.
template <auto part, auto member>
constexpr RuleSetting switchOf(std::string_view name, std::string_view section, bool beyond,
                               std::string_view summary, std::string_view paper) {
    return onOff(
        name, section, beyond, summary, paper,
        [](const Params& p) { return p.*part.*member ? 1.0 : 0.0; },
        [](Params& p, double value) { p.*part.*member = value != 0.0; }, true);
}

/// A reading of the paper.
template <bool Readings::*member>
constexpr RuleSetting reading(std::string_view name, std::string_view section,
                              std::string_view summary, std::string_view paper) {
    return switchOf<&Params::readings, member>(name, section, false, summary, paper);
}

/// A rule beyond the paper.
template <bool RobustRules::*member>
constexpr RuleSetting robust(std::string_view name, std::string_view section,
                             std::string_view summary) {
    return switchOf<&Params::robust, member>(name, section, true, summary, "");
}

/// A switch of the paper's own.
template <bool PaperRules::*member>
constexpr RuleSetting rule(std::string_view name, std::string_view section,
                           std::string_view summary, std::string_view paper) {
    return onOff(
        name, section, false, summary, paper,
        [](const Params& p) { return p.paper.*member ? 1.0 : 0.0; },
        [](Params& p, double value) { p.paper.*member = value != 0.0; }, false);
}

/// One of several ways to read the paper.
template <auto member>
constexpr RuleSetting option(std::string_view name, std::string_view section,
                             std::string_view summary, std::string_view paper,
                             std::span<const std::string_view> options) {
    return {name,
            section,
            false,
            summary,
            paper,
            SettingKind::Option,
            0.0,
            static_cast<double>(options.size()) - 1.0,
            "",
            options,
            [](const Params& p) { return static_cast<double>(p.paper.*member); },
            [](Params& p, double value) {
                using Option = std::remove_reference_t<decltype(p.paper.*member)>;
                p.paper.*member = static_cast<Option>(static_cast<int>(value));
            },
            false};
}

/// A number of a rule beyond the paper.
template <double RobustThresholds::*member>
constexpr RuleSetting number(std::string_view name, std::string_view section,
                             std::string_view summary, double low, double high,
                             std::string_view unit) {
    return {name,
            section,
            true,
            summary,
            "",
            SettingKind::Number,
            low,
            high,
            unit,
            {},
            [](const Params& p) { return p.thresholds.*member; },
            [](Params& p, double value) { p.thresholds.*member = value; },
            false};
}

/// An angle of a rule beyond the paper, from `low` to 180 degrees; held as its cosine.
template <double RobustThresholds::*member>
constexpr RuleSetting angle(std::string_view name, std::string_view section,
                            std::string_view summary, double low) {
    RuleSetting row = number<member>(name, section, summary, low, 180.0, "degrees");
    row.get = [](const Params& p) { return degreesOfCosine(p.thresholds.*member); };
    row.set = [](Params& p, double value) { p.thresholds.*member = cosineOfDegrees(value); };
    return row;
}

}  // namespace se::table
