#include "ledger_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "failures.h"
#include "sentences.h"
#include "spiraling_edge/run/event_text.h"

namespace se::cli {
namespace {

/// Adds lines of a ledger to the text, and to the JSON as `lines`.
void addLines(const std::vector<LedgerLine>& lines, std::size_t marked, Answer& answer) {
    answer.json["lines"] = Json::array();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const LedgerLine& line = lines[i];
        const std::string pivot = line.pivot == kNone ? "" : fmt::format("pivot {}", line.pivot);
        answer.text += fmt::format("{} {:<18} {:<8} {:<12} {:<4} {}\n", i == marked ? '>' : ' ',
                                   toString(line.event.address), roleName(line.role), pivot,
                                   stageSection(line.event.address.stage), describe(line.event));
        if (line.reading) answer.text += fmt::format("{:48}{}\n", "", readingText(*line.reading));
        answer.json["lines"].push_back(lineJson(line));
    }
}

/// Adds the sentence and the lines of a ledger, with the decisive one.
void addLedger(const Ledger& ledger, Answer& answer) {
    answer.text = ledger.answer + "\n\n";
    answer.json["answer"] = ledger.answer;
    answer.json["cause"] = toString(ledger.lines[ledger.cause].event.address);
    addLines(ledger.lines, ledger.cause, answer);
}

/// The moments of a failure: their names in text, their keys.
struct MomentRow {
    const char* name;
    const char* key;
    LedgerLine FailureMoments::*line;
};
constexpr MomentRow kMoments[] = {{"created", "created", &FailureMoments::created},
                                  {"decided", "decided", &FailureMoments::decided},
                                  {"first touched", "first_touched", &FailureMoments::touched}};

}  // namespace

std::string readingText(const Reading& reading) {
    return fmt::format("{} {:.6g}{} against {:.6g}{}, margin {:+.2g}", reading.quantity,
                       reading.value, reading.unit.empty() ? "" : " deg", reading.threshold,
                       reading.unit.empty() ? "" : " deg", reading.margin);
}

Json lineJson(const LedgerLine& line) {
    Json json;
    json["address"] = toString(line.event.address);
    json["role"] = roleName(line.role);
    json["pivot"] = line.pivot == kNone ? Json() : Json(line.pivot);
    json["section"] = stageSection(line.event.address.stage);
    json["text"] = describe(line.event);
    if (line.reading) {
        json["quantity"] = line.reading->quantity;
        json["value"] = line.reading->value;
        json["threshold"] = line.reading->threshold;
        json["margin"] = line.reading->margin;
    }
    return json;
}

Answer answerOf(const Ledger& ledger) {
    Answer answer;
    answer.json["present"] = ledger.present;
    addLedger(ledger, answer);
    if (!ledger.inversions.empty()) {
        answer.text += "\nInverted:";
        for (const WhatIf& each : ledger.inversions) {
            answer.text += fmt::format(" --what-if \"{}\"", lineOf(each));
            answer.json["what_if"].push_back(lineOf(each));
        }
        if (ledger.undoneBy != nullptr) {
            const std::string off = lineOf(RuleValue{std::string(ledger.undoneBy->name), 0.0});
            answer.text += fmt::format(" --rule {}", off);
            answer.json["without"] = off;
        }
        answer.text += "\n";
    }
    answer.json["proved_by"] = provedByName(ledger.provedBy);
    if (ledger.preventedBy) {
        const std::string option = optionsOf({*ledger.preventedBy}).front();
        answer.text +=
            (ledger.inversions.empty() ? "\n" : "") + fmt::format("Change:   {}\n", option);
        answer.json["change"] = option;
    }
    return answer;
}

Answer answerOf(const RingHistory& history) {
    Answer answer;
    answer.json = {{"ring", history.name}, {"length", history.length}};
    addLedger(history, answer);
    return answer;
}

