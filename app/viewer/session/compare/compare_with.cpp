#include "compare_with.h"

#include <filesystem>

#include "run/number_format.h"
#include "run/rule_set.h"
#include "spiraling_edge/base/files.h"
#include "teach/trace/setrace.h"

namespace se::view {

namespace {

void append(std::string& text, const std::string& part) {
    text += (text.empty() ? "" : ", ") + part;
}

std::string reachText(const NeighborOptions& options) {
    if (!options.recompute) return "neighbors of the input";
    if (const auto* nearest = std::get_if<KNearest>(&options.reach))
        return std::to_string(nearest->k) + " nearest";
    if (const auto* reach = std::get_if<WithinSpacings>(&options.reach))
        return "within " + numberText(reach->spacings) + " spacings";
    return "radius " + numberText(std::get<WithinRadius>(options.reach).radius);
}

std::string normalsText(NormalSource normals) {
    switch (normals) {
        case NormalSource::AsGiven:
            return "normals of the input";
        case NormalSource::Oriented:
            return "normals flipped";
        case NormalSource::Derived:
            return "normals derived";
    }
    return {};
}

/// Rules of `b` that differ from those of `a`; only counted if there are many.
std::string rulesText(const RuleSet& a, const RuleSet& b) {
    constexpr int kNamed = 3;
    std::string text;
    int count = 0;
    for (const RuleSetting& setting : ruleSettings()) {
        const double value = valueOf(b, setting);
        if (valueOf(a, setting) == value) continue;
        ++count;
        if (count <= kNamed)
            append(text, std::string(setting.name) + " " + valueText(setting, value));
    }
    if (count > kNamed) text = std::to_string(count) + " rules differ";
    if (a.whatIf != b.whatIf) append(text, b.whatIf.empty() ? "no what-ifs" : "what-if");
    return text;
}

/// Differences of a rule set from its name alone.
std::string beyondItsSet(const InputSpec& spec) {
    return rulesText({spec.rules, {}, {}}, rulesOf(spec));
}

}  // namespace

std::string runTitle(const InputSpec& spec) {
    std::string text = spec.rules + " rules";
    if (const std::string more = beyondItsSet(spec); !more.empty()) append(text, more);
    if (spec.neighbors.recompute) append(text, reachText(spec.neighbors));
    return text;
}

std::string differenceText(const InputSpec& a, const InputSpec& b) {
    std::string text;
    if (a.rules != b.rules) {
        text = b.rules + " rules";
        if (const std::string more = beyondItsSet(b); !more.empty()) append(text, more);
    } else {
        text = rulesText(rulesOf(a), rulesOf(b));
    }
    const std::string reach = reachText(b.neighbors);
    if (reach != reachText(a.neighbors)) append(text, reach);
    const auto added = [&](bool mine, bool theirs, const char* on, const char* off) {
        if (mine != theirs) append(text, theirs ? on : off);
    };
    added(a.neighbors.symmetric, b.neighbors.symmetric, "symmetric", "not symmetric");
    if (a.normals != b.normals) append(text, normalsText(b.normals));
    if (!(a.walls == b.walls)) append(text, "other walls");
    if (!(a.start == b.start)) append(text, "another start");
    added(a.rim, b.rim, "rims found", "no rims");
    added(a.keepOpposing, b.keepOpposing, "opposing normals kept", "opposing normals dropped");
    added(a.keepNoise, b.keepNoise, "noise kept", "noise set aside");
    added(a.keepStrays, b.keepStrays, "strays kept", "strays set aside");
    if (a.fixes != b.fixes) append(text, b.fixes.empty() ? "not repaired" : "repaired");
    return text.empty() ? "the same" : text;
}

InputSpec usualOther(InputSpec spec) {
    spec.rules = spec.rules == "robust" ? "paper" : "robust";
    spec.choices.clear();
    return spec;
}

std::string fileTitle(const CompareWith& with) {
    return std::filesystem::path(with.path).filename().string();
}

bool isTraceFile(std::string_view path) {
    return lowerExtension(std::filesystem::path(path)) == teach::kTraceExtension;
}

CompareWith CompareWith::otherFile(std::string path) {
    return isTraceFile(path) ? otherTrace(std::move(path)) : otherMesh(std::move(path));
}

}  // namespace se::view
