/// Everything about the rules that a person can set, in one table: it feeds the command line, the
/// Rules panel, session files and reports.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

/// What the value of a setting is. It is held as a number in any case.
enum class SettingKind : std::uint8_t {
    Switch,  ///< 0 or 1, written "off" and "on".
    Number,  ///< Within low and high.
    Whole,   ///< The same, a whole number.
    Option,  ///< An index into the options.
};

/// One row of the table.
struct RuleSetting {
    std::string_view name;     ///< As on the command line: `maxgap`.
    std::string_view section;  ///< "6.3"; docs/robust.md has those beyond the paper.
    bool beyondPaper;          ///< Not in the paper (docs/robust.md).
    std::string_view summary;  ///< One sentence: what it does, if it is a switch: when on.
    /// The paper's sentence, word for word; empty where it has none.
    std::string_view paper;
    SettingKind kind;
    double low, high;                           ///< Of a number; 0 and 1 of a switch.
    std::string_view unit;                      ///< Of a number; may be empty.
    std::span<const std::string_view> options;  ///< Of an option.
    double (*get)(const Params&);
    void (*set)(Params&, double);
    bool Rules::*member;  ///< If it is one of Rules, else null.
};

/// All settings: those of the paper in its order, then those beyond it.
std::span<const RuleSetting> ruleSettings();
/// An angle that is held as its cosine, in degrees.
double degreesOf(double cosine);
/// Null if there is none of that name.
const RuleSetting* findRuleSetting(std::string_view name);

/// "on", "120", "nearest": reads back as the same value.
std::string valueText(const RuleSetting& setting, double value);
/// What can be written there: "on or off", "a number from 90 to 180 (degrees)", "nearest, farthest
/// or both".
std::string valuesText(const RuleSetting& setting);
/// Fails with a sentence that says what can be written.
Result<double> valueFromText(const RuleSetting& setting, std::string_view text);
/// Can the setting have that value?
bool isValue(const RuleSetting& setting, double value);

/// One setting with a value of its own, beside a named set of rules.
struct RuleValue {
    std::string name;  ///< One of ruleSettings().
    double value = 1.0;
    friend bool operator==(const RuleValue&, const RuleValue&) = default;
};
/// Reads "maxgap=100". Fails with a sentence that names what there is.
Result<RuleValue> ruleValueFromText(std::string_view text);
/// "maxgap=100".
std::string lineOf(const RuleValue& value);
/// Carries them out in their order. Fails if there is no setting of a name, or no such value.
Status applyRuleValues(std::span<const RuleValue> values, Params& params);
/// The settings in which `params` differs from `base`, in the order of the table, with the values
/// of `params`.
std::vector<RuleValue> differingRules(const Params& params, const Params& base);

}  // namespace se
