#include "compare_page.h"

#include "panel_state/what_if_offers.h"

namespace se::view {

void CompareForm::takeOther(const RunSpec& other, const Model& model) {
    rules = other;
    prepare.take(other, model);
    prepare.open = false;
    whatIf.clear();
    complaint.clear();
}

void CompareForm::take(const RunSpec& spec, const Model& model) {
    takeOther(usualOther(spec), model);
    ruleFilter = {};
}

void CompareForm::follow(const RunSpec& before, const RunSpec& now, const Model& model) {
    // With the rules of `now` only the preparation remains to differ.
    if (differenceText(withRulesOf(before, now), now) != kNoDifference) {
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

Result<RunSpec> CompareForm::spec(const RunSpec& base) const {
    return prepare.spec(withRulesOf(base, rules));
}

RunSpec trueRunOf(RunSpec spec) {
    spec.whatIf.clear();
    return spec;
}

}  // namespace se::view
