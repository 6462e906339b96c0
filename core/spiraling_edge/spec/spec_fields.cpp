#include "spiraling_edge/spec/spec_fields.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/doctor/doctor.h"

namespace se {
namespace {

using Texts = std::vector<std::string>;

/// The row's `expected` says what was.
const Error kNotExpected{""};
Status validIf(bool valid) { return valid ? success() : Status(kNotExpected); }

std::string cornersText(const Vec3& low, const Vec3& high) {
    return plainNumbers(low) + "," + plainNumbers(high);
}
Texts listIf(bool set, const std::string& text) { return set ? Texts{text} : Texts{}; }

Status setSwitch(bool& value, std::string_view text) {
    const bool on = text == "on" || text == "true";
    value = on;
    return validIf(on || text == "off" || text == "false");
}

std::optional<double> positiveIn(std::string_view text) {
    const auto number = numberIn<double>(text);
    return number && *number > 0.0 && std::isfinite(*number) ? number : std::nullopt;
}

// ---- reading ----

Status setBytes(RunSpec& spec, std::string_view text) {
    spec.maxBytes = numberIn<std::uint64_t>(text).value_or(0);
    return validIf(spec.maxBytes > 0);
}

/// Six numbers, the lower corner first; equal ones only where a box may be flat.
std::optional<std::pair<Vec3, Vec3>> cornersIn(std::string_view text) {
    const auto n = numbersIn(text, 6);
    if (!n) return std::nullopt;
    return std::pair(Vec3((*n)[0], (*n)[1], (*n)[2]), Vec3((*n)[3], (*n)[4], (*n)[5]));
}

Status setCrop(RunSpec& spec, std::string_view text) {
    const auto corners = cornersIn(text);
    if (!corners) return kNotExpected;
    const auto& [low, high] = *corners;
    for (int i = 0; i < 3; ++i) {
        if (low[i] <= high[i]) continue;
        std::string why = "expected the lower corner first; X0 = ";
        why.append(plainNumber(low[i])).append(" is above X1 = ").append(plainNumber(high[i]));
        std::replace(why.begin(), why.end(), 'X', "XYZ"[i]);
        return Error{why};
    }
    spec.piece.crop = Box(low);
    spec.piece.crop->add(high);
    return success();
}

Status setThin(RunSpec& spec, std::string_view text) {
    spec.piece.thin = positiveIn(text).value_or(0.0);
    return validIf(spec.piece.thin > 0.0);
}

Status setScale(RunSpec& spec, std::string_view text) {
    const auto n = numbersIn(text, 3);
    if (!n || !std::all_of(n->begin(), n->end(), [](double each) { return each > 0.0; }))
        return kNotExpected;
    spec.piece.scale = Vec3((*n)[0], (*n)[1], (*n)[2]);
    return success();
}

Status setKeepSentinels(RunSpec& spec, std::string_view text) {
    bool on = false;
    const Status read = setSwitch(on, text);
    spec.piece.farValues = on ? FarValues::Real : FarValues::Missing;
    return read;
}

Status setLeftOut(RunSpec& spec, std::string_view text) {
    const auto ranges = rangesFromText(text);
    if (ranges) spec.leftOut = *ranges;
    return validIf(ranges.has_value());
}

Status addFix(RunSpec& spec, std::string_view text) {
    const DoctorCheck* check = findDoctorCheck(text);
    if (check == nullptr || check->fix == Fix::None) return kNotExpected;
    spec.fixes.emplace_back(text);
    return success();
}

// ---- rules ----

Status setRules(RunSpec& spec, std::string_view text) {
    if (!paramsByName(text))
        return Error{"no such set; the sets are " + wordList(paramSetNames(), "")};
    spec.rules = text;
    return success();
}

void choose(RunSpec& spec, RuleValue value) {
    std::erase_if(spec.choices, [&](const RuleValue& each) { return each.name == value.name; });
    spec.choices.push_back(std::move(value));
}

Status addRule(RunSpec& spec, std::string_view text) {
    if (isFormerRule(text)) return success();
    const Result<RuleValue> value = ruleValueFromText(text);
    if (!value) return value.error();
    choose(spec, value.value());
    return success();
}

Texts ruleTexts(const RunSpec& spec) {
    Texts texts;
    for (const RuleValue& each : spec.choices) texts.push_back(lineOf(each));
    return texts;
}

Status addWhatIf(RunSpec& spec, std::string_view text) {
    const Result<WhatIf> what = whatIfFromText(text);
    if (!what) return what.error();
    spec.whatIf.push_back(what.value());
    return success();
}

Texts whatIfTexts(const RunSpec& spec) {
    Texts texts;
    for (const WhatIf& each : spec.whatIf) texts.push_back(lineOf(each));
    return texts;
}

/// Turns the rule off that sets points or neighbors aside: a choice like any other.
template <const char* kRule>
Status keep(RunSpec& spec, std::string_view text) {
    bool on = false;
    const Status read = setSwitch(on, text);
    if (read && on) choose(spec, {kRule, 0.0});
    return read;
}
constexpr char kOpposing[] = "opposing";
constexpr char kNoise[] = "noise";
constexpr char kStrays[] = "strays";
/// No texts of its own: the rule that keep() turns off shows among the rules.
Texts noTexts(const RunSpec&) { return {}; }

// ---- lists ----

Status setReach(RunSpec& spec, const decltype(NeighborOptions::reach)& reach) {
    spec.neighbors.reach = reach;
    spec.neighbors.recompute = true;
    return success();
}
Status setNearest(RunSpec& spec, std::string_view text) {
    const auto count = numberIn<std::size_t>(text);
    const bool valid = count && *count > 0 && *count <= kMostNeighbors;
    return valid ? setReach(spec, KNearest{*count}) : kNotExpected;
}
template <typename Within>
Status setWithin(RunSpec& spec, std::string_view text) {
    const auto distance = positiveIn(text);
    return distance ? setReach(spec, Within{*distance}) : kNotExpected;
}
template <typename Reach, auto kMember>
Texts reachTexts(const RunSpec& spec) {
    const auto* reach = std::get_if<Reach>(&spec.neighbors.reach);
    if (!spec.neighbors.recompute || reach == nullptr) return {};
    return {plainNumber(static_cast<double>(reach->*kMember))};
}

// ---- derived ----

Status setNormals(RunSpec& spec, std::string_view text) {
    if (text != "derived" && text != "oriented") return kNotExpected;
    spec.normals = text == "derived" ? NormalSource::Derived : NormalSource::Oriented;
    return success();
}

Status setScanner(RunSpec& spec, std::string_view text) {
    const auto n = numbersIn(text, 3);
    if (n) spec.scanner = Vec3((*n)[0], (*n)[1], (*n)[2]);
    return validIf(n.has_value());
}

Status setBox(RunSpec& spec, std::string_view text) {
    if (text == "auto") {
        spec.walls = {WallChoice::From::Around, {}};
        return success();
    }
    const auto corners = cornersIn(text);
    if (!corners) return kNotExpected;
    const auto& [low, high] = *corners;
    if (!(low.x < high.x && low.y < high.y && low.z < high.z)) return kNotExpected;
    spec.walls = {WallChoice::From::Box, {low, high}};
    return success();
}

Texts boxTexts(const RunSpec& spec) {
    const WallChoice& walls = spec.walls;
    if (walls.from == WallChoice::From::File) return {};
    const bool around = walls.from == WallChoice::From::Around;
    return {around ? "auto" : cornersText(walls.box.low, walls.box.high)};
}

constexpr std::string_view kBoxExpected =
    "six numbers separated by commas, the lower corner first: X0,Y0,Z0,X1,Y1,Z1";

// key, option, its value, what a flag stands for
// help
// what is expected; in words; without it
// group, type, whether it repeats, what excludes it; set, texts
const std::array kFields{
    SpecField{"", "--most-bytes", "N", "",
              "Read and unpack at most N bytes of an input (default 2147483648, 2 GiB)",
              "a whole number from 1 on", "", "", SpecGroup::Reading, SpecType::Whole, false, "",
              setBytes, noTexts},
    SpecField{"crop", "--crop", "BOX", "",
              "Only the points in this box, X0,Y0,Z0,X1,Y1,Z1; the output has their numbers in "
              "the file as index",
              kBoxExpected, "the box {}", "no box", SpecGroup::Reading, SpecType::Numbers, false,
              "", setCrop,
              [](const RunSpec& s) {
                  return s.piece.crop ? Texts{cornersText(s.piece.crop->low, s.piece.crop->high)}
                                      : Texts{};
              }},
    SpecField{
        "thin", "--thin", "SPACING", "",
        "Then only points no nearer than this to one before; lists in the file get shorter "
        "(-k: new ones)",
        "a number > 0", "thinned to {}", "not thinned", SpecGroup::Reading, SpecType::Number, false,
        "", setThin,
        [](const RunSpec& s) { return listIf(s.piece.thin > 0.0, plainNumber(s.piece.thin)); }},
    SpecField{
        "scale", "--scale-by", "FACTORS", "",
        "Then multiply the coordinates by X,Y,Z, such as degrees by meters per degree; all "
        "other options but the two before mean scaled coordinates",
        "three numbers > 0 separated by commas: X,Y,Z", "scaled by {}", "not scaled",
        SpecGroup::Reading, SpecType::Numbers, false, "", setScale,
        [](const RunSpec& s) { return listIf(s.piece.isScaled(), plainNumbers(s.piece.scale)); }},
    SpecField{"keep_sentinels", "--keep-sentinels", "", "on",
              "Keep points far off all others where a missing value seems to be written, such as "
              "9999 or 1e30",
              "true or false", "far values kept", "far values set aside", SpecGroup::Reading,
              SpecType::Switch, false, "", setKeepSentinels,
              [](const RunSpec& s) { return listIf(s.piece.farValues == FarValues::Real, "on"); }},
    SpecField{"left_out", "", "", "", "", "ascending indices, such as \"3..9,40\"",
              "points left out", "no points left out", SpecGroup::Reading, SpecType::Word, false,
              "", setLeftOut,
              [](const RunSpec& s) { return listIf(!s.leftOut.empty(), rangesText(s.leftOut)); }},
    SpecField{"doctor", "", "", "", "", "a list of doctor checks that have a fix", "the fix of {}",
              "not repaired", SpecGroup::Reading, SpecType::Word, true, "", addFix,
              [](const RunSpec& s) { return s.fixes; }},
    SpecField{"rules", "--rules", "SET", "",
              "Reading of the paper: paper, printed, corrected, robust (default paper)",
              "the name of a set of rules, such as \"paper\"", "{} rules", "paper rules",
              SpecGroup::Rules, SpecType::Word, false, "", setRules,
              [](const RunSpec& s) { return listIf(s.rules != RunSpec{}.rules, s.rules); }},
    SpecField{"switches", "--rule", "NAME=VALUE", "",
              "Set one rule, after --rules; may be repeated",
              "an object of true, false, numbers and names", "{}", "", SpecGroup::Rules,
              SpecType::Rule, true, "", addRule, ruleTexts},
    SpecField{"what_if", "--what-if", "LINE", "",
              "Override one decision: \"137.sphere keep 812\", \"137.sphere drop 812\", "
              "\"137.advance pivot 640\", \"137 move 812 X Y Z\", \"137 list 812 5 7\"; may be "
              "repeated (docs/choices.md)",
              "a list of texts", "what-if", "no what-ifs", SpecGroup::Rules, SpecType::Word, true,
              "", addWhatIf, whatIfTexts},
    SpecField{"neighbors", "-k,--neighbors", "K", "",
              "Neighbors of a point: the K nearest (default: the lists in the file, or 12)",
              "a whole number from 1 to 1000000", "{} neighbors", "neighbors of the input",
              SpecGroup::Lists, SpecType::Whole, false, "reach", setNearest,
              reachTexts<KNearest, &KNearest::k>},
    SpecField{"radius", "-r,--radius", "R", "",
              "Neighbors of a point: all within R, in scene units", "a number > 0",
              "neighbors within {}", "neighbors of the input", SpecGroup::Lists, SpecType::Number,
              false, "reach", setWithin<WithinRadius>,
              reachTexts<WithinRadius, &WithinRadius::radius>},
    SpecField{"reach", "--reach", "X", "",
              "Neighbors of a point: all within X times the mean distance to the nearest",
              "a number > 0", "neighbors within {} spacings", "neighbors of the input",
              SpecGroup::Lists, SpecType::Number, false, "reach", setWithin<WithinSpacings>,
              reachTexts<WithinSpacings, &WithinSpacings::spacings>},
    SpecField{"symmetric", "--symmetric", "", "on", "Make neighbor lists symmetric",
              "true or false", "symmetric lists", "lists not made symmetric", SpecGroup::Lists,
              SpecType::Switch, false, "",
              [](RunSpec& s, std::string_view t) { return setSwitch(s.neighbors.symmetric, t); },
              [](const RunSpec& s) { return listIf(s.neighbors.symmetric, "on"); }},
    SpecField{"keep_opposing", "--keep-opposing", "", "on",
              "Keep neighbors whose normal opposes that of the point, as --rule opposing=off",
              "true or false", "", "", SpecGroup::Lists, SpecType::Switch, false, "",
              keep<kOpposing>, noTexts},
    SpecField{"keep_noise", "--keep-noise", "", "on",
              "Keep all points where noise is as wide as the spacing, as --rule noise=off "
              "(--rules robust sets aside those above or below others)",
              "true or false", "", "", SpecGroup::Lists, SpecType::Switch, false, "", keep<kNoise>,
              noTexts},
    SpecField{"keep_strays", "--keep-strays", "", "on",
              "Keep points far from all others, as --rule strays=off (--rules corrected and "
              "robust set them aside)",
              "true or false", "", "", SpecGroup::Lists, SpecType::Switch, false, "", keep<kStrays>,
              noTexts},
    SpecField{
        "normals", "--orient", "", "oriented",
        "Flip normals of the file so that they agree with each other",
        "\"derived\" or \"oriented\"", "normals oriented", "normals of the input",
        SpecGroup::Derived, SpecType::Word, false, "normals", setNormals,
        [](const RunSpec& s) { return listIf(s.normals == NormalSource::Oriented, "oriented"); }},
    SpecField{
        "normals", "--derive-normals", "", "derived",
        "Derive normals from the positions even if the file has some",
        "\"derived\" or \"oriented\"", "normals derived", "normals of the input",
        SpecGroup::Derived, SpecType::Word, false, "normals", setNormals,
        [](const RunSpec& s) { return listIf(s.normals == NormalSource::Derived, "derived"); }},
    SpecField{
        "scanner", "--scanner", "POINT", "",
        "Derived or flipped normals face this position, X,Y,Z, part by part (default: they "
        "face outward)",
        "three numbers separated by commas: X,Y,Z", "normals facing {}",
        "normals facing no scanner", SpecGroup::Derived, SpecType::Numbers, false, "", setScanner,
        [](const RunSpec& s) { return s.scanner ? Texts{plainNumbers(*s.scanner)} : Texts{}; }},
    SpecField{"box", "--box", "BOX", "",
              "Points on the walls of this box are boundary points: auto (around all points), or "
              "X0,Y0,Z0,X1,Y1,Z1",
              "auto, or six numbers separated by commas, the lower corner first: "
              "X0,Y0,Z0,X1,Y1,Z1",
              "walls of the box {}", "walls of the input", SpecGroup::Derived, SpecType::Numbers,
              false, "", setBox, boxTexts},
    SpecField{"rim", "--derive-rim", "", "on",
              "Find where the surface ends without a wall, and treat the points there as boundary "
              "points, even if the file has some (--rules robust finds them if it has none)",
              "true or false", "rims derived", "rims by the rules", SpecGroup::Derived,
              SpecType::Switch, false, "",
              [](RunSpec& s, std::string_view t) { return setSwitch(s.rim, t); },
              [](const RunSpec& s) { return listIf(s.rim, "on"); }},
};

/// The name by which messages call a field: that of its option without a short form, or its key.
std::string_view nameOf(const SpecField& field) {
    if (field.option.empty()) return field.key;
    return field.option.substr(field.option.find(',') + 1);
}

/// `pattern` with `text` in place of {}.
std::string filled(std::string_view pattern, std::string_view text) {
    std::string filled(pattern);
    if (const std::size_t at = filled.find("{}"); at != std::string::npos)
        filled.replace(at, 2, text);
    return filled;
}

std::string wordsOf(const FieldValue& value) {
    std::string words = filled(value.field->words, value.text);
    std::replace(words.begin(), words.end(), '_', ' ');
    std::replace(words.begin(), words.end(), '=', ' ');
    return words;
}

/// Appends a part of a list, unless it is the last one already.
void addPart(std::string& text, std::string_view part) {
    if (part.empty() || text.ends_with(part)) return;
    text.append(text.empty() ? "" : ", ").append(part);
}

/// The single rules in which `to` differs: from `from` if both have the same set.
std::vector<RuleValue> rulesThatDiffer(const RunSpec& from, const RunSpec& to) {
    if (from.rules == to.rules) return differingRules(ruleParams(to), ruleParams(from));
    return differingRules(ruleParams(to), paramsByName(to.rules).value_or(Params{}));
}

/// As shellQuoted(), but NAME=VALUE needs no quotes where no command begins.
std::string asWord(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return shellQuoted(text);
    return shellQuoted(text.substr(0, equals)) + "=" + shellQuoted(text.substr(equals + 1));
}

/// True if a field that excludes this one is set.
bool isReplaced(const SpecField& field, const RunSpec& spec) {
    return !field.excludes.empty() &&
           std::any_of(kFields.begin(), kFields.end(), [&](const SpecField& each) {
               return each.excludes == field.excludes && !each.texts(spec).empty();
           });
}

}  // namespace

std::span<const SpecField> specFields() { return kFields; }

const SpecField* findSpecField(std::string_view key) {
    const auto found = std::find_if(kFields.begin(), kFields.end(), [&](const SpecField& each) {
        return !key.empty() && each.key == key;
    });
    return found == kFields.end() ? nullptr : found;
}

Status setField(const SpecField& field, RunSpec& spec, std::string_view text) {
    Status set = field.set(spec, text);
    if (set || !set.error().message.empty()) return set;
    return Error{"expected " + std::string(field.expected)};
}

SpecChange specChange(std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
    SpecChange change;
    for (const auto& value : values) {
        const std::string_view key = value.first;
        const std::string_view text = value.second;
        const auto field = std::find_if(kFields.begin(), kFields.end(), [&](const SpecField& each) {
            // Of several options of a key the one that stands for the text.
            return each.key == key &&
                   (each.type != SpecType::Word || each.flag.empty() || each.flag == text);
        });
        assert(field != kFields.end());
        change.push_back({field, std::string(text)});
    }
    return change;
}

std::string_view textOf(const SpecChange& change, std::string_view key) {
    const auto found = std::find_if(change.begin(), change.end(),
                                    [&](const FieldValue& each) { return each.field->key == key; });
    return found == change.end() ? std::string_view{} : found->text;
}

Status applyChange(const SpecChange& change, RunSpec& spec) {
    for (const auto& [field, text] : change) {
        const Status set = setField(*field, spec, text);
        if (set) continue;
        return Error{std::string(nameOf(*field)) + " " + excerpt(text) + ": " +
                     set.error().message};
    }
    return success();
}

RunSpec changed(RunSpec spec, const SpecChange& change) {
    [[maybe_unused]] const Status applied = applyChange(change, spec);
    assert(applied.ok());
    return spec;
}

const RuleSetting* ruleOf(const FieldValue& value) {
    if (value.field->type != SpecType::Rule) return nullptr;
    return findRuleSetting(value.text.substr(0, value.text.find('=')));
}

RunSpec otherRun(RunSpec spec, const SpecChange& change) {
    if (!textOf(change, "rules").empty()) spec.choices.clear();
    return changed(std::move(spec), change);
}

SpecChange valuesOf(const RunSpec& spec) {
    SpecChange change;
    for (const SpecField& field : kFields) {
        for (std::string& text : field.texts(spec)) change.push_back({&field, std::move(text)});
    }
    return change;
}

SpecChange differenceOf(const RunSpec& from, const RunSpec& to) {
    SpecChange change;
    for (const SpecField& field : kFields) {
        if (field.type == SpecType::Rule) {
            for (const RuleValue& each : rulesThatDiffer(from, to))
                change.push_back({&field, lineOf(each)});
            continue;
        }
        const Texts before = field.texts(from);
        for (std::string& text : field.texts(to)) {
            if (std::find(before.begin(), before.end(), text) == before.end())
                change.push_back({&field, std::move(text)});
        }
    }
    return change;
}

std::string wordsOf(const SpecChange& change) {
    std::string words;
    for (const FieldValue& each : change) addPart(words, wordsOf(each));
    return words.empty() ? "no change" : words;
}

std::string differenceText(const RunSpec& from, const RunSpec& to) {
    constexpr std::ptrdiff_t kMostRules = 3;
    const SpecChange change = differenceOf(from, to);
    const auto of = [](const SpecField& field) {
        return [&field](const FieldValue& each) { return each.field == &field; };
    };
    std::string text;
    for (const SpecField& field : kFields) {
        const auto count = std::count_if(change.begin(), change.end(), of(field));
        if (field.type == SpecType::Rule && count > kMostRules) {
            addPart(text, std::to_string(count) + " rules differ");
            continue;
        }
        for (const FieldValue& each : change) {
            if (each.field == &field) addPart(text, wordsOf(each));
        }
        const bool gone = count == 0 && field.texts(from) != field.texts(to);
        if (gone && !isReplaced(field, to)) addPart(text, field.without);
    }
    if (!(from.start == to.start)) addPart(text, "another start");
    return text.empty() ? std::string(kNoDifference) : text;
}

std::vector<std::string> optionsOf(const SpecChange& change) {
    std::vector<std::string> options;
    for (const auto& [field, text] : change) {
        if (field->option.empty()) continue;
        std::string option(nameOf(*field));
        // Joined by =, since a value with a minus sign would be parsed as an option.
        if (!field->value.empty()) option += (text.starts_with('-') ? "=" : " ") + asWord(text);
        options.push_back(std::move(option));
    }
    return options;
}

std::string optionsText(const RunSpec& spec, std::initializer_list<SpecGroup> groups) {
    SpecChange change = valuesOf(spec);
    std::erase_if(change, [&](const FieldValue& each) {
        return std::find(groups.begin(), groups.end(), each.field->group) == groups.end();
    });
    std::string text;
    for (const std::string& each : optionsOf(change)) text += " " + each;
    return text;
}

Result<SpecChange> changeFromWords(std::span<const std::string> words) {
    SpecChange change;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::size_t equals =
            words[i].starts_with("--") ? words[i].find('=') : std::string::npos;
        const std::string_view name = std::string_view(words[i]).substr(0, equals);
        const auto field = std::find_if(kFields.begin(), kFields.end(), [&](const SpecField& each) {
            const std::size_t comma = std::min(each.option.find(','), each.option.size());
            return !name.empty() && (name == nameOf(each) || name == each.option.substr(0, comma));
        });
        if (field == kFields.end()) {
            return Error{excerpt(words[i]) +
                         ": no such option of a run's points and rules; docs/command-line.md lists "
                         "them as shared options"};
        }
        const bool takesNext = !field->value.empty() && equals == std::string::npos;
        if (takesNext && i + 1 == words.size())
            return Error{std::string(name) + ": its value is missing"};
        change.push_back({field, takesNext                     ? words[++i]
                                 : equals != std::string::npos ? words[i].substr(equals + 1)
                                                               : std::string(field->flag)});
    }
    std::stable_sort(change.begin(), change.end(),
                     [](const FieldValue& a, const FieldValue& b) { return a.field < b.field; });
    for (const FieldValue& each : change) {
        const auto other = std::find_if(change.begin(), change.end(), [&](const FieldValue& b) {
            return b.field != each.field && !b.field->excludes.empty() &&
                   b.field->excludes == each.field->excludes;
        });
        if (other != change.end())
            return Error{std::string(nameOf(*other->field)) + ": not together with " +
                         std::string(nameOf(*each.field))};
    }
    RunSpec trial;
    if (const Status valid = applyChange(change, trial); !valid) return valid.error();
    return change;
}

