#include "proof_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ledger_text.h"

namespace se::cli {
namespace {

constexpr std::array kProofs{Proof::Gone,     Proof::Later, Proof::Earlier,
                             Proof::Replaced, Proof::Stays, Proof::NotTurned};

std::size_t countOf(const std::vector<ProvenFailure>& proven, const FailureClass& kind,
                    std::optional<Proof> proof = {}) {
    return static_cast<std::size_t>(
        std::count_if(proven.begin(), proven.end(), [&](const ProvenFailure& each) {
            return each.failure->failure.kind == &kind && (!proof || each.proof.proof == *proof);
        }));
}

std::string lineFor(const ProvenFailure& each) {
    const LedgerLine& decision = each.failure->moments.unavoidable;
    std::string text = fmt::format("{}:{} {}: {} {}\n", each.failure->failure.kind->name,
                                   each.number, proofName(each.proof.proof),
                                   toString(decision.event.address), describe(decision.event));
    for (const WhatIf& turn : each.proof.turns)
        text += fmt::format("    --what-if \"{}\"\n", lineOf(turn));
    if (!each.proof.reason.empty()) text += "    " + each.proof.reason + "\n";
    return text;
}

}  // namespace

std::string proofsText(const std::vector<ProvenFailure>& proven) {
    if (proven.empty()) return "No failures found.\n";
    std::string text = fmt::format("{:<24}{:>7}", "decision inverted", "tried");
    const auto column = [](Proof proof) { return proofName(proof).size() + 3; };
    for (const Proof proof : kProofs)
        text += fmt::format("{:>{}}", proofName(proof), column(proof));
    text += "\n";
    for (const FailureClass& kind : failureClasses()) {
        if (countOf(proven, kind) == 0) continue;
        text += fmt::format("{:<24}{:>7}", kind.name, countOf(proven, kind));
        for (const Proof proof : kProofs)
            text += fmt::format("{:>{}}", countOf(proven, kind, proof), column(proof));
        text += "\n";
    }
    for (const ProvenFailure& each : proven) {
        if (each.proof.proof != Proof::Gone) text += "\n" + lineFor(each);
    }
    return text;
}

std::string proofsJson(const std::string& input, const std::vector<ProvenFailure>& proven) {
    nlohmann::ordered_json json{{"input", input}};
    for (const FailureClass& kind : failureClasses()) {
        if (countOf(proven, kind) == 0) continue;
        auto& row = json["proved"][std::string(kind.name)];
        for (const Proof proof : kProofs)
            row[std::string(proofName(proof))] = countOf(proven, kind, proof);
    }
    json["proofs"] = nlohmann::ordered_json::array();
    for (const ProvenFailure& each : proven) {
        nlohmann::ordered_json row{{"class", each.failure->failure.kind->name},
                                   {"number", each.number},
                                   {"points", each.failure->failure.points},
                                   {"unavoidable", lineJson(each.failure->moments.unavoidable)},
                                   {"proof", proofName(each.proof.proof)}};
        for (const WhatIf& turn : each.proof.turns) row["what_if"].push_back(lineOf(turn));
        if (!each.proof.reason.empty()) row["reason"] = each.proof.reason;
        json["proofs"].push_back(row);
    }
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace se::cli
