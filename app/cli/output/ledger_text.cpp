#include "ledger_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "failure_totals.h"
#include "sentences.h"
#include "spiraling_edge/run/event_text.h"
#include "verdict_text.h"

namespace se::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string linesText(const std::vector<LedgerLine>& lines, std::size_t marked) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const LedgerLine& line = lines[i];
        const std::string pivot = line.pivot == kNone ? "" : fmt::format("pivot {}", line.pivot);
        text += fmt::format("{} {:<18} {:<8} {:<12} {:<4} {}\n", i == marked ? '>' : ' ',
                            toString(line.event.address), roleName(line.role), pivot,
                            stageSection(line.event.address.stage), describe(line.event));
        if (line.reading) text += fmt::format("{:48}{}\n", "", readingText(*line.reading));
    }
    return text;
}

void addLines(const std::vector<LedgerLine>& lines, Json& json) {
    json["lines"] = Json::array();
    for (const LedgerLine& line : lines) json["lines"].push_back(lineJson(line));
}

/// Adds the answer of a ledger or of a ring's history, with the decisive line and all lines.
template <typename Answer>
void addAnswer(const Answer& answer, Json& json) {
    json["answer"] = answer.answer;
    json["cause"] = toString(answer.lines[answer.cause].event.address);
    addLines(answer.lines, json);
}

/// The moments of a failure: their names in text, their keys.
struct MomentRow {
    const char* name;
    const char* key;
    LedgerLine FailureMoments::*line;
};
constexpr MomentRow kMoments[] = {{"created", "created", &FailureMoments::created},
                                  {"unavoidable", "unavoidable", &FailureMoments::unavoidable},
                                  {"first touched", "first_touched", &FailureMoments::touched}};

/// "prevents", "stays", or "unknown" if too many failures are left to decide.
std::string_view effectOf(const Remedy& remedy) {
    return remedy.prevents ? "prevents" : remedy.unknown ? "unknown" : "stays";
}

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

std::string answerText(const Ledger& ledger) {
    return ledger.answer + "\n\n" + linesText(ledger.lines, ledger.cause);
}

Json answerJson(const Ledger& ledger) {
    Json json;
    json["subject"] =
        std::vector<Index>(ledger.subject.points().begin(), ledger.subject.points().end());
    json["present"] = ledger.present;
    addAnswer(ledger, json);
    return json;
}

std::string answerText(const RingHistory& history) {
    return history.answer + "\n\n" + linesText(history.lines, history.cause);
}

Json answerJson(const RingHistory& history) {
    Json json{{"ring", nameOf(history.ring)}, {"length", history.length}};
    addAnswer(history, json);
    return json;
}

std::string answerText(const std::vector<RunChart>& charts) {
    constexpr std::size_t kWidest = 30;
    std::string text;
    for (const RunChart& chart : charts) {
        text += fmt::format("{}{} ({})\n", text.empty() ? "" : "\n", chart.title, chart.unit);
        std::uint64_t limit = 1;
        for (const ChartBar& bar : chart.bars) limit = std::max(limit, bar.count);
        for (const ChartBar& bar : chart.bars) {
            const std::size_t length =
                (static_cast<std::size_t>(bar.count) * kWidest + limit - 1) / limit;
            text += fmt::format("  {:<12} {:<30} {:>9}  {}\n", bar.label, std::string(length, '#'),
                                bar.count, bar.query);
        }
    }
    return text;
}

Json answerJson(const std::vector<RunChart>& charts) {
    Json json{{"charts", Json::array()}};
    for (const RunChart& chart : charts) {
        Json row{{"name", chart.name}, {"unit", chart.unit}, {"bars", Json::array()}};
        for (const ChartBar& bar : chart.bars)
            row["bars"].push_back(
                {{"label", bar.label}, {"count", bar.count}, {"find", bar.query}});
        json["charts"].push_back(row);
    }
    return json;
}

std::string answerText(const NearestDecisions& decisions) {
    std::string text;
    for (const NearestDecision& decision : decisions.decisions) {
        const Vec3& by = decision.move.by;
        text += fmt::format("{:<18} {}\n{:19}{}; moving {} by ({:.3g}, {:.3g}, {:.3g}) flips it\n",
                            toString(decision.event.address), describe(decision.event), "",
                            readingText(decision.reading), decision.move.point, by.x, by.y, by.z);
    }
    return text;
}

