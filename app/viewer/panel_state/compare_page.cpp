#include "compare_page.h"

#include "what_if_offers.h"

namespace se::view {

void CompareForm::takeOther(const InputSpec& other, const Model& model) {
    rules = rulesOf(other);
    prepare.take(other, model);
    prepare.open = false;
    whatIf.clear();
    complaint.clear();
}

void CompareForm::take(const InputSpec& spec, const Model& model) {
    takeOther(usualOther(spec), model);
    ruleFilter = {};
}

void CompareForm::follow(const InputSpec& before, const InputSpec& now, const Model& model) {
    // With the rules of `now` only the preparation remains to differ.
    if (differenceText(withRules(before, rulesOf(now)), now) != "the same") {
        prepare.take(now, model);
        prepare.open = false;
    }
    if (before.whatIf != now.whatIf) rules.whatIf = now.whatIf;
}

void CompareForm::addWhatIf() {
    const Result<WhatIf> read = whatIfFromText(whatIf);
    complaint = read ? std::string{} : read.error().message;
    if (!read) return;
    rules = withWhatIf(rules, read.value());
    whatIf.clear();
}

Result<InputSpec> CompareForm::spec(const InputSpec& base) const {
    return prepare.spec(withRules(base, rules));
}

InputSpec trueRunOf(InputSpec spec) {
    spec.whatIf.clear();
    return spec;
}

}  // namespace se::view
