#include "report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <string>

#include "failures.h"
#include "sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "spiraling_edge/why/trial.h"
#include "spiraling_edge/why/what_if_check.h"
#include "teach/json_text.h"

namespace se::cli {
namespace {

/// "--rules robust, on the points of doctor --fix OUT.ply --drop noise". Requires a change.
std::string insteadText(const SpecChange& change) {
    assert(!change.empty());
    std::string text = fmt::format("{}", fmt::join(optionsOf(change), " "));
    const std::string_view drop = textOf(change, "doctor");
    if (drop.empty()) return text;
    return fmt::format("{}on the points of doctor --fix OUT.ply --drop {}",
                       text.empty() ? "" : text + ", ", drop);
}

Json trialJson(const Trial& trial) {
    return {{"options", optionsOf(trial.change)},
            {"drop", orNull(textOf(trial.change, "doctor"))},
            {"work", trial.work},
            {"verdict", verdictJson(trial.verdict)}};
}

/// Adds lines of the summary: the numbers before and of the best, and its options.
void addTrials(const Trials& trials, Answer& summary) {
    const Trial& first = trials.tried.front();
    const Trial& best = trials.tried[trials.best];
    summary.line("tried", counted(trials.tried.size() - 1, "change") + " of the settings");
    summary.line("before", describe(first.verdict));
    if (trials.best == 0) return summary.line("best", "as given; no change is better");
    summary.line("best", describe(best.verdict));
    summary.line("instead", insteadText(best.change));
    summary.line("but", lossesText(best.verdict, first.verdict));
}

/// All trials with their numbers, in the order in which they were made, and the position of the
/// best.
Json trialsJson(const Trials& trials) {
    Json tried = Json::array();
    for (const Trial& each : trials.tried) tried.push_back(trialJson(each));
    return {{"chosen", trials.best}, {"tried", tried}};
}

Json ruleJson(const RuleSetting& rule, double value) {
    if (rule.kind == SettingKind::Switch) return value != 0.0;
    if (rule.kind == SettingKind::Option) return valueText(rule, value);
    if (rule.kind == SettingKind::Whole) return static_cast<std::int64_t>(value);
    return value;
}

constexpr std::size_t kMaxAlerts = 100;
constexpr std::size_t kMaxFaults = 100;

std::string_view nameOf(StopReason ending) {
    if (ending == StopReason::Condition) return "max_pivots";
    return ending == StopReason::Capped ? "capped" : "finished";
}

void addCounters(const Counters& counters, Json& json) {
    json["pivots"] = counters.pivots;
    json["skipped"] = counters.skipped;
    json["seeds"] = counters.seeds;
    json["isolated"] = counters.isolated;
    json["stranded"] = counters.stranded;
    json["inserted"] = counters.inserted;
    json["discarded"] = counters.discarded;
    json["refused"] = counters.refused;
    json["splits"] = counters.splits;
    json["joins"] = counters.joins;
    json["closed_rings"] = counters.closedRings;
    json["freed_rings"] = counters.freedRings;
    json["shelved"] = counters.shelved;
    json["holes"] = counters.holes;
    json["openings"] = counters.openings;
    json["filled"] = counters.filled;
    json["lost_seeds"] = counters.lostSeeds;
    json["failed_seeds"] = counters.failedSeeds;
    json["max_ring_length"] = counters.maxRingLength;
    json["max_stack_depth"] = counters.maxStackDepth;
}

/// Counters of the steps after the last pivot.
void addRepairs(const RepairState& repair, Json& json) {
    json["mended"] = {
        {"reinserted_points", repair.reinserted}, {"points_taken_out", repair.takenOut},
        {"flipped_edges", repair.flipped},        {"dropped_patches", repair.droppedPatches},
        {"closed_holes", repair.closedHoles},     {"remeshed", repair.remeshed}};
}

void addMesh(const MeshReport& mesh, Json& json) {
    json["edges"] = mesh.edges;
    json["boundary_edges"] = mesh.boundaryEdges;
    json["boundary_loops"] = mesh.boundaryLoops;
    json["widest_loop"] =
        mesh.boundaryLoops == 0
            ? Json()
            : Json({{"width", mesh.widestLoopWidth}, {"edges", mesh.widestLoopEdges}});
    for (const MeshDefect& defect : meshDefects())
        json[std::string(defect.key)] = mesh.*defect.count;
    json["points_in_no_triangle"] = mesh.unusedPoints;
    json["euler_characteristic"] = mesh.eulerCharacteristic;
    json["closed_manifold"] = mesh.closedManifold();
}

/// One row of the list of faults.
Json faultRow(const MeshFailure& failure) {
    const std::vector<Index>& triangles = failure.triangles;
    Json row = {{"class", failure.kind->name}, {"points", failure.points}};
    row["triangle"] = triangles.empty() ? Json() : Json(triangles.front());
    row["other"] = triangles.size() == 2 ? Json(triangles.back()) : Json();
    row["at"] = failure.place;
    return row;
}

/// Calls visit(class, its total) for each class that is a fault.
template <typename Visit>
void forEachFault(const MeshInspection& inspection, Visit&& visit) {
    for (std::size_t i = 0; i < inspection.totals.size(); ++i) {
        const FailureClass& each = failureClasses()[i];
        if (each.fault && each.find != nullptr) visit(each, inspection.totals[i]);
    }
}

void addFaults(const RunOutcome& outcome, Json& json) {
    const MeshInspection& inspection = outcome.judged.inspection;
    forEachFault(inspection, [&](const FailureClass& each, const ClassTotal& total) {
        json["faults"][std::string(each.name)] = total.total;
    });
    json["verdict"] = verdictJson(outcome.judged.verdict);
    Json list = Json::array();
    std::vector<std::optional<std::size_t>> rowOf;
    for (const MeshFailure& failure : inspection.failures) {
        const bool listed = failure.kind->fault && list.size() < kMaxFaults;
        rowOf.push_back(listed ? std::optional(list.size()) : std::nullopt);
        if (listed) list.push_back(faultRow(failure));
    }
    json["judged"] = orNull(departureText(*outcome.judge));
    json["facts"] = inputFactsJson(outcome.judge->facts);
    json["fault_list"] = list;
    addPlaces(outcome.judged.places, inspection.failures, rowOf, kMaxFaults, json);
}

void addPreparation(const PrepareReport& report, Json& json) {
    json["set_aside"] = setAsideJson(report.aside);
    json["noise"] = report.noise;
    json["unscaled_normals"] = report.unscaledNormals;
    json["averaged_normals"] = report.averagedNormals;
    json["dropped_list_entries"] = report.droppedListEntries;
    json["neighbors_computed"] = report.neighborsComputed;
    const DerivedPieces& derived = report.derived;
    json["derived"] = {
        {"normals", derived.normals},
        {"orientation", derived.orientation},
        {"types", derived.types},
        {"rim", derived.rim},
        {"neighbors", report.neighborsComputed},
        {"completed_normals", derived.completedNormals},
        {"turned_normals", derived.turnedNormals},
        {"normal_components", derived.normalComponents},
        {"planeless_points", derived.normals ? report.count(Aside::NoNormal) : std::size_t{0}},
        {"unknown_sides", derived.unknownSides},
        {"rim_points", derived.rimPoints},
        {"rim_chains", derived.rimChains},
        {"seconds",
         {{"normals", derived.normalSeconds},
          {"orientation", derived.orientationSeconds},
          {"types", derived.typeSeconds},
          {"rim", derived.rimSeconds},
          {"neighbors", derived.neighborSeconds}}}};
}

void addRules(const RunOutcome& outcome, Json& json) {
    Json rules = {{"set", outcome.spec.rules}};
    for (const RuleSetting& rule : ruleSettings())
        rules[std::string(rule.name)] = ruleJson(rule, rule.get(outcome.params));
    rules["drop_opposing_normals"] = outcome.params.dropOpposingNormals;
    rules["set_noise_aside"] = outcome.params.setNoiseAside;
    rules["set_strays_aside"] = outcome.params.setStraysAside;
    json["rules"] = rules;
}

void addAlerts(const std::vector<Alert>& alerts, Json& json) {
    Json list = Json::array();
    for (std::size_t i = 0; i < std::min(alerts.size(), kMaxAlerts); ++i) {
        Json row = {{"kind", alertName(alerts[i].kind)}, {"pivot", alerts[i].pivot}};
        row["point"] = alerts[i].point == kNone ? Json() : Json(alerts[i].point);
        list.push_back(row);
    }
    json["alerts_total"] = alerts.size();
    json["alerts"] = list;
}

/// "3 isolated, 2 stranded"; empty if every point is used.
std::string leftOverSentence(const RunOutcome& outcome) {
    std::string text;
    const std::size_t aside = outcome.prepared.countAside();
    // What was stranded during the run may be in the mesh after its repairs.
    const std::size_t unused =
        outcome.mesh().unusedPoints - std::min(outcome.mesh().unusedPoints, aside);
    const auto add = [&](std::size_t most, const char* what) {
        const std::size_t count = std::min(most, unused);
        if (count > 0) appendPart(text, fmt::format("{} {}", count, what));
    };
    // Points that were set aside have no neighbors, and are listed above.
    const auto besides = [&](std::size_t count) { return count - std::min(count, aside); };
    add(besides(outcome.state.counters.isolated), "isolated");
    add(outcome.state.counters.stranded, "stranded");
    add(unused, "in no triangle");
    return text;
}

/// "normals, oriented in 2 parts, wall types", "no rim" of --derive-rim; empty if the file had all.
/// Neighbor lists are not listed.
std::string derivedSentence(const RunOutcome& outcome) {
    const DerivedPieces& derived = outcome.prepared.derived;
    std::string text;
    if (derived.normals) {
        appendPart(text, fmt::format("normals, oriented in {}",
                                     counted(derived.normalComponents, "part")));
    } else if (derived.orientation) {
        appendPart(text, fmt::format("sides of the normals, {} flipped", derived.turnedNormals));
    }
    if (derived.completedNormals > 0)
        appendPart(text, counted(derived.completedNormals, "normal that is zero or not finite",
                                 "normals that are zero or not finite"));
    if (derived.unknownSides > 0)
        appendPart(text, unknownSidesText(derived.unknownSides, derived.normalComponents));
    if (derived.types) appendPart(text, "wall types");
    if (derived.rim) {
        appendPart(text, fmt::format("{} with {}", counted(derived.rimChains, "rim"),
                                     counted(derived.rimPoints, "point")));
    } else if (outcome.spec.rim) {
        appendPart(text, "no rim");
    }
    return text;
}

/// "2 holes, 1 folded edge", without the search for pairs.
std::string faultCounts(const RunOutcome& outcome) {
    std::string text;
    forEachFault(outcome.judged.inspection, [&](const FailureClass& each, const ClassTotal& total) {
        if (total.total == 0) return;
        appendPart(text, fmt::format("{} {}", total.total, nounFor(each, total.total)));
    });
    return text;
}

std::string endingSentence(const RunOutcome& outcome) {
    if (outcome.ending == StopReason::Condition)
        return "stopped after " + counted(outcome.state.counters.pivots, "pivot") +
               ", as requested";
    if (outcome.ending == StopReason::Finished) return "";
    return fmt::format(
        "stopped: more than {} triangles per point, the input is too tangled; see docs/robust.md",
        outcome.params.maxTrianglesPerPoint);
}

/// The counts that are not 0, which a mesh without faults may have too: "5 pieces torn off, 84
/// edges of holes".
std::string countsText(const MeshVerdict& verdict) {
    std::vector<std::string> words;
    for (const VerdictCount& each : verdictCounts()) {
        const std::size_t count = each.of(verdict);
        if (count > 0) words.push_back(counted(count, each.singular, each.plural));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string faultSentence(const RunOutcome& outcome) {
    const std::vector<ClassTotal>& totals = outcome.judged.inspection.totals;
    const std::size_t count = faultCount(totals);
    if (outcome.judge ? outcome.judged.verdict.isSound() : count == 0) return {};
    if (count == 0 || outcome.mesh().triangles == 0) return headlineOf(outcome.judged.verdict);
    std::string text =
        "the mesh has " + (outcome.judge ? "faults at " + headlineOf(outcome.judged.verdict)
                                         : counted(count, "fault") + ": " + faultCounts(outcome));
    if (!outcome.judge)
        text += "; intersecting triangles and second layers not counted (use --check)";
    const bool whole = outcome.ending == StopReason::Finished && outcome.params.whatIf.empty() &&
                       outcome.params.start.empty();
    if (!outcome.trials && whole) text += "; --best may avoid them";
    return text;
}

std::string reportJson(const RunOutcome& outcome) {
    Json json;
    json["report_version"] = 2;
    json["program"] = "spiraling-edge " SPIRALING_EDGE_VERSION;
    json["input"] = outcome.input;
    json["output"] = orNull(outcome.output);
    json["columns"] = orNull(outcome.read.file.columns.names);
    json["notes"] = outcome.read.file.notes;
    json["piece"] = keptJson(outcome.read);
    json["shift"] = outcome.shift ? Json(*outcome.shift) : Json();
    json["stop_reason"] = nameOf(outcome.ending);
    json["points"] = outcome.mesh().points;
    json["triangles"] = outcome.mesh().triangles;
    json["components"] = outcome.mesh().components;
    addCounters(outcome.state.counters, json);
    addRepairs(outcome.state.repair, json);
    addMesh(outcome.mesh(), json);
    addFaults(outcome, json);
    addPreparation(outcome.prepared, json);
    addRules(outcome, json);
    json["best"] = outcome.trials ? trialsJson(*outcome.trials) : Json();
    json["what_if"] = Json::array();
    for (const WhatIf& each : outcome.params.whatIf) json["what_if"].push_back(lineOf(each));
    const GivenStart& start = outcome.params.start;
    json["start"] = start.empty() ? Json()
                                  : Json({{"triangles", start.triangles.size()},
                                          {"rings", start.rings.size()},
                                          {"done", start.done.size()}});
    json["run_hash"] = fmt::format("{:016x}", runHash(outcome.state, outcome.params));
    json["state_hash"] = fmt::format("{:016x}", stateHash(outcome.state));
    addAlerts(outcome.state.alerts, json);
    json["seconds"] = {{"read", outcome.seconds.read},
                       {"trials", outcome.seconds.trials},
                       {"prepare", outcome.seconds.prepare},
                       {"judge", outcome.seconds.judge},
                       {"triangulate", outcome.seconds.triangulate},
                       {"write", outcome.seconds.write}};
    // File names need not be UTF-8; other bytes are replaced.
    return teach::jsonText(json);
}

std::string shiftText(const RunOutcome& outcome) {
    if (!outcome.shift) return "";
    return fmt::format(
        "{}: positions are relative to {}, since STL keeps 7 digits; add this offset to get the "
        "input coordinates\n",
        printable(outcome.output), se::shiftText(*outcome.shift));
}

std::string summaryText(const RunOutcome& outcome) {
    Answer summary{fmt::format("{}: {}, {}\n", printable(outcome.input),
                               counted(outcome.mesh().points, "point"),
                               meshSentence(outcome.mesh()))};
    if (outcome.trials) addTrials(*outcome.trials, summary);
    const ColumnReading& columns = outcome.read.file.columns;
    if (!columns.reason.empty()) summary.line("columns", columnsSentence(columns));
    addNotes(outcome.read.file.notes, summary);
    summary.line("kept", keptSentence(outcome.read));
    summary.line("set aside", setAsideSentence(outcome.prepared.aside));
    summary.line("normals", averagedText(outcome.prepared.averagedNormals));
    summary.line("derived", derivedSentence(outcome));
    summary.line("left over", leftOverSentence(outcome));
    summary.line("open", openSentence(outcome.mesh()));
    if (outcome.judge) summary.line("judged", departureText(*outcome.judge));
    summary.line("defects", defectSentence(outcome.mesh()));
    if (outcome.judge && outcome.judged.verdict.isSound()) {
        summary.line("faults", "none: the mesh is sound");
        summary.line("besides", countsText(outcome.judged.verdict));
    }
    const std::size_t alerts = outcome.state.alerts.size();
    if (alerts > 0) summary.line("alerts", fmt::format("{}, listed by --report", alerts));
    summary.line("ended", endingSentence(outcome));
    summary.line("time", fmt::format("read {:.3f} s, prepare {:.3f} s, triangulate {:.3f} s",
                                     outcome.seconds.read, outcome.seconds.prepare,
                                     outcome.seconds.triangulate));
    summary.line("written", outcome.output.empty() ? "nothing; name a file with -o OUT.ply"
                                                   : printable(outcome.output));
    return summary.text;
}

}  // namespace se::cli
