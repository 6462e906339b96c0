#include "options/spec_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/text_scan.h"

namespace se {

void SpecOptions::addTo(CLI::App& app, std::initializer_list<SpecGroup> groups) {
    for (const SpecField& field : specFields()) {
        const bool wanted = std::find(groups.begin(), groups.end(), field.group) != groups.end();
        if (wanted && !field.option.empty()) addTo(app, field);
    }
}

void SpecOptions::addTo(CLI::App& app, const SpecField& field) {
    Bound& bound = bound_.emplace_back(Bound{&field});
    const std::string name(field.option);
    const std::string help(field.help);
    if (field.value.empty())
        bound.option = app.add_flag(name, bound.on, help);
    else if (field.repeats)
        bound.option = app.add_option(name, bound.texts, help)->allow_extra_args(false);
    else
        bound.option = app.add_option(name, bound.text, help);
    if (!field.value.empty()) bound.option->type_name(std::string(field.value));
    for (const Bound& other : bound_) {
        if (&other != &bound && !field.excludes.empty() && other.field->excludes == field.excludes)
            bound.option->excludes(other.option);
    }
}

SpecChange SpecOptions::given() const {
    SpecChange change;
    for (const Bound& each : bound_) {
        if (each.option->count() == 0) continue;
        if (each.field->repeats)
            for (const std::string& text : each.texts) change.push_back({each.field, text});
        else
            change.push_back({each.field, each.field->value.empty() ? std::string(each.field->flag)
                                                                    : each.text});
    }
    return change;
}

CLI::Validator wholeNumber(std::uint64_t least) {
    const auto check = [least](const std::string& text) -> std::string {
        const auto number = numberIn<std::uint64_t>(text);
        if (number && *number >= least) return {};
        return fmt::format("{}: expected a whole number from {} on", excerpt(text), least);
    };
    return CLI::Validator(check, least > 0 ? "POSITIVE" : "");  // As the help says it.
}

void addByteLimit(CLI::App& app, ByteLimit& limit) {
    const SpecField& field = specFields().front();
    addOption(app, std::string(field.option), std::string(field.value), limit.bytes,
              std::string(field.help))
        ->check(wholeNumber(1));
}

std::string rulesHelp() {
    std::string help = "\nRules (docs/choices.md):";
    for (const RuleSetting& rule : ruleSettings())
        help += fmt::format("\n  {:<12} {:<4} {}: {}", rule.name, rule.section, rule.summary,
                            valuesText(rule));
    return help;
}

}  // namespace se
