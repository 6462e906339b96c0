/// The values of settings as text.
#include <algorithm>
#include <cmath>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/stepper/rule_settings.h"

namespace se {
namespace {

std::string numberText(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

std::string noSuchRule(std::string_view name) {
    return "there is no rule " + inQuotes(name) + "; the nearest is " +
           nearestName(ruleSettings(), name) + "; spiraling-edge run --help lists all";
}

}  // namespace

const RuleSetting* findRuleSetting(std::string_view name) {
    const auto rows = ruleSettings();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const RuleSetting& each) { return each.name == name; });
    return row == rows.end() ? nullptr : &*row;
}

double gapLimitDegrees(const Params& params) {
    static const RuleSetting* const setting = findRuleSetting("maxgap");
    return setting->get(params);
}

std::string valueText(const RuleSetting& setting, double value) {
    if (setting.options.empty()) return numberText(value);
    return std::string(setting.options[static_cast<std::size_t>(value)]);
}

std::string valuesText(const RuleSetting& setting) {
    if (setting.kind == SettingKind::Switch) return "on or off";
    if (!setting.options.empty()) return wordList(setting.options, "or");
    const std::string unit = setting.unit.empty() ? "" : " (" + std::string(setting.unit) + ")";
    return (setting.kind == SettingKind::Whole ? "a whole number from " : "a number from ") +
           numberText(setting.low) + " to " + numberText(setting.high) + unit;
}

bool isValue(const RuleSetting& setting, double value) {
    const bool whole = setting.kind == SettingKind::Number || value == std::floor(value);
    return whole && value >= setting.low && value <= setting.high;
}

Result<double> valueFromText(const RuleSetting& setting, std::string_view text) {
    const auto option = std::find(setting.options.begin(), setting.options.end(), text);
    if (option != setting.options.end()) {
        return static_cast<double>(option - setting.options.begin());
    }
    if (setting.options.empty()) {
        double value = 0.0;
        if (io::parseDouble(text, value) && isValue(setting, value)) return value;
        return Error{"write " + std::string(setting.name) + "=VALUE with " + valuesText(setting)};
    }
    std::vector<std::string> ways;
    for (const std::string_view each : setting.options) {
        ways.push_back(std::string(setting.name) + "=" + std::string(each));
    }
    // "on or off" is the usual order.
    if (setting.kind == SettingKind::Switch) std::reverse(ways.begin(), ways.end());
    return Error{"write " + wordList(ways, "or")};
}

bool isFormerRule(std::string_view text) { return text.substr(0, text.find('=')) == "reseat"; }

Result<RuleValue> ruleValueFromText(std::string_view text) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string_view name = text.substr(0, equals);
    const RuleSetting* setting = findRuleSetting(name);
    if (setting == nullptr) return Error{noSuchRule(name)};
    const auto value = valueFromText(*setting, text.substr(std::min(equals + 1, text.size())));
    if (!value) return value.error();
    return RuleValue{std::string(name), value.value()};
}

std::string lineOf(const RuleValue& value) {
    const RuleSetting* setting = findRuleSetting(value.name);
    return value.name + "=" + (setting == nullptr ? "" : valueText(*setting, value.value));
}

Status applyRuleValues(std::span<const RuleValue> values, Params& params) {
    for (const RuleValue& each : values) {
        const RuleSetting* setting = findRuleSetting(each.name);
        if (setting == nullptr) return Error{noSuchRule(each.name)};
        if (!isValue(*setting, each.value)) {
            return Error{each.name + ": expected " + valuesText(*setting)};
        }
        setting->set(params, each.value);
    }
    return success();
}

std::vector<RuleValue> differingRules(const Params& params, const Params& base) {
    std::vector<RuleValue> values;
    for (const RuleSetting& each : ruleSettings()) {
        const double value = each.get(params);
        if (value != each.get(base)) values.push_back({std::string(each.name), value});
    }
    return values;
}

}  // namespace se