SpecChange changeOf(Fix fix) { return changeFromWords(io::wordsIn(optionOf(fix))).value(); }

// ---- JSON ----

std::string jsonQuoted(std::string_view text) {
    std::string json = "\"";
    for (const char c : text) {
        constexpr std::string_view kHex = "0123456789abcdef";
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') json += '\\';
        if (code >= 0x20)
            json += c;
        else
            json.append("\\u00").append({kHex[code >> 4U], kHex[code & 15U]});
    }
    return json + '"';
}

namespace {

/// "[a, b]" of the texts of all items.
template <typename Items, typename Text>
std::string listJson(const Items& items, Text&& text) {
    std::string list = "[";
    for (const auto& item : items) list.append(list.size() > 1 ? ", " : "").append(text(item));
    return list + "]";
}

bool isNumber(std::string_view text) { return numberIn<double>(text).has_value(); }

/// A number of any size as readers expect it: 2.0.
std::string decimal(std::string_view text) {
    const bool whole = text.find_first_of(".e") == std::string_view::npos;
    return std::string(text) + (whole ? ".0" : "");
}

/// A value of a type as JSON; of a rule what follows its name.
std::string valueJson(SpecType type, std::string_view text) {
    if (text == "on" || text == "off") {
        if (type == SpecType::Switch || type == SpecType::Rule)
            return text == "on" ? "true" : "false";
    }
    if (type == SpecType::Numbers && isNumber(text.substr(0, text.find(',')))) {
        std::string list;
        for (std::size_t at = 0; at <= text.size();) {
            const std::size_t comma = std::min(text.find(',', at), text.size());
            list += (at > 0 ? ", " : "") + decimal(text.substr(at, comma - at));
            at = comma + 1;
        }
        return "[" + list + "]";
    }
    if (type == SpecType::Number) return decimal(text);
    return type != SpecType::Word && isNumber(text) ? std::string(text) : jsonQuoted(text);
}

/// All values of a field.
std::string fieldJson(const SpecField& field, const Texts& texts) {
    if (field.type == SpecType::Rule) {
        std::string object = "{";
        for (const std::string& each : texts) {
            const std::size_t equals = each.find('=');
            object.append(object.size() > 1 ? ", " : "").append(jsonQuoted(each.substr(0, equals)));
            object += ": " + valueJson(field.type, std::string_view(each).substr(equals + 1));
        }
        return object + "}";
    }
    const auto json = [&](const std::string& text) { return valueJson(field.type, text); };
    return field.repeats ? listJson(texts, json) : json(texts.front());
}

}  // namespace

