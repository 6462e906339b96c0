/// All settings of the rules in one table, which feeds the command line, the Rules panel, session
/// files and reports.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

/// Kind of value of a setting. Every value is stored as a number.
enum class SettingKind : std::uint8_t {
    Switch,  ///< 0 or 1, written "off" and "on".
    Number,  ///< Within low and high.
    Whole,   ///< A whole number within low and high.
    Option,  ///< An index into the options.
};

/// One row of the table.
struct RuleSetting {
    std::string_view name;     ///< As on the command line: `maxgap`.
    std::string_view section;  ///< Of the paper: "6.3".
    bool beyondPaper;          ///< Not in the paper (docs/robust.md).
    std::string_view summary;  ///< One sentence: its effect; of a switch, when on.
    /// The paper's sentence, word for word; empty where it has none.
    std::string_view paper;
    /// The value by that sentence, which `printed` takes; nothing where there is none.
    std::optional<double> printed;
    SettingKind kind;
    double low, high;                           ///< Of a number; 0 and 1 of a switch.
    std::string_view unit;                      ///< Of a number; may be empty.
    std::span<const std::string_view> options;  ///< Of an option.
    double (*get)(const Params&);
    void (*set)(Params&, double);
    bool isRuleSwitch;  ///< One of Readings or RobustRules.

    /// Of a setting with values 0 and 1.
    bool isOn(const Params& params) const { return get(params) != 0.0; }
    void turnOn(Params& params) const { set(params, 1.0); }
    void turnOff(Params& params) const { set(params, 0.0); }
};

/// All settings: those of the paper in its order, then those beyond it.
std::span<const RuleSetting> ruleSettings();
/// The settings with isRuleSwitch, in the same order.
std::span<const RuleSetting> ruleSwitches();
/// The angle in degrees of a setting that is stored as a cosine.
double degreesOf(double cosine);
/// The setting of that name; null if there is none.
const RuleSetting* findRuleSetting(std::string_view name);

/// §6.3: the gap in degrees above which a neighbor is kept (the rule `maxgap`).
double gapLimitDegrees(const Params& params);

/// The text of a value: "on", "120", "nearest". It reads back as the same value.
std::string valueText(const RuleSetting& setting, double value);
/// The valid values in words: "on or off", "a number from 90 to 180 (degrees)", "nearest, farthest
/// or both".
std::string valuesText(const RuleSetting& setting);
/// The value of a text. Fails with a sentence that lists the valid values.
Result<double> valueFromText(const RuleSetting& setting, std::string_view text);
/// True if the setting can have that value.
bool isValue(const RuleSetting& setting, double value);

/// The value of one setting, in addition to a named set of rules.
struct RuleValue {
    std::string name;  ///< One of ruleSettings().
    double value = 1.0;
    friend bool operator==(const RuleValue&, const RuleValue&) = default;
};
/// True for a text "NAME=VALUE" of a rule of version 0.1 that is gone, and without which a run is
/// the same as with it.
bool isFormerRule(std::string_view text);
/// Reads "maxgap=100". Fails with a sentence that names the settings.
Result<RuleValue> ruleValueFromText(std::string_view text);
/// The text of a value: "maxgap=100".
std::string lineOf(const RuleValue& value);
/// Applies the values in their order. Fails if a setting does not exist or cannot have the value.
Status applyRuleValues(std::span<const RuleValue> values, Params& params);
/// The settings in which `params` differs from `base`, in the order of the table, with the values
/// of `params`.
std::vector<RuleValue> differingRules(const Params& params, const Params& base);

}  // namespace se
