#include "rule_guess.h"

namespace se::teach {
namespace {

/// The values of a number to try beside its own.
struct TriedNumbers {
    std::string_view name;
    double low, high;
};
constexpr TriedNumbers kTriedNumbers[] = {
    {"holesize", 0.0, 4.0}, {"maxgap", 90.0, 180.0}, {"sameangle", 0.0, 0.01}};

/// The values to try for a setting, its own among them.
std::vector<double> valuesOf(const RuleSetting& setting) {
    std::vector<double> values;
    if (setting.kind == SettingKind::Switch || setting.kind == SettingKind::Option) {
        for (double value = setting.low; value <= setting.high; value += 1.0)
            values.push_back(value);
    }
    for (const TriedNumbers& each : kTriedNumbers) {
        if (each.name == setting.name) values = {each.low, each.high};
    }
    return values;
}

/// The trace with the fans alone.
Trace fansOf(Trace trace) {
    for (TracePivot& each : trace.pivots) {
        for (const TraceStageRow& row : traceStages()) {
            if (row.id != TraceStage::Emit) (each.*row.points).reset();
        }
        each.start = each.end = each.next = std::nullopt;
    }
    return trace;
}

/// matchTrace() under a changed setting.
TraceMatch matchUnder(const RuleValue& setting, const Trace& trace, const SharedPoints& points,
                      Params params, std::optional<TraceStage> upto) {
    findRuleSetting(setting.name)->set(params, setting.value);
    return matchTrace(trace, points, params, upto);
}

}  // namespace

std::vector<RuleValue> singleSettings(const Params& base) {
    std::vector<RuleValue> settings;
    for (const RuleSetting& setting : ruleSettings()) {
        // `opposing` has a part in the lists only, which are made before, once for all runs.
        if (setting.beyondPaper || setting.name == "opposing") continue;
        for (const double value : valuesOf(setting)) {
            if (value != setting.get(base)) settings.push_back({std::string(setting.name), value});
        }
    }
    return settings;
}

Result<RuleGuess> guessRules(const Trace& trace, const SharedPoints& points, const Params& base,
                             std::optional<TraceStage> upto, const Progress& progress) {
    RuleGuess guess;
    // Another program may lack a rule in another way than our run without it: its stages differ,
    // its fans do not. So the fans are compared first, unless they are all alike.
    const Trace fans = fansOf(trace);
    const bool byFans = upto.value_or(TraceStage::Ring) >= TraceStage::Emit &&
                        matchTrace(fans, points, base, {}).alike < trace.pivots.size();
    const Trace& compared = byFans ? fans : trace;
    guess.alike = matchTrace(compared, points, base, upto).alike;
    const std::vector<RuleValue> settings = singleSettings(base);
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const RuleValue& each = settings[i];
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(settings.size())))
            return Error{"cancelled"};
        const TraceMatch match = matchUnder(each, compared, points, base, upto);
        if (match.whole) guess.whole.push_back(each);
        if (match.alike <= guess.alike) continue;
        guess.alike = match.alike;
        guess.nearest = each;
    }
    if (!guess.whole.empty()) guess.nearest.reset();
    // Of several those that give the stages of the trace too, if any does.
    std::vector<RuleValue> same = byFans ? guess.whole : std::vector<RuleValue>{};
    std::erase_if(same, [&](const RuleValue& each) {
        return !matchUnder(each, trace, points, base, upto).whole;
    });
    if (!same.empty()) guess.whole = std::move(same);
    return guess;
}

std::string guessText(const RuleGuess& guess, const Trace& trace) {
    const std::string count = std::to_string(trace.pivots.size());
    if (!guess.whole.empty()) {
        std::string rules;
        for (const RuleValue& each : guess.whole)
            rules += (rules.empty() ? "--rule " : " or --rule ") + lineOf(each);
        return "your whole trace, " + count + " pivots, behaves like " + rules + "\n";
    }
    const std::string none = "no single rule of the paper's, changed, gives your whole trace";
    if (!guess.nearest) return none + "\n";
    return none + "; --rule " + lineOf(*guess.nearest) + " goes along for longest, " +
           std::to_string(guess.alike) + " of " + count + " pivots\n";
}

}  // namespace se::teach