Answer answerOf(const std::vector<RunChart>& charts) {
    constexpr std::size_t kWidest = 30;
    Answer answer;
    answer.json["charts"] = Json::array();
    for (const RunChart& chart : charts) {
        answer.text +=
            fmt::format("{}{} ({})\n", answer.text.empty() ? "" : "\n", chart.title, chart.unit);
        Json row{{"name", chart.name}, {"unit", chart.unit}, {"bars", Json::array()}};
        std::uint64_t limit = 1;
        for (const ChartBar& bar : chart.bars) limit = std::max(limit, bar.count);
        for (const ChartBar& bar : chart.bars) {
            const std::size_t length =
                (static_cast<std::size_t>(bar.count) * kWidest + limit - 1) / limit;
            answer.text += fmt::format("  {:<12} {:<30} {:>9}  {}\n", bar.label,
                                       std::string(length, '#'), bar.count, bar.query);
            row["bars"].push_back(
                {{"label", bar.label}, {"count", bar.count}, {"find", bar.query}});
        }
        answer.json["charts"].push_back(row);
    }
    return answer;
}

Answer answerOf(const NearestDecisions& decisions) {
    Answer answer;
    answer.json["closest"] = Json::array();
    for (const NearestDecision& decision : decisions.decisions) {
        const Vec3& by = decision.move.by;
        answer.text +=
            fmt::format("{:<18} {}\n{:19}{}; moving {} by ({:.3g}, {:.3g}, {:.3g}) flips it\n",
                        toString(decision.event.address), describe(decision.event), "",
                        readingText(decision.reading), decision.move.point, by.x, by.y, by.z);
        const bool taken = outcomeOf(decision.event) == Outcome::Taken;
        Json row = lineJson({decision.event, decision.pivot,
                             taken ? LineRole::Taken : LineRole::Refused, decision.reading});
        row["nudge"] = {{"point", decision.move.point}, {"by", by}};
        answer.json["closest"].push_back(row);
    }
    return answer;
}

Answer answerOf(const FoundDecisions& found) {
    Answer answer;
    answer.text = counted(found.total, "decision");
    if (found.total > found.lines.size())
        answer.text += fmt::format(", the first {} of them:", found.lines.size());
    answer.text += "\n";
    answer.json["total"] = found.total;
    addLines(found.lines, found.lines.size(), answer);
    return answer;
}

Answer answerOf(const RunFailure& failure) {
    Answer answer{describe(failure.failure) + "\n",
                  {{"class", failure.failure.kind->name},
                   {"points", failure.failure.points},
                   {"triangles", failure.failure.triangles}}};
    for (const MomentRow& moment : kMoments) {
        const LedgerLine& line = failure.moments.*moment.line;
        answer.text += fmt::format("  {:<16} {:<18} {}\n", moment.name,
                                   toString(line.event.address), describe(line.event));
        if (line.reading) answer.text += fmt::format("{:38}{}\n", "", readingText(*line.reading));
        answer.json[moment.key] = lineJson(line);
    }
    return answer;
}

Answer answerOf(const RunFailureSearch& found, std::size_t limit) {
    const std::vector<ClassTotal>& totals = found.verdict.totals;
    Answer answer{headlineOf(found.verdict) + "\n" + placesText(found.places, found.all, limit),
                  {{"verdict", verdictJson(found.verdict)}}};
    addTotals(totals, failureClasses(), answer.json);
    std::vector<std::optional<std::size_t>> rowOf(found.all.size());
    for (std::size_t i = 0; i < found.failures.size(); ++i) rowOf[found.failures[i].position] = i;
    addPlaces(found.places, found.all, rowOf, found.places.size(), answer.json);
    answer.json["failures"] = Json::array();
    std::vector<std::string> texts;
    for (const RunFailure& each : found.failures) {
        Answer failure = answerOf(each);
        answer.json["failures"].push_back(std::move(failure.json));
        texts.push_back(std::move(failure.text));
    }
    for (std::size_t i = 0; i < totals.size(); ++i) {
        const FailureClass& kind = failureClasses()[i];
        if (totals[i].total == 0) continue;
        answer.text += classText(kind, totals[i]) + "\n";
        std::size_t shown = 0;
        for (std::size_t f = 0; f < texts.size(); ++f) {
            if (found.failures[f].failure.kind == &kind && shown++ < limit) answer.text += texts[f];
        }
    }
    return answer;
}

}  // namespace se::cli
