#include "inversion_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ledger_text.h"
#include "spiraling_edge/replay/event_text.h"
#include "teach/json_text.h"

namespace se::cli {
namespace {

constexpr std::array kInversions{Inversion::Gone,     Inversion::Later,
                                 Inversion::Earlier,  Inversion::Replaced,
                                 Inversion::NoEffect, Inversion::NotInvertible};

std::size_t countOf(const std::vector<InvertedFailure>& inverted, const FailureClass& kind,
                    std::optional<Inversion> inversion = {}) {
    return static_cast<std::size_t>(
        std::count_if(inverted.begin(), inverted.end(), [&](const InvertedFailure& each) {
            return each.failure->failure.kind == &kind &&
                   (!inversion || each.inversion.outcome == *inversion);
        }));
}

std::string lineFor(const InvertedFailure& each) {
    const LedgerLine& decision = each.failure->moments.unavoidable;
    std::string text = fmt::format("{}:{} {}: {} {}\n", each.failure->failure.kind->name,
                                   each.number, inversionName(each.inversion.outcome),
                                   toString(decision.event.address), describe(decision.event));
    for (const WhatIf& inverse : each.inversion.inverses)
        text += fmt::format("    --what-if \"{}\"\n", lineOf(inverse));
    if (!each.inversion.reason.empty()) text += "    " + each.inversion.reason + "\n";
    return text;
}

}  // namespace

std::string inversionsText(const std::vector<InvertedFailure>& inverted) {
    if (inverted.empty()) return "No failures found.\n";
    std::string text = fmt::format("{:<24}{:>7}", "decision inverted", "tried");
    const auto column = [](Inversion inversion) { return inversionName(inversion).size() + 3; };
    for (const Inversion inversion : kInversions)
        text += fmt::format("{:>{}}", inversionName(inversion), column(inversion));
    text += "\n";
    for (const FailureClass& kind : failureClasses()) {
        if (countOf(inverted, kind) == 0) continue;
        text += fmt::format("{:<24}{:>7}", kind.name, countOf(inverted, kind));
        for (const Inversion inversion : kInversions)
            text += fmt::format("{:>{}}", countOf(inverted, kind, inversion), column(inversion));
        text += "\n";
    }
    for (const InvertedFailure& each : inverted) {
        if (each.inversion.outcome != Inversion::Gone) text += "\n" + lineFor(each);
    }
    return text;
}

std::string inversionsJson(const std::string& input, const std::vector<InvertedFailure>& inverted) {
    nlohmann::ordered_json json{{"input", input}};
    for (const FailureClass& kind : failureClasses()) {
        if (countOf(inverted, kind) == 0) continue;
        auto& row = json["proved"][std::string(kind.name)];
        for (const Inversion inversion : kInversions)
            row[std::string(inversionName(inversion))] = countOf(inverted, kind, inversion);
    }
    json["proofs"] = nlohmann::ordered_json::array();
    for (const InvertedFailure& each : inverted) {
        nlohmann::ordered_json row{{"class", each.failure->failure.kind->name},
                                   {"number", each.number},
                                   {"points", each.failure->failure.points},
                                   {"unavoidable", lineJson(each.failure->moments.unavoidable)},
                                   {"proof", inversionName(each.inversion.outcome)}};
        for (const WhatIf& inverse : each.inversion.inverses)
            row["what_if"].push_back(lineOf(inverse));
        if (!each.inversion.reason.empty()) row["reason"] = each.inversion.reason;
        json["proofs"].push_back(row);
    }
    return teach::jsonText(json);
}

}  // namespace se::cli
