#include "rule_choice.h"

#include <algorithm>

namespace se::view {

namespace {

const RuleSwitch* findSwitch(std::string_view name) {
    const auto rows = ruleSwitches();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const RuleSwitch& each) { return each.name == name; });
    return row == rows.end() ? nullptr : &*row;
}

Error noSuchRule(std::string_view name) {
    std::string known;
    for (const RuleSwitch& each : ruleSwitches()) {
        known += (known.empty() ? "" : ", ") + std::string(each.name);
    }
    return Error{"There is no rule \"" + std::string(name) + "\"; there are " + known + "."};
}

}  // namespace

Result<RuleChoice> ruleChoiceFromText(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string name(text.substr(0, equals));
    const std::string_view value =
        equals == std::string_view::npos ? std::string_view{} : text.substr(equals + 1);
    if (findSwitch(name) == nullptr) return noSuchRule(name);
    if (value != "on" && value != "off") {
        return Error{"Write " + name + "=on or " + name + "=off."};
    }
    return RuleChoice{name, value == "on"};
}

Status applyChoices(const std::vector<RuleChoice>& choices, Rules& rules) {
    for (const RuleChoice& choice : choices) {
        const RuleSwitch* found = findSwitch(choice.name);
        if (found == nullptr) return noSuchRule(choice.name);
        rules.*found->member = choice.on;
    }
    return success();
}

}  // namespace se::view
