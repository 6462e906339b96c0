#include "spiraling_edge/explain/run_settings.h"
#include "spiraling_edge/base/outside_text.h"

#include <algorithm>

namespace se {
namespace {

std::string_view wordOf(NormalSource normals) {
    return normals == NormalSource::Oriented ? "normals oriented" : "normals derived";
}

std::string_view optionOf(NormalSource normals) {
    return normals == NormalSource::Oriented ? "--orient" : "--derive-normals";
}

bool hasLists(const RunSettings& settings, const PointFile& file, std::size_t nearest) {
    const NeighborOptions& lists = settings.prepare.neighbors;
    const bool computed = lists.recompute || !file.hasNeighbors();
    const auto* reach = std::get_if<KNearest>(&lists.reach);
    return computed && reach != nullptr && reach->k == nearest;
}

bool isOff(const RunSettings& settings, std::string_view rule) {
    const Result<Params> params = paramsOf(settings);
    const RuleSetting* setting = findRuleSetting(rule);
    return !params || setting == nullptr || !setting->isOn(params.value());
}

/// Sets `merged` to the one of both that is set. False if both are, to different values.
template <typename Value>
bool merge(const Value& a, const Value& b, Value& merged) {
    merged = a == Value{} ? b : a;
    return a == Value{} || b == Value{} || a == b;
}

}  // namespace

Result<Params> paramsOf(const RunSettings& settings) {
    std::optional<Params> params = paramsByName(settings.rules);
    if (!params) return Error{"There is no rule set " + inQuotes(settings.rules) + "."};
    if (const Status known = applyRuleValues(settings.choices, *params); !known)
        return known.error();
    if (settings.keepOpposing) params->dropOpposingNormals = false;
    if (settings.keepNoise) params->setNoiseAside = false;
    if (settings.keepStrays) params->setStraysAside = false;
    params->whatIf = settings.whatIf;
    params->start = settings.start;
    return *params;
}

PrepareOptions prepareOptionsFor(PrepareOptions options, const Params& params) {
    options.neighbors.dropOpposingNormals = params.dropOpposingNormals;
    options.setNoiseAside = params.setNoiseAside;
    options.setStraysAside = params.setStraysAside;
    return options;
}

NeighborOptions changedLists(NeighborOptions lists, const SettingsChange& change) {
    if (change.nearest > 0) {
        lists.reach = KNearest{change.nearest};
        lists.recompute = true;
    }
    lists.symmetric = lists.symmetric || change.symmetric;
    return lists;
}

RunSettings changed(RunSettings settings, const SettingsChange& change) {
    PrepareOptions& prepare = settings.prepare;
    if (!change.rules.empty()) settings.rules = change.rules;
    if (!change.ruleOff.empty()) {
        std::erase_if(settings.choices,
                      [&](const RuleValue& each) { return each.name == change.ruleOff; });
        settings.choices.push_back({std::string(change.ruleOff), 0.0});
    }
    prepare.neighbors = changedLists(prepare.neighbors, change);
    prepare.normals = change.normals.value_or(prepare.normals);
    prepare.rim = prepare.rim || change.rim;
    if (!change.drop.empty()) settings.drops.emplace_back(change.drop);
    return settings;
}

SettingsChange withoutPresent(SettingsChange change, const RunSettings& settings,
                              const PointFile& file) {
    if (change.rules == settings.rules) change.rules = {};
    if (isOff(changed(settings, {.rules = change.rules}), change.ruleOff)) change.ruleOff = {};
    if (hasLists(settings, file, change.nearest)) change.nearest = 0;
    // Derived normals are oriented.
    const bool derived = !file.hasNormals() || settings.prepare.normals == NormalSource::Derived;
    if (derived || change.normals == settings.prepare.normals) change.normals.reset();
    if (settings.prepare.neighbors.symmetric) change.symmetric = false;
    if (settings.prepare.rim) change.rim = false;
    const auto& drops = settings.drops;
    if (std::find(drops.begin(), drops.end(), change.drop) != drops.end()) change.drop = {};
    return change;
}

std::optional<SettingsChange> bothOf(const SettingsChange& a, const SettingsChange& b) {
    SettingsChange both;
    const bool agree =
        merge(a.rules, b.rules, both.rules) && merge(a.ruleOff, b.ruleOff, both.ruleOff) &&
        merge(a.nearest, b.nearest, both.nearest) && merge(a.normals, b.normals, both.normals) &&
        merge(a.drop, b.drop, both.drop);
    both.symmetric = a.symmetric || b.symmetric;
    both.rim = a.rim || b.rim;
    return agree ? std::optional(both) : std::nullopt;
}

std::string wordsOf(const SettingsChange& change) {
    std::string words;
    const auto add = [&words](std::string_view text, std::string_view more = {}) {
        words.append(words.empty() ? "" : ", ").append(text).append(more);
    };
    if (!change.rules.empty()) add("rules of ", change.rules);
    if (!change.ruleOff.empty()) add(change.ruleOff, " off");
    if (change.nearest > 0) add(std::to_string(change.nearest), " neighbors");
    if (change.symmetric) add("symmetric lists");
    if (change.normals) add(wordOf(*change.normals));
    if (change.rim) add("rims derived");
    if (!change.drop.empty()) add("without ", change.drop);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words.empty() ? "no change" : words;
}

std::vector<std::string> optionsOf(const SettingsChange& change) {
    std::vector<std::string> options;
    const auto add = [&options](std::string_view option, std::string_view value = {}) {
        options.emplace_back(option).append(value);
    };
    if (!change.rules.empty()) add("--rules ", change.rules);
    if (!change.ruleOff.empty()) add("--rule ", std::string(change.ruleOff) + "=off");
    if (change.nearest > 0) add("--neighbors ", std::to_string(change.nearest));
    if (change.symmetric) add("--symmetric");
    if (change.normals) add(optionOf(*change.normals));
    if (change.rim) add("--derive-rim");
    return options;
}

}  // namespace se