std::string startJson(const GivenStart& start) {
    const auto number = [](Index p) { return std::to_string(p); };
    const auto points = [&](const auto& list) { return listJson(list, number); };
    const auto triangle = [&](const Triangle& t) { return points(std::array{t.a, t.b, t.c}); };
    const auto step = [&](const RingStep& s) { return points(std::array{s.from, s.to}); };
    std::string json = "{";
    const auto add = [&json](std::string_view key, const std::string& list) {
        if (list == "[]") return;
        json.append(json.size() > 1 ? ", " : "").append(jsonQuoted(key)).append(": ").append(list);
    };
    add("triangles", listJson(start.triangles, triangle));
    add("rings", listJson(start.rings, points));
    add("done", points(start.done));
    add("open", listJson(start.open, step));
    return json + "}";
}

std::string optionsJson(const RunSpec& spec) {
    std::string json = "{\"rules\": " + jsonQuoted(spec.rules);
    for (const SpecField& field : kFields) {
        const Texts texts = field.texts(spec);
        if (texts.empty() || field.key == "rules") continue;
        json += ", " + jsonQuoted(field.key) + ": " + fieldJson(field, texts);
    }
    if (!spec.start.empty()) json += ", \"start\": " + startJson(spec.start);
    return json + "}";
}

}  // namespace se