Json answerJson(const NearestDecisions& decisions) {
    Json json{{"closest", Json::array()}};
    for (const NearestDecision& decision : decisions.decisions) {
        Json row = lineJson({decision.event, decision.pivot, LineRole::Fact, decision.reading});
        row["role"] = roleName(outcomeOf(decision.event) == Outcome::Taken ? LineRole::Taken
                                                                           : LineRole::Refused);
        const Vec3& by = decision.move.by;
        row["nudge"] = {{"point", decision.move.point}, {"by", {by.x, by.y, by.z}}};
        json["closest"].push_back(row);
    }
    return json;
}

std::string answerText(const FoundDecisions& found) {
    const std::string more = found.total > found.lines.size()
                                 ? fmt::format(", the first {} of them:", found.lines.size())
                                 : "";
    return fmt::format("{}{}\n", counted(found.total, "decision"), more) +
           linesText(found.lines, found.lines.size());
}

Json answerJson(const FoundDecisions& found) {
    Json json{{"total", found.total}};
    addLines(found.lines, json);
    return json;
}

std::string answerText(const RunFailure& failure) {
    std::string text = describe(failure.failure) + "\n";
    for (const MomentRow& moment : kMoments) {
        const LedgerLine& line = failure.moments.*moment.line;
        text += fmt::format("  {:<16} {:<18} {}\n", moment.name, toString(line.event.address),
                            describe(line.event));
        if (line.reading) text += fmt::format("{:38}{}\n", "", readingText(*line.reading));
    }
    return text;
}

Json answerJson(const RunFailure& failure) {
    Json json{{"class", failure.failure.kind->name},
              {"points", failure.failure.points},
              {"triangles", failure.failure.triangles}};
    for (const MomentRow& moment : kMoments)
        json[moment.key] = lineJson(failure.moments.*moment.line);
    return json;
}

Json answerJson(const Remedies& remedies) {
    Json json{{"of_class", remedies.ofClass}, {"all", remedies.all}, {"tried", Json::array()}};
    for (const Remedy& each : remedies.tried) {
        json["tried"].push_back({{each.rule != nullptr ? "rule" : "rules", nameOf(each)},
                                 {"prevents", each.prevents},
                                 {"unknown", each.unknown},
                                 {"of_class", each.ofClass},
                                 {"all", each.all}});
    }
    return json;
}

std::string answerText(const Remedies& remedies) {
    std::string text = fmt::format("\n  As run: {} of this class, {} in all. With one more rule:\n",
                                   remedies.ofClass, remedies.all);
    const bool any = std::any_of(remedies.tried.begin(), remedies.tried.end(),
                                 [](const Remedy& each) { return each.prevents; });
    if (!any) text += "  no rule of --rules robust prevents it\n";
    for (const Remedy& each : remedies.tried) {
        const std::string option = each.rule != nullptr ? fmt::format("--rule {}=on", nameOf(each))
                                                        : fmt::format("--rules {}", nameOf(each));
        text += fmt::format("  {:<22} {:<10} {:>6} of this class, {:>6} in all\n", option,
                            effectOf(each), each.ofClass, each.all);
    }
    return text;
}

std::string failuresText(const RunFailureSearch& found, std::size_t limit) {
    std::string text = headlineOf(found.verdict) + "\n";
    const std::vector<ClassTotal>& totals = found.verdict.totals;
    text += placesText(found.places, found.all, limit);
    for (std::size_t i = 0; i < totals.size(); ++i) {
        const FailureClass& kind = failureClasses()[i];
        if (totals[i].total == 0) continue;
        text += classText(kind, totals[i]) + "\n";
        std::size_t shown = 0;
        for (const RunFailure& each : found.failures) {
            if (each.failure.kind == &kind && shown++ < limit) text += answerText(each);
        }
    }
    return text;
}

Json answerJson(const RunFailureSearch& found) {
    Json json{{"verdict", verdictJson(found.verdict)}};
    addTotals(found.verdict.totals, failureClasses(), json);
    std::vector<std::optional<std::size_t>> rowOf(found.all.size());
    for (std::size_t i = 0; i < found.failures.size(); ++i) rowOf[found.failures[i].position] = i;
    addPlaces(found.places, found.all, rowOf, found.places.size(), json);
    json["failures"] = Json::array();
    for (const RunFailure& each : found.failures) json["failures"].push_back(answerJson(each));
    return json;
}

}  // namespace se::cli
