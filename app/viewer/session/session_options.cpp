#include "session_options.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "teach/start_file.h"

namespace se::view {

namespace {

using nlohmann::json;

template <typename Reach>
Complaint readDistance(const json& options, const char* name, NeighborOptions& out) {
    const json* distance = find(options, name);
    if (distance == nullptr) return std::nullopt;
    if (!distance->is_number() || !(distance->get<double>() > 0.0))
        return expected(std::string("options.") + name, "a number > 0");
    out = {Reach{distance->get<double>()}, true, 0, true};
    return std::nullopt;
}

Complaint readReach(const json& options, NeighborOptions& out) {
    if (const json* count = find(options, "neighbors"); count != nullptr) {
        if (!count->is_number_integer() || *count < 1 || *count > 1000) {
            return expected("options.neighbors", "a whole number from 1 to 1000");
        }
        out = {KNearest{count->get<std::size_t>()}, true, 0, true};
    }
    if (Complaint c = readDistance<WithinRadius>(options, "radius", out)) return c;
    return readDistance<WithinSpacings>(options, "reach", out);
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

Complaint readLeftOut(const json& options, IndexRanges& out) {
    const json* ranges = find(options, "left_out");
    if (ranges == nullptr) return std::nullopt;
    const auto read =
        ranges->is_string() ? rangesFromText(ranges->get<std::string>()) : std::nullopt;
    if (!read) return expected("options.left_out", "ascending indices, such as \"3..9,40\"");
    out = *read;
    return std::nullopt;
}

/// The numbers of a list; none if it has something else, or is no list.
std::vector<double> numbersOf(const json& list) {
    std::vector<double> numbers;
    if (!list.is_array()) return numbers;
    for (const json& each : list) {
        if (!each.is_number()) return {};
        numbers.push_back(each.get<double>());
    }
    return numbers;
}

Complaint readPiece(const json& options, Piece& out) {
    if (const json* crop = find(options, "crop"); crop != nullptr) {
        const std::vector<double> at = numbersOf(*crop);
        if (at.size() != 6 || at[0] > at[3] || at[1] > at[4] || at[2] > at[5])
            return expected("options.crop", "six numbers, the lower corner first");
        out.crop = Box({at[0], at[1], at[2]});
        out.crop->add({at[3], at[4], at[5]});
    }
    const json* thin = find(options, "thin");
    if (thin == nullptr) return std::nullopt;
    if (!thin->is_number() || !(thin->get<double>() > 0.0))
        return expected("options.thin", "a number > 0");
    out.thin = thin->get<double>();
    return std::nullopt;
}

Complaint readScanner(const json& options, std::optional<Vec3>& out) {
    const json* scanner = find(options, "scanner");
    if (scanner == nullptr) return std::nullopt;
    const std::vector<double> at = numbersOf(*scanner);
    if (at.size() != 3) return expected("options.scanner", "three numbers");
    out = Vec3(at[0], at[1], at[2]);
    return std::nullopt;
}

Complaint readBox(const json& options, WallChoice& out) {
    const json* box = find(options, "box");
    if (box == nullptr) return std::nullopt;
    if (*box == "auto") {
        out = {WallChoice::From::Around, {}};
        return std::nullopt;
    }
    const std::vector<double> at = numbersOf(*box);
    const bool good = at.size() == 6 && at[0] < at[3] && at[1] < at[4] && at[2] < at[5];
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
    if (Complaint c = readScanner(options, out.scanner)) return c;
    NeighborOptions& lists = out.neighbors;
    for (const auto& [name, on] : {std::pair{"symmetric", &lists.symmetric},
                                   {"rim", &out.rim},
                                   {"keep_opposing", &out.keepOpposing},
                                   {"keep_noise", &out.keepNoise},
                                   {"keep_strays", &out.keepStrays}})
        if (!readField(options, name, *on))
            return expected(std::string("options.") + name, "true or false");
    return std::nullopt;
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

Complaint readStart(const json& options, GivenStart& out) {
    const json* start = find(options, "start");
    if (start == nullptr) return std::nullopt;
    Result<GivenStart> read = teach::startFromText(start->dump(), "\"options.start\"");
    if (!read) return read.error().message;
    out = std::move(read.value());
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
    if (Complaint c = readPiece(*options, out.piece)) return c;
    if (Complaint c = readLeftOut(*options, out.leftOut)) return c;
    if (Complaint c = readReach(*options, out.neighbors)) return c;
    if (Complaint c = readStart(*options, out.start)) return c;
    return readPreparing(*options, out);
}

namespace {

/// Options for what is derived from the points, where they differ from the defaults.
void preparingToJson(const InputSpec& input, json& options) {
    const bool derived = input.normals == NormalSource::Derived;
    writeField(options, "normals", input.normals != NormalSource::AsGiven,
               derived ? "derived" : "oriented");
    writeField(options, "box", input.walls.from == WallChoice::From::Around, "auto");
    if (input.walls.from == WallChoice::From::Box) {
        const WallBox& b = input.walls.box;
        options["box"] = {b.low.x, b.low.y, b.low.z, b.high.x, b.high.y, b.high.z};
    }
    if (input.scanner) options["scanner"] = {input.scanner->x, input.scanner->y, input.scanner->z};
    writeField(options, "symmetric", input.neighbors.symmetric, true);
    writeField(options, "rim", input.rim, true);
    writeField(options, "keep_opposing", input.keepOpposing, true);
    writeField(options, "keep_noise", input.keepNoise, true);
    writeField(options, "keep_strays", input.keepStrays, true);
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
    for (const char* name : {"switches", "neighbors", "radius", "reach", "what_if"})
        options.erase(name);
    writeField(options, "doctor", !input.fixes.empty(), input.fixes);
    if (const auto& crop = input.piece.crop) {
        options["crop"] = {crop->low.x,  crop->low.y,  crop->low.z,
                           crop->high.x, crop->high.y, crop->high.z};
    }
    writeField(options, "thin", input.piece.thin > 0.0, input.piece.thin);
    writeField(options, "left_out", !input.leftOut.empty(), rangesText(input.leftOut));
    preparingToJson(input, options);
    options.erase("start");
    if (!input.start.empty()) options["start"] = json::parse(teach::startText(input.start));
    for (const RuleValue& each : input.choices) options["switches"][each.name] = ruleToJson(each);
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

namespace {

bool readCount(const json& object, const char* name, std::uint32_t least, std::uint32_t& out) {
    const json* count = find(object, name);
    if (count == nullptr) return true;
    if (!count->is_number_unsigned() || *count > std::numeric_limits<std::uint32_t>::max() ||
        *count < least)
        return false;
    out = count->get<std::uint32_t>();
    return true;
}

bool readBreakpoint(const json& object, Breakpoint& out) {
    return object.is_object() && object.contains("line") && readField(object, "line", out.line) &&
           readField(object, "name", out.name) && readField(object, "on", out.on) &&
           readField(object, "log_only", out.logOnly) && readCount(object, "skip", 0, out.skip) &&
           readCount(object, "every", 1, out.every);
}

}  // namespace

Complaint readStops(const json& object, Annotations& out) {
    if (const json* list = find(object, "breakpoints"); list != nullptr) {
        const bool good =
            list->is_array() && std::all_of(list->begin(), list->end(), [&](const json& each) {
                return readBreakpoint(each, out.breakpoints.emplace_back());
            });
        if (!good)
            return expected("breakpoints",
                            "a list of objects with \"line\" and optionally \"name\", \"skip\", "
                            "\"every\" (from 1), \"on\" and \"log_only\"");
    }
    const json* list = find(object, "watches");
    if (list == nullptr) return std::nullopt;
    const bool good =
        list->is_array() &&
        std::all_of(list->begin(), list->end(), [](const json& each) { return each.is_string(); });
    if (!good) return expected("watches", "a list of texts");
    out.watches = list->get<std::vector<std::string>>();
    return std::nullopt;
}

void stopsToJson(const Annotations& annotations, json& object) {
    object["breakpoints"] = json::array();
    for (const Breakpoint& each : annotations.breakpoints) {
        object["breakpoints"].push_back({{"line", each.line},
                                         {"name", each.name},
                                         {"skip", each.skip},
                                         {"every", each.every},
                                         {"on", each.on},
                                         {"log_only", each.logOnly}});
    }
    object["watches"] = annotations.watches;
}

}  // namespace se::view
