#include "session_options.h"

#include <vector>

namespace se::view {

namespace {

using nlohmann::json;

Complaint readReach(const json& options, NeighborOptions& out) {
    if (const json* count = find(options, "neighbors"); count != nullptr) {
        if (!count->is_number_integer() || *count < 1 || *count > 1000) {
            return expected("options.neighbors", "a whole number from 1 to 1000");
        }
        out = {KNearest{count->get<std::size_t>()}, true, 0, true};
    }
    if (const json* radius = find(options, "radius"); radius != nullptr) {
        if (!radius->is_number() || !(radius->get<double>() > 0.0)) {
            return expected("options.radius", "a number > 0");
        }
        out = {WithinRadius{radius->get<double>()}, true, 0, true};
    }
    if (const json* reach = find(options, "reach"); reach != nullptr) {
        if (!reach->is_number() || !(reach->get<double>() > 0.0)) {
            return expected("options.reach", "a number > 0");
        }
        out = {WithinSpacings{reach->get<double>()}, true, 0, true};
    }
    return std::nullopt;
}

Complaint readFixes(const json& options, Fixes& out) {
    const json* fixes = find(options, "doctor");
    if (fixes == nullptr) return std::nullopt;
    const Complaint wrong = expected("options.doctor", "a list of doctor checks that have a fix");
    if (!fixes->is_array()) return wrong;
    for (const json& name : *fixes) {
        const DoctorCheck* check =
            name.is_string() ? findDoctorCheck(name.get<std::string>()) : nullptr;
        if (check == nullptr || !canFix(*check)) return wrong;
        out.push_back(name.get<std::string>());
    }
    return std::nullopt;
}

Complaint readSwitch(const json& options, const std::string& name, bool& out) {
    const json* on = find(options, name.c_str());
    if (on == nullptr) return std::nullopt;
    if (!on->is_boolean()) return expected("options." + name, "true or false");
    out = on->get<bool>();
    return std::nullopt;
}

Complaint readBox(const json& options, WallChoice& out) {
    const json* box = find(options, "box");
    if (box == nullptr) return std::nullopt;
    if (*box == "auto") {
        out = {WallChoice::From::Around, {}};
        return std::nullopt;
    }
    std::vector<double> at;
    if (box->is_array()) {
        for (const json& each : *box) {
            if (each.is_number()) at.push_back(each.get<double>());
        }
    }
    const bool good =
        at.size() == 6 && box->size() == 6 && at[0] < at[3] && at[1] < at[4] && at[2] < at[5];
    if (!good) return expected("options.box", "\"auto\", or six numbers, the lower corner first");
    out = {WallChoice::From::Box, {{at[0], at[1], at[2]}, {at[3], at[4], at[5]}}};
    return std::nullopt;
}

/// Options for what is derived from the points.
Complaint readPreparing(const json& options, InputSpec& out) {
    if (const json* normals = find(options, "normals"); normals != nullptr) {
        if (*normals != "derived" && *normals != "oriented") {
            return expected("options.normals", "\"derived\" or \"oriented\"");
        }
        out.normals = *normals == "derived" ? NormalSource::Derived : NormalSource::Oriented;
    }
    if (Complaint c = readBox(options, out.walls)) return c;
    if (Complaint c = readSwitch(options, "symmetric", out.neighbors.symmetric)) return c;
    if (Complaint c = readSwitch(options, "rim", out.rim)) return c;
    if (Complaint c = readSwitch(options, "keep_opposing", out.keepOpposing)) return c;
    return readSwitch(options, "keep_noise", out.keepNoise);
}

/// A rule is true or false, a number, or the name of an option.
Complaint readRule(const std::string& name, const json& value, InputSpec& out) {
    const std::string text = value.is_boolean()  ? (value.get<bool>() ? "on" : "off")
                             : value.is_string() ? value.get<std::string>()
                                                 : value.dump();
    const Result<RuleValue> read = ruleValueFromText(name + "=" + text);
    const RuleSetting* setting = findRuleSetting(name);
    if (!read && setting == nullptr) return "\"options.switches\": " + read.error().message;
    if (!read) return expected("options.switches." + name, valuesText(*setting));
    out.choices.push_back(read.value());
    return std::nullopt;
}

/// One line per what-if, as on the command line.
Complaint readWhatIfs(const json& options, std::vector<WhatIf>& out) {
    const json* list = find(options, "what_if");
    if (list == nullptr) return std::nullopt;
    const Complaint wrong = expected("options.what_if", "a list of texts");
    if (!list->is_array()) return wrong;
    for (const json& each : *list) {
        if (!each.is_string()) return wrong;
        const Result<WhatIf> read = whatIfFromText(each.get<std::string>());
        if (!read) return "\"options.what_if\": " + read.error().message;
        out.push_back(read.value());
    }
    return std::nullopt;
}

}  // namespace

Complaint readOptions(const json& object, InputSpec& out) {
    const json* options = find(object, "options");
    if (options == nullptr) return std::nullopt;
    if (!options->is_object()) return expected("options", "an object");
    if (const json* rules = find(*options, "rules"); rules != nullptr) {
        if (!rules->is_string() || !paramsByName(rules->get<std::string>())) {
            return expected("options.rules", "the name of a set of rules, such as \"paper\"");
        }
        out.rules = rules->get<std::string>();
    }
    if (const json* choices = find(*options, "switches"); choices != nullptr) {
        if (!choices->is_object()) {
            return expected("options.switches", "an object of true, false, numbers and names");
        }
        for (const auto& [name, value] : choices->items()) {
            if (Complaint c = readRule(name, value, out)) return c;
        }
    }
    if (Complaint c = readWhatIfs(*options, out.whatIf)) return c;
    if (Complaint c = readFixes(*options, out.fixes)) return c;
    if (Complaint c = readReach(*options, out.neighbors)) return c;
    return readPreparing(*options, out);
}

namespace {

/// Options for what is derived from the points, where they differ from the defaults.
void preparingToJson(const InputSpec& input, json& options) {
    for (const char* name : {"normals", "box", "symmetric", "rim", "keep_opposing", "keep_noise"}) {
        options.erase(name);
    }
    if (input.normals == NormalSource::Derived) options["normals"] = "derived";
    if (input.normals == NormalSource::Oriented) options["normals"] = "oriented";
    if (input.walls.from == WallChoice::From::Around) options["box"] = "auto";
    if (input.walls.from == WallChoice::From::Box) {
        const WallBox& b = input.walls.box;
        options["box"] = {b.low.x, b.low.y, b.low.z, b.high.x, b.high.y, b.high.z};
    }
    if (input.neighbors.symmetric) options["symmetric"] = true;
    if (input.rim) options["rim"] = true;
    if (input.keepOpposing) options["keep_opposing"] = true;
    if (input.keepNoise) options["keep_noise"] = true;
}

json ruleToJson(const RuleValue& rule) {
    const RuleSetting* setting = findRuleSetting(rule.name);
    if (setting == nullptr || setting->kind == SettingKind::Switch) return rule.value != 0.0;
    if (setting->kind == SettingKind::Option) return valueText(*setting, rule.value);
    if (setting->kind == SettingKind::Whole) return static_cast<std::int64_t>(rule.value);
    return rule.value;
}

}  // namespace

json optionsToJson(const InputSpec& input, json options) {
    options["rules"] = input.rules;
    options.erase("switches");
    options.erase("neighbors");
    options.erase("radius");
    options.erase("reach");
    options.erase("doctor");
    if (!input.fixes.empty()) options["doctor"] = input.fixes;
    preparingToJson(input, options);
    for (const RuleValue& each : input.choices) options["switches"][each.name] = ruleToJson(each);
    options.erase("what_if");
    for (const WhatIf& each : input.whatIf) options["what_if"].push_back(lineOf(each));
    if (!input.neighbors.recompute) return options;
    if (const auto* nearest = std::get_if<KNearest>(&input.neighbors.reach)) {
        options["neighbors"] = nearest->k;
    } else if (const auto* reach = std::get_if<WithinSpacings>(&input.neighbors.reach)) {
        options["reach"] = reach->spacings;
    } else {
        options["radius"] = std::get<WithinRadius>(input.neighbors.reach).radius;
    }
    return options;
}

}  // namespace se::view
