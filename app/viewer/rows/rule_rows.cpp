#include "rule_rows.h"

#include <algorithm>
#include <array>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"

namespace se::view {

namespace {

struct SectionTitle {
    std::string_view section, title;
};
constexpr std::array kTitles{
    SectionTitle{"3", "Overview"},
    SectionTitle{"6.1", "Creating the neighbor ring"},
    SectionTitle{"6.2", "Filling holes"},
    SectionTitle{"6.3", "Removing neighbors"},
    SectionTitle{"6.4", "Triangulating the ring"},
    SectionTitle{"6.5", "Updating the edge ring"},
    SectionTitle{"7", "Boundary points"},
    SectionTitle{"7.1", "Ring of two boundary points"},
    SectionTitle{"7.2", "Corners"},
};
constexpr std::string_view kBeyond = "Beyond the paper";

std::string titleOfGroup(const RuleSetting& setting) {
    if (setting.beyondPaper) return std::string(kBeyond);
    const auto* row = rowWhere(
        kTitles, [&](const SectionTitle& each) { return each.section == setting.section; });
    std::string title(setting.section);
    if (row != nullptr) title += " " + std::string(row->title);
    return title;
}

bool matches(const RuleRow& row, const std::vector<std::string>& words) {
    const RuleSetting& s = *row.setting;
    std::string text = lowerCase(std::string(s.name) + " " + std::string(s.section) + " " +
                                 std::string(s.summary) + " " + std::string(s.paper) + " " +
                                 valueText(s, row.value) + " " + titleOfGroup(s));
    if (row.differs()) text += " differs";
    return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
        return text.find(word) != std::string::npos;
    });
}

}  // namespace

std::vector<RuleGroup> ruleGroups(const RunSpec& rules, std::string_view filter) {
    const std::string wanted = lowerCase(filter);
    const std::vector<std::string> words = io::wordsIn(wanted);
    std::vector<RuleGroup> groups;
    for (const RuleSetting& setting : ruleSettings()) {
        const RuleRow row{&setting, valueOf(rules, setting), usualValueOf(rules, setting)};
        if (!matches(row, words)) continue;
        const std::string title = titleOfGroup(setting);
        if (groups.empty() || groups.back().title != title) groups.push_back({title, {}});
        groups.back().rows.push_back(row);
    }
    return groups;
}

std::size_t differingCount(const RunSpec& rules) {
    return countWhere(ruleSettings(), [&](const RuleSetting& each) {
        return valueOf(rules, each) != usualValueOf(rules, each);
    });
}

std::string ruleSentence(const RuleRow& row) {
    return capitalized(std::string(row.setting->summary)) + ".";
}

std::string ruleHelp(const RuleRow& row) {
    const RuleSetting& s = *row.setting;
    std::string text = ruleSentence(row);
    if (s.kind != SettingKind::Switch) text.replace(text.size() - 1, 1, ": " + valuesText(s) + ".");
    if (!s.paper.empty()) {
        text += "\nSection " + std::string(s.section) + ": \xE2\x80\x9C" + std::string(s.paper) +
                "\xE2\x80\x9D";
        text += row.value == s.printed
                    ? "\nThis sentence is in force."
                    : "\nNot in force; --rule " + std::string(s.name) + "=" +
                          valueText(s, s.printed.value_or(row.value)) + " sets it.";
    } else {
        text += s.beyondPaper ? "\nNot in the paper: docs/robust.md."
                              : "\nNot specified in the paper: docs/choices.md.";
    }
    text += "\nValue in the rule set: " + valueText(s, row.usual) + ". --rule " +
            std::string(s.name) + "=" + valueText(s, row.value);
    return text;
}

}  // namespace se::view
