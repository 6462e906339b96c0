#include "compare_form.h"

#include "run/exact_text.h"
#include "session/compare_with.h"

namespace se::view {

namespace {

constexpr std::uint64_t kMostNeighbors = 1000;

}  // namespace

void CompareForm::take(const InputSpec& spec) {
    *this = {};
    chooseRules(usualOther(spec).rules);
}

void CompareForm::chooseRules(const std::string& name) {
    rules = name;
    switches = paramsByName(name).value_or(Params{}).rules;
}

int CompareForm::turnedOver() const {
    const Rules plain = paramsByName(rules).value_or(Params{}).rules;
    int turned = 0;
    for (const RuleSwitch& rule : ruleSwitches())
        turned += switches.*rule.member != plain.*rule.member ? 1 : 0;
    return turned;
}

Result<InputSpec> CompareForm::spec(InputSpec base) const {
    base.rules = rules;
    base.choices.clear();
    const Rules plain = paramsByName(rules).value_or(Params{}).rules;
    for (const RuleSwitch& rule : ruleSwitches()) {
        const bool on = switches.*rule.member;
        if (on != plain.*rule.member)
            base.choices.push_back({std::string(rule.name), on ? 1.0 : 0.0});
    }
    if (reach == Reach::Nearest) {
        const auto number = wholeFromText(count);
        if (!number || *number == 0 || *number > kMostNeighbors)
            return Error{"Nearest: expected a whole number from 1 to 1000."};
        base.neighbors.reach = KNearest{static_cast<std::size_t>(*number)};
        base.neighbors.recompute = true;
    }
    if (reach == Reach::Radius) {
        const auto number = numberFromText(radius);
        if (!number || !(*number > 0.0)) return Error{"Radius: expected a number above 0."};
        base.neighbors.reach = WithinRadius{*number};
        base.neighbors.recompute = true;
    }
    return base;
}

}  // namespace se::view
